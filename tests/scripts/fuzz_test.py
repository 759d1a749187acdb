#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Every fuzz target that is built (./dev fuzz, build/fuzz) for five seconds on its seeds. Usage: fuzz_test.py SOURCE_FOLDER BUILD_FOLDER."""
import pathlib
import re
import subprocess
import sys
import tempfile

SECONDS = 5
SOURCE, BUILD = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
FUZZ = BUILD.parent / "fuzz"


def main():
    targets = sorted(path.stem.removesuffix("_fuzz") for path in (SOURCE / "tests/fuzz").glob("*_fuzz.cpp"))
    built = [target for target in targets if (FUZZ / f"fuzz_{target}").exists()]
    if not built:
        print(f"skipped: no fuzz target is built in {FUZZ}; ./dev fuzz builds them with clang")
        return 77
    failed = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([SOURCE / "tools/fuzz_seeds.py", folder / "seeds", "20000"], check=True, capture_output=True)
        for target in built:
            corpus = folder / target
            corpus.mkdir()
            done = subprocess.run([FUZZ / f"fuzz_{target}", f"-max_total_time={SECONDS}", "-max_len=65536", "-timeout=60", "-print_final_stats=1",
                                   f"-artifact_prefix={FUZZ}/{target}-", corpus, folder / "seeds" / target], capture_output=True, text=True)
            count = re.search(r"number_of_executed_units: (\d+)", done.stderr)
            print(f"{target}: {count[1] if count else 'no'} executions, exit code {done.returncode}")
            if done.returncode or not count:
                failed += 1
                print(done.stderr[-4000:])
    for target in sorted(set(targets) - set(built)):
        print(f"{target}: is not built")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
