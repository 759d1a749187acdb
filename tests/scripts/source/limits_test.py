#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""docs/reference/limits.md says what the source says. The argument is the source root."""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
rows = re.findall(r"^\|.*\| `([^`]+)` \| `(src/[^`]+)` \|$", (root / "docs/reference/limits.md").read_text(encoding="utf-8"), re.M)
wrong = [f"{file}: does not say {words}" for words, file in rows
         if not re.search(r"\s+".join(map(re.escape, words.split())) + r"\s*[;,}]", (root / file).read_text(encoding="utf-8"))]
print("\n".join([*wrong, f"{len(rows)} limits"]))
sys.exit(1 if wrong or len(rows) < 60 else 0)
