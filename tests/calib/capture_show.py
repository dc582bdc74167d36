"""Shows patterns on a monitor: capture_show.py CUPOLA_CALIB, under an X server of 320x240."""
import os
import signal
import subprocess
import sys
import tempfile
import time

program = os.path.abspath(sys.argv[1])


def capture(*arguments, status=0):
    done = subprocess.run([program, "capture", *arguments], capture_output=True, text=True,
                          timeout=60, check=False)
    assert done.returncode == status, (arguments, done.returncode, done.stderr)
    return done.stdout + done.stderr


def expects_signals(process):
    """Whether it handles SIGINT and SIGTERM by now."""
    wanted = 1 << signal.SIGINT - 1 | 1 << signal.SIGTERM - 1
    with open("/proc/%d/status" % process.pid, encoding="ascii") as file:
        caught = [line.split()[1] for line in file if line.startswith("SigCgt:")]
    return int(caught[0], 16) & wanted == wanted


def interrupted(number, *arguments):
    """What is said after a signal while a pattern stands."""
    with subprocess.Popen([program, "capture", "show", "--patterns", "fits", *arguments],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as shows:
        try:
            while shows.poll() is None and not expects_signals(shows):
                time.sleep(0.05)
            time.sleep(0.5)  # the window opens; right either way
            shows.send_signal(number)
            said = shows.communicate(timeout=30)[0]
        finally:
            shows.kill()
    assert shows.returncode == 0, (number, shows.returncode, said)
    return said


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    for name, size in ("fits", "320, 240"), ("wider", "400, 240"):
        with open(name + ".cfg", "w", encoding="ascii") as rig:
            rig.write("outputs: ( { size_px = [%s]; } );\n" % size)
        capture("patterns", "--rig", name + ".cfg", "--folder", name)

    # All of the monitor, and a window.
    said = capture("show", "--patterns", "fits", "--every", "0.01")
    assert said.startswith("32 of 32 patterns shown"), said
    capture("show", "--patterns", "fits", "--every", "0.01", "--window")

    # Nobody presses a key, or the next pattern is far off: a signal ends either.
    for number in signal.SIGINT, signal.SIGTERM:
        assert interrupted(number).startswith("0 of 32 patterns shown")
        assert interrupted(number, "--every", "600").startswith("0 of 32 patterns shown")

    # A monitor of another size, one that is not there, a camera that is not there.
    said = capture("show", "--patterns", "wider", status=1)
    assert "monitor 0 shows 320 x 240 px, and the patterns are of 400 x 240" in said, said
    said = capture("show", "--patterns", "fits", "--monitor", "7", status=1)
    assert "--monitor: 7 is not allowed" in said, said
    for device in "/dev/none", "/dev/null":
        said = capture("show", "--patterns", "fits", "--device", device, "--folder", "photos",
                       status=1)
        assert device + " cannot be opened" in said, said
        assert not os.path.exists("photos")

    # Without a display.
    os.environ["DISPLAY"] = ""
    os.environ.pop("WAYLAND_DISPLAY", None)
    said = capture("show", "--patterns", "fits", status=1)
    assert "a window needs a display" in said, said
print("patterns are shown")
