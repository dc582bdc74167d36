"""cupola-calib solve as a user meets it: files in, files out, JSON that parses, odd input refused.

solve.py CUPOLA_CALIB [--keep FOLDER]
"""
import csv
import errno
import json
import math
import os
import random
import resource
import shutil
import subprocess
import sys
import tempfile

PROGRAM = os.path.abspath(sys.argv[1])
KEEP = os.path.abspath(sys.argv[3]) if len(sys.argv) > 3 else None

START = """
screen: { radius_m = 1.5; cap_deg = 100; };
eye_m = [0.1, 0.2, 0.3];
outputs = ( { size_px = [1280, 1024]; circle = { center_px = [640, 500]; radius_px = 600; };
              lens = { model = "angular"; fov_deg = 180; }; } );
"""
POSITION = [0.15, -0.4, 0.2]
AIM_DEG = [-6, 14, 3]


def turn_back(p, axis, angle):
    u, v = (axis + 1) % 3, (axis + 2) % 3
    q = list(p)
    q[u] = math.cos(angle) * p[u] + math.sin(angle) * p[v]
    q[v] = math.cos(angle) * p[v] - math.sin(angle) * p[u]
    return q


def pixel(direction, mirrored=False):
    """An angular lens of 180 degrees at POSITION, in a screen of 1.5 m."""
    p = [1.5 * d - l for d, l in zip(direction, POSITION)]
    for axis, angle in ((1, AIM_DEG[0]), (0, AIM_DEG[1]), (2, AIM_DEG[2])):
        p = turn_back(p, axis, math.radians(angle))
    across = math.hypot(p[0], p[1])
    r = 600 * math.atan2(across, -p[2]) / (math.pi / 2)
    x = r * p[0] / across
    return 640 + (-x if mirrored else x), 500 + r * p[1] / across


def theatre(count, seed=5, noise_px=0.4, mirrored=False):
    rng = random.Random(seed)
    rows = []
    while len(rows) < count:
        angle, way = math.radians(85) * math.sqrt(rng.random()), rng.random() * 2 * math.pi
        d = [math.sin(angle) * math.cos(way), math.sin(angle) * math.sin(way), -math.cos(angle)]
        x, y = pixel(d, mirrored)
        if math.hypot(x - 640, y - 500) > 590 or not (0 < x < 1280 and 0 < y < 1024):
            continue
        rows.append(["m%d" % len(rows), x + rng.gauss(0, noise_px), y + rng.gauss(0, noise_px)] + d)
    return rows


def write_marks(name, rows, header="name,x_px,y_px,dir_x,dir_y,dir_z"):
    with open(name, "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(header.split(","))
        writer.writerows(rows)


def run(*words):
    done = subprocess.run([PROGRAM, "solve", *words], capture_output=True, text=True, timeout=60,
                          encoding="utf-8")
    assert done.returncode >= 0, (words, done)
    return done


def refused(status, said, *words):
    before = sorted(os.listdir("."))
    done = run(*words)
    assert done.returncode == status, (words, done)
    assert said in done.stderr, (said, done.stderr)
    assert done.stderr.count("\n") == 1 and done.stderr.startswith("cupola-calib solve: "), done
    assert done.stdout == "", done
    assert sorted(os.listdir(".")) == before, "files of a failure: %s" % os.listdir(".")


def near(found, wished, sds, times=5):
    for f, w, s in zip(found, wished, sds):
        assert abs(f - w) <= times * s and s > 0, (found, wished, sds)


KEYS = ["projector_position_m", "projector_position_m_sd", "projector_aim_deg",
        "projector_aim_deg_sd", "lens", "lens_sd", "circle_px", "circle_px_sd", "radius_m",
        "radius_m_sd", "flip", "residual_px", "direction_sd_deg", "marks_used", "rejected", "free",
        "warnings"]


def finds_the_projector_and_names_the_wrong():
    rows = theatre(24)
    rows[3][0] = 'left, "low" é\\'
    rows[3][1] += 80
    rows[7][1:3], rows[9][1:3] = rows[9][1:3], rows[7][1:3]
    write_marks("marks.csv", rows)
    done = run("marks.csv", "--rig", "start.cfg", "--output", "rig.cfg", "--json", "out.json",
               "--plot", "plot.png")
    assert done.returncode == 0, done
    result = json.load(open("out.json", encoding="utf-8"))
    assert list(result) == KEYS, list(result)
    near(result["projector_position_m"], POSITION, result["projector_position_m_sd"])
    near(result["projector_aim_deg"], AIM_DEG, result["projector_aim_deg_sd"])
    assert result["rejected"] == [rows[3][0], "m7", "m9"] and result["marks_used"] == 21
    assert result["lens"] == {"model": "angular", "fov_deg": 180}, result["lens"]
    assert result["lens_sd"] == {"fov_deg": 0} and result["radius_m_sd"] == 0
    assert result["circle_px"] == [640, 500, 600] and result["free"] == ["position", "aim"]
    assert 0.3 < result["residual_px"]["rms"] < 0.9, result
    assert "rejected as wrong: " + rows[3][0] + ", m7, m9" in done.stdout, done.stdout
    assert open("plot.png", "rb").read(8) == b"\x89PNG\r\n\x1a\n"
    assert open("start.cfg").read() == START
    check_rig(result)


def check_rig(result):
    """The rig that was written is what the JSON says: solved again from it, nothing changes."""
    again = run("marks.csv", "--rig", "rig.cfg", "--json", "-", "--verbose")
    assert again.returncode == 0, again
    same = json.loads(again.stdout)
    for key in ("projector_position_m", "projector_aim_deg"):
        for a, b, sd in zip(same[key], result[key], result[key + "_sd"]):
            assert abs(a - b) < 1e-3 * sd, (key, same[key], result[key])
    assert again.stderr.count("\n") > 24, "the report goes to stderr"


def in_place_keeps_what_was_there():
    write_marks("marks.csv", theatre(24))
    shutil.copy("start.cfg", "mine.cfg")
    done = run("marks.csv", "--rig", "mine.cfg", "--output", "mine.cfg")
    assert done.returncode == 0, done
    assert open("mine.cfg.bak").read() == START and "position_m" in open("mine.cfg").read()


def points_tell_the_radius():
    rows = [row[:3] + [1.5 * d for d in row[3:]] for row in theatre(12)]
    write_marks("points.csv", rows, "name,x_px,y_px,x_m,y_m,z_m")
    done = run("points.csv", "--preset", "visionstation", "--free",
               "radius,position,aim,circle,lens", "--json", "-")
    assert done.returncode == 0, done  # even from another theatre
    wide = json.loads(done.stdout)
    near(wide["projector_position_m"], POSITION, wide["projector_position_m_sd"])
    for said in ("1024x768", "points lie at one distance"):
        assert any(said in warning for warning in wide["warnings"]), wide["warnings"]
    done = run("points.csv", "--rig", "start.cfg", "--free", "radius,position,aim", "--json", "-")
    assert done.returncode == 0, done
    assert abs(json.loads(done.stdout)["radius_m"] - 1.5) < 1e-9


def a_mirrored_picture_is_told():
    write_marks("mirror.csv", theatre(16, mirrored=True))
    refused(1, "--flips", "mirror.csv", "--rig", "start.cfg", "--output", "never.cfg")
    done = run("mirror.csv", "--rig", "start.cfg", "--flips", "--json", "-")
    assert done.returncode == 0, done
    assert json.loads(done.stdout)["flip"] == "x"


def what_marks_cannot_tell_is_refused():
    write_marks("marks.csv", theatre(24))
    start = ("marks.csv", "--rig", "start.cfg", "--output", "never.cfg", "--json", "never.json",
             "--plot", "never.png")
    refused(1, "only relative to the radius", *start, "--free", "position,radius")
    refused(1, "at the centre", *start, "--free", "aim,radius")
    refused(1, "lens and circle-radius", *start, "--free", "lens,circle-radius")
    write_marks("few.csv", theatre(3))
    refused(1, "allowed: 4 at least", "few.csv", *start[1:])
    meridian = []
    for i in range(12):
        angle = math.radians(-70 + 12 * i)
        d = [math.sin(angle), 0.001, -math.cos(angle)]
        meridian.append(["m%d" % i, *pixel(d), *d])
    write_marks("meridian.csv", meridian)
    refused(1, "one meridian", "meridian.csv", *start[1:])
    rng = random.Random(1)
    write_marks("junk.csv", [["m%d" % i, rng.uniform(0, 1280), rng.uniform(0, 1024)] +
                             [rng.uniform(-1, 1) for k in range(3)] for i in range(20)])
    refused(1, "marks", "junk.csv", *start[1:])


def odd_command_lines_are_refused():
    write_marks("marks.csv", theatre(24))
    good = ("marks.csv", "--rig", "start.cfg")
    refused(2, "no marks")
    refused(2, "nothing to start from", "marks.csv")
    refused(2, "both given", *good, "--preset", "visionstation")
    refused(2, "--free: 'lense' is not allowed", *good, "--free", "aim,lense")
    refused(2, "--free: 'position' is there twice", *good, "--free", "position,aim,position")
    refused(2, "--free: '' is not allowed", *good, "--free", "")
    refused(2, "second file", *good, "other.csv")
    refused(2, "needs a value", *good, "--output")
    refused(2, "unknown option '--what'", *good, "--what")
    refused(2, "unknown option '-x'", *good, "-x")
    refused(2, "takes no value", *good, "--flips=1")
    for name in "plot.pfm", ".", "/dev/full", "-", "marks.csv", ".png", "":
        refused(2, "--plot: '%s' is not allowed; allowed: FILE.png\n" % name, *good, "--plot", name)
    refused(2, "same file", *good, "--output", "./marks.csv")
    refused(2, "same file", *good, "--output", "new.cfg", "--json", "new.cfg")
    refused(2, "same file", *good, "--json", "start.cfg")
    refused(2, "same file", *good, "--output", "start.cfg", "--json", "start.cfg.bak")
    refused(1, "projector 3", *good, "--projector", "3")
    refused(1, "absent.csv", "absent.csv", "--rig", "start.cfg")
    refused(1, "absent.cfg", "marks.csv", "--rig", "absent.cfg")
    refused(1, "--output", *good, "--output", "absent/rig.cfg")
    refused(1, "--json", *good, "--json", ".")
    refused(1, "--plot", *good, "--plot", "absent/plot.png")
    done = run("--help")
    assert done.returncode == 0 and done.stdout.startswith("Usage: cupola-calib solve"), done


def a_disk_that_fills_up_is_named():
    """Files may have 4096 bytes: the picture needs more, and nothing of it stays."""
    write_marks("marks.csv", theatre(24))
    before = sorted(os.listdir("."))
    done = subprocess.run(
        [PROGRAM, "solve", "marks.csv", "--rig", "start.cfg", "--output", "never.cfg", "--plot",
         "full.png"], capture_output=True, text=True, timeout=60, restore_signals=False,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096)))
    wished = "--plot: full.png: cannot be written: " + os.strerror(errno.EFBIG)
    assert done.returncode == 1 and wished in done.stderr, done
    assert sorted(os.listdir(".")) == before, os.listdir(".")


def files_of_a_solution_come_together():
    """JSON that does not fit leaves the rig as it was, and the other way round."""
    rows = theatre(40)
    for i in range(10):
        rows[i][0] = "%060d" % i
        rows[i][1] += 70 + 5 * i
    write_marks("marks.csv", rows)
    words = ["marks.csv", "--rig", "start.cfg", "--output", "whole.cfg", "--json", "whole.json"]
    assert run(*words).returncode == 0
    size = os.path.getsize("whole.json")
    assert os.path.getsize("whole.cfg") < size < 4096, "only the JSON is too large for less"
    for name in "whole.cfg", "whole.json":
        with open(name, "w") as file:
            file.write("as it was\n")
    before = sorted(os.listdir("."))

    def nothing_changed(done, wished):
        assert done.returncode == 1 and wished in done.stderr, done
        assert sorted(os.listdir(".")) == before, os.listdir(".")
        for name in "whole.cfg", "whole.json":
            assert open(name).read() == "as it was\n", name

    nothing_changed(
        subprocess.run([PROGRAM, "solve", *words], capture_output=True, text=True, timeout=60,
                       preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE,
                                                             (size - 1, size - 1))),
        "whole.json: cannot be written: " + os.strerror(errno.EFBIG))
    # The rig's backup would go where a folder is.
    os.mkdir("whole.cfg.bak")
    before = sorted(os.listdir("."))
    nothing_changed(run(*words), "whole.cfg.bak: is a directory")


def main():
    folder = tempfile.mkdtemp(prefix="cupola-solve-")
    try:
        os.chdir(folder)
        with open("start.cfg", "w") as file:
            file.write(START)
        finds_the_projector_and_names_the_wrong()
        if KEEP:
            shutil.copytree(".", KEEP, dirs_exist_ok=True)
        in_place_keeps_what_was_there()
        points_tell_the_radius()
        a_mirrored_picture_is_told()
        what_marks_cannot_tell_is_refused()
        odd_command_lines_are_refused()
        a_disk_that_fills_up_is_named()
        files_of_a_solution_come_together()
    finally:
        os.chdir("/")
        shutil.rmtree(folder)


main()
