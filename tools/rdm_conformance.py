#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The conformance list after ANSI E1.20-2010 and E1.11 as a page: runs test_rdm and writes docs/reference/rdm-conformance.md, or with
--check says whether that page is what the tests say now. Arguments: build folder [--check]."""
import json
import pathlib
import subprocess
import sys
import tempfile

from wrap_docs import wrap

SOURCE = pathlib.Path(__file__).resolve().parent.parent
PAGE = SOURCE / "docs/reference/rdm-conformance.md"
# What the tests cannot ask, because there is none of it.
MISSING = [
    ("ACK_TIMER (6.3.4)", "every answer is there at once"),
    ("sub-devices that answer (9.3)", "a fixture has none; that every message to one is refused is tested"),
    ("PARAMETER_DESCRIPTION (10.4.2)", "there is no parameter of our own"),
    ("proxies (10.1 to 10.1.2)", "nothing stands behind another device"),
    ("timing on a line (E1.20 3, E1.11)", "there is no line: Art-Net carries the messages"),
]


def words(name):
    return name.replace("_", " ")


def outcome(test):
    if test.get("failures"):
        return "failed"
    if test.get("status") != "RUN" or test.get("result") == "SKIPPED" or "not_run" in test:
        return "not run"
    return "passed"


def run(build):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "tests.json"
        subprocess.run([str(build / "test_rdm"), "--gtest_filter=*Conformance*:RdmMessage*", f"--gtest_output=json:{file}", "--gtest_brief=1"], check=False,
                       stdout=subprocess.DEVNULL, timeout=120)
        suites = json.loads(file.read_text())["testsuites"]
    return [(suite["name"], test) for suite in suites for test in suite["testsuite"]]


def page(tests):
    counts = {kind: sum(outcome(test) == kind for _, test in tests) for kind in ("passed", "failed", "not run")}
    lines = ["# RDM: the conformance list", "", "Written by `tools/rdm_conformance.py build/release` from what `tests/rdm/conformance_test.cpp` and `tests/rdm/message_test.cpp` say; clauses of ANSI E1.20-2010 and",
             "E1.11. [rdm.md](rdm.md) says what is answered.", "",
             f"**{counts['passed']} passed, {counts['failed']} failed, {counts['not run']} not run; {len(MISSING)} things cannot be run.**", "", "## Each parameter", ""]
    rows, checks = {}, []
    for suite, test in tests:
        if "/" not in test["name"]:
            continue
        check, parameter = test["name"].split("/")
        if check not in checks:
            checks.append(check)
        rows.setdefault(parameter, {})[check] = outcome(test)
    lines += ["| parameter | " + " | ".join(words(check) for check in checks) + " |", "|---" * (len(checks) + 1) + "|"]
    for parameter, row in rows.items():
        lines.append(f"| `{parameter}` | " + " | ".join({"passed": "yes", "not run": "-"}.get(row[check], f"**{row[check]}**") for check in checks) + " |")
    lines += ["", "*yes*: passed; *-*: such a message says nothing of that parameter (" +
              ", ".join(sorted({test["not_run"] for _, test in tests if "not_run" in test})) + ").", "", "## All parameters together", "", "| what | |", "|---|---|"]
    lines += [f"| {words(test['name'])} | {outcome(test)} |" for _, test in tests if "/" not in test["name"]]
    lines += ["", "## What cannot be run", "", "| what | why |", "|---|---|"]
    lines += [f"| {what} | {why} |" for what, why in MISSING]
    failed = [f"{suite}.{test['name']}" for suite, test in tests if outcome(test) == "failed"]
    return wrap("\n".join(lines) + "\n"), failed


def main():
    text, failed = page(run(pathlib.Path(sys.argv[1]).resolve()))
    for name in failed:
        print("failed:", name)
    if "--check" not in sys.argv:
        PAGE.write_text(text)
    elif PAGE.read_text() != text:
        sys.exit(f"{PAGE.name} is not what the tests say: tools/rdm_conformance.py BUILD")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
