# SPDX-License-Identifier: Apache-2.0
"""What a test cannot run without: where a Debian package is missing, the test is skipped with one sentence that names it, which
./dev test counts. Scripts of the shell run this file: needs.py PACKAGE..."""
import importlib.util
import pathlib
import shutil
import sys

FILES = {"libasound2-plugins": "*/alsa-lib/libasound_module_pcm_pulse.so", "qt6-wayland": "*/qt6/plugins/platforms/libqwayland-generic.so"}
MODULES = {"python3-numpy": "numpy", "python3-pil": "PIL"}
PROGRAMS = {"iproute2": ["ip"], "nftables": ["nft"], "tshark": ["tshark"], "ola": ["olad", "ola_rdm_discover", "ola_rdm_get", "ola_rdm_set", "ola_streaming_client"], "qlcplus": ["qlcplus"], "util-linux": ["setpriv", "unshare", "nsenter"], "xvfb": ["Xvfb"],
            "xdotool": ["xdotool"], "weston": ["weston"], "openbox": ["openbox"], "chromium": ["chromium"], "firefox-esr": ["firefox-esr"], "webkit2gtk-driver": ["WebKitWebDriver"], "poppler-utils": ["pdftotext", "pdffonts"], "slurm-wlm": ["slurmctld", "slurmd", "sbatch", "squeue"], "munge": ["munged"],
            "faketime": ["faketime"], "ffmpeg": ["ffmpeg", "ffprobe"], "patchelf": ["patchelf"], "help2man": ["help2man"], "pulseaudio": ["pulseaudio"], "pulseaudio-utils": ["pactl", "parec"]}


def skip(reason):
    print("skipped:", reason)
    sys.exit(77)


def is_there(package, path=None):
    if package in FILES:
        return any(pathlib.Path("/usr/lib").glob(FILES[package]))
    if package in MODULES:
        return importlib.util.find_spec(MODULES[package]) is not None
    return all(shutil.which(program, path=path) for program in PROGRAMS[package])


def packages(*names, path=None):
    """path: where programs are looked for, if not in PATH."""
    missing = [name for name in names if not is_there(name, path)]
    if missing:
        skip(f"{' and '.join(missing)} {'is' if len(missing) == 1 else 'are'} not installed")


if __name__ == "__main__":
    packages(*sys.argv[1:])
