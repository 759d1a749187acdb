#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What ./dev test says in its last line of the tests that did not run. Usage: skipped_test.py SOURCE_FOLDER BUILD_FOLDER."""
import pathlib
import re
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(sys.argv[1]) / "tools"))
sys.dont_write_bytecode = True
import skipped_tests  # noqa: E402

LOG = """
[ RUN      ] Usb.Comes
tests/dmx/receive/usb_ports_test.cpp:70: Skipped
no pseudo-terminals here (/dev/pts)
[  SKIPPED ] Usb.Comes (0 ms)
[ RUN      ] Usb.Goes
tests/dmx/receive/usb_ports_test.cpp:70: Skipped
no pseudo-terminals here (/dev/pts)

[  SKIPPED ] Usb.Goes (1 ms)
[ RUN      ] Usb.Mute
tests/dmx/receive/usb_ports_test.cpp:70: Skipped
[  SKIPPED ] Usb.Mute (1 ms)
[==========] 3 tests from 1 test suite ran. (5 ms total)
[  SKIPPED ] 3 tests, listed below:
[  SKIPPED ] Usb.Comes
[  SKIPPED ] Usb.Goes
[  SKIPPED ] Usb.Mute
skipped: needs root for network namespaces
"""


class Skipped(unittest.TestCase):
    def test_each_case_once_the_most_common_reason_first(self):
        self.assertEqual(skipped_tests.summary(LOG),
                         "skipped: 4 (2 x no pseudo-terminals here (/dev/pts); 1 x without a reason; "
                         "1 x needs root for network namespaces)")

    def test_a_whole_run(self):
        self.assertEqual(skipped_tests.summary("[       OK ] Usb.Comes (3 ms)\nwhich were skipped: none"), "skipped: nothing")

    def test_a_script_without_its_packages_names_them(self):
        """-S: a Python that has nothing but its own library."""
        scripts = pathlib.Path(sys.argv[1]).resolve() / "tests/scripts"
        uses = re.compile(r"^(import numpy|from PIL|from lib import (pictures|window)|(import|from) window)\b", re.M)
        found = [path for path in sorted(scripts.glob("*.py")) if uses.search(path.read_text(encoding="utf-8"))]
        self.assertGreater(len(found), 8)
        for path in found:
            done = subprocess.run(["/usr/bin/python3", "-S", path, sys.argv[1], "no such folder"], capture_output=True, text=True, timeout=60)
            self.assertEqual(done.returncode, 77, (path, done.stderr))
            self.assertRegex(done.stdout, r"^skipped: ([\w-]+ and )*python3-(numpy|pil)[\w -]* (is|are) not installed\n$", path)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
