# SPDX-License-Identifier: Apache-2.0
"""A node group that maps texture coordinates to the cell of a sprite sheet that the scene's frame selects."""
import bpy


def new_cell_group(plan):
    """Returns a node group with a vector input and a vector output."""
    sheet = plan.bake.sheet
    group = bpy.data.node_groups.new(f"{plan.bake.preset} cell", "ShaderNodeTree")
    _new_socket(group, "UV", "INPUT")
    _new_socket(group, "UV", "OUTPUT")
    entry = group.nodes.new("NodeGroupInput")
    exit_ = group.nodes.new("NodeGroupOutput")
    index = _frame_index(group, plan)
    row = _math(group, "FLOOR", _math(group, "DIVIDE", _math(group, "ADD", index, 0.5), sheet.columns))
    column = _math(group, "SUBTRACT", index, _math(group, "MULTIPLY", row, sheet.columns))
    cell = group.nodes.new("ShaderNodeCombineXYZ")
    group.links.new(column, cell.inputs[0])
    group.links.new(row, cell.inputs[1])
    # Rows are counted from the top, but v points up: the corner is the lower left corner of the frame.
    width, height = sheet.frame
    corner = _vector_math(group, "MULTIPLY_ADD", cell.outputs[0], (sheet.cell[0], -sheet.cell[1], 0),
                          (sheet.inset[0], 1 - sheet.inset[1] - height, 0))
    inside = _position_in_frame(group, entry.outputs[0], plan.bake.tiles)
    group.links.new(_vector_math(group, "MULTIPLY_ADD", inside, (width, height, 0), corner), exit_.inputs[0])
    for k, node in enumerate(group.nodes):
        node.location = (200 * k, 0)
    return group


def _new_socket(group, name, direction):
    if hasattr(group, "interface"):  # Blender 4.0 and later
        group.interface.new_socket(name=name, in_out=direction, socket_type="NodeSocketVector")
    else:
        (group.inputs if direction == "INPUT" else group.outputs).new("NodeSocketVector", name)


def _frame_index(group, plan):
    """Returns a socket with the index of the shown frame, from 0."""
    frame = group.nodes.new("ShaderNodeValue")
    frame.label = "Scene frame"
    # Blender evaluates this expression without Python, so files with it need no permission to run scripts.
    frame.outputs[0].driver_add("default_value").driver.expression = "frame"
    index = _math(group, "FLOOR", _math(group, "SUBTRACT", frame.outputs[0], plan.first))
    if plan.cyclic:
        return _math(group, "WRAP", index, plan.count, 0)
    return _math(group, "MINIMUM", _math(group, "MAXIMUM", index, 0), plan.count - 1)


def _position_in_frame(group, uv, tiles):
    if tiles:
        return _vector_math(group, "FRACTION", uv)
    return _vector_math(group, "MINIMUM", _vector_math(group, "MAXIMUM", uv, (0, 0, 0)), (1, 1, 1))


def _math(group, operation, *operands):
    return _operation(group, "ShaderNodeMath", operation, operands)


def _vector_math(group, operation, *operands):
    return _operation(group, "ShaderNodeVectorMath", operation, operands)


def _operation(group, kind, operation, operands):
    """Returns the output of a new node. Operands are sockets or values."""
    node = group.nodes.new(kind)
    node.operation = operation
    for socket, operand in zip(node.inputs, operands):
        if isinstance(operand, bpy.types.NodeSocket):
            group.links.new(operand, socket)
        else:
            socket.default_value = operand
    return node.outputs[0]
