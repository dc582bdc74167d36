"""Writes a C header that holds text files as strings: embed.py HEADER FILE...

warp.frag becomes `static const char shader_warp_frag[]`. A string of C11 need only be portable up
to 4095 bytes, so the text is written as an array of numbers.
"""

import os
import sys


def c_array(name, text):
    body = ",".join(str(byte) for byte in text.encode("utf-8") + b"\0")
    return f"static const char {name}[] = {{{body}}};\n"


header, *files = sys.argv[1:]
with open(header, "w", encoding="utf-8") as out:
    out.write("/* Made by shaders/embed.py. */\n")
    for path in files:
        base = os.path.basename(path)
        name = "shader_" + base.replace(".", "_").replace("-", "_")
        with open(path, encoding="utf-8") as source:
            out.write(f"/* {base} */\n" + c_array(name, source.read()))
