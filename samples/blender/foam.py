# SPDX-License-Identifier: Apache-2.0

# Renders pictures of a baked foam and of its flipbook. run.sh runs this script in Blender.
#
#     blender -b -P foam.py -- FOLDER
#
# FOLDER/tile contains the maps albedo, normal and height of frame 1 as PNGs. FOLDER/book contains
# albedo of all frames, and their sheet. The paths and the meaning of the files are read from
# manifest.json and from the JSON of the flipbook.
import json
import math
import pathlib
import sys

import bpy
import numpy

SAMPLES = 24  # per pixel; even light needs only FLAT_SAMPLES
FLAT_SAMPLES = 4
SIZE = (960, 540)
GRID = 700  # subdivisions along a side of the displaced surface
TILES = 2  # number of tiles along a side of a plane


def read_json(path):
    return json.loads(path.read_text(encoding="utf-8"))


class Baked:
    """The images of the only preset in a folder, as its manifest describes them."""

    def __init__(self, folder):
        self.folder = folder
        self.set = read_json(folder / "manifest.json")["sets"][0]

    def file(self, name, frame):
        """Returns the description of the file of a map and a frame."""
        return next(f for f in self.set["files"] if f["frame"] == frame and name in f["maps"])

    def image(self, name, frame):
        found = next(m for m in self.set["maps"] if m["name"] == name)
        return load(self.folder / self.file(name, frame)["path"], found["color_space"])


def load(path, color_space):
    image = bpy.data.images.load(str(path))
    image.colorspace_settings.name = "sRGB" if color_space == "sRGB" else "Non-Color"
    return image


def texture(nodes, image):
    node = nodes.new("ShaderNodeTexImage")
    node.image = image
    return node


def material(name):
    """Returns a new material, its nodes, its links and its surface shader."""
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    surface = made.node_tree.nodes["Principled BSDF"]
    surface.inputs["Roughness"].default_value = 0.45
    surface.inputs["Specular"].default_value = 0.3
    return made, made.node_tree.nodes, made.node_tree.links, surface


def normal_mapped(baked, frame):
    made, nodes, links, surface = material("normal map")
    links.new(texture(nodes, baked.image("albedo", frame)).outputs[0], surface.inputs["Base Color"])
    normal = nodes.new("ShaderNodeNormalMap")
    color = texture(nodes, baked.image("normal", frame)).outputs[0]
    if baked.set["conventions"]["normal_y"] == "down":  # Blender expects y up
        color = flipped(nodes, links, color)
    links.new(color, normal.inputs["Color"])
    links.new(normal.outputs[0], surface.inputs["Normal"])
    return made


def flipped(nodes, links, color):
    split = nodes.new("ShaderNodeSeparateColor")
    invert = nodes.new("ShaderNodeMath")
    invert.operation = "SUBTRACT"
    invert.inputs[0].default_value = 1.0
    join = nodes.new("ShaderNodeCombineColor")
    links.new(color, split.inputs[0])
    links.new(split.outputs[0], join.inputs[0])
    links.new(split.outputs[1], invert.inputs[1])
    links.new(invert.outputs[0], join.inputs[1])
    links.new(split.outputs[2], join.inputs[2])
    return join.outputs[0]


def displaced(baked, frame):
    made, nodes, links, surface = material("height map")
    links.new(texture(nodes, baked.image("albedo", frame)).outputs[0], surface.inputs["Base Color"])
    displacement = nodes.new("ShaderNodeDisplacement")
    displacement.inputs["Midlevel"].default_value = 0.0
    # The height of white, as a fraction of the width of a tile, which is 1.
    displacement.inputs["Scale"].default_value = baked.file("height", frame)["displacement"]
    height = texture(nodes, baked.image("height", frame)).outputs[0]
    links.new(height, displacement.inputs["Height"])
    links.new(displacement.outputs[0], nodes["Material Output"].inputs["Displacement"])
    made.cycles.displacement_method = "DISPLACEMENT"
    return made


def flipbook(baked, book, image, number):
    """Returns a material that repeats frame `number`, from 0, of a sheet: fract(uv) is mapped to its cell."""
    layout = book["layout"]
    made, nodes, links, surface = material("flipbook")
    surface.inputs["Specular"].default_value = 0.0
    uv = nodes.new("ShaderNodeUVMap")
    fract = vector_math(nodes, "FRACTION")
    place = vector_math(nodes, "MULTIPLY_ADD")
    row, column = divmod(number, layout["columns"])
    cell, inset, size = (layout["uv"][key] for key in ("cell", "inset", "frame"))
    left = column * cell[0] + inset[0]
    top = row * cell[1] + inset[1]
    place.inputs[1].default_value = (size[0], size[1], 0)
    place.inputs[2].default_value = (left, 1 - top - size[1], 0)  # v points up in Blender
    links.new(uv.outputs[0], fract.inputs[0])
    links.new(fract.outputs[0], place.inputs[0])
    sheet = texture(nodes, load(baked.folder / image["file"], image["color_space"]))
    links.new(place.outputs[0], sheet.inputs[0])
    links.new(sheet.outputs[0], surface.inputs["Base Color"])
    return made


def vector_math(nodes, operation):
    node = nodes.new("ShaderNodeVectorMath")
    node.operation = operation
    return node


def frame_alone(baked, frame):
    made, nodes, links, surface = material("frame")
    surface.inputs["Specular"].default_value = 0.0
    links.new(texture(nodes, baked.image("albedo", frame)).outputs[0], surface.inputs["Base Color"])
    return made


def plane(surface, x, size, subdivisions=2):
    """Adds a square of `size` x `size` tiles, each of width 1, with its lower left corner at (x, 0)."""
    bpy.ops.mesh.primitive_grid_add(
        x_subdivisions=subdivisions, y_subdivisions=subdivisions, size=size,
        location=(x + size / 2, size / 2, 0))
    grid = bpy.context.object
    for loop in grid.data.uv_layers.active.data:
        loop.uv = [size * c for c in loop.uv]
    grid.data.materials.append(surface)
    for polygon in grid.data.polygons:
        polygon.use_smooth = True
    return grid


def empty_scene():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = SAMPLES
    scene.cycles.use_denoising = False
    scene.cycles.seed = 1
    scene.render.resolution_x, scene.render.resolution_y = SIZE
    scene.view_settings.view_transform = "Standard"
    world = bpy.data.worlds.new("sky")
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs[0].default_value = (0.5, 0.6, 0.7, 1)
    world.node_tree.nodes["Background"].inputs[1].default_value = 0.35
    scene.world = world
    return scene


def light(elevation, azimuth, energy):
    """Adds a sun. The azimuth is its direction, counterclockwise from +x. Both angles are in degrees."""
    sun = bpy.data.lights.new("sun", "SUN")
    sun.energy = energy
    sun.angle = math.radians(2)
    lamp = bpy.data.objects.new("sun", sun)
    lamp.rotation_euler = (0, math.radians(90 - elevation), math.radians(azimuth))
    bpy.context.collection.objects.link(lamp)


def look_from_above(scene, width, height):
    camera = bpy.data.cameras.new("camera")
    camera.type = "ORTHO"
    camera.ortho_scale = max(width, height)
    thing = bpy.data.objects.new("camera", camera)
    thing.location = (width / 2, height / 2, 5)
    bpy.context.collection.objects.link(thing)
    scene.camera = thing


def look_across(scene, target, place):
    camera = bpy.data.cameras.new("camera")
    camera.lens = 42
    thing = bpy.data.objects.new("camera", camera)
    thing.location = place
    bpy.context.collection.objects.link(thing)
    aim = bpy.data.objects.new("aim", None)
    aim.location = target
    bpy.context.collection.objects.link(aim)
    track = thing.constraints.new("TRACK_TO")
    track.target = aim
    scene.camera = thing


def render(scene, path):
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)


def render_relief(baked, pictures):
    """Renders two squares side by side, lit by one sun: a flat plane with the normal map, and a displaced surface."""
    scene = empty_scene()
    plane(normal_mapped(baked, 1), 0, 1)
    plane(displaced(baked, 1), 1, 1, GRID)
    light(elevation=35, azimuth=120, energy=3)
    look_from_above(scene, 2, 1)
    scene.render.resolution_x, scene.render.resolution_y = (1024, 512)
    render(scene, pictures / "relief.png")
    print(f"==> how alike the two halves of relief.png are lit: {likeness(pictures / 'relief.png'):.3f}")


def likeness(path):
    """Returns the correlation of the green channels of the left and the right half of a picture."""
    image = bpy.data.images.load(str(path))
    width, height = image.size
    green = numpy.array(image.pixels[:]).reshape(height, width, 4)[:, :, 1]
    return numpy.corrcoef(green[:, : width // 2].ravel(), green[:, width // 2 :].ravel())[0, 1]


def render_tiles(baked, pictures):
    """Renders a floor of tiles in perspective."""
    scene = empty_scene()
    plane(normal_mapped(baked, 1), 0, TILES)
    light(elevation=30, azimuth=110, energy=3)
    look_across(scene, (TILES * 0.5, TILES * 0.42, 0), (TILES * 0.5, -0.35, 0.75))
    render(scene, pictures / "tiles.png")


def render_flipbook(baked, pictures):
    """Renders a few frames, tiled, twice: from the sheet, and from the files of the frames."""
    book = read_json(baked.folder / f"{baked.set['preset']}_sheet.json")
    found = next(i for i in book["images"] if i["map"] == "albedo")
    for number in range(0, book["frames"], book["frames"] // 4):
        render_flat(flipbook, (baked, book, found, number), pictures / f"sheet.{number + 1:04d}.png")
        render_flat(frame_alone, (baked, number + 1), pictures / f"frame.{number + 1:04d}.png")


def render_flat(make, arguments, path):
    """Renders tiles in even light, from above. make(*arguments) returns their material."""
    scene = empty_scene()
    plane(make(*arguments), 0, TILES)
    light(elevation=90, azimuth=0, energy=3)
    look_from_above(scene, TILES, TILES)
    scene.cycles.samples = FLAT_SAMPLES
    scene.render.resolution_x = scene.render.resolution_y = 512
    render(scene, path)


def main():
    folder = pathlib.Path(sys.argv[sys.argv.index("--") + 1]).resolve()
    tile = Baked(folder / "tile")
    render_relief(tile, folder)
    render_tiles(tile, folder)
    render_flipbook(Baked(folder / "book"), folder)


main()
