# SPDX-License-Identifier: Apache-2.0
"""Two-dimensional dry foams in mechanical equilibrium, and animated textures made of them.

    import foamtex
    preset = foamtex.Preset("sea_foam", {"foam.bubbles": 300, "foam.seed": 7})
    for frame in preset.simulate():
        image = frame.map("albedo")       # numpy array of height x width x channels
        areas = frame.bubbles["area"]     # structured array

Lengths are in foam units: the mean bubble area of a seeded foam is 1. Slow functions release the GIL.
"""
import json as _json

from ._foamtex import (
    ALGORITHM_VERSION,
    ArgumentError,
    Difference,
    Equilibrium,
    EquilibriumError,
    Error,
    Event,
    Foam,
    Frame,
    InputError,
    MapInfo,
    OutputError,
    Preset,
    Progress,
    Simulation,
    StepSettings,
    __version__,
    _key_schema,
    bake,
    compare,
    maps,
    presets,
    write_png,
)

__all__ = [
    "ALGORITHM_VERSION", "ArgumentError", "Difference", "Equilibrium", "EquilibriumError", "Error", "Event", "Foam", "Frame", "InputError", "MapInfo",
    "OutputError", "Preset", "Progress", "Simulation", "StepSettings", "bake", "compare", "key_schema", "maps",
    "presets", "write_png",
]


def key_schema():
    """Returns the JSON Schema of preset files, which documents every key, as a dict."""
    return _json.loads(_key_schema())
