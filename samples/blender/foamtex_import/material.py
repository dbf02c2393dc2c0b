# SPDX-License-Identifier: Apache-2.0
"""Builds a material from a plan."""
import dataclasses
import typing

import bpy

from .builder import Builder
from .relief import add_displacement, add_normal


@dataclasses.dataclass
class MaterialOptions:
    """The choices that a user has for a material."""

    name: str = ""  # the name of the preset if empty
    relief: typing.Optional[str] = None  # "NORMAL" or "DISPLACEMENT"; None: NORMAL if there is a map of normals
    occlusion: bool = False  # multiplies the base color by occlusion
    tile_size: float = 1.0  # width of a tile on the object, in units of the object


def build_material(plan, options):
    """Returns a new material with one Principled BSDF, and notes for the user."""
    material = bpy.data.materials.new(options.name or plan.bake.preset)
    material.use_nodes = True
    material["foamtex_source"] = str(plan.bake.source.resolve())
    material["foamtex_seed"] = plan.bake.seed
    surface = next(node for node in material.node_tree.nodes if node.type == "BSDF_PRINCIPLED")
    builder = Builder(material.node_tree, plan)
    _add_colors(builder, surface, options)
    _add_numbers(builder, surface)
    _add_alpha(builder, material, surface)
    return material, _add_relief(builder, material, surface, options)


def _input(surface, *names):
    """Returns the input that has one of the names, which differ between versions of Blender."""
    return next(surface.inputs[name] for name in names if name in surface.inputs)


def _add_colors(builder, surface, options):
    plan = builder.plan
    if plan.color:
        color = builder.texture(plan.color).outputs["Color"]
        if options.occlusion and "occlusion" in plan.numbers:
            occlusion = builder.number(plan.numbers["occlusion"])
            color = builder.vector_math("MULTIPLY", color, occlusion, label="Occlusion").outputs[0]
        builder.link(color, surface.inputs["Base Color"])
    if plan.emission:
        emission = builder.texture(plan.emission).outputs["Color"]
        builder.link(emission, _input(surface, "Emission Color", "Emission"))
        surface.inputs["Emission Strength"].default_value = 1.0


def _add_numbers(builder, surface):
    for name, socket in (("roughness", "Roughness"), ("metallic", "Metallic")):
        if name in builder.plan.numbers:
            builder.drive(builder.plan.numbers[name], surface.inputs[socket])


def _add_alpha(builder, material, surface):
    plan = builder.plan
    if plan.alpha_of_color:
        builder.link(builder.texture(plan.color).outputs["Alpha"], surface.inputs["Alpha"])
    elif "opacity" in plan.numbers and not plan.bake.tiles:  # the opacity of a tile is 1 everywhere
        builder.drive(plan.numbers["opacity"], surface.inputs["Alpha"])
    else:
        return
    if hasattr(material, "blend_method"):
        material.blend_method = "HASHED"  # for Eevee; Cycles needs no setting


def _add_relief(builder, material, surface, options):
    """Adds the nodes of normals and heights, and links the one that shows the relief. Returns notes."""
    normal = add_normal(builder)
    displacement, notes = add_displacement(builder, options.tile_size)
    relief = options.relief or ("NORMAL" if normal else "DISPLACEMENT")
    if relief == "NORMAL" and normal:
        builder.link(normal, surface.inputs["Normal"])
    if relief == "DISPLACEMENT" and displacement:
        output = next(node for node in material.node_tree.nodes if node.type == "OUTPUT_MATERIAL")
        builder.link(displacement, output.inputs["Displacement"])
    if displacement:
        _displace_geometry(material)
    return notes


def _displace_geometry(material):
    """Lets Cycles move the vertices of a mesh, and show finer detail by the direction of light."""
    settings = material if hasattr(material, "displacement_method") else material.cycles
    settings.displacement_method = "BOTH"
