# SPDX-License-Identifier: Apache-2.0
"""The type stubs describe the module, and a program that uses it passes mypy."""
import pathlib
import subprocess
import sys

import pytest

import foamtex

PROGRAM = """
import foamtex
import numpy as np

preset = foamtex.Preset("sea_foam", {"foam.bubbles": 300, "foam.seed": 7})
for frame in preset.simulate("1-4", threads=2):
    image = frame.map("albedo", np.uint8)
    print(image.shape, frame.bubbles["area"], frame.number + 1)
foam = foamtex.Foam.torus(100, seed=3)
foam.step(0.1, areas={1: 2.0}, pushes=[((0.0, 0.0), 1.0, (0.1, 0.0))], settings=foamtex.StepSettings(kappa=0.1))
print(foam.relax().t1 + 1, foam.stress() @ foam.stress())
foamtex.bake(preset, "out", progress=print)
"""


# Classes of pybind11 have a metaclass of their own, and those that cannot be made have an __init__ that always fails.
BOUND = "Difference Equilibrium Event Foam Frame MapInfo Preset Progress Simulation StepSettings".split()


def test_stubs_name_what_the_module_has(tmp_path):
    pytest.importorskip("mypy")
    (tmp_path / "allowed").write_text("".join(f"foamtex.{name}\nfoamtex.{name}.__init__\n" for name in BOUND))
    command = [sys.executable, "-m", "mypy.stubtest", "foamtex", "--ignore-missing-stub", "--ignore-positional-only"]
    command += ["--allowlist", str(tmp_path / "allowed"), "--ignore-unused-allowlist"]
    done = subprocess.run(command, capture_output=True, text=True, cwd=pathlib.Path(foamtex.__file__).parents[1])
    assert done.returncode == 0, done.stdout + done.stderr


def test_a_program_passes_mypy(tmp_path):
    pytest.importorskip("mypy")
    (tmp_path / "program.py").write_text(PROGRAM)
    command = [sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(tmp_path), str(tmp_path / "program.py")]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def test_everything_has_a_docstring():
    for name in set(foamtex.__all__) - {"ALGORITHM_VERSION"}:
        assert getattr(foamtex, name).__doc__, name
