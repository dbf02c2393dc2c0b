# SPDX-License-Identifier: Apache-2.0
"""Shared by the tests of the add-on: its modules, JSON files to read, and small bakes of the program."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "samples/blender/foamtex_import"))

PROGRAM = os.environ.get("FOAMTEX")
SMALL = ["--set", "foam.bubbles=24", "--set", "foam.lloyd=2", "-q"]  # options of a bake that takes a second
needs_program = unittest.skipUnless(PROGRAM, "FOAMTEX is not set")


def foamtex(*arguments):
    subprocess.run([PROGRAM, *map(str, arguments)], check=True, stdin=subprocess.DEVNULL)


class FolderTest(unittest.TestCase):
    """A test with a temporary folder, and functions that write descriptions of bakes into it."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def write_json(self, name, document):
        path = self.folder / name
        path.write_text(json.dumps(document), encoding="utf-8")
        return path

    def write_manifest(self, *sets):
        return self.write_json("manifest.json", {"format": "foamtex-manifest", "version": 1, "sets": list(sets)})

    def write_images(self, baked):
        """Writes an empty file for every image of a set."""
        for file in baked["files"]:
            (self.folder / file["path"]).write_bytes(b"")


def map_entry(name, **members):
    return {"name": name, "color_space": "data", "alpha": "none", "type": "uint8"} | members


def make_set(maps, frames=range(1, 5), period=4, **members):
    """Returns a set of a manifest. `maps` contains entries of maps, or names of maps of numbers."""
    entries = [map_entry(item) if isinstance(item, str) else item for item in maps]
    frames = list(frames)
    files = [{"path": f"a_{entry['name']}.{frame:04d}.png", "maps": [entry["name"]], "frame": frame}
             for frame in frames for entry in entries]
    foam = [{"frame": frame, "tiles": True, "bubbles": 100, "mean_area": 1.0} for frame in frames]
    return {"preset": "a", "description": "a foam", "seed": 1, "size": [64, 64], "frames_per_second": 24,
            "loop": {"period": period}, "conventions": {"normal_y": "up"}, "maps": entries, "files": files,
            "foam": foam, "toml": '[relief]\nmean_bubble = "current"\n'} | members
