"""What a terminal would obey in the name of a file is not printed by any command that is done."""
import os
import subprocess
import sys
import tempfile

program = os.path.abspath(sys.argv[1])
EVIL, SHOWN = "\x1b[31m\x07", "?[31m?"


def run(*words):
    done = subprocess.run([program, *words], capture_output=True, text=True, timeout=60,
                          encoding="utf-8")
    assert done.returncode == 0, (words, done)
    for stream in done.stdout, done.stderr:
        assert not any(ord(c) < 32 and c != "\n" for c in stream), (words, done)
    return done.stdout + done.stderr


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    with open("rig.cfg", "w", encoding="ascii") as rig:
        rig.write('outputs: ( { size_px = [200, 200]; lens: { model = "angular"; '
                  'fov_deg = 140.0; }; } );\n')
    said = run("capture", "patterns", "--rig", "rig.cfg", "--folder", EVIL + "p")
    assert "in %sp: sines of" % SHOWN in said, said
    camera = ("--rig", "rig.cfg", "--patterns", EVIL + "p", "--camera", "angular:160")
    said = run("capture", "simulate", *camera, "--photo-size", "200x200", "--folder", EVIL + "f")
    assert said.endswith("in %sf\n" % SHOWN), said
    said = run("capture", "decode", *camera, "--folder", EVIL + "f", "--output", EVIL + "m.csv")
    assert " in %sm.csv, places" % SHOWN in said, said
    # The control: the names themselves are as they were given.
    assert os.path.exists(EVIL + "m.csv")
    solve = ("solve", EVIL + "m.csv", "--rig", "rig.cfg", "--free", "aim", "--output")
    said = run(*solve, EVIL + "o.cfg")
    assert "written: %so.cfg\n" % SHOWN in said, said
    assert os.path.exists(EVIL + "o.cfg")
print("names are printed as plain text")
