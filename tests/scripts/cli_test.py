#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The program as a user sees it: exit codes, messages, repeatable bytes, and what bad input gets. Usage:
cli_test.py SOURCE_FOLDER BUILD_FOLDER. Works on a copy of the demo show; nothing but Python's own library is needed."""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import zlib

from lib import full_disk

SOURCE = pathlib.Path(sys.argv[1]).resolve()
PROGRAM = pathlib.Path(sys.argv[2]).resolve() / "ghostlight"
SIZE = "96x54"
FRAME_500 = "16.66667"
WORK = None  # a folder of our own; WORK/demo is the show


def run(*arguments, full=None):
    """stdout and stderr together are in .text. full: a folder whose disk has no room."""
    words = [str(PROGRAM), *map(str, arguments)]
    done = subprocess.run(full_disk.command(full, words) if full else words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          timeout=300)
    done.text = done.stdout + done.stderr
    return done


def copy_demo(name):
    folder = WORK / name
    folder.mkdir()
    demo = SOURCE / "assets" / "demo"
    for large in ("stage.glb", "demo.show"):
        (folder / large).symlink_to(demo / large)
    shutil.copy(demo / "show.toml", folder / "show.toml")
    return folder


def edit(path, old, new):
    text = path.read_text()
    assert old in text, old
    path.write_text(text.replace(old, new, 1))


class Case(unittest.TestCase):
    def fails(self, done, code, *parts):
        self.assertEqual(done.returncode, code, done.text)
        for part in parts:
            self.assertIn(part, done.text)

    def works(self, done):
        self.assertEqual(done.returncode, 0, done.text)

    def only(self, folder, *names):
        self.assertEqual(sorted(p.name for p in folder.iterdir()), sorted(names))

    def out(self):
        """A new empty folder."""
        return pathlib.Path(tempfile.mkdtemp(dir=WORK))


class Usage(Case):
    def test_no_command_or_a_wrong_one_is_wrong_usage(self):
        self.fails(run(), 2)
        self.fails(run("rendre"), 2)
        self.fails(run("render"), 2, "SHOW")
        self.fails(run("render", WORK / "demo"), 2, "--out")
        self.fails(run("render", WORK / "demo", "-o", "a.png", "--beams", "zigzag"), 2, "cone", "march")
        self.fails(run("render", WORK / "demo", "-o", "a.png", "--at", "-3"), 2, "--at")
        self.fails(run("render", WORK / "demo", "-o", "a.png", "--nonsense"), 2, "--nonsense")
        self.fails(run("render", WORK / "demo", "-o", "a.mp4", "--hold-fps", "25"), 2, "--live-input")
        held = ("render", WORK / "demo", "-o", "a.mp4", "--live-input", "--hold-fps")
        self.fails(run(*held, "50", "--fps", "30"), 2, "--hold-fps", "30 frames")
        self.fails(run(*held, "25", "--beams", "cone"), 2, "--hold-fps", "gate")
        self.fails(run(*held, "0"), 2, "--hold-fps")
        self.fails(run("render", WORK / "demo", "-o", "a.mp4", "--no-caption"), 2, "--live-input")
        self.fails(run("render", WORK / "demo", "-o", "a.mp4", "--live-input", "--on-loss", "dark"), 2, "hold, black")
        self.fails(run("bake", WORK / "demo", "--spp", "0"), 2, "--spp")

    def test_options_that_are_no_numbers(self):
        demo = ("render", WORK / "demo", "-o", "a.png")
        eye = ("--eye", "0", "-3", "2", "--target", "0", "5", "2")
        for option in ["--fov", "--ev", "--glare", "--at"]:
            for value in ["nan", "inf", "much"]:
                self.fails(run(*demo, *eye, option, value), 2, option)
        self.fails(run(*demo, "--live-input", "--seconds", "nan"), 2, "--seconds")
        self.fails(run(*demo, "--eye", "1e30", "3", "1", "--target", "0", "5", "2"), 2, "10 km")
        self.fails(run(*demo, "--eye", "nan", "3", "1", "--target", "0", "5", "2"), 2, "10 km")
        for option in ["--from", "--until", "--rate"]:
            self.fails(run("play", WORK / "demo" / "demo.show", "--to", "127.0.0.1", option, "nan"), 2, option)
        for option in ["--ev", "--ppd"]:
            self.fails(run("compare", "a.png", "b.png", option, "nan"), 2, option)
        self.fails(run("monitor", "--seconds", "nan"), 2, "--seconds")

    def test_options_that_would_do_nothing(self):
        demo = ("render", WORK / "demo", "-o", "a.png")
        self.fails(run(*demo, "--fov", "30"), 2, "--eye")
        self.fails(run(*demo, "--seconds", "3"), 2, "--live-input")
        self.fails(run(*demo, "--no-shadows"), 2, "--live")
        self.fails(run(*demo, "--supersample", "2"), 2, "--live")
        self.fails(run(*demo, "--live", "--reference", "--supersample", "2"), 2, "--pixel-samples")
        for useless in (["--glare", "0.1"], ["--beams", "cone"], ["--json"], ["--device", "0"]):
            self.fails(run(*demo, "--reference", *useless), 2, "--reference", useless[0])
        self.fails(run(*demo, "--steps", "20"), 2, "--beams march")
        self.fails(run(*demo, "--map-size", "128"), 2, "--live")
        self.fails(run(*demo, "--live", "--map-size", "100"), 2, "power of two")
        self.fails(run(*demo, "--live", "--size", "8192x8192", "--supersample", "3"), 1, "16384")
        self.fails(run(*demo, "--travel", "close"), 2, "--from")
        self.fails(run(*demo, "--live-input", "--travel", "close"), 2, "--from")

    def test_help_has_an_example_for_every_command(self):
        commands = ["bake", "bench", "check", "monitor", "play", "record", "render"]
        self.works(run("--help"))
        for command in commands:
            done = run(command, "--help")
            self.works(done)
            self.assertIn("Example", done.text, command)

    def test_bad_sizes(self):
        for size in ("12", "8x8", "100x", "9000x9000", "-64x36", "64x36x3", "axb"):
            done = run("render", WORK / "demo", "-o", self.out() / "a.png", "--size", size)
            self.fails(done, 2, "--size")

    def test_unknown_device_lists_devices(self):
        done = run("render", WORK / "demo", "-o", self.out() / "a.png", "--size", SIZE, "--device", "GeForce 8600M")
        self.fails(done, 1, "GeForce 8600M", "0:")

    def test_unknown_view_names_the_views(self):
        out = self.out()
        done = run("render", WORK / "demo", "-o", out / "a.png", "--view", "huose")
        self.fails(done, 1, "huose", "'house'")
        self.only(out)
        self.fails(run("bake", WORK / "demo", "--view", "huose"), 1, "'house'")
        flight = run("render", WORK / "demo", "-o", out / "a.mp4", "--from", "1", "--to", "2", "--travel", "clos", "--size", SIZE)
        self.fails(flight, 1, "did you mean 'close'", "(cameras: 'house', 'close', 'high')")
        self.only(out)

    def test_camera_inside_an_object_is_said_by_all_who_look(self):
        folder = copy_demo("inside")
        edit(folder / "show.toml", "position_m = [0.0, -15.5, 4.2]", "position_m = [0.0, 6.7, 1.35]")
        said = "stands inside 'riser_drums'"
        self.assertIn(said, run("check", folder).text)
        picture = ("-o", self.out() / "a.png", "--size", SIZE, "--at", "20")
        self.assertIn(said, run("render", folder, *picture).text)
        self.assertIn(said, run("render", folder, "--live", "--no-shadows", *picture).text)

    def test_output_must_be_a_kind_that_we_write(self):
        self.fails(run("render", WORK / "demo", "-o", self.out() / "a.gif"), 2, ".png", ".exr", ".mp4")

    def test_film_without_a_range(self):
        self.fails(run("render", WORK / "demo", "-o", self.out() / "a.mp4"), 2, "--from", "--to")

    def test_empty_range(self):
        out = self.out()
        done = run("render", WORK / "demo", "-o", out / "a.mp4", "--size", SIZE, "--from", 5, "--to", 4)
        self.fails(done, 2, "--from")
        self.only(out)

    def test_missing_things_are_named(self):
        self.fails(run("render", WORK / "nowhere", "-o", "a.png"), 1, "nowhere")
        self.fails(run("render", WORK / "demo", "-o", self.out() / "a.png", "--size", SIZE, "--replay", WORK / "no.show"),
                   1, "no.show")
        self.fails(run("play", WORK / "no.show"), 1, "no.show")
        self.fails(run("check", WORK / "no.gdtf"), 1, "no.gdtf")
        self.fails(run("bake", WORK / "nowhere"), 1, "nowhere")


class Pictures(Case):
    def render(self, out, *arguments, **options):
        return run("render", WORK / "demo", "-o", out, "--size", SIZE, *arguments, **options)

    def test_same_recording_same_bytes(self):
        out = self.out()
        for ending in ("png", "exr"):
            for name in ("a", "b"):
                self.works(self.render(out / f"{name}.{ending}", "--at", FRAME_500))
            self.assertEqual((out / f"a.{ending}").read_bytes(), (out / f"b.{ending}").read_bytes())
        self.assertGreater((out / "a.png").stat().st_size, 1500)
        # A range: the same bytes every time, and the show moves. (Frame 500 alone and in a range differ by rounding, see
        # tests/live/session/golden_test.cpp: there, images of lights that rest are kept from frame to frame.)
        for name in ("one", "two"):
            self.works(self.render(out / f"{name}.png", "--from", "16.5", "--to", "16.8", "--fps", "30"))
        one, two = ([p.read_bytes() for p in sorted(out.glob(f"{name}-*"))] for name in ("one", "two"))
        self.assertEqual(len(one), 9)
        self.assertEqual(one, two)
        self.assertEqual(len(set(one)), 9)

    def test_film(self):
        out = self.out()
        done = self.render(out / "a.mp4", "--from", "16", "--to", "16.4", "--fps", "25", "--json")
        self.works(done)
        row = json.loads(done.stdout)
        self.assertEqual((row["frames"], row["width"], row["height"]), (10, 96, 54))
        self.assertIn(b"ftyp", (out / "a.mp4").read_bytes()[:16])
        self.assertNotIn("x264", done.text)
        self.only(out, "a.mp4")

    def test_free_camera(self):
        show = copy_demo("live")
        with open(show / "show.toml", "a") as file:
            file.write("\n[shadows]\nmap_size = 64\n")
        out = self.out()
        live = ("render", show, "--live", "--view", "close", "--size", SIZE, "--at", "50", "--validation")
        self.works(run(*live, "-o", out / "a.png"))
        self.assertFalse((show / ".ghost" / "passes").exists(), "nothing is baked")
        self.assertEqual(len(list((show / ".ghost" / "distances" / "64").glob("*.exr"))), 10)
        again = run(*live, "-o", out / "b.png")
        self.works(again)
        self.assertNotIn("validation", again.text.lower())
        self.assertEqual((out / "a.png").read_bytes(), (out / "b.png").read_bytes())
        self.works(run(*live, "-o", out / "open.png", "--no-shadows"))
        self.assertNotEqual((out / "a.png").read_bytes(), (out / "open.png").read_bytes())
        fine = run(*live, "-o", out / "fine.exr", "--supersample", "3", "--json")
        self.works(fine)
        self.assertEqual("%dx%d" % (json.loads(fine.stdout)["width"], json.loads(fine.stdout)["height"]), SIZE)
        self.works(run(*live, "-o", out / "plain.exr"))
        self.works(run("compare", out / "plain.exr", out / "fine.exr", "--min", "psnr=25"))
        free = ("render", show, "-o", out / "c.png", "--size", SIZE, "--at", "50")
        self.works(run(*free, "--eye", "2.2", "0.6", "1.9", "--target", "-0.3", "6", "2.9"))
        self.works(run(*free, "--eye", "0", "9.05", "1", "--target", "0", "9.5", "1"))  # in the back wall
        self.fails(run(*free, "--eye", "0", "0", "1"), 2, "--target")
        self.fails(run(*free, "--eye", "0", "0", "1", "--target", "0", "0", "1"), 2, "--eye")
        self.fails(run(*free, "--eye", "0", "nan", "1", "--target", "0", "0", "1"), 2, "--eye")
        self.fails(run(*free, "--view", "close", "--eye", "0", "0", "1", "--target", "0", "5", "1"), 2, "--view")
        fly = run("render", show, "-o", out / "fly.mp4", "--size", SIZE, "--from", "50", "--to", "50.2", "--view", "house",
                  "--travel", "close", "--json")
        self.works(fly)
        self.assertEqual(json.loads(fly.stdout)["frames"], 6)

    def test_a_film_of_the_free_camera_holds_a_rate(self):
        out = self.out()
        for rate in ("1", "10"):
            done = run("render", WORK / "demo", "--live", "--view", "close", "--size", "320x180", "--from", "20", "--to", "20.5", "--fps", "10",
                       "--json", "-o", out / "held.png", "--hold-fps", rate)
            self.works(done)
            figures = json.loads(done.stdout)
            self.assertEqual((figures["width"], figures["height"]), (320, 180))
            self.assertEqual(sum(figures["frames_by_size"].values()), 5)
        for k in range(5):  # whatever was drawn, the file has its size
            head = (out / f"held-{k:05}.png").read_bytes()[16:24]
            self.assertEqual((int.from_bytes(head[:4], "big"), int.from_bytes(head[4:], "big")), (320, 180))
        self.fails(run("render", WORK / "demo", "-o", out / "a.mp4", "--from", "1", "--to", "2", "--hold-fps", "25"), 2, "--live")

    def test_live_and_baked_pictures_agree(self):
        """What is left is silhouettes and shadows in the air: docs/measurements/live-accuracy.md."""
        out = self.out()
        common = ("--size", "256x75", "--at", "50", "--glare", "0")
        self.works(run("render", WORK / "demo", "-o", out / "baked.exr", *common))
        self.works(run("render", WORK / "demo", "-o", out / "live.exr", "--live", *common))
        done = run("compare", out / "live.exr", out / "baked.exr", "--ev", "6", "--json")
        self.works(done)
        row = json.loads(done.stdout)
        self.assertGreater(row["psnr"], 31.5)
        self.assertLess(abs(row["bias"]), 0.03)

    def test_vulkan_is_used_as_it_should_be(self):
        done = self.render(self.out() / "a.png", "--at", "50", "--validation")
        self.works(done)
        self.assertNotIn("validation", done.text.lower())

    def test_march_and_exposure_change_the_picture(self):
        out = self.out()
        self.works(self.render(out / "cone.png", "--at", "50"))
        self.works(self.render(out / "march.png", "--at", "50", "--beams", "march", "--steps", "40"))
        self.works(self.render(out / "bright.png", "--at", "50", "--ev", "3"))
        pictures = {(out / name).read_bytes() for name in ("cone.png", "march.png", "bright.png")}
        self.assertEqual(len(pictures), 3)

    def test_quiet_is_quiet(self):
        self.assertEqual(self.render(self.out() / "a.png", "--quiet").text, "")

    def test_places_that_cannot_be_written(self):
        self.fails(self.render(WORK / "no" / "such" / "a.png"), 1, "no such folder")
        self.fails(self.render(WORK / "no" / "such" / "a.mp4", "--from", 0, "--to", 1), 1, "no such folder")

    def test_full_disk_leaves_nothing_behind(self):
        if not full_disk.is_possible():
            return
        out = self.out()
        (out / "old.png").write_bytes(b"yesterday")
        still = ("--at", 50)
        for name, when in (("a.png", still), ("old.png", still), ("a.exr", still), ("a.mp4", ("--from", 50, "--to", 51))):
            done = self.render(out / name, *when, full=out)
            self.fails(done, 1, name)
            self.only(out, "old.png")
        self.assertEqual((out / "old.png").read_bytes(), b"yesterday")


class BadShows(Case):
    """The picture is drawn all the same, with a message and exit 1."""

    def draws_with_a_message(self, show, *parts):
        out = self.out()
        done = run("render", show, "-o", out / "a.png", "--size", SIZE, "--at", "70")
        self.fails(done, 1, *parts)
        self.assertGreater((out / "a.png").stat().st_size, 1000, done.text)
        return (out / "a.png").read_bytes()

    def baked_copy(self, name):
        show = copy_demo(name)
        shutil.copytree(WORK / "demo" / ".ghost", show / ".ghost")
        for manifest in show.rglob("manifest.json"):
            os.utime(manifest, (time.time() + 5, time.time() + 5))
        return show

    def test_lost_and_wrong_passes(self):
        whole = self.out() / "whole.png"
        self.works(run("render", WORK / "demo", "-o", whole, "--size", SIZE, "--at", "70"))
        self.works(run("render", WORK / "demo", "-o", self.out() / "a.png", "--size", "48x30"))
        show = self.baked_copy("lost_pass")
        lost = next(p for p in show.rglob("light_Wash 1_0.exr") if SIZE in str(p))
        surroundings = lost.parent / "ambient.exr"
        good = lost.read_bytes()
        other = next(p for p in (WORK / "demo" / ".ghost").rglob(lost.name) if "48x30" in str(p))
        for content, name in (
            (None, "missing"),
            (b"", "empty"),
            (b"not an exr", "junk"),
            (other.read_bytes(), "of another size"),
            (good[: len(good) // 2], "cut short"),
        ):
            for damaged in (lost, surroundings):
                damaged.unlink() if content is None else damaged.write_bytes(content)
                picture = self.out() / "a.png"
                done = run("render", show, "-o", picture, "--size", SIZE, "--at", "70")
                self.works(done)
                self.assertIn(damaged.name, done.text, name)
                self.assertIn("baked again", done.text, name)
                self.assertEqual(picture.read_bytes(), whole.read_bytes(), name)
                self.assertEqual(lost.read_bytes(), good, name)

    def test_cameras_whose_names_are_nearly_the_same(self):
        folder = copy_demo("names")
        edit(folder / "show.toml", 'name = "house"', 'name = "cam.1"')
        edit(folder / "show.toml", 'name = "close"', 'name = "cam:1"')
        edit(folder / "show.toml", 'name = "high"', 'name = "cam_1"')
        pictures = set()
        out = self.out()
        for view in ("cam.1", "cam_1"):
            self.works(run("render", folder, "-o", out / "a.png", "--view", view, "--size", SIZE, "--at", "50"))
            pictures.add((out / "a.png").read_bytes())
        self.assertEqual(len(pictures), 2)

    def test_texture_beside_the_stage(self):
        """Whoever changes it sees it, and while it is missing every render says so."""
        folder = copy_demo("obj")
        (folder / "wall.obj").write_text("mtllib wall.mtl\nusemtl wall\nv -8 4 0\nv 8 4 0\nv 8 4 8\nv -8 4 8\n"
                                         "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 -1 0\nf 1/1/1 2/2/1 3/3/1 4/4/1\n")
        (folder / "wall.mtl").write_text("newmtl wall\nKd 1 1 1\nmap_Kd wall.png\n")
        edit(folder / "show.toml", 'stage = "stage.glb"', 'stage = "wall.obj"')
        out = self.out()
        picture = ("render", folder, "-o", out / "a.png", "--size", SIZE, "--at", "50", "--ev", "2")
        for _ in range(2):
            self.fails(run(*picture), 1, "wall.png")
        (folder / "wall.mtl").rename(folder / "other.mtl")
        self.fails(run("check", folder), 1, "wall.mtl")
        os.mkfifo(folder / "wall.mtl")  # must not be waited for
        self.fails(run("check", folder), 1, "wall.mtl")
        (folder / "wall.mtl").unlink()
        (folder / "other.mtl").rename(folder / "wall.mtl")
        seen = []
        for red in (255, 40):
            chunk = lambda kind, data: len(data).to_bytes(4, "big") + kind + data + zlib.crc32(kind + data).to_bytes(4, "big")
            (folder / "wall.png").write_bytes(
                b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", bytes([0, 0, 0, 1, 0, 0, 0, 1, 8, 2, 0, 0, 0])) +
                chunk(b"IDAT", zlib.compress(bytes([0, red, 255, 90]))) + chunk(b"IEND", b""))
            self.works(run(*picture))
            seen.append((out / "a.png").read_bytes())
        self.assertNotEqual(*seen)

    def test_what_would_come_out_after_the_bake(self):
        folder = copy_demo("early")
        picture = ("render", folder, "--size", SIZE, "-o")
        self.fails(run(*picture, WORK / "nowhere" / "a.png"), 1, "no such folder")
        (WORK / "folder.mp4").mkdir()
        self.fails(run(*picture, WORK / "folder.mp4", "--from", "1", "--to", "2"), 1, "is a folder")
        self.fails(run(*picture, WORK / "a.png", "--replay", WORK / "none.show"), 1, "none.show")
        self.fails(run(*picture, WORK / "a.mp4", "--live-input", "--universes", "5-1"), 2, "5-1")
        edit(folder / "show.toml", 'recording = "demo.show"', 'recording = "lost.show"')
        self.fails(run(*picture, WORK / "a.png"), 1, "lost.show")
        edit(folder / "show.toml", 'recording = "lost.show"', "")
        self.fails(run(*picture, WORK / "a.png"), 1, "has no recording")
        self.assertFalse((folder / ".ghost").exists())

    def test_film_that_is_interrupted_replaces_none(self):
        out = self.out()
        (out / "a.mp4").write_bytes(b"the film of yesterday")
        render = subprocess.Popen([str(PROGRAM), "render", str(WORK / "demo"), "-o", str(out / "a.mp4"), "--from", "0", "--to", "80",
                                   "--size", SIZE], stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        time.sleep(4)
        render.send_signal(signal.SIGINT)
        text = render.communicate(timeout=60)[0].decode()
        self.assertEqual(render.returncode, 1, text)
        self.assertIn("interrupted", text)
        self.assertEqual((out / "a.mp4").read_bytes(), b"the film of yesterday")
        self.only(out, "a.mp4")

    def test_missing_fixture_file(self):
        show = self.baked_copy("no_gdtf")
        edit(show / "show.toml", "VL2500_Wash.gdtf", "VL2500_Wahs.gdtf")
        self.draws_with_a_message(show, "VL2500_Wahs.gdtf", "show.toml:")

    def test_unknown_key_and_mode(self):
        show = self.baked_copy("odd_keys")
        edit(show / "show.toml", "ambient_lux", "ambiant_lux")
        edit(show / "show.toml", "Standard 15 channels", "Standard 16 channels")
        self.draws_with_a_message(show, "ambiant_lux", "ambient_lux", "Standard 16 channels", "Standard 15 channels")

    def test_missing_recording(self):
        show = self.baked_copy("no_recording")
        (show / "demo.show").unlink()
        self.fails(run("render", show, "-o", self.out() / "a.png", "--size", SIZE), 1, "demo.show")
        edit(show / "show.toml", 'recording = "demo.show"\n', "")
        self.fails(run("render", show, "-o", self.out() / "a.png", "--size", SIZE), 1, "--replay")

    def test_stage_cut_short(self):
        show = copy_demo("cut_stage")
        data = (show / "stage.glb").read_bytes()
        (show / "stage.glb").unlink()
        (show / "stage.glb").write_bytes(data[: len(data) // 3])
        self.fails(run("render", show, "-o", self.out() / "a.png", "--size", SIZE), 1, "stage.glb")
        (show / "stage.glb").unlink()
        self.fails(run("render", show, "-o", self.out() / "a.png", "--size", SIZE), 1, "stage.glb")

    def test_not_toml(self):
        show = copy_demo("no_toml")
        (show / "show.toml").write_text("[show\nname = 3\n")
        self.fails(run("render", show, "-o", self.out() / "a.png"), 1, "show.toml:1")

    def test_full_disk_while_baking(self):
        if not full_disk.is_possible():
            return
        show = copy_demo("full_disk")
        out = self.out()
        arguments = ("render", show, "-o", out / "a.png", "--size", "48x30")
        self.fails(run(*arguments, full=show), 1, ".ghost")
        self.only(out)
        self.works(run(*arguments))  # and goes on when there is room again
        self.only(out, "a.png")
        self.assertEqual([p for p in show.rglob("*") if "tmp" in p.name or p.name.endswith(".part")], [])


def main():
    global WORK
    if not PROGRAM.exists():
        print(f"skipped: {PROGRAM} is not built")
        return 77
    with tempfile.TemporaryDirectory(prefix="ghost_cli_") as folder:
        WORK = pathlib.Path(folder)
        (WORK / "fixtures").symlink_to(SOURCE / "assets" / "fixtures")
        copy_demo("demo")
        suite = unittest.defaultTestLoader.loadTestsFromModule(sys.modules["__main__"])
        return 0 if unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
