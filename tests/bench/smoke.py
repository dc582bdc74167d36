"""Whether the bench works: smoke.py PROGRAM

Runs a few small frames and looks at what it writes: JSON with finite ratios, and every contender
with the right picture, at 30 dB or more against the reference. The control, which shows another
picture on purpose, must be told from it. Times are asked for nothing but being numbers.
"""

import json
import math
import subprocess
import sys

RUN = ["--family", "warp,eye,frame,views", "--load", "directions", "--size", "64", "--frames", "2",
       "--warm-up", "0"]
NO_PICTURE = {"blit", "clear", "clear-moving"}
EXIT_SKIPPED = 77


def faults_of(comparison, contender):
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
    psnr = contender["psnr_db"]
    if contender["name"] in NO_PICTURE:
        return
    if contender["name"] == "control":
        if psnr is None or psnr >= 30:
            yield f"{place}: passes for the right picture ({psnr} dB)"
    elif psnr is None or psnr <= 30:
        yield f"{place}: the wrong picture ({psnr} dB)"


ran = subprocess.run([sys.argv[1], *RUN], stdout=subprocess.PIPE, check=False)
if ran.returncode:
    sys.exit(EXIT_SKIPPED if ran.returncode == EXIT_SKIPPED else 1)
report = json.loads(ran.stdout)
print("renderer:", report["machine"]["renderer"])
families = [comparison["family"] for comparison in report["comparisons"]]
faults = [fault for comparison in report["comparisons"] for contender in comparison["contenders"]
          for fault in faults_of(comparison, contender)]
if families != ["warp", "warp", "eye", "frame", "views"]:
    faults.append(f"comparisons of {families}")
print("\n".join(faults) or "every picture is right")
sys.exit(1 if faults else 0)
