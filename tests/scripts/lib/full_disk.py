# SPDX-License-Identifier: Apache-2.0
"""A command whose folder is on a disk that is full: a small one of memory, in a mount namespace of the command's own. A limit of file
sizes is not the same: what a graphics driver keeps in memory would count.

full_disk.py FOLDER BYTES_LEFT COMMAND...: runs it; what is in the folder afterwards stays there."""
import os
import pathlib
import shutil
import subprocess
import sys

DISK_BYTES = 256 << 20
NAMESPACE = ["unshare", "--mount", "--propagation", "private"] + ([] if os.geteuid() == 0 else ["--map-root-user"])


def is_possible():
    """Whether this machine lets us mount one; says so, for ./dev test to count, if not."""
    if subprocess.run([*NAMESPACE, "mount", "-t", "tmpfs", "none", "/mnt"], capture_output=True).returncode == 0:
        return True
    print("skipped: a full disk: none can be mounted here", flush=True)
    return False


def command(folder, words, bytes_left=0):
    return [*NAMESPACE, sys.executable, __file__, str(folder), str(bytes_left), *map(str, words)]


def copy(source, to):
    for entry in os.scandir(source):
        if entry.is_dir(follow_symlinks=False):
            shutil.copytree(entry.path, to / entry.name, symlinks=True)
        else:
            shutil.copy2(entry.path, to / entry.name, follow_symlinks=False)


def main():
    folder, bytes_left = pathlib.Path(sys.argv[1]), int(sys.argv[2])
    below = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
    below_path = pathlib.Path(f"/proc/self/fd/{below}")
    subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={DISK_BYTES}", "full", folder], check=True)
    copy(below_path, folder)
    disk = os.statvfs(folder)
    room = disk.f_bavail * disk.f_frsize - bytes_left
    assert room > 0, "what is there does not fit"
    filler = folder / ".full"
    with open(filler, "wb") as file:
        os.posix_fallocate(file.fileno(), 0, room)
    code = subprocess.run(sys.argv[3:], restore_signals=False).returncode
    filler.unlink()
    for entry in os.scandir(below_path):
        if entry.is_dir(follow_symlinks=False):
            shutil.rmtree(below_path / entry.name)
        else:
            os.unlink(below_path / entry.name)
    copy(folder, below_path)
    return code if code >= 0 else 128 - code


if __name__ == "__main__":
    sys.exit(main())
