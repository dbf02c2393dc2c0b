# SPDX-License-Identifier: Apache-2.0
"""Builds the nodes of a material that has a Principled BSDF."""
from .images import new_texture
from .model.plan import Channel
from .sheet import new_cell_group

COLUMNS = {"uv": -1500, "texture": -1200, "separate": -850, "work": -650, "last": -250}  # x of nodes
ROW = 320  # distance between nodes of a column


class Builder:
    """Adds nodes to the tree of a material. Each image is loaded once, and each packed image is separated once."""

    def __init__(self, tree, plan):
        self.tree = tree
        self.plan = plan
        self._textures = {}  # node by name of the map
        self._separated = {}
        self._heights = dict.fromkeys(COLUMNS, 400)  # y of the next node of each column
        self._cell = None  # the output of the node group that selects a cell of a sheet

    def node(self, kind, column, label=""):
        node = self.tree.nodes.new(kind)
        node.label = label
        self._place(node, column)
        return node

    def _place(self, node, column):
        node.location = (COLUMNS[column], self._heights[column])
        self._heights[column] -= ROW

    def link(self, output, socket):
        self.tree.links.new(output, socket)

    def math(self, operation, *operands, label="", kind="ShaderNodeMath"):
        """Returns a new node that computes with numbers or, for another kind, vectors: sockets or values."""
        node = self.node(kind, "work", label)
        node.operation = operation
        for socket, operand in zip(node.inputs, operands):
            if hasattr(operand, "is_linked"):
                self.link(operand, socket)
            else:
                socket.default_value = operand
        return node

    def vector_math(self, operation, *operands, label=""):
        return self.math(operation, *operands, label=label, kind="ShaderNodeVectorMath")

    def texture(self, images):
        """Returns the node that shows the images of a map."""
        if images.name not in self._textures:
            node = new_texture(self.tree, self.plan, images)
            self._place(node, "texture")
            if self.plan.bake.sheet:
                self.link(self._cell_output(), node.inputs[0])
            self._textures[images.name] = node
        return self._textures[images.name]

    def _cell_output(self):
        if self._cell is None:
            uv = self.node("ShaderNodeTexCoord", "uv")
            group = self.node("ShaderNodeGroup", "uv", "Cell of the sheet")
            group.node_tree = new_cell_group(self.plan)
            self.link(uv.outputs["UV"], group.inputs[0])
            self._cell = group.outputs[0]
        return self._cell

    def number(self, channel):
        """Returns a socket with the number in a channel of an image."""
        socket = self._channel(channel)
        return self.math("SUBTRACT", 1.0, socket, label="Invert").outputs[0] if channel.inverted else socket

    def _channel(self, channel):
        texture = self.texture(channel.images)
        if channel.index is None:
            return texture.outputs["Color"]
        if channel.index == 3:
            return texture.outputs["Alpha"]
        name = channel.images.name
        if name not in self._separated:
            self._separated[name] = self.node("ShaderNodeSeparateColor", "separate", name)
            self.link(texture.outputs["Color"], self._separated[name].inputs[0])
        return self._separated[name].outputs[channel.index]

    def drive(self, source, socket):
        """Drives an input by a Channel, or sets it to a number."""
        if isinstance(source, Channel):
            self.link(self.number(source), socket)
        else:
            socket.default_value = source
