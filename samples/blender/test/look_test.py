# SPDX-License-Identifier: Apache-2.0
"""Renders lit materials, and compares them with the maps lit and albedo of foamtex."""
import math
import re
import unittest

import bpy

import bakes
import stage

SUBDIVISIONS = 512  # two vertices per pixel of a displaced surface


def light_options(bake):
    """Returns azimuth and elevation in degrees, and the fraction of light that comes from the sky, of the map lit."""
    text = (bakes.FOLDER / bake / "manifest.json").read_text(encoding="utf-8")
    table = re.search(r"\[lit\]\\n.*?\\n\\n", text)[0]
    return [float(re.search(rf"\\n{name} = ([0-9.]+)", table)[1]) for name in ("azimuth", "elevation", "ambient")]


class Look(unittest.TestCase):
    def render(self, bake, subdivisions=2, flip=False, **options):
        """Returns the luminance of the rendered material, of the map lit and of the map albedo.

        The material has the light of lit: a sun and a sky that give a white plane the brightness 1. Its highlights,
        which lit has not in these bakes, are removed.
        """
        scene = stage.empty_scene(samples=64)
        maps = ["albedo", "normal", "height", "roughness"]
        material = bakes.load(bake, maps=maps, **options)
        bakes.surface(material).inputs["Specular"].default_value = 0
        if flip:
            flip_green(material)
        stage.add_plane(material, subdivisions=subdivisions)
        azimuth, elevation, ambient = light_options(bake)
        stage.add_sun(elevation, azimuth, math.pi * (1 - ambient) / math.sin(math.radians(elevation)))
        stage.set_sky(scene, (1, 1, 1), ambient)
        stage.look_from_above(scene)
        name = f"{bake}{'_heights' if 'relief' in options else ''}{'_flipped' if flip else ''}.png"
        picture = stage.render(scene, 1, bakes.FOLDER / name)
        return [stage.light_of(codes) for codes in (picture, bakes.codes(bake, "lit", 1), bakes.codes(bake, "albedo", 1))]

    def check(self, pictures, tone, likeness):
        """Checks the ratio of the mean luminances, and the correlation with lit, which albedo has not."""
        picture, lit, albedo = pictures
        ratio = picture.mean() / lit.mean()
        with_lit, with_albedo = stage.correlation(picture, lit), stage.correlation(lit, albedo)
        print(f"\n    mean luminance {ratio:.3f} of lit, correlation {with_lit:.4f}; "
              f"of lit with albedo {with_albedo:.4f}", end=" ")
        self.assertLess(abs(ratio - 1), tone)
        self.assertGreater(with_lit, likeness)
        self.assertGreater(with_lit, with_albedo)

    def test_sea_foam_in_the_light_of_lit(self):
        # lit darkens furrows by the visible sky, which a normal map cannot block, and Cycles darkens steep slopes.
        pictures = self.render("loop")
        self.check(pictures, tone=0.03, likeness=0.99)
        self.assertGreater(stage.correlation(pictures[0], pictures[2]), 0.97)

    def test_pebbles_in_a_sun(self):
        # The relief dominates here: a sun without a sky shows Lambert's law alone.
        self.check(self.render("pebbles"), tone=0.03, likeness=0.99)

    def test_pebbles_with_heights(self):
        # Higher pebbles cast shadows, which lit does not draw.
        self.check(self.render("pebbles", SUBDIVISIONS, relief="DISPLACEMENT"), tone=0.08, likeness=0.985)

    def test_a_wrong_direction_of_y_would_be_noticed(self):
        picture, lit, _ = self.render("pebbles", flip=True)
        self.assertLess(stage.correlation(picture, lit), 0.95)

    def test_heights_of_the_displaced_surface(self):
        # The z of the surface, divided by the scale of the manifest, is the code of the map height.
        scene = stage.empty_scene()
        material = bakes.load("pebbles", relief="DISPLACEMENT", tile_size=1.0)
        stage.add_plane(material, subdivisions=SUBDIVISIONS)
        stage.look_from_above(scene)
        scale = bakes.source(bakes.node(material, "DISPLACEMENT").inputs["Scale"]).inputs[1].default_value
        stage.show_unlit(scene, height_output(material, scale), "Raw")
        difference = stage.mean_difference(stage.render(scene, 1), bakes.codes("pebbles", "height", 1))
        self.assertLess(difference, 1.5)  # codes of 255; vertices lie between texels


def flip_green(material):
    normal = bakes.node(material, "NORMAL_MAP")
    flip = material.node_tree.nodes.new("ShaderNodeVectorMath")
    flip.operation = "MULTIPLY_ADD"
    flip.inputs[1].default_value, flip.inputs[2].default_value = (1, -1, 1), (0, 1, 0)
    material.node_tree.links.new(normal.inputs["Color"].links[0].from_socket, flip.inputs[0])
    material.node_tree.links.new(flip.outputs[0], normal.inputs["Color"])


def height_output(material, scale):
    """Returns a socket with the z of the surface divided by `scale`."""
    tree = material.node_tree
    split, divide = tree.nodes.new("ShaderNodeSeparateXYZ"), tree.nodes.new("ShaderNodeMath")
    divide.operation = "DIVIDE"
    divide.inputs[1].default_value = scale
    tree.links.new(tree.nodes.new("ShaderNodeNewGeometry").outputs["Position"], split.inputs[0])
    tree.links.new(split.outputs["Z"], divide.inputs[0])
    return divide.outputs[0]
