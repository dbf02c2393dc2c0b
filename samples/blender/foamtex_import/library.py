# SPDX-License-Identifier: Apache-2.0
"""Marks a material as an asset, and sets the frames of a scene."""
import bpy

PREVIEW_SIZE = 256  # largest width and height of a preview in pixels


def mark_as_asset(material, plan):
    """Marks a material as an asset with a description, tags and a preview."""
    bake = plan.bake
    material.asset_mark()
    material.asset_data.description = bake.description or f"{bake.preset}, seed {bake.seed}"
    for tag in ("foamtex", bake.preset, "animated" if plan.count > 1 else "still", "tile" if bake.tiles else "patch"):
        material.asset_data.tags.new(tag, skip_if_exists=True)
    picture = bake.maps.get("lit") or plan.color
    if bake.sheet or picture is None or picture.layered:
        material.asset_generate_preview()  # Blender renders it in the background, if it has a window
    else:
        _show(material, picture.files.get(plan.first))


def _show(material, path):
    """Uses the picture in a file as the preview, which also works without a window."""
    image = bpy.data.images.load(str(path.resolve()))
    width, height = image.size
    factor = min(1.0, PREVIEW_SIZE / max(width, height, 1))
    size = (max(1, round(width * factor)), max(1, round(height * factor)))
    image.scale(*size)
    preview = material.preview_ensure()
    preview.image_size = size
    preview.image_pixels_float = image.pixels[:]
    bpy.data.images.remove(image)


def set_scene_frames(scene, plan):
    """Sets the frame rate of a scene, and its range of frames to the frames of the bake."""
    rate = plan.bake.frames_per_second
    scene.render.fps = max(1, round(rate))
    scene.render.fps_base = scene.render.fps / rate
    scene.frame_start = plan.first
    scene.frame_end = plan.first + plan.count - 1
