#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""tools/fuzz.py with a program in the place of libFuzzer's: time adds up over calls, what was built anew begins anew, an input that is slow
by the clock alone is none, and a crash is kept, said, and rests its target. Usage: fuzz_tool_test.py SOURCE_FOLDER BUILD_FOLDER."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(sys.argv[1]).resolve()
FUZZER = """#!/usr/bin/python3
import pathlib, shutil, sys, time
flags = dict(word[1:].split("=", 1) for word in sys.argv[1:] if word.startswith("-"))
places = [pathlib.Path(word) for word in sys.argv[1:] if not word.startswith("-")]
if "merge" in flags:
    for place in places[1:]:
        for file in place.iterdir():
            shutil.copy(file, places[0])
elif "max_total_time" in flags:
    end = time.process_time() + float(flags["max_total_time"])
    while time.process_time() < end:
        pass
    (places[0] / "new").write_bytes(b"new")
    print("#9 DONE cov: 7 ft: 11 corp: 2/9b\\\\nstat::number_of_executed_units: 1000")
    what = pathlib.Path(sys.argv[0]).with_name("what").read_text()
    if what:
        pathlib.Path(flags["artifact_prefix"] + what).write_bytes(b"x")
        sys.exit(77 if what.startswith("crash") else 0)
"""


def fuzz(folder, seconds):
    return subprocess.run([sys.executable, SOURCE / "tools/fuzz.py", "--jobs", "1", folder, str(seconds), "osc"], capture_output=True, text=True, check=False)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        program, what = folder / "fuzz_osc", folder / "what"
        program.write_text(FUZZER.replace("\\\\n", "\\n"), encoding="utf-8")
        program.chmod(0o755)
        what.write_text("slow-unit-1", encoding="utf-8")
        (folder / "seeds/osc").mkdir(parents=True)
        (folder / "seeds/osc/seed0000").write_bytes(b"seed")

        def done():
            return json.loads((folder / "done.json").read_text(encoding="utf-8"))["osc"]

        first = fuzz(folder, 1)
        assert first.returncode == 0, first.stdout + first.stderr
        assert 1 <= done()["seconds"] < 2 and done()["executions"] == 1000 and done()["edges"] == 7 and done()["features"] == 11, done()
        assert not list(folder.glob("osc-slow*")), "slow by the clock alone"
        assert sorted(path.name for path in (folder / "corpus_osc").iterdir()) == ["new", "seed0000"] and done()["kept"] == 2
        assert "| osc | 1 | 1,000 |" in (folder / "table.md").read_text(encoding="utf-8")

        fuzz(folder, 1)
        assert done()["executions"] == 1000, "it had its time"
        fuzz(folder, 2)
        assert done()["executions"] == 2000 and 2 <= done()["seconds"] < 3.5, done()

        os.utime(program, (1, 1))  # built anew
        what.write_text("crash-1", encoding="utf-8")
        crashed = fuzz(folder, 1)
        assert crashed.returncode == 1 and "osc-crash-1 |" in crashed.stdout, crashed.stdout
        assert done()["executions"] == 1000, done()
        fuzz(folder, 2)
        assert done()["executions"] == 1000, "it rests until the crash is taken away"
        print("fuzz.py: time adds up, a new build begins anew, slow by the clock is none, a crash rests its target")


if __name__ == "__main__":
    main()
