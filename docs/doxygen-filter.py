#!/usr/bin/env python3
"""Turns the comments of Cupola's public headers into what Doxygen reads.

    doxygen-filter.py HEADER            the header for Doxygen, to standard output
    doxygen-filter.py --check HEADER... names every entry that is not complete; status 1 if any

The headers have comments of one form: prose, an empty line, then fields of a name, two spaces and
a text: the parameters, `returns`, `thread` and `since`. Declarations that follow one another
without a comment between them share one. What means the same everywhere, `error` and the handles,
has its text here.
"""
import re
import sys

HANDLE = {
    False: "made by @c cupola_{0}_create",
    True: "the handle, set to NULL; may be NULL",
}
ERROR = "out: what failed, if anything; may be NULL"
TOKEN = re.compile(r"/\*.*?\*/|\n|[^/\n]+|/", re.S)
RESERVED = ("returns", "thread", "since")


def lines_of(comment):
    """The text of a comment without its frame."""
    lines = comment[2:-2].split("\n")
    lines = [lines[0].strip()] + [re.sub(r"^\s*\* ?", "", line.rstrip()) for line in lines[1:]]
    while lines and not lines[0].strip():
        lines.pop(0)
    while lines and not lines[-1].strip():
        lines.pop()
    return lines


def escaped(text):
    text = re.sub(r"([\\@&<>#%])", r"\\\1", text)
    return re.sub(r"`([^`]+)`", r"<code>\1</code>", text)


def prose(lines):
    """Paragraphs; what is set in by two spaces or more stays as it is."""
    out, verbatim = [], False
    for i, line in enumerate(lines):
        inset = line.startswith("  ")
        if not line and verbatim:  # an empty line inside of a block belongs to it
            inset = any(lines[i + 1:]) and next(x for x in lines[i + 1:] if x).startswith("  ")
        if inset != verbatim and (line or verbatim):
            out.append("@verbatim" if inset else "@endverbatim")
            verbatim = inset
        out.append(line if verbatim else escaped(line))
    return out + (["@endverbatim"] if verbatim else [])


def joined(words):
    """A field's text in one piece; each status that may be returned begins a line of its own."""
    text = escaped(words[0])
    for line in words[1:]:
        text += ("<br>" if line.startswith("CUPOLA_") else "") + "\n * " + escaped(line)
    return text


def block(lines):
    return "/**\n" + "".join((" * " + line).rstrip() + "\n" for line in lines) + " */"


class Function:
    """One declaration: its name, what it returns and its parameters, as (name, type) pairs."""

    def __init__(self, text):
        text = " ".join(text.split())
        head, _, inside = text.partition("(")
        self.text = text
        self.name = re.search(r"(\w+)$", head).group(1)
        self.void = re.match(r"CUPOLA_API void (?!\*)", text) is not None
        inside = inside.rsplit(")", 1)[0]
        parts, depth, last = [], 0, ""
        for character in inside:
            depth += {"(": 1, ")": -1}.get(character, 0)
            if character == "," and depth == 0:
                parts.append(last)
                last = ""
            else:
                last += character
        self.parameters = [self.parameter(part) for part in parts + [last]
                           if part.strip() not in ("", "void")]

    @staticmethod
    def parameter(text):
        callback = re.search(r"\(\*(\w+)\)", text)
        name = callback or re.search(r"(\w+)(\[\w*\])*\s*$", text)
        return name.group(1), text

    def default(self, name, type_text):
        """The text of a parameter that means the same everywhere, or None."""
        if name == "error":
            return ERROR
        handle = re.search(r"\bcupola_(dome|plan|gl|points|theatre) (\*+)" + name + "$", type_text)
        if handle and handle.group(1) == name:
            twice = handle.group(2) == "**"
            if not twice or self.name.endswith("_destroy"):
                return HANDLE[twice].format(name)
        return None


def fields_of(lines, names):
    """Splits a comment's lines: its prose, and its fields by name."""
    start = max((i + 1 for i, line in enumerate(lines) if not line), default=0)
    pattern = re.compile(r"((?:\w+, )*\w+)(?: +(\S.*))?$")
    fields, current = {}, []
    for line in lines[start:]:
        match = pattern.match(line)
        known = match and all(name in names for name in match.group(1).split(", "))
        if known:
            current = match.group(1).split(", ")
            for name in current:
                fields[name] = [match.group(2)] if match.group(2) else []
        elif line.startswith(" ") and current:
            for name in current:
                fields[name].append(line.strip())
        else:
            return lines, {}
    return lines[:start], fields


def entry(function, lines, names, complaints):
    """One function's comment; what it lacks is added to `complaints`."""
    text, fields = fields_of(lines, names)
    out = prose(text)
    if not any(text):
        complaints.append("%s: no description" % function.name)
    for name, type_text in function.parameters:
        words = fields.get(name)
        default = function.default(name, type_text)
        if not words and not default:
            complaints.append("%s: parameter %s has no entry" % (function.name, name))
        out.append("@param %s %s" % (name, joined(words) if words else default or "?"))
    if not function.void:
        if not fields.get("returns"):
            complaints.append("%s: no entry returns" % function.name)
        out.append("@return " + joined(fields.get("returns", "?")))
    for name, mark in (("thread", "@par Thread\n * "), ("since", "@since ")):
        if not fields.get(name):
            complaints.append("%s: no entry %s" % (function.name, name))
        out.append(mark + joined(fields.get(name, "?")))
    return block(out)


def declarations_after(text, at):
    """The functions that a comment ending at `at` stands for, and where they end."""
    match = re.compile(r"\n(?:CUPOLA_API [^;]*;\n)+").match(text, at)
    if not match:
        return [], at
    found = re.findall(r"CUPOLA_API [^;]*;", match.group(0))
    return [Function(one) for one in found], match.end() - 1


def filtered(text):
    """The header for Doxygen, and complaints as (line, message)."""
    out, complaints, at = [], [], 0
    for match in TOKEN.finditer(text):
        if match.start() < at:
            continue
        token = match.group(0)
        at = match.end()
        line_start = text.rfind("\n", 0, match.start()) + 1
        before = text[line_start:match.start()].strip()
        if not token.startswith("/*"):
            handle = re.match(r"typedef struct (cupola_\w+) \1;$", token)
            if handle:
                out.append("/** An opaque handle: see %s_create. */\n" % handle.group(1))
            out.append(token)
            continue
        lines = lines_of(token)
        functions, end = declarations_after(text, at)
        if match.start() == 0:
            out.append(block(["@file"] + prose(lines)))
        elif functions:
            names = [name for one in functions for name, _ in one.parameters] + list(RESERVED)
            line = text.count("\n", 0, match.start()) + 1
            for one in functions:
                missing = []
                out.append(entry(one, lines, names, missing) + "\n" + one.text + "\n")
                complaints += [(line, message) for message in missing]
            at = end
        elif before:
            out.append("/**< " + " ".join(prose(lines)) + " */")
        elif re.match(r"\n\s*([a-z]|#define )", text[at:]):
            out.append(block(prose(lines)))
        else:
            out.append(token)
    for match in re.finditer(r"^CUPOLA_API [^;]*;", "".join(out), re.M):
        if not "".join(out)[:match.start()].rstrip().endswith("*/"):
            complaints.append((0, "%s: no comment" % Function(match.group(0)).name))
    return "".join(out), complaints


def main(arguments):
    check = arguments[:1] == ["--check"]
    failed = False
    for path in arguments[1:] if check else arguments:
        with open(path, encoding="utf-8") as file:
            result, complaints = filtered(file.read())
        if not check:
            sys.stdout.write(result)
            continue
        for line, message in complaints:
            print("%s:%d: %s" % (path, line, message))
        failed = failed or bool(complaints)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
