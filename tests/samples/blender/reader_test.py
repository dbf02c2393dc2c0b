# SPDX-License-Identifier: Apache-2.0
import math
import unittest

import support
from model.fault import Fault
from model.reader import read_bake


class ChoiceOfSet(support.FolderTest):
    def setUp(self):
        super().setUp()
        self.path = self.write_manifest(support.make_set(["height"]), support.make_set(["height"], seed=2),
                                        support.make_set(["height"], preset="b", size=[128, 64]))

    def test_newest_is_the_last(self):
        self.assertEqual(read_bake(self.path).preset, "b")

    def test_by_preset_size_and_seed(self):
        self.assertEqual(read_bake(self.path, preset="a").seed, 2)
        self.assertEqual(read_bake(self.path, seed=1).preset, "b")
        self.assertEqual(read_bake(self.path, preset="a", seed=1).seed, 1)
        self.assertEqual(read_bake(self.path, size=(64, 64)).seed, 2)

    def test_says_what_there_is(self):
        with self.assertRaisesRegex(Fault, "it has: a 64x64 seed 1, a 64x64 seed 2, b 128x64 seed 1"):
            read_bake(self.path, preset="c")


class BadFiles(support.FolderTest):
    def test_missing_file(self):
        with self.assertRaisesRegex(Fault, "^cannot read '.*manifest.json': No such file"):
            read_bake(self.folder / "manifest.json")

    def test_other_documents(self):
        for document, reason in (([], "neither a manifest nor a flipbook"), ({"format": "x"}, "neither"),
                                 ({"format": "foamtex-manifest", "version": 2}, "version 2"),
                                 ({"format": "foamtex-manifest", "version": 1}, "a member is missing"),
                                 ({"format": "foamtex-manifest", "version": 1, "sets": [{"preset": 3}]}, "missing")):
            with self.assertRaisesRegex(Fault, reason):
                read_bake(self.write_json("a.json", document))

    def test_not_json(self):
        (self.folder / "a.json").write_text("{", encoding="utf-8")
        with self.assertRaisesRegex(Fault, "is not JSON"):
            read_bake(self.folder / "a.json")

    def test_paths_stay_in_the_folder(self):
        for name in ("../a.png", "/a.png"):
            baked = support.make_set(["height"])
            baked["files"][0]["path"] = name
            with self.assertRaisesRegex(Fault, "leaves the folder"):
                read_bake(self.write_manifest(baked))


class Displacements(support.FolderTest):
    def read(self, baked):
        return read_bake(self.write_manifest(baked)).maps["height"].displacements

    def test_of_codes_by_frame(self):
        baked = support.make_set(["height"], frames=(1, 2))
        for file, displacement in zip(baked["files"], (0.01, 0.02)):
            file["displacement"] = displacement
        self.assertEqual(self.read(baked), {1: 0.01, 2: 0.02})

    def test_of_numbers_is_the_diameter_of_a_bubble(self):
        # 100 bubbles in an image of width 1 and height 1/2: each has the area 0.005, of a circle with the diameter
        # sqrt(4 * 0.005 / pi).
        baked = support.make_set([support.map_entry("height", type="float")], frames=(1,), size=[64, 32])
        self.assertAlmostEqual(self.read(baked)[1], math.sqrt(0.02 / math.pi), 12)

    def test_unknown_for_a_patch_or_another_unit(self):
        baked = support.make_set([support.map_entry("height", type="float")])
        self.assertIsNone(self.read(baked | {"toml": 'mean_bubble = "first"\n'}))
        baked["foam"][0]["tiles"] = False
        self.assertIsNone(self.read(baked))


@support.needs_program
class RealBakes(support.FolderTest):
    """Reads what the program writes, so that a change of its formats is noticed."""

    def bake(self, *arguments, pattern="{preset}_{map}.####.png"):
        support.foamtex("bake", "sea_foam", *support.SMALL, "--size", "32", "--out", self.folder / pattern, *arguments)
        return self.folder / "manifest.json"

    def test_manifest(self):
        bake = read_bake(self.bake("--frames", "2-3", "--maps", "albedo,normal,height", "--normal-y", "dx"))
        self.assertEqual((bake.preset, bake.size, bake.normal_y, bake.tiles, bake.period, bake.frames_per_second),
                         ("sea_foam", (32, 32), "down", True, 48, 24.0))
        self.assertEqual([bake.maps[name].color_space for name in ("albedo", "normal", "height")],
                         ["sRGB", "data", "data"])
        for images in bake.maps.values():
            self.assertTrue(images.is_codes)
            self.assertEqual(list(images.files), [2, 3])
            self.assertTrue(all(path.is_file() for path in images.files.values()))

    def test_scale_of_heights_in_an_exr_agrees_with_a_png(self):
        codes = read_bake(self.bake("--frames", "1", "--maps", "height", "--set", "height.full=1")).maps["height"]
        numbers = read_bake(self.bake("--frames", "1", "--maps", "height", "--set", "height.full=1",
                                      pattern="{map}.####.exr")).maps["height"]
        self.assertFalse(numbers.is_codes)
        self.assertAlmostEqual(numbers.displacements[1], codes.displacements[1], 12)

    def test_layers(self):
        bake = read_bake(self.bake("--frames", "1", "--maps", "albedo,height", pattern="all.####.exr"))
        self.assertTrue(bake.maps["albedo"].layered)
        self.assertEqual(bake.maps["albedo"].color_space, "linear sRGB")

    def test_flipbook(self):
        self.bake("--frames", "2-5", "--maps", "albedo,height")
        support.foamtex("flipbook", self.folder, "--columns", "4", "--gutter", "4", "-q")
        bake = read_bake(self.folder / "sea_foam_sheet.json")
        self.assertEqual((bake.sheet_frames, bake.sheet.columns, bake.period), ((2, 3, 4, 5), 4, 0))
        # A cell of 32 + 2 * 4 pixels is a quarter of the width of the sheet, which has one row.
        self.assertEqual((bake.sheet.cell, bake.sheet.inset, bake.sheet.frame), ((0.25, 1), (0.025, 0.1), (0.2, 0.8)))
        self.assertTrue(bake.maps["albedo"].files[1].is_file())
        self.assertGreater(bake.maps["height"].displacements[1], 0)


class Flipbooks(support.FolderTest):
    def test_texture_arrays_alone_are_rejected(self):
        book = {"format": "foamtex-flipbook", "version": 1, "frame_numbers": "1-4", "frames": 4,
                "layout": {"frame_size": [8, 8], "layers": 4}, "images": [{"file": "a.dds", "map": "albedo"}]}
        with self.assertRaisesRegex(Fault, "cannot read texture arrays"):
            read_bake(self.write_json("a_sheet.json", book))


if __name__ == "__main__":
    unittest.main()
