# SPDX-License-Identifier: Apache-2.0
"""The fixture assert_matches_golden, in tests that run in a folder of their own."""
import subprocess
import sys

import foamtex

TEST = """
import numpy as np

def test_image(assert_matches_golden):
    image = np.full((8, 8, 3), {value}, np.uint8)
    assert_matches_golden(image, "golden/a.png", sample=0.01)
"""


def run_pytest(folder, value, *options):
    (folder / "test_image.py").write_text(TEST.format(value=value))
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *options]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True)


def test_golden_images(tmp_path):
    missing = run_pytest(tmp_path, 10)
    assert missing.returncode == 1 and "--update-golden" in missing.stdout
    assert run_pytest(tmp_path, 10, "--update-golden").returncode == 0
    assert run_pytest(tmp_path, 11).returncode == 0
    assert sorted(path.name for path in (tmp_path / "golden").iterdir()) == ["a.png"]
    different = run_pytest(tmp_path, 40)
    assert different.returncode == 1 and "a.diff.png" in different.stdout
    names = sorted(path.name for path in (tmp_path / "golden").iterdir())
    assert names == ["a.diff.png", "a.new.png", "a.png"]
    (found,) = foamtex.compare(str(tmp_path / "golden/a.png"), str(tmp_path / "golden/a.new.png"))
    assert round(found.largest * 255) == 30
    assert run_pytest(tmp_path, 10).returncode == 0
    assert sorted(path.name for path in (tmp_path / "golden").iterdir()) == ["a.png"]
