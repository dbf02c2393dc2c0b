# SPDX-License-Identifier: Apache-2.0
"""Runs the operators of the menu and of the panel."""
import unittest

import bpy

import bakes
import stage


class Import(unittest.TestCase):
    def setUp(self):
        stage.empty_scene()

    def run_import(self, bake, **options):
        return bpy.ops.import_material.foamtex(filepath=str(bakes.FOLDER / bake / "manifest.json"), **options)

    def test_assigns_to_the_active_object(self):
        bpy.ops.mesh.primitive_plane_add(size=3)
        self.assertEqual(self.run_import("loop"), {"FINISHED"})
        material = bpy.context.object.active_material
        self.assertEqual(material.name, "sea_foam")
        scale = bakes.source(bakes.node(material, "DISPLACEMENT").inputs["Scale"])
        self.assertAlmostEqual(bakes.source(scale.inputs[0]).outputs[0].default_value, 3, 5)

    def test_without_an_object(self):
        self.assertEqual(self.run_import("loop", maps="albedo, normal", asset=True, scene=True), {"FINISHED"})
        material, = bpy.data.materials
        self.assertEqual(len(bakes.textures(material)), 2)
        self.assertEqual(bpy.context.scene.frame_end, 8)

    def test_reports_errors(self):
        with self.assertRaisesRegex(RuntimeError, "bake with {map} in the file name"):
            self.run_import("layers")


class Bake(unittest.TestCase):
    def setUp(self):
        stage.empty_scene()
        self.settings = bpy.context.scene.foamtex
        self.settings.preset, self.settings.maps, self.settings.frames = "sea_foam", "albedo,height", "1-2"
        self.settings.size = 32
        self.settings.folder = str(bakes.FOLDER / "panel")
        bpy.context.preferences.addons["foamtex_import"].preferences.program = str(bakes.PROGRAM)

    def test_bakes_and_imports(self):
        self.assertEqual(bpy.ops.foamtex.bake(), {"FINISHED"})
        material, = bpy.data.materials
        self.assertEqual({node.label for node in bakes.textures(material)}, {"albedo", "height"})
        self.assertTrue((bakes.FOLDER / "panel/sea_foam_albedo.0002.png").is_file())

    def test_error_of_the_program(self):
        self.settings.preset = "sea_fom"
        with self.assertRaisesRegex(RuntimeError, "preset 'sea_fom': .* did you mean 'sea_foam'"):
            bpy.ops.foamtex.bake()
        self.assertTrue(bpy.ops.foamtex.bake.poll())

    def test_missing_program(self):
        bpy.context.preferences.addons["foamtex_import"].preferences.program = "/no/foamtex"
        with self.assertRaisesRegex(RuntimeError, "cannot run '/no/foamtex'"):
            bpy.ops.foamtex.bake()

    def test_relative_folder_without_a_file(self):
        self.settings.folder = "//foam"
        with self.assertRaisesRegex(RuntimeError, "relative to the Blender file, which has no name yet"):
            bpy.ops.foamtex.bake()
