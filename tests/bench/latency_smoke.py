"""Whether the bench of latency works: latency_smoke.py PROGRAM

A few small frames: finite figures, and every frame's pixel shows the eye that it should. The
control, whose frames never get the eye, must be told from that. Times are asked for nothing but
being numbers.
"""

import json
import math
import os
import subprocess
import sys
import tempfile

from latency_report import tables

RUN = ["--size", "32,64", "--frames", "60"]
EXIT_SKIPPED = 77
FIGURES = ["lag_ms", "error_mm"]
SPREADS = ["message_ms", "age_ms", "poll_ms", "frame_ms"]


def measure(options):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "latency.json")
        ran = subprocess.run([sys.argv[1], *options, "--output", path], check=False)
        if ran.returncode:
            sys.exit(EXIT_SKIPPED if ran.returncode == EXIT_SKIPPED else 1)
        with open(path, encoding="utf-8") as file:
            return json.load(file)


def faults_in(report):
    if len(report["runs"]) != 8:
        yield f"{len(report['runs'])} runs"
    for run in report["runs"]:
        place = f"{run['size_px']} px, predicted {run['predicted']}, flood {run['flood_hz']}"
        numbers = [run[name] for name in FIGURES] + sum((run[name] for name in SPREADS), [])
        # On a machine that is busy no report may come within a few frames: then there is none.
        if run["reports"] > 0 and not all(
                number is not None and math.isfinite(number) for number in numbers):
            yield f"{place}: {run}"
        if run["unproven"] > 0.1 * run["frames"]:
            yield f"{place}: {run['unproven']} of {run['frames']} frames show another eye"
        if run["flood_hz"] and not run["flooded"]:
            yield f"{place}: no flood"


def main():
    faults = list(faults_in(measure(RUN)))
    control = measure([*RUN, "--control", "--flood", "0"])
    for run in control["runs"]:
        if run["reports"] > 0 and run["unproven"] < 0.3 * run["frames"]:
            faults.append(f"the control passes: {run}")
    faults += [] if "| 32 |" in tables(control) else ["the report has no table"]
    for fault in faults:
        print(fault)
    sys.exit(1 if faults else 0)


main()
