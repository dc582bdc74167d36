"""Tables and plots of the bench's figures: report.py FOLDER COST.json...

The files are parts of one report, all from one machine and renderer. Writes FOLDER/cost.md and,
where gnuplot is installed, FOLDER/cost-*.png for what varies.
"""

import json
import os
import shutil
import subprocess
import sys

from bars import bar_lines, blits_beyond, by_name, frames_of, median_ms, memory_lines

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
    "filters": "Antialiasing, in blits",
    "frame": "Whole frames, in perspective views",
    "parts": "Where a frame's time goes",
    "lamps": "Against lamps",
    "triangles": "Against triangles",
    "views": "Against the number of views",
    "size": "Against the output's size",
}


# Their views are drawn once, and only the warp is timed.
WARPS = ("warp", "eye", "filters")


def number(value, digits=2):
    return "–" if value is None else f"{value:.{digits}f}"


def spread(quartiles):
    return f"{quartiles[0]:.2f} to {quartiles[2]:.2f}"


def heading(comparison):
    parts = [f"{comparison['size_px']} px", f"{comparison['lens']} {comparison['fov_deg']:.0f}°"]
    if comparison["off_axis"]:
        parts.append("off axis")
    if comparison["family"] not in WARPS:
        parts.append(f"load {comparison['load']}, table {comparison['table']}")
    return ", ".join(parts)


def moved(found):
    """What a moved eye adds to the warp of each stage, in warps of that stage, and to clears."""
    added = {name: found[name + "-moving"]["time_ms"][1] - rest["time_ms"][1]
             for name, rest in found.items() if name + "-moving" in found}
    warps = [f"{name} {more_ms / found[name]['time_ms'][1]:+.2f}"
             for name, more_ms in added.items() if name != "clear"]
    text = f" An eye that moved adds, in warps of the stage: {', '.join(warps)}." if warps else ""
    if "clear" in added:
        text += f" Clears and masks of its views: {added['clear']:+.2f} ms."
    return text


def in_short(comparison):
    """What the unit costs."""
    found = by_name(comparison)
    run = (f" Medians of {frames_of(comparison)}, "
           f"load average {comparison['load_average']:.1f}.")
    if "perspective" not in found:
        return f"A blit: {found['blit']['time_ms'][1]:.2f} ms.{moved(found)}{run}"
    plain = found["perspective"]
    text = (f"The perspective view of {comparison['plain_fov_deg']:.0f}°: "
            f"{plain['time_ms'][1]:.2f} ms, {plain['ns_per_pixel']:.1f} ns per pixel.")
    if comparison.get("object_radius_deg"):
        text += (f" Median of the trees' angular radii from the camera: "
                 f"{comparison['object_radius_deg']:.2f}°.")
    return text + run


def row(comparison, contender):
    if not contender["took_part"]:
        return f"| {contender['name']} | {contender['skipped']} |" + " |" * 11
    plain = comparison["contenders"][0]
    whole = contender["shows_dome"] and comparison["family"] not in WARPS + ("parts",)
    per_pixel = contender["ns_per_pixel"] / plain["ns_per_pixel"]
    cells = [
        contender["name"],
        number(contender["time_ms"][1]),
        number(contender["ratio"]),
        spread(contender["round_ratio"]),
        number(per_pixel if comparison["family"] not in WARPS else None),
        number(blits_beyond(comparison, contender["name"]) if whole else None, 1),
        str(int(contender["views"])) if contender["views"] else "–",
        number(contender["texels_per_pixel"] or None),
        number(contender["planned_texels_per_pixel"]),
        number(contender["shaded_texels_per_pixel"]),
        number(contender["bytes_per_output_byte"] or None),
        number(contender["table_bytes_per_output_byte"]),
        number(contender["psnr_db"], 1),
    ]
    return "| " + " | ".join(cells) + " |"


def table(comparison):
    unit = comparison["contenders"][0]["name"]
    lines = [
        f"### {heading(comparison)}", "", in_short(comparison), "",
        f"| contender | ms | / {unit} | quartiles by round | the same per pixel "
        "| blits beyond 1.08 | views | texels per pixel | of them planned "
        "| shaded | views' bytes / output | table's bytes | PSNR, dB |",
        "|---|---|---|---|---|---|---|---|---|---|---|---|---|",
    ]
    lines += [row(comparison, contender) for contender in comparison["contenders"]]
    return lines + [""] + model(comparison)


def model_row(comparison, name, price_ns):
    """A frame as the sum of its parts, if a texel cost what a pixel of the plain view does."""
    texels = by_name(comparison)[name]["shaded_texels_per_pixel"] * comparison["lit_pixels"]
    shading = 1e-6 * price_ns * texels
    clear, views = median_ms(comparison, f"{name}-clear"), median_ms(comparison, f"{name}-views")
    warp, whole = median_ms(comparison, "cupola-warp"), median_ms(comparison, name)
    unit, total = median_ms(comparison, "perspective"), shading + clear + warp
    cells = [shading, clear, warp, total, whole, total / unit, whole / unit,
             (views - clear) / shading]
    return "| " + " | ".join([name] + [number(cell) for cell in cells]) + " |"


def model(comparison):
    """What a frame should cost by its texels, beside what it does."""
    if comparison["family"] != "parts":
        return []
    plain, clear = (median_ms(comparison, name) for name in ("perspective", "perspective-clear"))
    names = [name for name in ("cupola", "cupola-unmasked")
             if None not in [median_ms(comparison, one) for one in
                             (name, f"{name}-clear", f"{name}-views", "cupola-warp")]]
    if plain is None or clear is None or not names:
        return []
    price_ns = 1e6 * (plain - clear) / comparison["size_px"] ** 2
    return [f"Without its clear, a pixel of the perspective view costs {price_ns:.1f} ns. "
            "The frame if a shaded texel cost the same:", "",
            "| contender | texels, ms | clear and mask, ms | warp, ms | sum, ms | measured, ms "
            "| sum / perspective | measured / perspective | a texel's price / a pixel's |",
            "|---|---|---|---|---|---|---|---|---|",
            *[model_row(comparison, name, price_ns) for name in names], ""]


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


def plain(value):
    """A number as an axis names it: 1 million, not 1e+06."""
    return f"{value / 1e6:g} million" if value >= 1e6 else f"{value:g}"


def plot(family, comparisons, path):
    """Whether there was anything to plot."""
    axis, logarithmic = AXES[family]
    lines = points(family, comparisons)
    if not lines:
        return False
    values = sorted({x for line in lines.values() for x, _ in line})
    script = ["set terminal pngcairo size 560,340 font 'sans,10'",
              f"set output '{path}'", "set key outside right", "set grid", "set yrange [0:*]",
              f"set xrange [{values[0]}:{values[-1]}]", "set linetype 9 linecolor rgb '#806040'",
              f"set xlabel '{axis}'", "set ylabel 'frame / perspective view'"]
    if logarithmic:
        script.append("set logscale x")
        if len(values) <= 8:
            labels = ", ".join(f"'{plain(value)}' {value}" for value in values)
            script.append(f"set xtics ({labels})")
    script.append("plot " + ", ".join(f"'-' with linespoints title '{name}'" for name in lines))
    for line in lines.values():
        script += [f"{x} {y}" for x, y in sorted(line)] + ["e"]
    subprocess.run(["gnuplot"], input="\n".join(script) + "\n", text=True, check=True)
    return True


# What the parts of a report have in common.
MACHINE = ("renderer", "processor", "clock", "llvmpipe_threads")


def read_part(path):
    """What one run of the bench wrote."""
    try:
        with open(path, encoding="utf-8") as source:
            part = json.load(source)
    except (OSError, ValueError) as error:
        sys.exit(f"report.py: '{path}' is no whole result: {error}")
    keys = set(part) if isinstance(part, dict) else set()
    machine = part["machine"] if "machine" in keys else None
    missing = sorted({"machine", "frames", "comparisons"} - keys) or sorted(
        set(MACHINE) - set(machine if isinstance(machine, dict) else ()))
    if missing:
        sys.exit(f"report.py: '{path}' is no result of cupola-bench: it has no {missing[0]}")
    return part


def read_parts(paths):
    """One report of several, in which each comparison knows its number of frames."""
    if not paths:
        sys.exit("report.py: allowed: FOLDER COST.json...")
    parts = [read_part(path) for path in paths]
    for key in MACHINE:
        found = {part["machine"][key] for part in parts}
        if len(found) > 1:
            sys.exit(f"report.py: parts of different {key}: {', '.join(sorted(found))}")
    for part in parts:
        for comparison in part["comparisons"]:
            comparison["frames"] = part["frames"]
    return {"machine": parts[0]["machine"],
            "comparisons": [one for part in parts for one in part["comparisons"]]}


def fill_quality(comparisons):
    """Where no pictures were compared: what they were at the same setting elsewhere."""
    keys = ("size_px", "lens", "fov_deg", "off_axis", "load", "table")
    known = {}
    for one in comparisons:
        for name, contender in by_name(one).items():
            if contender["psnr_db"] is not None:
                known.setdefault((name, *(one[key] for key in keys)), contender["psnr_db"])
    for one in comparisons:
        for name, contender in by_name(one).items():
            if contender["psnr_db"] is None:
                contender["psnr_db"] = known.get((name, *(one[key] for key in keys)))


def machine_lines(machine):
    return [
        "# What a dome costs", "",
        "Made by `script/bench`; docs/benchmarks.md says what each figure is.",
        "",
        f"- renderer: {machine['renderer']}, {machine['gl_version']}",
        f"- processor: {machine['processor']}, {machine['processors']:.0f} of them",
        f"- clock: {machine['clock']}; threads of llvmpipe: {machine['llvmpipe_threads']}",
        "",
    ]


def main(folder, *paths):
    report = read_parts(paths)
    os.makedirs(folder, exist_ok=True)
    fill_quality(report["comparisons"])
    lines = (machine_lines(report["machine"]) + bar_lines(report["comparisons"])
             + memory_lines(report["comparisons"]))
    for family, title in TITLES.items():
        comparisons = [one for one in report["comparisons"] if one["family"] == family]
        if not comparisons:
            continue
        lines += [f"## {title}", ""]
        picture = os.path.join(folder, f"cost-{family}.png")
        if family in AXES and shutil.which("gnuplot") and plot(family, comparisons, picture):
            lines += [f"![{title}](cost-{family}.png)", ""]
        for comparison in comparisons:
            lines += table(comparison)
    with open(os.path.join(folder, "cost.md"), "w", encoding="utf-8") as out:
        out.write("\n".join(lines).rstrip() + "\n")


main(*sys.argv[1:])
