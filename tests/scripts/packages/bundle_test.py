#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The folder that runs anywhere (tools/make_bundle.sh): two makings give the same bytes; moved, below a name with a space, read-only, in a root
that holds glibc, a shell and nothing else, it checks, draws on its own driver and writes a film. Usage: bundle_test.py SOURCE_FOLDER
BUILD_FOLDER."""
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SOURCE, BUILD = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
sys.path.insert(0, str(SOURCE / "tests/scripts/lib"))
import needs  # noqa: E402  (the folder is known only now)

needs.packages("patchelf", "help2man")


def run(*words, expected=0, **options):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=300, **options)
    assert done.returncode == expected, (words, done.returncode, done.stdout, done.stderr)
    return done.stdout + done.stderr


def digest(folder):
    """Of names, rights, times, links and contents."""
    result = hashlib.sha256()
    for path in sorted(folder.rglob("*")):
        status = path.lstat()
        result.update(f"{path.relative_to(folder)} {status.st_mode} {int(status.st_mtime)}\n".encode())
        if path.is_symlink():
            result.update(os.readlink(path).encode())
        elif path.is_file():
            result.update(hashlib.sha256(path.read_bytes()).digest())
    return result.hexdigest()


def put_with_libraries(program, root):
    for file in [program, *re.findall(r"(/[^ ]+) \(0x", run("ldd", program))]:
        place = root / pathlib.Path(file).relative_to("/")
        place.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(pathlib.Path(file).resolve(), place)


with tempfile.TemporaryDirectory(prefix="ghost-bundle-") as folder:
    work = pathlib.Path(folder)
    environment = {**os.environ, "SOURCE_DATE_EPOCH": "1700000000"}
    run(SOURCE / "tools/package_files.sh", BUILD / "ghostlight", work / "files", env=environment)
    for name in ("one", "two"):
        print(run(SOURCE / "tools/make_bundle.sh", BUILD, work / name, work / "files", env=environment), end="")
    (bundle,) = (work / "one").iterdir()
    assert digest(bundle) == digest(work / "two" / bundle.name), "two makings, other bytes"
    shutil.rmtree(work / "two")

    # Each library has its licence, and nothing points to this machine.
    told = (bundle / "licences/packages.tsv").read_text(encoding="utf-8").splitlines()[1:]
    assert len(told) > 50, told
    for line in told:
        assert (bundle / "licences" / line.split("\t")[0]).stat().st_size > 100, line
    paths = {run("patchelf", "--print-rpath", path).strip() for path in bundle.rglob("*.so*") if path.is_file()}
    assert all(path.startswith("$ORIGIN") or path == "" for path in paths), paths

    # Completion: words of a command that has some, options, files.
    (work / "demo").mkdir()
    for words, expected in {"re": "record render", "farm re": "retry", "farm run --tr": "--trust", "farm run de": "demo", "render de": "demo"}.items():
        given = words.split()
        found = run("bash", "-c", f"source {work}/files/ghostlight.bash; COMP_WORDS=(ghostlight {words}); COMP_CWORD={len(given)}; "
                    '_ghostlight 2>/dev/null; echo "${COMPREPLY[@]}"', cwd=work).split()
        assert set(expected.split()) <= set(found) and all(word.startswith(given[-1]) for word in found), (words, found)

    # What the launcher set elsewhere comes along with a farm's job; what the user set stays.
    fake = work / "fake"
    for place in ("bin", "libexec", "share/vulkan", "share/fonts", "lib/fallback/libnobody.so.1"):
        (fake / place).mkdir(parents=True)
    shutil.copy2(bundle / "bin/ghostlight", fake / "bin")
    (fake / "share/vulkan/lavapipe.json").write_text("{}")
    (fake / "libexec/ghostlight").write_text("#!/bin/sh\nenv\n")
    (fake / "libexec/ghostlight").chmod(0o755)
    settings = {"PATH": os.environ["PATH"], "VK_DRIVER_FILES": f"{fake}/share/vulkan/lavapipe.json", "FONTCONFIG_FILE": "/mine.conf",
                "LD_LIBRARY_PATH": f"/mine:{fake}/lib/fallback/libm.so.6:/too"}
    said = dict(line.split("=", 1) for line in run(fake / "bin/ghostlight", env=settings).splitlines())
    assert said["LD_LIBRARY_PATH"] == f"/mine:/too:{fake}/lib/fallback/libnobody.so.1", said
    assert said["FONTCONFIG_FILE"] == "/mine.conf", said
    has_driver = any(pathlib.Path("/usr/share/vulkan/icd.d").glob("*.json"))
    assert ("VK_DRIVER_FILES" in said) != has_driver, said

    if os.geteuid() != 0:
        print("skipped: only root can change the root folder")
        sys.exit(77)
    root = work / "root"
    place = root / "opt/stage light"
    place.mkdir(parents=True)
    shutil.move(bundle, place / "bundle")
    for program in ("/bin/sh", "/usr/bin/readlink", "/usr/bin/dirname"):
        put_with_libraries(program, root)
    put_with_libraries("/usr/bin/env", root)
    for soname in ("libc.so.6", "libm.so.6", "libmvec.so.1", "libpthread.so.0", "libdl.so.2", "librt.so.1", "libresolv.so.2"):
        (found,) = set(re.findall(rf"{re.escape(soname)} \(libc6,x86-64[^)]*\) => (\S+)", run("/sbin/ldconfig", "-p")))
        place_of = root / pathlib.Path(found).relative_to("/")
        place_of.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(pathlib.Path(found).resolve(), place_of)
    shutil.copy2("/sbin/ldconfig", root / "ldconfig")
    (root / "sbin").mkdir(exist_ok=True)
    shutil.move(root / "ldconfig", root / "sbin/ldconfig")
    for name in ("home", "tmp", "dev", "proc", "etc"):
        (root / name).mkdir(exist_ok=True)
    run("/sbin/ldconfig", "-r", root)

    def inside(*words, expected=0):
        mounts = 'mount -t proc proc "$0/proc"; mount --rbind /dev "$0/dev"; cd /; exec chroot "$0" /usr/bin/env -i HOME=/home PATH=/usr/bin:/bin "$@"'
        return run("unshare", "--mount", "--pid", "--fork", "sh", "-euc", mounts, root, *words, expected=expected)

    program, demo = "/opt/stage light/bundle/bin/ghostlight", "/opt/stage light/bundle/share/ghostlight/demo"
    print(inside(program, "--version"), end="")
    said = inside(program, "check", demo)
    assert "10 fixtures, 3 cameras" in said, said
    inside(program, "render", demo, "-o", "/home/still.png", "--live", "--size", "96x54", "--at", "36", "--map-size", "64")
    inside(program, "render", demo, "-o", "/home/film.mp4", "--live", "--size", "96x54", "--from", "36", "--to", "36.2", "--map-size", "64")
    assert (root / "home/still.png").stat().st_size > 1000
    assert (root / "home/film.mp4").stat().st_size > 1000
    said = inside(program, "bake", "/nowhere", expected=1)
    assert "/nowhere" in said, said
    # The window stays, where nothing is installed either.
    said = run("timeout", "8", "unshare", "--mount", "--pid", "--fork", "--kill-child", "sh", "-euc",
               'mount -t proc proc "$0/proc"; mount --rbind /dev "$0/dev"; exec chroot "$0" /usr/bin/env -i HOME=/home PATH=/usr/bin:/bin '
               'QT_QPA_PLATFORM=offscreen "$@"', root, program, "open", demo, "--no-desk", expected=124)
    assert "drawing on" in said, said
    (root / "opt/a:b").mkdir()
    shutil.move(place / "bundle", root / "opt/a:b/bundle")
    said = inside("/opt/a:b/bundle/bin/ghostlight", "--version", expected=2)
    assert "colon" in said, said
