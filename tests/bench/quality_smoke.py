"""Whether the bench of pictures works: quality_smoke.py PROGRAM

Small pictures, few rays: JSON with finite figures for every method and scene, a report, and what
must be true of any: a picture of slow colours is nearly the reference whatever the method, the
finest scenes are far from it without antialiasing, and more rays bring them nearer. No times are
asked for but that they are numbers.
"""

import json
import math
import os
import subprocess
import sys
import tempfile

SMALL = ["--size", "64", "--rays", "16", "--eye", "0/0.2/-0.1", "--lens", "hemispheric:180"]
SCENES = ["zone-plate", "siemens", "checkers", "starfield"]
METHODS = ["none", "texture", "texture:9", "cone:4", "cone:16:blue-noise:turned", "adaptive",
           "footprint"]
RUN = [*SMALL, "--scene", ",".join(SCENES), "--method", ",".join(METHODS), "--steps", "2",
       "--frames", "1"]
SLOW = [*SMALL, "--scene", "directions", "--method", ",".join(METHODS), "--steps", "0",
        "--frames", "0", "--check"]
NO_MODEL = [*SMALL, "--scene", "model", "--model", "no-such-file"]
# What is refused before the first frame, whatever comes before it.
REFUSED = [["--pictures", "no-such-folder"], ["--scene", "siemens,moon"], ["--scene", "checkers:x"],
           ["--eye", "0/0/0,0.9/0.9/0.9"], ["--cut-out", "0.5,0.5,8,2"],
           ["--cut-out", "0.5,0.5,8.7,2", "--pictures", "."]]
EXIT_SKIPPED = 77
FIGURES = ["psnr_db", "ssim", "worst_db", "shimmer", "warp_ms", "warp_blits", "frame_ms",
           "frame_ratio"]


def measure(options):
    ran = subprocess.run([sys.argv[1], *options], stdout=subprocess.PIPE, check=False)
    if ran.returncode:
        sys.exit(EXIT_SKIPPED if ran.returncode == EXIT_SKIPPED else 1)
    return json.loads(ran.stdout)


def figures_of(trial):
    return {method["name"]: method for method in trial["methods"]}


def number_faults(trial):
    if list(figures_of(trial)) != METHODS:
        yield f"{trial['scene']}: methods {list(figures_of(trial))}"
    for name, method in figures_of(trial).items():
        for figure in FIGURES:
            number = method[figure]
            if number is None or not math.isfinite(number) or number <= 0:
                yield f"{trial['scene']}, {name}: {figure} is {number}"
        if not method["worst_db"] < method["psnr_db"]:
            yield f"{trial['scene']}, {name}: the worst pixels are not worse"


def picture_faults(trial):
    plain, many = (figures_of(trial)[name] for name in ("none", METHODS[4]))
    if plain["psnr_db"] > 33:
        yield f"{trial['scene']}: there is nothing to filter ({plain['psnr_db']} dB)"
    if not many["psnr_db"] > plain["psnr_db"]:
        yield f"{trial['scene']}: 16 rays are no nearer ({many['psnr_db']} dB)"


def slow_faults(trial):
    """The reference itself is right: another way finds it, but not a quarter of a pixel beside."""
    if not (trial["check_db"] > 50 and trial["check_moved_db"] < trial["check_db"] - 5):
        yield f"the reference: {trial['check_db']} dB, moved {trial['check_moved_db']} dB"
    for name, method in figures_of(trial).items():
        if not (method["psnr_db"] > 35 and method["ssim"] > 0.95):
            yield f"slow colours, {name}: {method['psnr_db']} dB, SSIM {method['ssim']}"
        if method["shimmer"] is not None or method["warp_ms"] is not None:
            yield f"slow colours, {name}: figures of what was not measured"


def report_faults(report):
    """Whether a report can be made, with a row for every method of every trial."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "quality.json")
        with open(path, "w", encoding="utf-8") as out:
            json.dump(report, out)
        script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "quality_report.py")
        if subprocess.run([sys.executable, script, folder, path], check=False).returncode:
            yield "no report can be made"
            return
        with open(os.path.join(folder, "quality.md"), encoding="utf-8") as text:
            rows = sum(line.startswith("| footprint |") for line in text)
    wished = 2 * len(SCENES) + 1
    if rows != wished:
        yield f"the report has {rows} rows of footprint, not {wished}"


def said_in_one_line(place, command, status):
    ran = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
    if ran.returncode != status or ran.stdout or ran.stderr.count(b"\n") != 1:
        yield f"{place}: status {ran.returncode}, {ran.stderr.decode()}"


def refusal_faults():
    for options in REFUSED:
        yield from said_in_one_line(options, [sys.argv[1], *options], 2)
    if os.path.exists("/dev/full"):
        full = subprocess.run([sys.argv[1], *NO_MODEL, "--output", "/dev/full"],
                              stderr=subprocess.PIPE, check=False)
        if full.returncode != 1 or b"/dev/full" not in full.stderr:
            yield f"a full disk: status {full.returncode}, {full.stderr.decode()}"


def mixture_faults(report):
    """What is no part of one report is refused in one line."""
    script = os.path.join(os.path.dirname(os.path.abspath(__file__)), "quality_report.py")
    trial = {**report["trials"][0], "size_px": 65}
    others = [{}, [], {**report, "trials": [1]}, {**report, "comparisons": [], "trials": None},
              {**report, "rays": 17}, {**report, "steps": 3}, {**report, "trials": [trial]},
              {**report, "trials": [{**trial, "size_px": 64, "methods": trial["methods"][:2]}]}]
    yield from said_in_one_line("no file", [sys.executable, script], 1)
    with tempfile.TemporaryDirectory() as folder:
        paths = [os.path.join(folder, f"{i}.json") for i in range(2)]
        for other in others:
            for path, part in zip(paths, (report, other)):
                with open(path, "w", encoding="utf-8") as out:
                    json.dump(part, out)
            yield from said_in_one_line(f"a report with {str(other)[:60]}",
                                        [sys.executable, script, folder, *paths], 1)


def faults():
    report, slow, none = measure(RUN), measure(SLOW), measure(NO_MODEL)
    print("renderer:", report["machine"]["renderer"])
    if [trial["scene"] for trial in report["trials"]] != SCENES or none["trials"]:
        yield "other trials than those that were asked for"
    for trial in report["trials"]:
        yield from number_faults(trial)
        yield from picture_faults(trial)
    for trial in slow["trials"]:
        yield from slow_faults(trial)
    yield from report_faults(report)
    yield from mixture_faults(report)
    yield from refusal_faults()


found = list(faults())
print("\n".join(found) or "every figure is there")
sys.exit(1 if found else 0)
