#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Every fuzz target that is built (./dev fuzz, build/fuzz) for five seconds on its seeds. Usage: fuzz_test.py SOURCE_FOLDER BUILD_FOLDER."""
import pathlib
import subprocess
import sys
import tempfile

SECONDS = 5
SOURCE, BUILD = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
FUZZ = BUILD.parent / "fuzz"
sys.path.insert(0, str(SOURCE / "tools"))
sys.dont_write_bytecode = True
import fuzz  # noqa: E402  (the folder is known only now)


def main():
    targets = fuzz.targets()
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
            (folder / "seeds" / target).mkdir(parents=True, exist_ok=True)
            did = fuzz.run(FUZZ, target, SECONDS, corpus, folder / "seeds" / target)
            print(f"{target}: {did['executions']} executions, exit code {did['code']}")
            if did["code"] or not did["executions"]:
                failed += 1
                print(did["said"][-4000:])
    for target in sorted(set(targets) - set(built)):
        print(f"{target}: is not built")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
