"""Tables of the bench of latency: latency_report.py FILE.json...

Of several reports each setting has the run with the shortest frames: the one that whatever else the
machine did has disturbed the least.
"""

import json
import sys

HEAD = """| size, px | reports | port | message to picture | 95 % | newest shown \
| picture behind head | error | poll, 95 % | frame | lost |
|---|---|---|---|---|---|---|---|---|---|---|
"""


def number(value, digits=1):
    return "-" if value is None else f"{value:.{digits}f}"


def row(run):
    return " | ".join([
        f"| {run['size_px']}", "predicted" if run["predicted"] else "as they are",
        f"{run['flood_hz']:.0f}/s more" if run["flood_hz"] else "quiet",
        number(run["message_ms"][0]) + " ms", number(run["message_ms"][1]) + " ms",
        number(run["age_ms"][0]) + " ms", number(run["lag_ms"]) + " ms",
        number(run["error_mm"]) + " mm", number(run["poll_ms"][1], 2) + " ms",
        number(run["frame_ms"][0]) + " ms", f"{run['lost']} of {run['reports']} |"])


def tables(report):
    machine = report["machine"]
    proven = sum(run["frames"] - run["unproven"] for run in report["runs"])
    frames = sum(run["frames"] for run in report["runs"])
    return (f"{machine['renderer']}, {machine['processors']:.0f} processors, load average "
            f"{machine['load_average']}; reports {report['runs'][0]['rate_hz']:.0f} times a "
            f"second; {proven} of {frames} frames show the eye that they should\n\n{HEAD}"
            + "\n".join(map(row, report["runs"])) + "\n")


def least_disturbed(reports):
    best = {}
    for report in reports:
        for run in report["runs"]:
            setting = (run["size_px"], run["flood_hz"], run["predicted"])
            if setting not in best or run["frame_ms"][0] < best[setting]["frame_ms"][0]:
                best[setting] = run
    return {"machine": reports[0]["machine"], "runs": [best[key] for key in sorted(best)]}


def read(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


if __name__ == "__main__":
    print(tables(least_disturbed([read(path) for path in sys.argv[1:]])), end="")
