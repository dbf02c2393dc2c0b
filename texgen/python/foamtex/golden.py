# SPDX-License-Identifier: Apache-2.0
"""A plugin for pytest: the fixture assert_matches_golden compares images with golden images.

    def test_lava(assert_matches_golden):
        frame = next(foamtex.Preset("lava", {"image.size": [128, 128]}).simulate("1"))
        assert_matches_golden(frame.map("albedo", "uint8"), "golden/lava.png", sample=0.01)

A relative path of a golden image is relative to the folder of the test. If the images differ, the test fails and leaves
two files beside the golden image NAME.png: NAME.new.png, the new image, and, if both images have the same size and
channels, NAME.diff.png, a picture of the differences. `pytest --update-golden` writes the golden images instead.
"""
import pathlib
import shutil

import pytest

import foamtex


def pytest_addoption(parser):
    parser.addoption("--update-golden", action="store_true", help="write golden images instead of comparing with them")


class GoldenImages:
    """Compares images with golden images in a folder."""

    def __init__(self, folder, update):
        self.folder = pathlib.Path(folder)
        self.update = update

    def __call__(self, image, golden, **limits):
        """Fails the test unless an image matches a golden image.

        `image` is the path of an image file, or an array of uint8 or uint16 of height x width x channels. `golden` is
        the path of the golden image. `limits` are those of foamtex.compare: sample, rms, angle, allowed_percent.
        """
        golden = self.folder / golden
        new = golden.with_suffix(".new" + golden.suffix)
        difference = golden.with_suffix(".diff.png")
        if self.update:
            golden.parent.mkdir(parents=True, exist_ok=True)
            _write(image, golden)
            return
        if not golden.exists():
            pytest.fail(f"there is no golden image '{golden}'; pytest --update-golden writes it", pytrace=False)
        _write(image, new)
        found = foamtex.compare(golden, new, **limits)
        if all(found):
            new.unlink()
            difference.unlink(missing_ok=True)
            return
        reasons = "; ".join(reason for layer in found for reason in layer.reasons)
        difference.unlink(missing_ok=True)
        names = new.name
        if all(layer.same_shape for layer in found):
            foamtex.compare(golden, new, picture=difference, **limits)
            names += f" and {difference.name}"
        pytest.fail(f"'{golden}': {reasons}; see {names}", pytrace=False)


def _write(image, path):
    if isinstance(image, (str, pathlib.Path)):
        shutil.copyfile(image, path)
    elif path.suffix != ".png":
        raise ValueError(f"'{path}': the golden image of an array must be a PNG")
    else:
        foamtex.write_png(path, image)


@pytest.fixture
def assert_matches_golden(request):
    """Returns a function that compares an image with a golden image (GoldenImages)."""
    return GoldenImages(request.path.parent, request.config.getoption("--update-golden"))
