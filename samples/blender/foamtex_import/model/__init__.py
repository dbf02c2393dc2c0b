# SPDX-License-Identifier: Apache-2.0
"""The part of the add-on that does not use Blender: files of foamtex, the choice of nodes, running the program."""
