"""Whether the bench of latency works: latency_smoke.py PROGRAM

A few small frames: finite figures, and every frame's pixel shows the eye that it should. Two
controls must be told from that: frames that never get the eye, and a tracker that never sends.
Times are asked for nothing but being numbers.
"""

import json
import math
import os
import subprocess
import sys
import tempfile

from latency_report import tables

RUN = ["--size", "32,64", "--frames", "300", "--rate", "500"]
EXIT_SKIPPED = 77
FIGURES = ["lag_ms", "error_mm"]
KINDS = {(predicted, flood) for predicted in (False, True) for flood in (False, True)}
SPREADS = ["message_ms", "age_ms", "poll_ms", "frame_ms"]


def refuse(word):
    sys.exit(f"{word} is no JSON")


def measure(options):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "latency.json")
        ran = subprocess.run([sys.argv[1], *options, "--output", path], check=False)
        if ran.returncode:
            sys.exit(EXIT_SKIPPED if ran.returncode == EXIT_SKIPPED else 1)
        with open(path, encoding="utf-8") as file:
            return json.load(file, parse_constant=refuse)


def silent_kinds(report, kinds):
    """On a machine that is busy no report may come within a few frames, but not in every run."""
    heard = {(run["predicted"], run["flood_hz"] > 0) for run in report["runs"] if run["reports"]}
    for predicted, flood in sorted(kinds - heard):
        yield f"predicted {predicted}, flood {flood}: no report in any run"


def faults_in(report):
    if len(report["runs"]) != 8:
        yield f"{len(report['runs'])} runs"
    for run in report["runs"]:
        place = f"{run['size_px']} px, predicted {run['predicted']}, flood {run['flood_hz']}"
        numbers = [run[name] for name in FIGURES] + sum((run[name] for name in SPREADS), [])
        if run["reports"] > 0 and not all(
                number is not None and math.isfinite(number) for number in numbers):
            yield f"{place}: {run}"
        if run["unproven"] > 0.1 * run["frames"]:
            yield f"{place}: {run['unproven']} of {run['frames']} frames show another eye"
        if run["flood_hz"] and not run["flooded"]:
            yield f"{place}: no flood"
    yield from silent_kinds(report, KINDS)


def main():
    faults = list(faults_in(measure(RUN)))
    control = measure([*RUN, "--control", "--flood", "0"])
    for run in control["runs"]:
        if run["reports"] > 0 and run["unproven"] < 0.3 * run["frames"]:
            faults.append(f"the control passes: {run}")
    silent = measure(["--size", "32", "--frames", "20", "--rate", "0", "--flood", "0"])
    if len(list(silent_kinds(silent, {(False, False), (True, False)}))) != 2:
        faults.append(f"a tracker that never sends passes: {silent['runs']}")
    if any(run["message_ms"] != [None, None] or "| - ms |" not in tables(silent)
           for run in silent["runs"]):
        faults.append(f"without a report there is a time: {silent['runs']}")
    faults += [] if "| 32 |" in tables(control) else ["the report has no table"]
    for fault in faults:
        print(fault)
    sys.exit(1 if faults else 0)


main()
