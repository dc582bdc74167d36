"""Whether --report writes what it should, for rigs of many kinds: report.py PROGRAM

JSON that parses, finite numbers alone, a unit in every key, spreads in order, parts that add up to
the whole, an advice that is true once it is followed. The control shows that a report with a fault
is told from one without.
"""

import json
import math
import os
import re
import subprocess
import sys
import tempfile

TWO = ("screen = { radius_m = 2, cap_deg = 80 }\n"
       "outputs = ({ size_px = (90, 70), aim: { yaw_deg = 30 }, lens: { fov_deg = 120 } },\n"
       "{ size_px = (80, 80), aim: { yaw_deg = -30 }, position_m = (0.2, 0, 0.1) })\n")
UNLIT = ("screen = { radius_m = 1, cap_deg = 40 }\n"
         "outputs = ({ size_px = (60, 60), lens: { fov_deg = 60 } },\n"
         "{ size_px = (60, 60), aim: { yaw_deg = 180 }, lens: { fov_deg = 60 } })\n")
TABLE = "angle_deg,radius\n0,0\n30,0.4\n60,0.75\n85,1\n"
RIGS = [
    "--size 100x100",
    "--size 100x100 --lens hemispheric",
    "--size 100x100 --lens hemispheric --fov 140 --viewer 0,0.2,-0.1",
    "--size 100x100 --lens angular --fov 360",
    "--size 100x100 --lens equisolid --fov 320",
    "--size 100x100 --lens stereographic --fov 250 --flip xy",
    "--size 100x100 --lens-k 1,-0.05",
    "--size 100x100 --lens-table lens.csv",
    "--size 100x100 --fov 1",
    "--size 120x75 --preset visionstation --viewer 0,0.1,0.25 --projector 0,-0.25,0",
    "--preset truncated-16x10 --size 120x75",
    "--preset domemaster --size 64x64 --density 2.5",
    "--size 100x100 --layout asymmetric --views 3 --fov 120 --view-size 40",
    "--size 100x100 --fov 140 --head-radius 0.3",
    "--size 1x1", "--size 3x2", "--size 100x100 --circle 50,50,20 --mask none --guard 9",
    "--rig two.cfg", "--rig unlit.cfg",
]
UNITS = re.compile(r".*(_px|_deg|_m|texels|_texels|sampled|share_never_sampled)$")
PLAIN = {"min", "median", "max", "output", "view", "x_px", "y_px", "outputs", "views", "advice",
         "coarsest", "finest"}
SPREADS = re.compile(r"texels_per_px_.*|pixels_per_deg")


def refuse(text):
    raise ValueError(f"{text} is no JSON")


def run(program, words):
    done = subprocess.run([program, *words.split()], capture_output=True, text=True, timeout=60)
    if done.returncode != 0:
        raise RuntimeError(f"{words}: {done.stderr}")
    return done.stdout


def walk(value, key):
    if isinstance(value, dict):
        for name, inner in value.items():
            if name not in PLAIN and not UNITS.fullmatch(name) and not SPREADS.fullmatch(name):
                yield f"{name} has no unit"
            if isinstance(inner, dict) and SPREADS.fullmatch(name):
                if not 0 <= inner["min"] <= inner["median"] <= inner["max"]:
                    yield f"{name} is not in order: {inner}"
            yield from walk(inner, name)
    elif isinstance(value, list):
        for inner in value:
            yield from walk(inner, key)
    elif isinstance(value, str):
        if key != "advice" or not 0 < len(value) < 320:
            yield f"{key} is a strange text: {value}"
    elif not math.isfinite(value):
        yield f"{key} is {value}"


def sums(report):
    for output in report["outputs"]:
        seen = sum(view["lit_px"] for view in output["views"])
        if abs(seen - output["lit_px"]) > 1e-4 * max(seen, 1):
            yield f"views have {seen} px of {output['lit_px']}"
    for key in "texels", "texels_never_sampled":
        if sum(view[key] for view in report["views"]) != report[key]:
            yield f"{key} of views are not those of all"
    for part in [report, *report["views"]]:
        share = part["texels_never_sampled"] / part["texels"]
        if not 0 <= share <= 1 or abs(share - part["share_never_sampled"]) > 1e-5:
            yield f"the share is {part['share_never_sampled']}, not {share}"


def faults(report):
    yield from walk(report, "")
    yield from sums(report)


def parse(text):
    return json.loads(text, parse_constant=refuse)


def check_rigs(program):
    for words in RIGS:
        text = run(program, words + " --report -")
        report = parse(text)
        for fault in faults(report):
            yield f"{words}: {fault}"
        if run(program, words + " --report x.json") or open("x.json").read() != text:
            yield f"{words}: the file is not what goes to stdout"
    report = parse(run(program, "--rig unlit.cfg --report -"))
    advice = [output["advice"] for output in report["outputs"]]
    if advice[1] != "no pixel is lit" or "match" not in advice[0]:
        yield f"an output that is not lit: {advice}"
    if len(parse(run(program, "--rig two.cfg --report -"))["outputs"]) != 2:
        yield "two outputs are not two"


def check_advice(program):
    """Views of 333 texels: what the advice says is finer, and followed it matches."""
    words = "--size 100x100 --lens equisolid --fov 150 --views 5 --report - --view-size "
    advice = parse(run(program, words + "333"))["advice"]
    found = re.match(r"views are ([\d.]+)x finer than the projector can show: (\d+) px would do",
                     advice)
    if not found:
        yield f"the advice is: {advice}"
        return
    if abs(float(found[1]) - 333 / int(found[2])) > 0.02 * float(found[1]):
        yield f"{found[1]} is not 333 / {found[2]}"
    followed = parse(run(program, words + found[2]))["advice"]
    if not followed.startswith("views and projector match"):
        yield f"followed: {followed}"
    wide = parse(run(program, "--size 200x200 --fov 340 --report -"))
    least = min(view["texels_per_px_along_least"]["min"] for view in wide["outputs"][0]["views"])
    if f"lost: {least:.2g} texels per pixel" not in wide["advice"]:
        yield f"{least} texels per pixel near the rim, and: {wide['advice']}"


def check_control(program):
    report = parse(run(program, RIGS[0] + " --report -"))
    report["texels"] += 1
    report["outputs"][0]["pixels_per_deg"]["median"] = 1e9
    report["outputs"][0]["lit"] = math.inf
    if len(list(faults(report))) < 4:
        yield "faults are not told"


def check_drawing(program):
    """With --output the picture is drawn, too; what it has to say goes to stderr."""
    parse(run(program, "--size 40x40 --report - --headless"))
    if not os.path.exists("dome.png"):
        yield "nothing was drawn"


def main():
    program = os.path.abspath(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for name, text in ("two.cfg", TWO), ("unlit.cfg", UNLIT), ("lens.csv", TABLE):
            with open(name, "w") as file:
                file.write(text)
        found = [fault for check in (check_rigs, check_advice, check_control, check_drawing)
                 for fault in check(program)]
        os.chdir("/")
    print("\n".join(found) or f"{len(RIGS)} rigs, no fault")
    return 1 if found else 0


sys.exit(main())
