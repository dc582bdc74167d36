"""Tables and plots of the bench's figures: report.py FOLDER COST.json...

The files are parts of one report, all from one machine and renderer. Writes FOLDER/cost.md and,
where gnuplot is installed, FOLDER/cost-*.png for what varies.
"""

import json
import os
import shutil
import subprocess
import sys

# What is drawn of each family that varies one thing: its axis, and whether that is logarithmic.
AXES = {
    "lamps": ("lamps", True),
    "triangles": ("triangles", True),
    "size": ("side of the output, px", True),
    "views": ("views", False),
}
DRAWN = ["cupola", "cupola-vertices", "cupola-3-views", "cupola-5-views", "control",
         "four-faces", "six-faces", "six-faces-mesh", "three-frusta"]
TITLES = {
    "warp": "The warp alone, in blits",
    "eye": "A viewer who moves, in blits",
    "frame": "Whole frames, in perspective views",
    "lamps": "Against lamps",
    "triangles": "Against triangles",
    "views": "Against the number of views",
    "size": "Against the output's size",
}


# Their views are drawn once, and only the warp is timed.
WARPS = ("warp", "eye")


def number(value, digits=2):
    return "–" if value is None else f"{value:.{digits}f}"


def spread(quartiles):
    return f"{quartiles[0]:.2f} to {quartiles[2]:.2f}"


def by_name(comparison):
    return {one["name"]: one for one in comparison["contenders"] if one["took_part"]}


def heading(comparison):
    parts = [f"{comparison['size_px']} px", f"{comparison['lens']} {comparison['fov_deg']:.0f}°"]
    if comparison["off_axis"]:
        parts.append("off axis")
    if comparison["family"] not in WARPS:
        parts.append(f"load {comparison['load']}, table {comparison['table']}")
    return ", ".join(parts)


def moved(found):
    """What a moved eye adds to the warp of each stage, in warps of that stage."""
    added = [f"{name} {found[name + '-moving']['time_ms'][1] / rest['time_ms'][1] - 1:+.2f}"
             for name, rest in found.items() if name + "-moving" in found]
    return f" An eye that moved adds, in warps of the stage: {', '.join(added)}." if added else ""


def in_short(comparison):
    """What the plain view costs, and the dome's frame as plain views and blits."""
    found = by_name(comparison)
    run = (f" Medians of {comparison['frames']} frames, "
           f"load average {comparison['load_average']:.1f}.")
    if "perspective" not in found:
        return f"A blit: {found['blit']['time_ms'][1]:.2f} ms.{moved(found)}{run}"
    plain = found["perspective"]
    text = (f"The perspective view of {comparison['plain_fov_deg']:.0f}°: "
            f"{plain['time_ms'][1]:.2f} ms, {plain['ns_per_pixel']:.1f} ns per pixel.")
    if "cupola" in found and "blit" in found:
        rest = found["cupola"]["time_ms"][1] - 1.08 * plain["time_ms"][1]
        blits = rest / found["blit"]["time_ms"][1]
        text += f" Cupola's frame: 1.08 perspective views {'+-'[blits < 0]} {abs(blits):.1f} blits."
    return text + run


def row(comparison, contender):
    if not contender["took_part"]:
        return f"| {contender['name']} | {contender['skipped']} |" + " |" * 8
    plain = comparison["contenders"][0]
    per_pixel = contender["ns_per_pixel"] / plain["ns_per_pixel"]
    cells = [
        contender["name"],
        number(contender["time_ms"][1]),
        number(contender["ratio"]),
        spread(contender["round_ratio"]),
        number(per_pixel if comparison["family"] not in WARPS else None),
        str(int(contender["views"])) if contender["views"] else "–",
        number(contender["texels_per_pixel"] or None),
        number(contender["masked_texels_per_pixel"]),
        number(contender["bytes_per_output_byte"] or None),
        number(contender["psnr_db"], 1),
    ]
    return "| " + " | ".join(cells) + " |"


def table(comparison):
    unit = comparison["contenders"][0]["name"]
    lines = [
        f"### {heading(comparison)}", "", in_short(comparison), "",
        f"| contender | ms | / {unit} | quartiles by round | the same per pixel | views | "
        "texels per pixel | of them needed | memory / output | PSNR, dB |",
        "|---|---|---|---|---|---|---|---|---|---|",
    ]
    lines += [row(comparison, contender) for contender in comparison["contenders"]]
    return lines + [""]


def points(family, comparisons):
    """Name of a line -> its (x, y)."""
    lines = {}
    for comparison in comparisons:
        for name, contender in by_name(comparison).items():
            if family == "views" and name != "perspective":
                line, x = comparison["load"], contender["views"]
            elif name in DRAWN:
                line, x = name, comparison["value"]
            else:
                continue
            lines.setdefault(line, []).append((x, contender["ratio"]))
    return lines


def plot(family, comparisons, path):
    axis, logarithmic = AXES[family]
    lines = points(family, comparisons)
    script = ["set terminal pngcairo size 560,340 font 'sans,10'",
              f"set output '{path}'", "set key outside right", "set grid", "set yrange [0:*]",
              "set autoscale xfix", "set linetype 9 linecolor rgb '#806040'",
              f"set xlabel '{axis}'", "set ylabel 'frame / perspective view'"]
    if logarithmic:
        script.append("set logscale x")
    script.append("plot " + ", ".join(f"'-' with linespoints title '{name}'" for name in lines))
    for line in lines.values():
        script += [f"{x} {y}" for x, y in sorted(line)] + ["e"]
    subprocess.run(["gnuplot"], input="\n".join(script) + "\n", text=True, check=True)


def read_parts(paths):
    """One report of several, in which each comparison knows its number of frames."""
    parts = []
    for path in paths:
        with open(path, encoding="utf-8") as source:
            parts.append(json.load(source))
    for key in ("renderer", "processor", "clock", "llvmpipe_threads"):
        found = {part["machine"][key] for part in parts}
        if len(found) > 1:
            sys.exit(f"report.py: parts of different {key}: {', '.join(sorted(found))}")
    for part in parts:
        for comparison in part["comparisons"]:
            comparison["frames"] = part["frames"]
    return {"machine": parts[0]["machine"],
            "comparisons": [one for part in parts for one in part["comparisons"]]}


def machine_lines(machine):
    return [
        "# What a dome costs", "",
        "Made by `script/bench cost`; docs/benchmarks.md says what each figure is.",
        "",
        f"- renderer: {machine['renderer']}, {machine['gl_version']}",
        f"- processor: {machine['processor']}, {machine['processors']:.0f} of them",
        f"- clock: {machine['clock']}; threads of llvmpipe: {machine['llvmpipe_threads']}",
        "",
    ]


def main(folder, *paths):
    report = read_parts(paths)
    os.makedirs(folder, exist_ok=True)
    lines = machine_lines(report["machine"])
    for family, title in TITLES.items():
        comparisons = [one for one in report["comparisons"] if one["family"] == family]
        if not comparisons:
            continue
        lines += [f"## {title}", ""]
        if family in AXES and shutil.which("gnuplot"):
            plot(family, comparisons, os.path.join(folder, f"cost-{family}.png"))
            lines += [f"![{title}](cost-{family}.png)", ""]
        for comparison in comparisons:
            lines += table(comparison)
    with open(os.path.join(folder, "cost.md"), "w", encoding="utf-8") as out:
        out.write("\n".join(lines).rstrip() + "\n")


main(*sys.argv[1:])
