# SPDX-License-Identifier: Apache-2.0
"""The demo show in a folder of its own, whose large files are links to the demo's."""


def demo_show(source, folder):
    """Makes the folder; the text of show.toml, which whoever asks writes there, with the fixtures where they are."""
    folder.mkdir()
    demo = source / "assets/demo"
    for large in ("stage.glb", "demo.show"):
        (folder / large).symlink_to(demo / large)
    return (demo / "show.toml").read_text(encoding="utf-8").replace("../fixtures", str(source / "assets/fixtures"))
