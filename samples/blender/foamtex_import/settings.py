# SPDX-License-Identifier: Apache-2.0
"""The settings of the panel. The path of the program is a preference, the others belong to the scene."""
import functools

import bpy
from bpy.props import BoolProperty, IntProperty, PointerProperty, StringProperty

from .model.fault import Fault
from .model.run import BakeOptions, preset_names


class FoamtexPreferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    program: StringProperty(
        name="Program", description="Path of the program foamtex, or its name if it is in the search path",
        default="foamtex", subtype="FILE_PATH")

    def draw(self, _context):
        self.layout.prop(self, "program")


def preferences(context):
    return context.preferences.addons[__package__].preferences


names_of = functools.lru_cache(maxsize=4)(preset_names)


def find_presets(_settings, context, text):
    """Returns the presets whose names contain a text, for the list of suggestions."""
    return [name for name in names_of(program_of(context)) if text.lower() in name]


class FoamtexSettings(bpy.types.PropertyGroup):
    preset: StringProperty(
        name="Preset", description="Name of a shipped preset, or path of a .toml file", default="sea_foam",
        search=find_presets, search_options={"SUGGESTION"})
    size: IntProperty(name="Size", description="Width and height in pixels", default=512, min=16, max=16384)
    seed: IntProperty(
        name="Seed", description="Another seed gives another foam of the same kind; 0: the seed of the preset", default=0,
        min=0)
    maps: StringProperty(
        name="Maps", description="Names of maps, separated by commas; empty: the maps of the preset",
        default="albedo,normal,height,roughness,occlusion")
    frames: StringProperty(name="Frames", description="Frames such as 1-48; empty: all frames of the preset")
    folder: StringProperty(
        name="Folder", description="Folder of the images; // is the folder of the Blender file",
        default="//foamtex", subtype="DIR_PATH")
    scene: BoolProperty(
        name="Scene frames", description="Set the frame rate and the range of frames of the scene", default=True)
    asset: BoolProperty(name="Mark as asset", description="Mark the material as an asset, with tags and a preview")


def bake_options(context):
    """Returns the options of the panel with absolute paths. Throws Fault if a path has no meaning."""
    settings = context.scene.foamtex
    return BakeOptions(
        program=program_of(context), preset=_absolute(settings.preset), folder=_absolute(settings.folder),
        maps=settings.maps, frames=settings.frames, size=settings.size, seed=settings.seed)


def program_of(context):
    return bpy.path.abspath(preferences(context).program)


def _absolute(path):
    if path.startswith("//") and not bpy.data.filepath:
        raise Fault(f"'{path}' is relative to the Blender file, which has no name yet; save it, or choose another path")
    return bpy.path.abspath(path)


def register():
    bpy.utils.register_class(FoamtexPreferences)
    bpy.utils.register_class(FoamtexSettings)
    bpy.types.Scene.foamtex = PointerProperty(type=FoamtexSettings)


def unregister():
    del bpy.types.Scene.foamtex
    bpy.utils.unregister_class(FoamtexSettings)
    bpy.utils.unregister_class(FoamtexPreferences)
