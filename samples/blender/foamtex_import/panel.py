# SPDX-License-Identifier: Apache-2.0
"""The tab foamtex in the sidebar of the 3D view."""
import bpy

from .bake_operator import BakeFoamtex, CancelBake
from .import_operator import ImportFoamtex
from .settings import preferences


class FoamtexPanel(bpy.types.Panel):
    bl_idname = "VIEW3D_PT_foamtex"
    bl_label = "foamtex"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "foamtex"

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        for name in ("preset", "size", "seed", "maps", "frames", "folder", "scene", "asset"):
            layout.prop(context.scene.foamtex, name)
        layout.prop(preferences(context), "program")
        if BakeFoamtex.run:
            _draw_progress(layout, BakeFoamtex.run.progress)
        else:
            layout.operator(BakeFoamtex.bl_idname, icon="RENDER_ANIMATION")
            layout.operator(ImportFoamtex.bl_idname, text="Import", icon="IMPORT")


def _draw_progress(layout, progress):
    if hasattr(layout, "progress"):  # Blender 4.0 and later
        layout.progress(text=progress.text, factor=progress.fraction)
    else:
        layout.label(text=f"{progress.text} ({progress.fraction:.0%})", icon="SORTTIME")
    layout.operator(CancelBake.bl_idname, icon="CANCEL")


def register():
    bpy.utils.register_class(FoamtexPanel)


def unregister():
    bpy.utils.unregister_class(FoamtexPanel)
