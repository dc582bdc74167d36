"""Counts the test cases of a run of the suite by script/test: count.py BUILD_FOLDER EXIT_STATUS

Prints "PASSED FAILED". Every test program leaves an XML report in BUILD_FOLDER/results; one that
crashed leaves none and counts as one failure, as does a run that failed without a failed case.
Failures are repeated on standard error.
"""

import json
import pathlib
import sys
import xml.etree.ElementTree

build, status = pathlib.Path(sys.argv[1]), int(sys.argv[2])
passed = failed = 0
logs = list((build / "meson-logs").glob("testlog-*.json"))
lines = logs[0].read_text(encoding="utf-8").splitlines() if len(logs) == 1 else []
for line in lines:
    test = json.loads(line)
    name = test["name"].split(" / ")[-1]
    report = build / "results" / f"{name}.xml"
    bad = test["result"] not in ("OK", "SKIP", "EXPECTEDFAIL")
    if not report.exists():
        passed += test["result"] == "OK"
        failed += bad
        if bad:
            print(f"{name}: {test['result']} and no report", file=sys.stderr)
        continue
    failures_before = failed
    for case in xml.etree.ElementTree.parse(report).getroot().iter("testcase"):
        wrong = [part for part in case if part.tag in ("failure", "error")]
        if wrong:
            failed += 1
            print(f"{name}: {case.get('name')}: {wrong[0].text}", file=sys.stderr)
        elif not any(part.tag == "skipped" for part in case):
            passed += 1
    if bad and failed == failures_before:
        failed += 1
        print(f"{name}: {test['result']}", file=sys.stderr)
if status != 0 and failed == 0:
    failed = 1
print(passed, failed)
