# SPDX-License-Identifier: Apache-2.0
"""What tests of the farm share: a small show, and the bytes of what was made of it."""
import pathlib
import re
import shutil
import subprocess

FILM = ["--view", "house", "--from", "6", "--to", "22"]  # frames 180 to 659: cut at 240 and 480


def small_show(source, folder, size=(64, 32)):
    """A copy of the demo whose cameras are small, beside its fixtures. size: of their pictures; 64 x 32 are drawn slowly enough that a task can
    be disturbed in the middle."""
    shutil.copytree(source / "assets/demo", folder, ignore=shutil.ignore_patterns(".ghost"))
    if not (folder.parent / "fixtures").exists():
        shutil.copytree(source / "assets/fixtures", folder.parent / "fixtures")
    toml = folder / "show.toml"
    text = toml.read_text(encoding="utf-8")
    toml.write_text(re.sub(r"^size = .*$", f"size = {list(size)}", text, flags=re.M), encoding="utf-8")
    return folder


def files_of(folder, pattern="**/*"):
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in folder.glob(pattern) if path.is_file()}


class Ghostlight:
    def __init__(self, program, environment, folder, limit_s=600):
        # What it notes of its plans is the test's, not the tester's.
        environment = {"XDG_STATE_HOME": str(pathlib.Path(folder) / "state"), **environment}
        self.program, self.environment, self.folder, self.limit_s = program, environment, folder, limit_s

    def run(self, *words, code=0, says="", **more):
        done = subprocess.run([str(self.program), *map(str, words)], env=self.environment, cwd=self.folder, capture_output=True, text=True,
                              timeout=self.limit_s, **more)
        said = done.stdout + done.stderr
        assert done.returncode == code, (words, done.returncode, said)
        assert says in said, (words, says, said)
        return said

    def start(self, *words):
        return subprocess.Popen([str(self.program), *map(str, words)], env=self.environment, cwd=self.folder, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, text=True)


def plan_of(show):
    """The one that was asked for last."""
    farm = show / ".ghost/farm"
    return farm / (farm / "newest").read_text()


def started(ghost, show, out, *words):
    """A film that is on its way: the command that follows it, and its plan."""
    watching = ghost.start("render", show, "-o", out, *FILM, *words)
    newest = show / ".ghost/farm/newest"

    def is_submitted():
        if watching.poll() is not None:
            raise AssertionError(watching.communicate()[0])
        return newest.exists() and (plan_of(show) / "submitted.json").exists() and f'/{out}"' in (plan_of(show) / "plan.json").read_text()

    wait_until(is_submitted, 120, out + " is submitted")
    return watching, plan_of(show)


def wait_for_pictures(plan, task):
    wait_until(lambda: list((plan / "frames").glob(f"{task}.*/*.mp4")), 180, f"task {task} draws")


def ends(watching, code, says):
    said = watching.communicate(timeout=600)[0]
    assert watching.returncode == code and says in said, (watching.args, watching.returncode, said)
    return said


def wait_until(holds, seconds, what):
    import time
    end = time.monotonic() + seconds
    while not holds():
        assert time.monotonic() < end, f"not within {seconds} s: {what}"
        time.sleep(0.2)


def numbered(folder, stem):
    """Pictures of a film in their order."""
    return [path.read_bytes() for path in sorted(pathlib.Path(folder).glob(stem + "-*.png"))]
