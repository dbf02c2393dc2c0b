# SPDX-License-Identifier: Apache-2.0
"""Bakes with the program foamtex, and imports the result."""
import bpy

from . import settings
from .import_operator import import_material
from .model.fault import Fault
from .model.run import Run, bake_command

INTERVAL = 0.2  # seconds between looks at the program


class BakeFoamtex(bpy.types.Operator):
    """Bake with foamtex, and import the images as a material"""

    bl_idname = "foamtex.bake"
    bl_label = "Bake"
    bl_options = {"REGISTER"}

    run = None  # the Run in progress, which the panel shows; only one at a time

    @classmethod
    def poll(cls, _context):
        return cls.run is None

    def execute(self, context):
        """Waits for the program, as scripts need it."""
        if not self._start(context):
            return {"CANCELLED"}
        BakeFoamtex.run.wait()
        return self._finish(context)

    def invoke(self, context, _event):
        """Starts the program, and looks at it from time to time."""
        if not self._start(context):
            return {"CANCELLED"}
        self._timer = context.window_manager.event_timer_add(INTERVAL, window=context.window)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type != "TIMER":
            return {"PASS_THROUGH"}
        ended = BakeFoamtex.run.poll()
        _redraw_panels(context)
        if not ended:
            return {"PASS_THROUGH"}
        context.window_manager.event_timer_remove(self._timer)
        return self._finish(context)

    def cancel(self, context):
        """Called when Blender ends the operator, for example when it opens another file."""
        context.window_manager.event_timer_remove(self._timer)
        BakeFoamtex.run.cancel()
        BakeFoamtex.run = None

    def _start(self, context):
        try:
            BakeFoamtex.run = Run(bake_command(settings.bake_options(context)))
        except Fault as fault:
            self.report({"ERROR"}, f"foamtex: {fault}")
            return False
        return True

    def _finish(self, context):
        run, BakeFoamtex.run = BakeFoamtex.run, None
        chosen = context.scene.foamtex
        try:
            manifest = run.manifest()
        except Fault as fault:
            self.report({"ERROR"}, f"foamtex: {fault}")
            return {"CANCELLED"}
        return import_material(self, context, manifest, scene=chosen.scene, asset=chosen.asset)


class CancelBake(bpy.types.Operator):
    """Stop the bake after its present step"""

    bl_idname = "foamtex.cancel_bake"
    bl_label = "Cancel"

    @classmethod
    def poll(cls, _context):
        return BakeFoamtex.run is not None

    def execute(self, _context):
        BakeFoamtex.run.cancel()
        return {"FINISHED"}


def _redraw_panels(context):
    for window in context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                area.tag_redraw()


def register():
    settings.register()
    bpy.utils.register_class(BakeFoamtex)
    bpy.utils.register_class(CancelBake)


def unregister():
    bpy.utils.unregister_class(CancelBake)
    bpy.utils.unregister_class(BakeFoamtex)
    settings.unregister()
