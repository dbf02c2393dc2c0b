# SPDX-License-Identifier: Apache-2.0
"""Renders materials without light, and compares the pictures with the files of the frames."""
import json
import pathlib
import tempfile
import unittest

import bpy
import numpy

import bakes
import foamtex_import
import stage

ROUNDING = 0.5  # codes of 255; the path from a file through the renderer to a PNG rounds once
FILTER = 0.6  # for a sheet, whose texels are a little off the centers of pixels


class FramesTest(unittest.TestCase):
    def show(self, material, output, view="Standard", tiles=1):
        """Shows a plane with the unlit color that a socket of the material gives."""
        scene = bpy.context.scene
        stage.add_plane(material, tiles=tiles)
        stage.look_from_above(scene, tiles, tiles)
        stage.show_unlit(scene, output, view)
        return scene

    def setUp(self):
        stage.empty_scene()

    def check(self, scene, shown, bake, name, limit=ROUNDING):
        """Checks that scene frames show the files of frames, and that no neighbor of the file fits as well."""
        for scene_frame, file_frame in shown.items():
            picture = stage.render(scene, scene_frame)
            difference = stage.mean_difference(picture, bakes.codes(bake, name, file_frame))
            self.assertLess(difference, limit, f"scene frame {scene_frame}, file {file_frame}")
            for other in set(shown.values()) - {file_frame}:
                self.assertGreater(stage.mean_difference(picture, bakes.codes(bake, name, other)), 2 * limit)


class Loop(FramesTest):
    def test_albedo(self):
        material = bakes.load("loop")
        scene = self.show(material, bakes.texture(material, "albedo").outputs["Color"])
        self.check(scene, {1: 1, 2: 2, 5: 5, 8: 8, 9: 1, 0: 8, 17: 1}, "loop", "albedo")

    def test_data(self):
        for name in ("normal", "height"):
            stage.empty_scene()
            material = bakes.load("loop")
            scene = self.show(material, bakes.texture(material, name).outputs["Color"], "Raw")
            self.check(scene, {1: 1, 4: 4, 8: 8, 9: 1}, "loop", name)

    def test_tiles(self):
        material = bakes.load("loop")
        scene = self.show(material, bakes.texture(material, "albedo").outputs["Color"], tiles=2)
        self.assertLess(stage.mean_difference(stage.render(scene, 3), tiled(bakes.codes("loop", "albedo", 3))), ROUNDING)

    def test_animation(self):
        material = bakes.load("loop", scene=True)
        scene = self.show(material, bakes.texture(material, "albedo").outputs["Color"])
        scene.frame_start, scene.frame_end = 7, 10
        with tempfile.TemporaryDirectory() as folder:
            scene.render.filepath = str(pathlib.Path(folder) / "a.####.png")
            bpy.ops.render.render(animation=True)
            for scene_frame, file_frame in ((7, 7), (8, 8), (9, 1), (10, 2)):
                picture = stage.read_codes(pathlib.Path(folder) / f"a.{scene_frame:04d}.png")
                self.assertLess(stage.mean_difference(picture, bakes.codes("loop", "albedo", file_frame)), ROUNDING)


def tiled(codes):
    return numpy.tile(codes, (2, 2, 1))


class Part(FramesTest):
    """The frames 3 to 6 of a loop of 8."""

    def test_last_frame_is_held(self):
        material = bakes.load("part")
        scene = self.show(material, bakes.texture(material, "albedo").outputs["Color"])
        self.check(scene, {3: 3, 4: 4, 6: 6, 7: 6, 12: 6}, "part", "albedo")

    def test_says_what_earlier_frames_show(self):
        notes = []
        bakes.load("part", report=notes.append)
        self.assertEqual(notes, ["foamtex: sea_foam: the frames do not repeat, and Blender has no image before scene "
                                 "frame 3"])

    def test_cyclic(self):
        material = bakes.load("part", cyclic=True)
        scene = self.show(material, bakes.texture(material, "albedo").outputs["Color"])
        self.check(scene, {2: 6, 3: 3, 6: 6, 7: 3, 8: 4}, "part", "albedo")

    def test_normals_agree_with_the_other_direction(self):
        material = bakes.load("part")
        scene = self.show(material, bakes.source(bakes.node(material, "NORMAL_MAP").inputs["Color"]).outputs[0], "Raw")
        self.check(scene, {4: 4}, "loop", "normal", limit=1.0)  # both files are rounded, in other directions


class Sheet(FramesTest):
    def test_frames(self):
        material = bakes.load_sheet()
        scene = self.show(material, bakes.texture(material, "albedo").outputs["Color"])
        self.check(scene, {0: 8, 1: 1, 2: 2, 3: 3, 4: 4, 5: 5, 8: 8, 9: 1}, "loop", "albedo", FILTER)

    def test_tiles(self):
        material = bakes.load_sheet()
        scene = self.show(material, bakes.texture(material, "albedo").outputs["Color"], tiles=2)
        difference = numpy.abs(stage.render(scene, 6) - tiled(bakes.codes("loop", "albedo", 6)))[..., :3]
        self.assertLess(difference.mean(), FILTER)

    def test_without_a_loop(self):
        material = bakes.load_sheet(cyclic=False)
        scene = self.show(material, bakes.texture(material, "albedo").outputs["Color"])
        self.check(scene, {-3: 1, 1: 1, 8: 8, 12: 8}, "loop", "albedo", FILTER)


class Float(FramesTest):
    """The same frames as EXR files: colors are linear, normals are from -1 to 1."""

    def test_colors(self):
        material = bakes.load("float")
        scene = self.show(material, bakes.texture(material, "albedo").outputs["Color"])
        self.check(scene, {1: 1, 2: 2}, "loop", "albedo")

    def test_normals(self):
        material = bakes.load("float")
        scene = self.show(material, bakes.source(bakes.node(material, "NORMAL_MAP").inputs["Color"]).outputs[0], "Raw")
        self.check(scene, {1: 1, 2: 2}, "loop", "normal")

    def test_numbers(self):
        material = bakes.load("float")
        scene = self.show(material, bakes.texture(material, "roughness").outputs["Color"], "Raw")
        self.check(scene, {1: 1}, "loop", "roughness")


class Patch(FramesTest):
    def test_transparency(self):
        for maps in (["albedo"], None):
            scene = stage.empty_scene(samples=64)
            material = bakes.load("raft", maps=maps)
            stage.add_plane(material)
            stage.look_from_above(scene)
            scene.render.film_transparent = True
            difference = numpy.abs(stage.render(scene, 1) - bakes.codes("raft", "opacity", 1)[..., :1])[..., 3]
            self.assertLess(difference.mean(), 1.0)

    def test_colors_are_straight(self):
        """An opaque rim pixel has the color of the foam, not a darker one."""
        material = bakes.load("raft")
        scene = self.show(material, bakes.texture(material, "albedo").outputs["Color"])
        self.check(scene, {1: 1, 2: 2}, "raft", "albedo")


class Packed(FramesTest):
    """Channels of a packed image give the sockets the same numbers as separate maps."""

    def setUp(self):
        super().setUp()
        self.manifest = pack_maps()

    def test_numbers(self):
        for socket, name in (("Roughness", "roughness"), ("Metallic", "occlusion")):
            stage.empty_scene()
            material = foamtex_import.load(self.manifest)
            scene = self.show(material, bakes.surface(material).inputs[socket].links[0].from_socket, "Raw")
            self.assertLess(stage.mean_difference(stage.render(scene, 1), bakes.codes("loop", name, 1)), ROUNDING)

    def test_normals_without_z(self):
        material = foamtex_import.load(self.manifest)
        color = bakes.node(material, "NORMAL_MAP").inputs["Color"].links[0].from_socket
        scene = self.show(material, color, "Raw")
        difference = stage.mean_difference(stage.render(scene, 1), bakes.codes("loop", "normal", 1))
        self.assertLess(difference, 1.0)  # z from rounded x and y


def pack_maps():
    """Writes a bake whose image contains normal.X, normal.Y, 1 - roughness and, as metallic, occlusion."""
    folder = bakes.FOLDER / "packed"
    folder.mkdir(exist_ok=True)
    normal, roughness, occlusion = (bakes.codes("loop", name, 1) for name in ("normal", "roughness", "occlusion"))
    channels = [normal[..., 0], normal[..., 1], 255 - roughness[..., 0], occlusion[..., 0]]
    write_codes(folder / "a_packed.0001.png", numpy.stack(channels, axis=-1))
    manifest = json.loads((bakes.FOLDER / "loop/manifest.json").read_text(encoding="utf-8"))
    baked = manifest["sets"][-1]
    baked["maps"] = [{"name": "packed", "packed": ["normal.X", "normal.Y", "1-roughness", "metallic"],
                      "color_space": "data", "alpha": "none", "type": "uint8"}]
    baked["files"] = [{"path": "a_packed.0001.png", "maps": ["packed"], "frame": 1}]
    path = folder / "manifest.json"
    path.write_text(json.dumps(manifest), encoding="utf-8")
    return path


def write_codes(path, codes):
    height, width, _ = codes.shape
    image = bpy.data.images.new("packed", width, height, alpha=True)
    image.colorspace_settings.name = "Non-Color"
    image.alpha_mode = "CHANNEL_PACKED"
    image.pixels.foreach_set((codes / 255).astype(numpy.float32).ravel())
    image.filepath_raw = str(path)
    image.file_format = "PNG"
    image.save()
    bpy.data.images.remove(image)
