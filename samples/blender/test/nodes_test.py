# SPDX-License-Identifier: Apache-2.0
"""Checks the nodes, images and settings of imported materials."""
import re
import unittest

import bpy

import bakes
import foamtex_import
import stage


class NodesTest(unittest.TestCase):
    def setUp(self):
        stage.empty_scene()


class Loop(NodesTest):
    def test_inputs(self):
        material = bakes.load("loop", occlusion=True)
        inputs = bakes.surface(material).inputs
        multiply = bakes.source(inputs["Base Color"])
        self.assertEqual([bakes.source(socket).label for socket in multiply.inputs[:2]], ["albedo", "occlusion"])
        self.assertEqual(bakes.source(inputs["Roughness"]).label, "roughness")
        self.assertEqual(bakes.source(bakes.source(inputs["Normal"]).inputs["Color"]).label, "normal")
        self.assertFalse(inputs["Alpha"].is_linked)

    def test_occlusion_is_an_option(self):
        self.assertEqual(bakes.source(bakes.surface(bakes.load("loop")).inputs["Base Color"]).label, "albedo")

    def test_color_spaces(self):
        spaces = {node.label: node.image.colorspace_settings.name
                  for node in bakes.textures(bakes.load("loop", occlusion=True))}
        self.assertEqual(spaces, {"albedo": "sRGB", "normal": "Non-Color", "height": "Non-Color",
                                  "roughness": "Non-Color", "occlusion": "Non-Color"})

    def test_every_sequence(self):
        for node in bakes.textures(bakes.load("loop", occlusion=True)):
            user = node.image_user
            self.assertEqual(
                (node.image.source, node.extension, user.frame_start, user.frame_duration, user.frame_offset,
                 user.use_cyclic, user.use_auto_refresh),
                ("SEQUENCE", "REPEAT", 1, 8, 0, True, True), node.label)

    def test_tags(self):
        data = bakes.load("loop", asset=True).asset_data
        self.assertEqual({tag.name for tag in data.tags}, {"foamtex", "sea_foam", "animated", "tile"})
        self.assertTrue(data.description)

    def test_preview_shows_the_map_lit(self):
        preview = bakes.load("loop", asset=True).preview
        self.assertEqual(preview.image_size[:], (256, 256))
        lit = bakes.codes("loop", "lit", 1)
        shown = [value * 255 for value in preview.image_pixels_float]
        self.assertLess(abs(sum(shown) / len(shown) - float(lit.mean())), 1)

    def test_no_asset_by_default(self):
        self.assertIsNone(bakes.load("loop").asset_data)

    def test_scene(self):
        scene = bpy.context.scene
        scene.render.fps = 25
        bakes.load("loop")
        self.assertEqual(scene.render.fps, 25)
        bakes.load("loop", scene=True)
        self.assertEqual((scene.render.fps / scene.render.fps_base, scene.frame_start, scene.frame_end), (24, 1, 8))


class Part(NodesTest):
    """The frames 3 to 6, with normals whose y points down."""

    def test_offset(self):
        user = bakes.texture(bakes.load("part"), "albedo").image_user
        self.assertEqual((user.frame_start, user.frame_duration, user.frame_offset, user.use_cyclic), (3, 4, 2, False))

    def test_green_is_inverted(self):
        material = bakes.load("part")
        invert = bakes.source(bakes.node(material, "NORMAL_MAP").inputs["Color"])
        self.assertEqual((invert.operation, invert.inputs[1].default_value[:], invert.inputs[2].default_value[:]),
                         ("MULTIPLY_ADD", (1, -1, 1), (0, 1, 0)))


class Heights(NodesTest):
    def displacement(self, **options):
        material = bakes.load("loop", **options)
        node = bakes.node(material, "DISPLACEMENT")
        return material, node, bakes.source(node.inputs["Scale"])

    def test_scale(self):
        text = (bakes.FOLDER / "loop/manifest.json").read_text(encoding="utf-8")
        expected = float(re.search(r'"displacement":([0-9.e-]+)', text)[1])
        _, node, scale = self.displacement(tile_size=2.5)
        self.assertEqual(node.inputs["Midlevel"].default_value, 0)
        self.assertAlmostEqual(scale.inputs[1].default_value, expected, 8)
        self.assertEqual(bakes.source(scale.inputs[0]).outputs[0].default_value, 2.5)

    def test_only_one_of_normals_and_heights_is_linked(self):
        for relief, normal, height in ((None, True, False), ("NORMAL", True, False), ("DISPLACEMENT", False, True)):
            material, _, _ = self.displacement(relief=relief)
            output = bakes.node(material, "OUTPUT_MATERIAL")
            self.assertEqual((bakes.surface(material).inputs["Normal"].is_linked,
                              output.inputs["Displacement"].is_linked), (normal, height), relief)

    def test_scales_that_differ_are_animated(self):
        text = (bakes.FOLDER / "coarsening/manifest.json").read_text(encoding="utf-8")
        expected = [float(number) for number in re.findall(r'"displacement":([0-9.e-]+)', text)]
        scale = bakes.source(bakes.node(bakes.load("coarsening"), "DISPLACEMENT").inputs["Scale"])
        curve, = scale.id_data.animation_data.action.fcurves
        found = [curve.evaluate(frame) for frame in (0, 1, 2, 3, 4, 5)]
        self.assertGreater(max(expected), min(expected))
        for value, frame in zip(found, (1, 1, 2, 3, 4, 4)):
            self.assertAlmostEqual(value, expected[frame - 1], 8)


class OtherBakes(NodesTest):
    def test_patch(self):
        material = bakes.load("raft", maps=["albedo"])
        self.assertEqual(bakes.source(bakes.surface(material).inputs["Alpha"]).label, "albedo")
        self.assertEqual(bakes.texture(material, "albedo").extension, "EXTEND")
        alpha = bakes.source(bakes.surface(bakes.load("raft")).inputs["Alpha"])
        self.assertEqual(alpha.label, "opacity")

    def test_layers_are_rejected(self):
        with self.assertRaisesRegex(foamtex_import.Fault, "bake with {map} in the file name"):
            bakes.load("layers")

    def test_a_rejected_bake_adds_nothing(self):
        before = len(bpy.data.materials)
        with self.assertRaises(foamtex_import.Fault):
            bakes.load("layers")
        self.assertEqual(len(bpy.data.materials), before)

    def test_linear_colors(self):
        material = bakes.load("float")
        self.assertIn(bakes.texture(material, "albedo").image.colorspace_settings.name, ("Linear", "Linear Rec.709"))
        self.assertEqual(bakes.texture(material, "normal").image.colorspace_settings.name, "Non-Color")

    def test_sheet(self):
        material = bakes.load_sheet()
        for node in bakes.textures(material):
            self.assertEqual((node.image.source, node.extension), ("FILE", "EXTEND"))
            self.assertEqual(bakes.source(node.inputs["Vector"]).type, "GROUP")
        group = bakes.node(material, "GROUP").node_tree
        curve, = group.animation_data.drivers
        self.assertTrue(curve.driver.is_simple_expression)
