# SPDX-License-Identifier: Apache-2.0
"""The files of the source tree, as git lists them; where there is no git, or the tree is one that was unpacked, as they lie there."""
import subprocess

TOPS = ("src", "shaders", "tests", "tools", "docs")


def listed(root):
    """Their paths below root."""
    try:
        said = subprocess.run(["git", "-C", root, "ls-files", "-z"], capture_output=True, text=True)
        names = said.stdout.split("\0")[:-1] if said.returncode == 0 else []
    except FileNotFoundError:
        names = []
    if not names:
        found = [*root.glob("*.md"), *(file for top in TOPS for file in (root / top).rglob("*"))]
        names = sorted(file.relative_to(root).as_posix() for file in found if file.is_file())
    return [name for name in names if (root / name).is_file()]
