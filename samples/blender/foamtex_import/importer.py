# SPDX-License-Identifier: Apache-2.0
"""The function that imports a bake."""
import bpy

from .library import mark_as_asset, set_scene_frames
from .material import MaterialOptions, build_material
from .model.plan import plan_material
from .model.reader import read_bake


def load(path, *, preset=None, size=None, seed=None, maps=None, cyclic=None, scene=False, asset=False, report=print,
         **options):
    """Builds a material from `manifest.json` or from the JSON of a flipbook, and returns it.

    `preset`, `size` (width, height) and `seed` choose a set of images of the manifest; the default is the newest.
    `maps` limits the material to some maps. `cyclic` says whether the frames repeat; by default they do if they are a
    closed loop. `scene` sets the frame rate and the range of frames of the scene; `asset` marks the material as an
    asset. `options` are the members of MaterialOptions. `report` is called with each note for the user. Throws Fault if
    the bake cannot be imported; then nothing is added to the file.
    """
    options = MaterialOptions(**options)
    plan = plan_material(read_bake(path, preset, size, seed), maps, cyclic)
    material, notes = build_material(plan, options)
    if scene:
        set_scene_frames(bpy.context.scene, plan)
    if asset:
        mark_as_asset(material, plan)
    if plan.sequences and plan.count > 1 and plan.first > 1 and not plan.cyclic:
        notes.append(f"the frames do not repeat, and Blender has no image before scene frame {plan.first}")
    for note in notes:
        report(f"foamtex: {plan.bake.preset}: {note}")
    return material
