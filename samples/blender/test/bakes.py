# SPDX-License-Identifier: Apache-2.0
"""The bakes that ../test.sh has prepared, and the nodes of imported materials."""
import foamtex_import
from stage import read_codes

FOLDER = None  # set by run.py
PROGRAM = None


def load(bake, **options):
    return foamtex_import.load(FOLDER / bake / "manifest.json", **options)


def load_sheet(**options):
    return foamtex_import.load(FOLDER / "loop/sea_foam_sheet.json", **options)


def codes(bake, name, frame):
    """Returns the codes of the PNG of a map and a frame (stage.read_codes)."""
    found = sorted((FOLDER / bake).glob(f"*_{name}.{frame:04d}.png"))
    return read_codes(found[0])


def texture(material, name):
    return next(node for node in material.node_tree.nodes if node.type == "TEX_IMAGE" and node.label == name)


def textures(material):
    return [node for node in material.node_tree.nodes if node.type == "TEX_IMAGE"]


def node(material, kind):
    """Returns the only node of a type."""
    found, = [candidate for candidate in material.node_tree.nodes if candidate.type == kind]
    return found


def source(socket):
    """Returns the node that drives an input, or None."""
    return socket.links[0].from_node if socket.is_linked else None


def surface(material):
    return node(material, "BSDF_PRINCIPLED")
