# SPDX-License-Identifier: Apache-2.0
"""Scenes in which a material is looked at: a plane of tiles, light, a camera, and pictures as arrays of numbers."""
import math
import pathlib
import tempfile

import bpy
import numpy

SAMPLES = 32  # per pixel


def empty_scene(samples=SAMPLES):
    """Replaces the open file by an empty scene for Cycles on the processor."""
    for collection in (bpy.data.objects, bpy.data.meshes, bpy.data.materials, bpy.data.images, bpy.data.node_groups,
                       bpy.data.lights, bpy.data.cameras, bpy.data.worlds, bpy.data.actions):
        for item in list(collection):
            if getattr(item, "type", "") != "RENDER_RESULT":
                collection.remove(item)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = samples
    scene.cycles.use_denoising = False
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.seed = 1
    scene.cycles.pixel_filter_type = "BOX"
    scene.cycles.filter_width = 1.0  # a pixel shows the mean over its own area
    scene.render.dither_intensity = 0.0
    scene.render.resolution_percentage = 100
    scene.render.film_transparent = False
    scene.view_settings.view_transform = "Standard"
    return scene


def add_plane(material, x=0.0, tiles=1, subdivisions=2):
    """Adds a square of tiles x tiles tiles, each of width 1, with its lower left corner at (x, 0)."""
    bpy.ops.mesh.primitive_grid_add(
        x_subdivisions=subdivisions, y_subdivisions=subdivisions, size=tiles, location=(x + tiles / 2, tiles / 2, 0))
    grid = bpy.context.object
    for loop in grid.data.uv_layers.active.data:
        loop.uv = [tiles * c for c in loop.uv]
    grid.data.materials.append(material)
    for polygon in grid.data.polygons:
        polygon.use_smooth = True
    return grid


def add_sun(elevation, azimuth, energy, angle=0.0):
    """Adds a sun. The azimuth is its direction, counterclockwise from +x. All angles are in degrees."""
    sun = bpy.data.lights.new("sun", "SUN")
    sun.energy = energy
    sun.angle = math.radians(angle)
    lamp = bpy.data.objects.new("sun", sun)
    lamp.rotation_euler = (0, math.radians(90 - elevation), math.radians(azimuth))
    bpy.context.collection.objects.link(lamp)


def set_sky(scene, color, strength):
    scene.world = bpy.data.worlds.new("sky")
    scene.world.use_nodes = True
    background = scene.world.node_tree.nodes["Background"]
    background.inputs[0].default_value = (*color, 1)
    background.inputs[1].default_value = strength


def look_from_above(scene, width=1.0, height=1.0, pixels=256):
    """Shows the rectangle from (0, 0) to (width, height), with `pixels` pixels per unit."""
    camera = bpy.data.cameras.new("camera")
    camera.type = "ORTHO"
    camera.ortho_scale = max(width, height)
    eye = bpy.data.objects.new("camera", camera)
    eye.location = (width / 2, height / 2, 5)
    bpy.context.collection.objects.link(eye)
    scene.camera = eye
    scene.render.resolution_x, scene.render.resolution_y = round(width * pixels), round(height * pixels)


def show_unlit(scene, output, view="Standard"):
    """Replaces the surface of a material by emission of the color that a socket of its nodes gives.

    Pixels then show the centers of texels. The view Raw stores numbers as codes without the curve of sRGB.
    """
    tree = output.id_data
    emission = tree.nodes.new("ShaderNodeEmission")
    tree.links.new(output, emission.inputs[0])
    target = next(node for node in tree.nodes if node.type == "OUTPUT_MATERIAL")
    tree.links.new(emission.outputs[0], target.inputs["Surface"])
    scene.view_settings.view_transform = view
    scene.cycles.samples = 1
    scene.cycles.filter_width = 0.01


def render(scene, frame=None, path=None):
    """Renders a frame and returns its codes (read_codes)."""
    if frame is not None:
        scene.frame_set(frame)
    with tempfile.TemporaryDirectory() as folder:
        scene.render.filepath = str(path or pathlib.Path(folder) / "picture.png")
        bpy.ops.render.render(write_still=True)
        return read_codes(scene.render.filepath)


def read_codes(path):
    """Returns the codes of an image file, from 0 to 255, as an array of rows from bottom to top with RGBA."""
    image = bpy.data.images.load(str(path))
    image.colorspace_settings.name = "Non-Color"
    image.alpha_mode = "CHANNEL_PACKED"
    width, height = image.size
    codes = numpy.empty(width * height * 4, dtype=numpy.float32)
    image.pixels.foreach_get(codes)
    bpy.data.images.remove(image)
    return codes.reshape(height, width, 4) * 255


def mean_difference(a, b, channels=3):
    return float(numpy.abs(a[..., :channels] - b[..., :channels]).mean())


def light_of(codes):
    """Returns the luminance of sRGB codes: linear light from 0 to 1."""
    c = codes[..., :3] / 255
    linear = numpy.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)
    return linear @ numpy.array([0.2126, 0.7152, 0.0722])


def correlation(a, b):
    return float(numpy.corrcoef(a.ravel(), b.ravel())[0, 1])
