# SPDX-License-Identifier: Apache-2.0
"""Runs the tests of the add-on in Blender. ../test.sh prepares the bakes and calls this script:

    blender -b -noaudio -P run.py -- FOLDER PROGRAM ZIP

FOLDER contains the bakes, PROGRAM is the path of foamtex, ZIP is the add-on, which is installed first.
"""
import pathlib
import sys
import unittest

import bpy

HERE = pathlib.Path(__file__).resolve().parent


def main():
    sys.path.insert(0, str(HERE))
    folder, program, archive = sys.argv[sys.argv.index("--") + 1:]
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.preferences.addon_install(filepath=archive)
    bpy.ops.preferences.addon_enable(module="foamtex_import")
    import bakes  # imports the installed add-on
    bakes.FOLDER, bakes.PROGRAM = pathlib.Path(folder).resolve(), pathlib.Path(program).resolve()
    tests = unittest.defaultTestLoader.discover(str(HERE), pattern="*_test.py")
    result = unittest.TextTestRunner(verbosity=2).run(tests)
    sys.exit(0 if result.wasSuccessful() and result.testsRun > 0 else 1)


main()
