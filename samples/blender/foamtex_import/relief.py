# SPDX-License-Identifier: Apache-2.0
"""The nodes of normals and heights."""
import math

from .model.plan import Channel

SAME = 1e-9  # largest relative difference of equal displacements


def add_normal(builder):
    """Adds the nodes of the normals. Returns the output of the Normal Map node, or None if there are no normals.

    The node expects codes from 0 to 1 of normals whose y points up.
    """
    normal = builder.plan.normal
    if normal is None:
        return None
    color = builder.texture(normal.images).outputs["Color"] if normal.images else _combined(builder, normal.channels)
    color = _as_codes_with_y_up(builder, color, normal)
    if not normal.images and len(normal.channels) < 3:
        color = _with_z(builder, color)
    node = builder.node("ShaderNodeNormalMap", "last")
    builder.link(color, node.inputs["Color"])
    return node.outputs[0]


def _combined(builder, channels):
    """Returns a color with the numbers of channels. A missing third number stays 0.5, the code of z = 0."""
    node = builder.node("ShaderNodeCombineXYZ", "work")
    node.inputs[2].default_value = 0.5
    for channel, socket in zip(channels, node.inputs):
        builder.link(builder.number(channel), socket)
    return node.outputs[0]


def _as_codes_with_y_up(builder, color, normal):
    if not normal.signed and not normal.y_down:
        return color
    scale, offset = (0.5, 0.5) if normal.signed else (1.0, 0.0)
    y_scale, y_offset = (-scale, 1.0 - offset) if normal.y_down else (scale, offset)
    label = "Invert green" if normal.y_down else "Codes of normals"
    return builder.vector_math("MULTIPLY_ADD", color, (scale, y_scale, scale), (offset, y_offset, offset),
                               label=label).outputs[0]


def _with_z(builder, color):
    """Adds z = sqrt(1 - x² - y²) to the codes of x and y, with half of z as its code relative to 0.5."""
    numbers = builder.vector_math("MULTIPLY_ADD", color, (2.0, 2.0, 2.0), (-1.0, -1.0, -1.0)).outputs[0]
    square = builder.vector_math("DOT_PRODUCT", numbers, numbers).outputs["Value"]
    rest = builder.math("SUBTRACT", 1.0, square)
    rest.use_clamp = True
    z = builder.node("ShaderNodeCombineXYZ", "work")
    builder.link(builder.math("MULTIPLY", builder.math("SQRT", rest.outputs[0]).outputs[0], 0.5).outputs[0],
                 z.inputs[2])
    return builder.vector_math("ADD", color, z.outputs[0], label="Z of normals").outputs[0]


def add_displacement(builder, tile_size):
    """Adds the nodes of the heights. Returns the output of the Displacement node (or None) and a list of notes."""
    height = builder.plan.numbers.get("height")
    if not isinstance(height, Channel):
        return None, []
    size = builder.node("ShaderNodeValue", "work", "Tile size")
    size.outputs[0].default_value = tile_size
    scale = builder.math("MULTIPLY", size.outputs[0], 0.0, label="Height of white in tiles")
    notes = _set_scale(builder, scale.inputs[1], height.images.displacements)
    node = builder.node("ShaderNodeDisplacement", "last")
    node.inputs["Midlevel"].default_value = 0.0
    builder.link(scale.outputs[0], node.inputs["Scale"])
    builder.link(builder.number(height), node.inputs["Height"])
    return node.outputs[0], notes


def _set_scale(builder, socket, displacements):
    """Sets the scale of heights, which is animated if it differs from frame to frame. Returns notes."""
    if not displacements:
        return ["the scale of the heights is unknown, so it is 0; set it in the node 'Height of white in tiles'"]
    socket.default_value = next(iter(displacements.values()))
    if not all(math.isclose(value, socket.default_value, rel_tol=SAME) for value in displacements.values()):
        _animate(builder, socket, displacements)
    return []


def _animate(builder, socket, displacements):
    for frame, value in displacements.items():
        socket.default_value = value
        socket.keyframe_insert("default_value", frame=frame)
    curve = builder.tree.animation_data.action.fcurves[-1]
    for point in curve.keyframe_points:
        point.interpolation = "CONSTANT"
    if builder.plan.cyclic:
        # The modifier repeats the time from the first to the last key, so the first value follows as another key.
        last = max(displacements)
        curve.keyframe_points.insert(last + 1, displacements[min(displacements)]).interpolation = "CONSTANT"
        curve.modifiers.new("CYCLES")
