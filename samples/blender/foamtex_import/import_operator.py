# SPDX-License-Identifier: Apache-2.0
"""File > Import > foamtex."""
import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, StringProperty
from bpy_extras.io_utils import ImportHelper

from .importer import load
from .model.fault import Fault
from .objects import active_mesh, assign, tile_size_of


def import_material(operator, context, path, **options):
    """Imports a bake for an operator, and assigns the material to the active object. Returns the operator's result."""
    target = active_mesh(context)
    if not options.get("tile_size"):
        options["tile_size"] = tile_size_of(target) if target else 1.0
    try:
        material = load(path, report=lambda note: operator.report({"WARNING"}, note), **options)
    except Fault as fault:
        operator.report({"ERROR"}, str(fault))
        return {"CANCELLED"}
    if target:
        assign(target, material)
    operator.report({"INFO"}, f"foamtex: imported the material {material.name}")
    return {"FINISHED"}


class ImportFoamtex(bpy.types.Operator, ImportHelper):
    """Import the images of a manifest or a flipbook of foamtex as a material"""

    bl_idname = "import_material.foamtex"
    bl_label = "Import foamtex"
    bl_options = {"REGISTER", "UNDO", "PRESET"}

    filename_ext = ".json"
    filter_glob: StringProperty(default="*.json", options={"HIDDEN"})
    preset: StringProperty(name="Preset", description="Preset of the images; empty: any")
    seed: IntProperty(name="Seed", description="Seed of the images; -1: any", default=-1, min=-1)
    maps: StringProperty(name="Maps", description="Names of the maps to use, separated by commas; empty: all")
    relief: EnumProperty(
        name="Relief",
        items=(("AUTO", "Automatic", "Normals if there is a map of normals, otherwise heights"),
               ("NORMAL", "Normals", "The map of normals changes how light is reflected"),
               ("DISPLACEMENT", "Heights", "The map of heights displaces the surface")))
    occlusion: BoolProperty(name="Occlusion", description="Multiply the base color by the map of occlusion")
    tile_size: FloatProperty(
        name="Tile size", description="Width of a tile on the object, for the scale of heights; 0: measured on the "
        "active object", min=0.0, subtype="DISTANCE")
    scene: BoolProperty(name="Scene frames", description="Set the frame rate and the range of frames of the scene")
    asset: BoolProperty(name="Mark as asset", description="Mark the material as an asset, with tags and a preview")

    def execute(self, context):
        return import_material(
            self, context, self.filepath,
            preset=self.preset or None,
            seed=None if self.seed < 0 else self.seed,
            maps=[name.strip() for name in self.maps.split(",") if name.strip()],
            relief=None if self.relief == "AUTO" else self.relief,
            occlusion=self.occlusion,
            tile_size=self.tile_size,
            scene=self.scene,
            asset=self.asset)


def draw_menu(self, _context):
    self.layout.operator(ImportFoamtex.bl_idname, text="foamtex (.json)")


def register():
    bpy.utils.register_class(ImportFoamtex)
    bpy.types.TOPBAR_MT_file_import.append(draw_menu)


def unregister():
    bpy.types.TOPBAR_MT_file_import.remove(draw_menu)
    bpy.utils.unregister_class(ImportFoamtex)
