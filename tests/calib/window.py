"""The tool in a window under Xvfb, with the keys and the mouse of a user: window.py CALIB.

Every wait is for something that must appear, so a slow machine only takes longer.
"""

import contextlib
import glob
import os
import re
import struct
import subprocess
import sys
import tempfile
import time
import zlib

PATIENCE_S = 60


def wait_for(what, found):
    end = time.monotonic() + PATIENCE_S
    while time.monotonic() < end:
        result = found()
        if result:
            return result
        time.sleep(0.1)
    sys.exit(f"failed: waited {PATIENCE_S} s for {what}")


def xdotool(*words):
    return subprocess.run(["xdotool", *words], capture_output=True, text=True, check=False).stdout


def png_rows(path):
    """Rows of bytes and how many there are in a pixel; 8 bits a channel."""
    data = open(path, "rb").read()
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, _, color = struct.unpack(">IIBB", body[:10])
            deep = {0: 1, 2: 3, 4: 2, 6: 4}[color]
        if kind == b"IDAT":
            packed += body
        at += 12 + length
    raw, rows = zlib.decompress(packed), []
    before = bytearray(width * deep)
    for j in range(height):
        start = j * (width * deep + 1)
        how, row = raw[start], bytearray(raw[start + 1:start + 1 + width * deep])
        for i in range(len(row)):
            left = row[i - deep] if i >= deep else 0
            up = before[i]
            corner = before[i - deep] if i >= deep else 0
            guess = left + up - corner
            nearest = min((left, up, corner), key=lambda value: abs(guess - value))
            row[i] = (row[i] + (0, left, up, (left + up) // 2, nearest)[how]) & 255
        rows.append(row)
        before = row
    return rows, deep


def count_lit(path):
    rows, deep = png_rows(path)
    return len(rows[0]) // deep, len(rows), sum(
        max(row[i:i + 3]) > 60 for row in rows for i in range(0, len(row), deep))


def number(text, name, index=0):
    found = re.search(name + r" = \[?([-0-9., e]+)", text)
    return float(found.group(1).rstrip(", ").split(",")[index])


def expect(what, value, wanted, within):
    if not abs(value - wanted) <= within:
        sys.exit(f"failed: {what} is {value}, expected {wanted}")


def next_picture():
    """F12 until a picture is there: the first keys may come before the window listens."""
    there = set(glob.glob("*.png"))

    def found():
        xdotool("key", "F12")
        time.sleep(0.4)
        return set(glob.glob("*.png")) - there

    name = min(wait_for("a picture", found))
    time.sleep(0.5)
    return name


def drive(tool):
    window = wait_for("a window", lambda: xdotool("search", "--name", "cupola-calib").split())[0]
    xdotool("windowfocus", window)
    xdotool("mousemove", "--window", window, "300", "200")
    width, height, lit = count_lit(next_picture())
    expect("width of the picture", width, 640, 0)
    expect("height of the picture", height, 480, 0)
    expect("lit pixels", lit, 50000, 47000)

    # The projector: three steps to the right, one up; its aim a step and a tenth, and one undone.
    for key in "t Right Right Right Up a Right shift+Right Up ctrl+z".split():
        xdotool("key", key)
    # The image circle, with the mouse: 64 px of 640 are 102.4 of 1024.
    xdotool("key", "c")
    xdotool("mousedown", "1")
    xdotool("mousemove", "--window", window, "332", "200")
    xdotool("mousemove", "--window", window, "364", "184")
    xdotool("mouseup", "1")
    xdotool("key", "s")
    wait_for("the saved rig", lambda: os.path.exists("out.cfg"))
    text = open("out.cfg", encoding="utf-8").read()
    expect("x of the projector", number(text, "position_m", 0), 0.03, 1e-9)
    expect("y of the projector", number(text, "position_m", 1), 0.01, 1e-9)
    expect("yaw", number(text, "yaw_deg"), 0.11, 1e-6)
    expect("x of the circle", number(text, "center_px", 0), 512 + 102.4, 2)
    expect("y of the circle", number(text, "center_px", 1), 384 + 25.6, 2)

    # Beside the image, on the preview and below, a press takes nothing, even where the image was.
    for key in ("c", "p"):
        xdotool("key", key)
    time.sleep(0.5)
    for x, y in (("364", "184"), ("500", "240"), ("100", "470")):
        if x != "364":
            xdotool("mousemove", "--window", window, x, y)
        xdotool("mousedown", "1")
        xdotool("mousemove", "--window", window, "160", "240")
        xdotool("mouseup", "1")
    os.remove("out.cfg")
    for key in "pps":
        xdotool("key", key)
    wait_for("the rig saved once more", lambda: os.path.exists("out.cfg"))
    text = open("out.cfg", encoding="utf-8").read()
    expect("x of the circle", number(text, "center_px", 0), 512 + 102.4, 2)
    expect("y of the circle", number(text, "center_px", 1), 384 + 25.6, 2)

    xdotool("key", "F11")
    time.sleep(1)
    width, height, lit = count_lit(next_picture())
    expect("width of the full screen", width, 1024, 0)
    expect("height of the full screen", height, 700, 0)
    for key in ("ctrl+z", "Escape", "Escape"):
        xdotool("key", key)
    try:
        expect("exit status", tool.wait(PATIENCE_S), 0, 0)
    except subprocess.TimeoutExpired:
        sys.exit("failed: Escape does not end it")


@contextlib.contextmanager
def display():
    """A display of its own, whose number the server finds: two at a time take two."""
    reading, writing = os.pipe()
    with subprocess.Popen(["Xvfb", "-displayfd", str(writing), "-screen", "0", "1024x700x24"],
                          pass_fds=[writing], stderr=subprocess.DEVNULL) as server:
        os.close(writing)
        with os.fdopen(reading) as number:
            os.environ["DISPLAY"] = ":" + number.readline().strip()
        try:
            yield
        finally:
            server.terminate()


def main():
    calib = os.path.abspath(sys.argv[1])
    with display(), tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        with subprocess.Popen([calib, "--preset", "visionstation", "--windowed", "640x480",
                               "--output", "out.cfg", "--fresh"]) as tool:
            try:
                drive(tool)
            finally:
                tool.kill()
        os.chdir("/")


if __name__ == "__main__":
    main()
