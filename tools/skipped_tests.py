#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Counts in one line what the last run of ctest skipped, and why: whole scripts (exit 77, "skipped: REASON") and cases of
GoogleTest. Usage: skipped_tests.py LastTest.log"""
import collections
import re
import sys


def reasons(log):
    """Of each skipped case, in the order of the log."""
    lines = log.splitlines()
    found = []
    for k, line in enumerate(lines):
        if line.startswith("skipped: "):
            found.append(line[len("skipped: "):])
        elif re.match(r"\[  SKIPPED \] \S+ \(\d+ ms\)", line):
            said = next((before.strip() for before in reversed(lines[:k]) if before.strip()), "")
            found.append("without a reason" if not said or said.endswith(": Skipped") else said)
    return found


def summary(log):
    counts = collections.Counter(reasons(log))
    if not counts:
        return "skipped: nothing"
    parts = [f"{count} x {reason}" for reason, count in counts.most_common()]
    return f"skipped: {sum(counts.values())} ({'; '.join(parts)})"


def main():
    with open(sys.argv[1], encoding="utf-8", errors="replace") as file:
        print(summary(file.read()))


if __name__ == "__main__":
    main()
