# SPDX-License-Identifier: Apache-2.0
"""Renders the pictures of the README from a bake of sea_foam. ../test.sh calls this script after the tests.

    blender -b -noaudio -P pictures.py -- FOLDER
"""
import pathlib
import sys

import bpy

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]

import foamtex_import  # noqa: E402
import stage  # noqa: E402

GRID = 700  # subdivisions along a side of the displaced surface
SKY = ((0.5, 0.6, 0.7), 0.35)


def load(folder, relief):
    material = foamtex_import.load(folder / "tile/manifest.json", relief=relief)
    surface = material.node_tree.nodes["Principled BSDF"]
    surface.inputs["Roughness"].default_value = 0.45
    surface.inputs["Specular"].default_value = 0.3
    return material


def render_relief(folder):
    """Renders two squares side by side, lit by one sun: a flat plane with normals, and a displaced surface."""
    scene = stage.empty_scene()
    stage.add_plane(load(folder, "NORMAL"), 0)
    stage.add_plane(load(folder, "DISPLACEMENT"), 1, subdivisions=GRID)
    stage.add_sun(elevation=35, azimuth=120, energy=3, angle=2)
    stage.set_sky(scene, *SKY)
    stage.look_from_above(scene, 2, 1, pixels=512)
    codes = stage.render(scene, 1, folder / "relief.png")
    green = codes[..., 1]
    print(f"==> correlation of the two halves of relief.png: {stage.correlation(green[:, :512], green[:, 512:]):.3f}")


def render_tiles(folder):
    """Renders a floor of 2 x 2 tiles in perspective."""
    scene = stage.empty_scene()
    stage.add_plane(load(folder, "NORMAL"), tiles=2)
    stage.add_sun(elevation=30, azimuth=110, energy=3, angle=2)
    stage.set_sky(scene, *SKY)
    look_across(scene, target=(1.0, 0.84, 0.0), place=(1.0, -0.35, 0.75))
    stage.render(scene, 1, folder / "tiles.png")


def look_across(scene, target, place):
    camera = bpy.data.cameras.new("camera")
    camera.lens = 42
    eye = bpy.data.objects.new("camera", camera)
    eye.location = place
    aim = bpy.data.objects.new("aim", None)
    aim.location = target
    for item in (eye, aim):
        bpy.context.collection.objects.link(item)
    eye.constraints.new("TRACK_TO").target = aim
    scene.camera = eye
    scene.render.resolution_x, scene.render.resolution_y = 960, 540


def main():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    folder = pathlib.Path(sys.argv[sys.argv.index("--") + 1]).resolve()
    render_relief(folder)
    render_tiles(folder)


main()
