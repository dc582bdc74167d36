"""Windows on the second of two monitors: monitors.py CALIB DEMO.

An X server of two monitors of different sizes, without hardware. Ends with 77 where there is none.
"""

import contextlib
import os
import re
import shutil
import subprocess
import sys
import tempfile

from window import expect, next_picture, png_rows, wait_for, xdotool

SERVER = """
Section "Device"
  Identifier "none"
  Driver "dummy"
  VideoRam 65536
EndSection
Section "Screen"
  Identifier "two"
  Device "none"
  DefaultDepth 24
  SubSection "Display"
    Depth 24
    Virtual 1440 600
    Modes "800x600" "640x480"
  EndSubSection
EndSection
Section "ServerFlags"
  Option "AutoAddDevices" "false"
EndSection
"""
RIG = 'preset = "visionstation";\noutputs = ( { size_px = [800, 600]; } );\n'


@contextlib.contextmanager
def display():
    """640 x 480 at the left, 800 x 600 at the right of it."""
    with open("server.conf", "w", encoding="ascii") as file:
        file.write(SERVER)
    reading, writing = os.pipe()
    with subprocess.Popen(["Xorg", "-displayfd", str(writing), "-noreset", "-config",
                           os.path.abspath("server.conf"), "-logfile",
                           os.path.abspath("server.log"), "-novtswitch", "-sharevts",
                           "-nolisten", "tcp"],
                          pass_fds=[writing], stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL) as server:
        os.close(writing)
        try:
            with os.fdopen(reading) as number:
                line = number.readline().strip()
            if not line:
                print("skipped: no X server with monitors can be had here")
                sys.exit(77)
            os.environ["DISPLAY"] = ":" + line
            for words in (["--output", "DUMMY0", "--mode", "640x480"],
                          ["--addmode", "DUMMY1", "800x600"],
                          ["--output", "DUMMY1", "--mode", "800x600", "--pos", "640x0"],
                          # Makes the server look at what is connected.
                          ["--query"]):
                subprocess.run(["xrandr", *words], check=True, capture_output=True)
            yield
        finally:
            server.terminate()


def geometry(window):
    found = re.search(r"Position: (-?\d+),(-?\d+).*Geometry: (\d+)x(\d+)",
                      xdotool("getwindowgeometry", window), re.S)
    return tuple(map(int, found.groups())) if found else None


def place_of(window, what, wanted):
    """Windows move when the server has the time."""
    wait_for(f"{what}: {wanted}", lambda: geometry(window) == wanted)


def toggled(title, key, first, second):
    """The place of a window at first and after the key, which brings it back when pressed again."""
    window = wait_for("a window", lambda: xdotool("search", "--name", title).split())[0]
    place_of(window, "at first", first)
    xdotool("windowfocus", window)
    rows, deep = png_rows(next_picture())
    expect("width of the picture", len(rows[0]) // deep, first[2], 0)
    expect("height of the picture", len(rows), first[3], 0)
    for wanted in (second, first):
        xdotool("key", "--window", window, key)
        place_of(window, "after the key", wanted)


def refused(*command):
    done = subprocess.run(command, capture_output=True, text=True, timeout=60,
                          check=False)
    if done.returncode != 1 or not re.search(
            r"--monitor: 2 is not allowed; allowed: 0 \([^,()]+, 640 x 480 px\), "
            r"1 \([^,()]+, 800 x 600 px\)\n$", done.stderr):
        sys.exit(f"failed: {command}: {done.returncode} {done.stderr}")


def drive(calib, demo):
    tool = [calib, "right.cfg", "--output", "out.cfg", "--fresh", "--monitor"]
    show = [demo, "--rig", "right.cfg", "--monitor"]
    right = (640, 0, 800, 600)
    for command, key, more, at_first in (
            (tool, "F11", [], right),
            (tool, "F11", ["--windowed", "320x240"], (640, 0, 320, 240)),
            (show, "f", ["--fullscreen"], right),
            (show, "f", ["--size", "320x240"], (640, 0, 320, 240))):
        with subprocess.Popen([*command, "1", *more]) as running:
            try:
                toggled(os.path.basename(command[0]), key, at_first, right)
                for _ in range(2):
                    xdotool("key", "Escape")
                expect("exit status", running.wait(60), 0, 0)
            finally:
                running.kill()
    refused(*tool, "2")
    refused(*show, "2")
    for words in (["patterns", "--rig", "right.cfg", "--folder", "patterns"],
                  ["show", "--patterns", "patterns", "--monitor", "1", "--every", "0.01"]):
        subprocess.run([calib, "capture", *words], check=True, timeout=60)
    refused(calib, "capture", "show", "--patterns", "patterns", "--monitor", "2")


def main():
    if not shutil.which("Xorg") or not shutil.which("xrandr"):
        print("skipped: needs Xorg and xrandr")
        sys.exit(77)
    calib, demo = map(os.path.abspath, sys.argv[1:])
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        with open("right.cfg", "w", encoding="ascii") as file:
            file.write(RIG)
        with display():
            drive(calib, demo)
        os.chdir("/")


if __name__ == "__main__":
    main()
