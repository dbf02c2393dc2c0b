# SPDX-License-Identifier: Apache-2.0
"""Image texture nodes: files, color spaces, and the settings that play a sequence."""
import bpy

from .model.fault import Fault

COLOR_SPACES = {  # names that versions of Blender use, the newest first
    "sRGB": ("sRGB",),
    "linear sRGB": ("Linear Rec.709", "Linear"),
    "ACEScg": ("ACEScg",),
    "data": ("Non-Color",),
}
ALPHA_MODES = {
    # The color of straight alpha is used as it is; the mode STRAIGHT would multiply it by alpha.
    "straight": "CHANNEL_PACKED",
    "premultiplied": "PREMUL",
    "none": "NONE",
}


def new_texture(tree, plan, images):
    """Returns a new image texture node that shows the images of a map."""
    node = tree.nodes.new("ShaderNodeTexImage")
    node.label = images.name
    node.image = _load(plan, images)
    node.extension = _extension(plan)
    if node.image.source == "SEQUENCE":
        _play(node.image_user, plan, plan.sequences[images.name])
    return node


def _load(plan, images):
    sequence = plan.sequences.get(images.name)
    path = sequence.path if sequence else next(iter(images.files.values()))
    image = bpy.data.images.load(str(path.resolve()))
    image.name = f"{plan.bake.preset}_{images.name}"
    if sequence and sequence.count > 1:
        image.source = "SEQUENCE"
    _set_color_space(image, images.color_space)
    image.alpha_mode = "CHANNEL_PACKED" if images.packed else ALPHA_MODES[images.alpha]
    return image


def _set_color_space(image, color_space):
    settings = image.colorspace_settings
    known = {item.identifier for item in settings.bl_rna.properties["name"].enum_items}
    names = COLOR_SPACES.get(color_space, COLOR_SPACES["data"])
    found = [name for name in names if name in known]
    if not found:
        raise Fault(f"'{image.filepath}': this version of Blender has no color space {color_space}; bake with --set "
                    "output.primaries=srgb")
    settings.name = found[0]


def _extension(plan):
    if plan.bake.sheet or not plan.bake.tiles:
        return "EXTEND"
    return "REPEAT"


def _play(user, plan, sequence):
    """Makes the scene frame k show the file of the frame k, and before and after them other periods of the loop."""
    user.frame_start = plan.first
    user.frame_duration = sequence.count
    user.frame_offset = sequence.frame_offset
    user.use_cyclic = plan.cyclic
    user.use_auto_refresh = True
