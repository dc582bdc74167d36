"""Whether the bench works: smoke.py PROGRAM

Runs a few small frames and looks at what it writes: JSON with finite ratios, and every contender
with the right picture, at 30 dB or more against the reference. The control, which shows another
picture on purpose, must be told from it. Times are asked for nothing but being numbers. Families
that vary loads and sizes are asked for that alone, and for a report.
"""

import json
import math
import os
import subprocess
import sys
import tempfile

RUN = ["--family", "warp,eye,frame,views", "--load", "directions", "--size", "64", "--frames", "2",
       "--warm-up", "0"]
NUMBERS = ["--family", "parts,lamps,triangles,size", "--load", "directions", "--size", "32,64",
           "--frames", "1", "--warm-up", "0", "--no-quality", "--contenders",
           "blit,cupola,cupola-clear,cupola-views,cupola-warp,cupola-vertices"]
NO_PICTURE = {"blit", "blit-turned", "blit-turned-small", "clear", "clear-moving"}
EXIT_SKIPPED = 77


def number_faults(comparison, contender):
    place = f"{comparison['family']}, {contender['name']}"
    if not contender["took_part"]:
        # The others know no eye off the axis, and few views do not reach far.
        if not comparison["off_axis"] and comparison["family"] != "views":
            yield f"{place}: {contender['skipped']}"
        return
    for name in ("ratio", "ns_per_pixel"):
        number = contender[name]
        if number is None or not math.isfinite(number) or number <= 0:
            yield f"{place}: {name} is {number}"


def faults_of(comparison, contender):
    yield from number_faults(comparison, contender)
    if not contender["took_part"]:
        return
    place = f"{comparison['family']}, {contender['name']}"
    psnr = contender["psnr_db"]
    if contender["name"] in NO_PICTURE:
        return
    if contender["name"] == "control":
        if psnr is None or psnr >= 30:
            yield f"{place}: passes for the right picture ({psnr} dB)"
    elif psnr is None or psnr <= 30:
        yield f"{place}: the wrong picture ({psnr} dB)"


def measure(options):
    ran = subprocess.run([sys.argv[1], *options], stdout=subprocess.PIPE, check=False)
    if ran.returncode:
        sys.exit(EXIT_SKIPPED if ran.returncode == EXIT_SKIPPED else 1)
    return json.loads(ran.stdout)


def faults_in(report, wished, each):
    """Faults of a report that should have comparisons of these families."""
    families = [comparison["family"] for comparison in report["comparisons"]]
    if families != wished:
        yield f"comparisons of {families}"
    for comparison in report["comparisons"]:
        for contender in comparison["contenders"]:
            yield from each(comparison, contender)


def report_faults(*parts):
    """Whether one report can be made of all, with a table for each comparison."""
    with tempfile.TemporaryDirectory() as folder:
        paths = [os.path.join(folder, f"{i}.json") for i in range(len(parts))]
        for path, one in zip(paths, parts):
            with open(path, "w", encoding="utf-8") as out:
                json.dump(one, out)
        script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "report.py")
        if subprocess.run([sys.executable, script, folder, *paths], check=False).returncode:
            yield "no report can be made"
            return
        with open(os.path.join(folder, "cost.md"), encoding="utf-8") as text:
            tables = sum(line.startswith("### ") for line in text)
    wished = sum(len(one["comparisons"]) for one in parts)
    if tables != wished:
        yield f"the report has {tables} tables of {wished}"


def refusal_faults():
    """Loads that are none are refused before anything is measured, results that are none, too."""
    for load in ("ns:0", "heavy:65", "forest:1", "moon", "light,heavy:x"):
        ran = subprocess.run([sys.argv[1], "--load", load], stdout=subprocess.PIPE,
                             stderr=subprocess.PIPE, check=False)
        if ran.returncode != 2 or ran.stdout or ran.stderr.count(b"\n") != 1:
            yield f"--load {load}: status {ran.returncode}, {len(ran.stdout)} bytes, {ran.stderr}"
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "report.py")
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "none.json")
        for text in ("{}", "[]", "1", '{"machine": 1, "frames": 1, "comparisons": []}'):
            with open(path, "w", encoding="utf-8") as out:
                out.write(text)
            ran = subprocess.run([sys.executable, script, os.path.join(folder, "out"), path],
                                 stderr=subprocess.PIPE, check=False)
            if ran.returncode != 1 or ran.stderr.count(b"\n") != 1:
                yield f"report of {text}: {ran.stderr.decode()}"


pictures, numbers = measure(RUN), measure(NUMBERS)
print("renderer:", pictures["machine"]["renderer"])
faults = [
    *faults_in(pictures, ["warp", "warp", "eye", "frame", "views"], faults_of),
    *faults_in(numbers, ["parts"] * 2 + ["lamps"] * 7 + ["triangles"] * 4 + ["size"] * 2,
               number_faults),
    *report_faults(pictures, numbers),
    *refusal_faults(),
]
print("\n".join(faults) or "every picture is right")
sys.exit(1 if faults else 0)
