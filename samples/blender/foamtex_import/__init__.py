# SPDX-License-Identifier: Apache-2.0
"""Imports bakes of foamtex into Blender as materials.

    import foamtex_import
    material = foamtex_import.load("out/manifest.json")
"""
from . import import_operator, bake_operator, panel
from .importer import load
from .model.fault import Fault

bl_info = {
    "name": "foamtex importer",
    "author": "The foamtex authors",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "File > Import > foamtex, and the tab foamtex in the sidebar of the 3D view",
    "description": "Imports animated foam textures of foamtex as materials, and bakes them",
    "category": "Import-Export",
}

__all__ = ["Fault", "load"]


def register():
    import_operator.register()
    bake_operator.register()
    panel.register()


def unregister():
    panel.unregister()
    bake_operator.unregister()
    import_operator.unregister()
