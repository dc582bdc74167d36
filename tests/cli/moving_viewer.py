"""Whether a tracker moves the viewer, and nobody else harms a frame: moving_viewer.py PROGRAM

Runs the demo without a window and sends it packets over UDP while it draws: reports of the eye, and
what is none. It has to end well, to have counted each kind, and to have drawn what that eye sees.
"""

import array
import json
import os
import random
import re
import socket
import struct
import subprocess
import sys
import tempfile
import threading

PROGRAM = os.path.abspath(sys.argv[1])
EXIT_SKIPPED = 77
ENVIRONMENT = {key: value for key, value in os.environ.items()
               if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
SECOND = 1 << 32
NOW = 4_000_000_000 * SECOND


def text(letters):
    padded = letters.encode() + b"\0"
    return padded + b"\0" * (-len(padded) % 4)


def report(x, y, z, path="/viewer"):
    return text(path) + text(",fff") + struct.pack(">3f", x, y, z)


def bundle(tag, *elements):
    return text("#bundle") + struct.pack(">Q", tag) + b"".join(
        struct.pack(">I", len(element)) + element for element in elements)


def nested(depth):
    packet = report(0.05, 0, 0)
    for _ in range(depth):
        packet = bundle(1, packet)
    return packet


GOOD = [report(0.01, 0, 0), bundle(1, report(9, 9, 9), report(0.02, 0, 0)), nested(3),
        text("/viewer") + text(",dih") + struct.pack(">diq", 0.03, 0, 0),
        bundle(NOW + 3600 * SECOND, report(0.04, 0, 0)), bundle(NOW, report(0.05, 0, 0))]
LATE = [bundle(NOW - SECOND // 2, report(0.1, 0.1, 0.1))]
REFUSED = [report(float("nan"), 0, 0), report(0, float("inf"), 0), report(1e30, 0, 0)]
OTHERS = [report(0, 0, 0, "/head"), text("/viewer") + text(",ff") + bytes(8),
          text("/viewer") + text(",s") + text("0 0 0"), text("/viewer") + text(",")]
MALFORMED = [b"", b"/viewer", report(1, 2, 3)[:-4], report(1, 2, 3)[:-1], nested(40),
             bundle(1, report(0, 0, 0)) + b"\xff\xff\xff\xfc", b"#bundle\0", bytes(64),
             bundle(1, *[report(0, 0, 0)] * 65), b"\xff" * 1000]


CONTRADICTIONS = [
    ("--osc 0 --eye-circle 0.1", "both move the eye"),
    ("--viewer-lookahead 5", "needs --osc"),
    ("--osc 0 --viewer-lookahead 501", "'501'"),
    ("--osc 0 --perspective --fov 90", "belong to the dome's views"),
    ("--osc 0 --reference 4", "wants an eye that rests"),
    ("--osc localhost", "'localhost' is not allowed"),
    ("--osc 192.0.2.1:9000", "cannot be listened on"),
]


class Demo:
    """A run that draws frames and listens, until `wait`."""

    def __init__(self, folder, frames, more=()):
        self.stats = os.path.join(folder, "stats.json")
        self.process = subprocess.Popen(
            [PROGRAM, "--headless", "--size", "48x48", "--fov", "140", "--frames", str(frames),
             "--osc", "0", "--head-radius", "0.3", "--stats", self.stats, *more],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=folder, env=ENVIRONMENT)
        line = self.process.stdout.readline()
        found = re.search(r" on 127\.0\.0\.1:([0-9]+),", line)
        if not found:
            _, said = self.process.communicate(timeout=60)
            print(f"{line}{said}")
            sys.exit(EXIT_SKIPPED if "EGL" in said else 1)
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.connect(("127.0.0.1", int(found[1])))

    def send(self, packets):
        """Whether the run still goes on after the last of them."""
        for packet in packets:
            try:
                self.socket.send(packet)
            except ConnectionRefusedError:
                return False
        return self.process.poll() is None

    def keep_sending(self, choose):
        """Whatever `choose` gives, as fast as it can be sent, until the run ends; how many."""
        def work():
            self.sent = 0
            while self.send([choose()]):
                self.sent += 1

        self.sender = threading.Thread(target=work)
        self.sender.start()

    def wait(self):
        _, said = self.process.communicate(timeout=200)
        if hasattr(self, "sender"):
            self.sender.join()
        self.socket.close()
        if self.process.returncode != 0:
            sys.exit(f"the demo ended with {self.process.returncode}: {said}")
        with open(self.stats, encoding="utf-8") as file:
            return json.load(file)["viewer_reports"]


def count_faults(folder):
    """Each kind once, in an order in which none is late but one; what ended too early is redone."""
    frames = 400
    while True:
        demo = Demo(folder, frames)
        whole = demo.send(GOOD + LATE + REFUSED + OTHERS + MALFORMED)
        # What was sent before the run ended may yet have come after its last frame.
        whole = whole and demo.send([]) and not demo_ends_within(demo, 0.05)
        counts = demo.wait()
        if whole:
            break
        frames *= 4
    wished = {"packets": sum(map(len, (GOOD, LATE, REFUSED, OTHERS, MALFORMED))),
              "taken": len(GOOD), "refused": len(REFUSED), "late": len(LATE),
              "malformed": len(MALFORMED), "others": len(OTHERS)}
    if {**counts, "lost": 0} != {**wished, "lost": 0}:
        yield f"of {wished} it counts {counts}"


def demo_ends_within(demo, seconds):
    try:
        demo.process.wait(seconds)
        return True
    except subprocess.TimeoutExpired:
        return False


def read_pfm(path):
    with open(path, "rb") as file:
        parts = file.read().split(b"\n", 3)
    numbers = array.array("f", parts[3])
    if (float(parts[2]) > 0) != (sys.byteorder == "big"):
        numbers.byteswap()
    return numbers


def difference(one, other):
    return sum(abs(a - b) for a, b in zip(one, other)) / len(one)


def picture_of(folder, options):
    path = os.path.join(folder, "still.pfm")
    subprocess.run([PROGRAM, "--headless", "--size", "48x48", "--fov", "140", "--scene",
                    "directions", "--output", path, *options], check=True, env=ENVIRONMENT,
                   stdout=subprocess.DEVNULL)
    return read_pfm(path)


def picture_faults(folder):
    """The directions that are drawn are those that the reported eye sees."""
    place = (0.125, -0.0625, 0.1875)
    path = os.path.join(folder, "moved.pfm")
    demo = Demo(folder, 400, ["--scene", "directions", "--output", path])
    demo.keep_sending(lambda: report(*place))
    demo.wait()
    moved = read_pfm(path)
    there = picture_of(folder, ["--viewer", ",".join(map(str, place))])
    home = picture_of(folder, [])
    if not difference(moved, there) < 2e-3:
        yield f"the picture is {difference(moved, there)} off that of the same eye at rest"
    if not difference(moved, home) > 2e-2:
        yield f"the picture is {difference(moved, home)} off that of the eye that was not moved"


def flood_faults(folder):
    """As fast as Python sends, of every kind, with random bytes in between."""
    chance = random.Random(3)
    kinds = GOOD + LATE + REFUSED + OTHERS + MALFORMED
    huge = [bundle(1, *[text("/a")] * 8000), bytes(65000), nested(3000)]

    def choose():
        if chance.random() < 0.02:
            return chance.choice(huge)
        packet = bytearray(chance.choice(kinds))
        if packet and chance.random() < 0.5:
            packet[chance.randrange(len(packet))] = chance.randrange(256)
        return bytes(packet)

    demo = Demo(folder, 400)
    demo.keep_sending(choose)
    counts = demo.wait()
    print(f"a flood of {demo.sent}: {counts}")
    for kind, least in (("packets", 50), ("taken", 1), ("malformed", 1), ("others", 1)):
        if counts[kind] < least:
            yield f"of a flood of {demo.sent} it counts {counts}"
    if counts["packets"] > demo.sent + 1:
        yield f"it counts more than the {demo.sent} that were sent: {counts}"


def contradiction_faults(folder):
    for options, wished in CONTRADICTIONS:
        done = subprocess.run([PROGRAM, "--headless", *options.split()], capture_output=True,
                              text=True, cwd=folder, env=ENVIRONMENT, check=False)
        if done.returncode not in (1, 2) or done.stdout or wished not in done.stderr:
            yield f"{options}: {done.returncode}, {done.stderr}"


def main():
    faults = []
    with tempfile.TemporaryDirectory() as folder:
        for check in (contradiction_faults, count_faults, picture_faults, flood_faults):
            faults += check(folder)
    for fault in faults:
        print(fault)
    sys.exit(1 if faults else 0)


main()
