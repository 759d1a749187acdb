#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The stage that travels (assets/kinetic): its files are those of its tool; on the way of its movers each picture is that of a scene in which
everything stands there; a film and a still have the same bytes twice; check names what meets, what goes through the floor and who is asked for too much.
Usage: kinetic_test.py SOURCE_FOLDER BUILD_FOLDER."""
import pathlib
import re
import subprocess
import sys
import tempfile

SOURCE, BUILD = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
GHOST, SHOW = BUILD / "ghostlight", SOURCE / "assets/kinetic"


def run(*command, code=0):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    assert done.returncode == code, (command, done.returncode, done.stdout, done.stderr)
    return done.stdout + done.stderr


def files_are_those_of_the_tool(top):
    run(sys.executable, SOURCE / "tools/make_kinetic.py", "--out", top / "made")
    for name in ("stage.glb", "kinetic.show"):
        assert (top / "made" / name).read_bytes() == (SHOW / name).read_bytes(), f"{name}: run tools/make_kinetic.py and commit"
    folder = re.compile(r'"[./a-z]*fixtures/')   # where it lies is relative
    made, kept = (folder.sub('"', (path / "show.toml").read_text()) for path in (top / "made", SHOW))
    assert made == kept, "show.toml: run tools/make_kinetic.py and commit"


def places_are_those_of_scenes_that_stand_there():
    for maps in ("processor", "device"):
        said = run(sys.executable, SOURCE / "tools/kinetic_places.py", BUILD, "--mover", "all", "--places", 2, "--size", "240x136", "--lamps", 3,
                   "--moving-maps", maps)
        print(f"maps by the {maps}: {said.strip()}")


def film_twice(top):
    for name in ("a", "b"):
        run(GHOST, "render", SHOW, "--from", 3, "--to", 3.5, "--fps", 4, "--size", "96x54", "-o", top / f"{name}.exr", "--quiet")
    first = [path.read_bytes() for path in sorted(top.glob("a-*.exr"))]
    assert len(first) == 2 and first[0] != first[1], "it travels"
    assert first == [path.read_bytes() for path in sorted(top.glob("b-*.exr"))]


def still_twice(top):
    for name in ("a", "b"):
        run(GHOST, "render", SHOW, "--at", 9, "--size", "96x54", "-o", top / f"still_{name}.exr", "--quiet")
    assert (top / "still_a.exr").read_bytes() == (top / "still_b.exr").read_bytes()


def check_names_what_goes_wrong(top):
    quiet = run(GHOST, "check", SHOW)
    assert " meets " not in quiet and "below the floor" not in quiet and "end stops" not in quiet, quiet
    text = (top / "made/show.toml").read_text()
    wrong = top / "wrong"
    wrong.mkdir()
    (wrong / "stage.glb").write_bytes((SHOW / "stage.glb").read_bytes())
    (wrong / "kinetic.show").write_bytes((SHOW / "kinetic.show").read_bytes())
    text = re.sub(r'gdtf = "[^"]*/', f'gdtf = "{SOURCE}/assets/fixtures/', text)
    # The truss into the flat of the revolve, and on through the floor.
    text = text.replace("range_m = [0.0, -4.0]", "range_m = [0.0, -7.0]").replace('fixtures = ["Truss *"]', 'fixtures = ["Truss *"]\n'
                        "[[mover.key]]\nat_s = 0\nvalues = [0, 0]\n[[mover.key]]\nat_s = 7\nvalues = [-7, -7]\n[[mover.key]]\nat_s = 8\nvalues = [-9, -7]\n", 1)
    (wrong / "show.toml").write_text(text.replace("speed_m_s = 0.8", "speed_m_s = 5").replace("acceleration_m_s2 = 0.8", "acceleration_m_s2 = 50"))
    said = run(GHOST, "check", "--all", wrong)
    met = re.search(r"at ([0-9.]+) s 'Truss' of mover 'Truss' meets 'Revolve flat' at \[(.*?)\]", said)
    assert met, said
    # The chords are 2.5 cm thick, the flat ends at 1.8 m and has turned under them: 4.175 m down, at 1 m/s.
    assert 4.1 <= float(met[1]) <= 4.4, met[0]
    assert re.search(r"at [67]\.\d+ s 'Truss.*is below the floor", said), said
    assert re.search(r"at 7\.\d+ s axis 'left' of mover 'Truss' is asked to go to -\d\.\d+ m, past its end stops \[-7\.00, 0\.00\]", said), said
    print(met[0])


def main():
    with tempfile.TemporaryDirectory() as temporary:
        top = pathlib.Path(temporary)
        files_are_those_of_the_tool(top)
        places_are_those_of_scenes_that_stand_there()
        film_twice(top)
        still_twice(top)
        check_names_what_goes_wrong(top)
    return 0


if __name__ == "__main__":
    sys.exit(main())
