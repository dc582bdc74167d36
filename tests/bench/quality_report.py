"""Tables of how good pictures are: quality_report.py FOLDER QUALITY.json...

The files are parts of one report: one machine and renderer, and the same size, rays, steps and
methods; what was measured otherwise is a report of its own, in another folder. Writes
FOLDER/quality.md.
"""

import json
import os
import sys

# What the parts of a report have in common, besides sizes and methods.
MACHINE = ("renderer", "processor", "clock", "llvmpipe_threads", "gl_version")
SETTINGS = ("density", "samples", "yaw_deg", "table", "rays", "steps", "shimmer_rays", "frames")
# What is promised of methods at this lens; the rest of a promise is in `bars`.
LENS, FOV_DEG = "hemispheric", 180
CONE, ADAPTIVE, FOOTPRINT = "cone:4", "adaptive", "footprint"
MOST_BLITS = {CONE: 2, ADAPTIVE: 1, FOOTPRINT: 1}
# What the paper loses of its frame rate, as frame time: 35 % and 25 %.
# Of frames like its own, lit by pixel, where there are any.
DEAR = ("heavy", "ns:")
MOST_FRAME = {CONE: 1 / 0.65 - 1, ADAPTIVE: 1 / 0.75 - 1}


def number(value, digits=2):
    return "–" if value is None else f"{value:.{digits}f}"


def mean(values):
    values = list(values)
    return None if not values or None in values else sum(values) / len(values)


def refuse(text):
    sys.exit(f"quality_report.py: {text}")


def read_part(path):
    """What one run of cupola-quality wrote."""
    try:
        with open(path, encoding="utf-8") as source:
            part = json.load(source)
    except (OSError, ValueError) as error:
        refuse(f"'{path}' is no whole result: {error}")
    for keys, found in ((("machine", "trials", *SETTINGS), part),
                        (MACHINE, part.get("machine") if isinstance(part, dict) else None)):
        missing = [key for key in keys if not isinstance(found, dict) or key not in found]
        if missing:
            refuse(f"'{path}' is no result of cupola-quality: it has no {missing[0]}")
    try:
        for trial in part["trials"]:
            trial_lines(trial)
    except (AttributeError, KeyError, TypeError, ValueError):
        refuse(f"'{path}' is no result of cupola-quality: its trials are none")
    return part


def settings_of(part):
    """All that parts of one report have in common, by name."""
    trials = part["trials"]
    return {
        **{key: part["machine"][key] for key in MACHINE}, **{key: part[key] for key in SETTINGS},
        "size_px": " and ".join(sorted({f"{trial['size_px']:g}" for trial in trials})),
        "methods": " and ".join(sorted({", ".join(by_name(trial)) for trial in trials})),
    }


def read_parts(paths):
    if not paths:
        refuse("allowed: FOLDER QUALITY.json...")
    parts = [(path, part) for path, part in ((path, read_part(path)) for path in paths)
             if part["trials"]]
    if not parts:
        refuse("there is no trial in these files")
    first_path, first = parts[0][0], settings_of(parts[0][1])
    for path, part in parts:
        for key, value in settings_of(part).items():
            if value != first[key]:
                refuse(f"'{path}' is no part of one report with '{first_path}': {key} is {value}, "
                       f"not {first[key]}")
    return [part for _, part in parts]


def by_name(trial):
    return {method["name"]: method for method in trial["methods"]}


def of_all(trials, name, key):
    """The mean of a method's figure over trials; None where one has none."""
    return mean(by_name(trial).get(name, {}).get(key) for trial in trials)


def added_blits(trials, name):
    warp, plain = of_all(trials, name, "warp_blits"), of_all(trials, "none", "warp_blits")
    return None if warp is None or plain is None else warp - plain


def bar_row(text, wished, found, met):
    word = "not measured" if met is None else "yes" if met else "**no**"
    return f"| {text} | {wished} | {found} | {word} |"


def least(trials, name, key, others, better):
    """Whether a method's mean is better than those of others, and all means as text."""
    means = {one: of_all(trials, one, key) for one in [name, *others]}
    text = ", ".join(f"{one} {number(value)}" for one, value in means.items())
    if None in means.values():
        return text, None
    return text, all(better(means[name], means[one]) for one in others)


def bar_lines(trials):
    here = [trial for trial in trials if trial["lens"] == LENS and trial["fov_deg"] == FOV_DEG]
    straight = [trial for trial in here if not any(trial["eye"])]
    if not here:
        return []
    rows = []
    for name, most in MOST_BLITS.items():
        added = added_blits(straight or here, name)
        rows.append(bar_row(f"{name}: blits beyond none", f"at most {most}", number(added),
                            None if added is None else added <= most))
    for text, name, key, others, better in (
            ("PSNR not below that of cone:4", ADAPTIVE, "psnr_db", [CONE], float.__ge__),
            ("PSNR above both", FOOTPRINT, "psnr_db", [CONE, ADAPTIVE], float.__gt__),
            ("shimmer below both", FOOTPRINT, "shimmer", [CONE, ADAPTIVE], float.__lt__)):
        found, met = least(here, name, key, others, better)
        rows.append(bar_row(f"{name}: {text}", "", found, met))
    dear = [trial for trial in here if trial["scene"].startswith(DEAR)] or straight or here
    for name, most in MOST_FRAME.items():
        ratios = [by_name(trial).get(name, {}).get("frame_ratio") for trial in dear]
        worst = None if None in ratios else max(ratios) - 1
        found = "–" if worst is None else f"{100 * worst:+.0f} %"
        rows.append(bar_row(f"{name}: frame time beyond none's, at most; "
                            f"{', '.join(dict.fromkeys(one['scene'] for one in dear))}",
                            f"below {100 * most:+.0f} %", found,
                            None if worst is None else worst < most))
    return [f"## What is promised, {LENS} {FOV_DEG}°", "",
            "Blits and frames with the eye in the middle, PSNR and shimmer means over all scenes "
            "and eyes.", "",
            "| promise | bar | measured | met |", "|---|---|---|---|", *rows, ""]


def method_row(name, figures, blits, added):
    cells = [name, number(figures("psnr_db")), number(figures("ssim"), 4),
             number(figures("worst_db")), number(figures("shimmer")), number(blits), number(added),
             number(figures("frame_ratio"), 3)]
    return "| " + " | ".join(cells) + " |"


HEAD = ["| method | PSNR, dB | SSIM | worst 1 %, dB | shimmer | warp, blits | beyond none "
        "| frame / none |", "|---|---|---|---|---|---|---|---|"]


def mean_lines(title, trials):
    names = [method["name"] for method in trials[0]["methods"]]
    rows = [method_row(name, lambda key, name=name: of_all(trials, name, key),
                       of_all(trials, name, "warp_blits"), added_blits(trials, name))
            for name in names]
    return [f"## {title}", "", *HEAD, *rows, ""]


def place_of(trial):
    eye = "eye in the middle" if not any(trial["eye"]) else \
        f"eye at ({', '.join(f'{part:g}' for part in trial['eye'])}) R"
    return f"{trial['size_px']:.0f} px, {trial['lens']} {trial['fov_deg']:.0f}°, {eye}"


def trial_lines(trial):
    rows = [method_row(name, method.get, method["warp_blits"], added_blits([trial], name))
            for name, method in by_name(trial).items()]
    words = []
    if trial["change"] is not None:
        words.append(f"The reference changes by {trial['change']:.2f} a step.")
    if trial["blit_ms"] is not None:
        words.append(f"A blit takes {trial['blit_ms']:.2f} ms, a frame with none "
                     f"{by_name(trial)['none']['frame_ms']:.1f} ms.")
    head = [f"### {place_of(trial)}", ""]
    return head + ([" ".join(words), ""] if words else []) + HEAD + rows + [""]


def head_lines(parts):
    part, machine = parts[0], parts[0]["machine"]
    return [
        "# How good the pictures are", "",
        "Made by `script/bench quality`; docs/quality.md says what each figure is.", "",
        f"- renderer: {machine['renderer']}, {machine['gl_version']}",
        f"- processor: {machine['processor']}; clock: {machine['clock']}; threads of llvmpipe: "
        f"{machine['llvmpipe_threads']}",
        f"- reference: {part['rays']:.0f} rays per pixel",
        f"- views: density {part['density']:g}, {part['samples']:.0f} samples per texel; table "
        f"{part['table']}",
        f"- shimmer: a turn of {part['yaw_deg']:g}° in {part['steps']:.0f} steps, "
        f"{part['shimmer_rays']:.0f} rays per pixel",
        f"- costs: medians of {part['frames']:.0f} frames", "",
    ]


def main(folder=None, *paths):
    parts = read_parts(paths)
    trials = [trial for part in parts for trial in part["trials"]]
    lines = head_lines(parts) + bar_lines(trials) + mean_lines("Means over all", trials)
    for scene in dict.fromkeys(trial["scene"] for trial in trials):
        same = [trial for trial in trials if trial["scene"] == scene]
        lines += mean_lines(f"Scene {scene}: means", same)
        for trial in same:
            lines += trial_lines(trial)
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "quality.md"), "w", encoding="utf-8") as out:
        out.write("\n".join(lines).rstrip() + "\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
