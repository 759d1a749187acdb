#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""docs/reference/limits.md says what the source says, and each limit names its test. The argument is the source root."""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
lines = (root / "docs/reference/limits.md").read_text(encoding="utf-8").splitlines()
rows = [re.fullmatch(r"\| (.*?) \| .*? \| `([^`]+)` \| `(src/[^`]+)` \| `(tests/[^`]+)`: `([^`]+)` \|", line)
        for line in lines if re.search(r"\| `src/", line)]
wrong = []
for line, row in zip([line for line in lines if re.search(r"\| `src/", line)], rows):
    if not row:
        wrong.append(f"no row of five columns, of which the last is a test: {line}")
        continue
    what, words, file, test, name = row.groups()
    if not re.search(r"\s+".join(map(re.escape, words.split())) + r"\s*[;,}]", (root / file).read_text(encoding="utf-8")):
        wrong.append(f"{file}: does not say {words}")
    if not ((root / test).is_file() and name in (root / test).read_text(encoding="utf-8")):
        wrong.append(f"{what}: {test} has no {name}")
print("\n".join([*wrong, f"{len(rows)} limits, each with a test"]))
sys.exit(1 if wrong or len(rows) < 100 else 0)
