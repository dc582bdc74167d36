"""The tool in a window whose viewer is tracked, on a port that anybody may send to.

tracked.py CALIB

Reports move the eye, by which the preview changes, and what is no report does nothing.
"""

import glob
import os
import re
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time

from window import display, png_rows

PATIENCE_S = 60
JUNK = [b"", b"/viewer", b"#bundle\0", bytes(60000), b"\xff" * 1000, b"/viewer\0,f\0\0\0\0\0\0"]


def report(x, y, z):
    return b"/viewer\0,fff\0\0\0\0" + struct.pack(">3f", x, y, z)


def take_picture(tool):
    """
    What of the preview no text lies over. F12 until a picture is there: the first keys may come
    before the window listens.
    """
    there = set(glob.glob("*.png"))
    end = time.monotonic() + PATIENCE_S
    while time.monotonic() < end and tool.poll() is None:
        subprocess.run(["xdotool", "key", "F12"], check=True)
        time.sleep(0.5)
        new = set(glob.glob("*.png")) - there
        if new:
            time.sleep(0.5)
            rows, deep = png_rows(sorted(new)[0])
            return [bytes(row[450 * deep:690 * deep]) for row in rows[150:450]]
    sys.exit("failed: no picture")


def drive(tool):
    line = tool.stdout.readline()
    found = re.match(r"listens for /viewer on 127\.0\.0\.1:([0-9]+), head radius [0-9.]+ m$", line)
    if not found:
        sys.exit(f"failed: {line}{tool.stderr.read()}")
    sender = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    sender.connect(("127.0.0.1", int(found[1])))
    place, ends = [None], threading.Event()

    def send():
        while not ends.wait(0.005):
            for packet in JUNK + ([report(*place[0])] if place[0] else []):
                try:
                    sender.send(packet)
                except ConnectionRefusedError:
                    return

    threading.Thread(target=send, daemon=True).start()
    still = take_picture(tool)
    if take_picture(tool) != still:
        sys.exit("failed: what is no report moves something")
    place[0] = (0.2, 0.1, 0.05)
    time.sleep(1)
    moved = take_picture(tool)
    ends.set()
    if still == moved:
        sys.exit("failed: the reports move nothing")
    for _ in range(3):
        subprocess.run(["xdotool", "key", "Escape"], check=True)
        time.sleep(0.2)
    if tool.wait(PATIENCE_S) != 0:
        sys.exit(f"failed: it ends with {tool.returncode}: {tool.stderr.read()}")


def main():
    calib = os.path.abspath(sys.argv[1])
    with display(), tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        with subprocess.Popen([calib, "--windowed=700x500", "--preview", "eye", "--osc", "0",
                               "--viewer-lookahead", "30", "--fresh"], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True) as tool:
            try:
                drive(tool)
            finally:
                tool.kill()
        os.chdir("/")


main()
