"""Shows patterns on a monitor: capture_show.py CUPOLA_CALIB, under an X server of 320x240."""
import os
import subprocess
import sys
import tempfile

program = os.path.abspath(sys.argv[1])


def capture(*arguments, status=0):
    done = subprocess.run([program, "capture", *arguments], capture_output=True, text=True,
                          timeout=60, check=False)
    assert done.returncode == status, (arguments, done.returncode, done.stderr)
    return done.stdout + done.stderr


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

    # A monitor of another size, one that is not there, a camera that is not there.
    said = capture("show", "--patterns", "wider", status=1)
    assert "monitor 0 shows 320 x 240 px, and the patterns are of 400 x 240" in said, said
    said = capture("show", "--patterns", "fits", "--monitor", "7", status=1)
    assert "--monitor: 7 is not allowed" in said, said
    said = capture("show", "--patterns", "fits", "--device", "/dev/none", "--folder", "photos",
                   status=1)
    assert "/dev/none cannot be opened" in said, said
    assert os.listdir("photos") == []

    # Without a display.
    os.environ["DISPLAY"] = ""
    os.environ.pop("WAYLAND_DISPLAY", None)
    said = capture("show", "--patterns", "fits", status=1)
    assert "a window needs a display" in said, said
print("patterns are shown")
