#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""docs/reference/rdm-conformance.md is what the tests of RDM say. Arguments: source folder, build folder. Exit 77: skipped."""
import pathlib
import subprocess
import sys

source, build = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
if not (build / "test_rdm").exists():
    print("skipped: test_rdm is not built")
    sys.exit(77)
sys.exit(subprocess.run([sys.executable, str(source / "tools/rdm_conformance.py"), str(build), "--check"]).returncode)
