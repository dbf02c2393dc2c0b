# SPDX-License-Identifier: Apache-2.0
"""The images of one bake, as read from a manifest or from the JSON of a flipbook."""
import dataclasses
import pathlib
import typing

from .fault import Fault


@dataclasses.dataclass(frozen=True)
class SheetLayout:
    """The positions of the frames in a sprite sheet. Lengths are fractions of the width or height of the sheet."""

    columns: int
    cell: tuple  # width and height of a cell
    inset: tuple  # from the top left corner of a cell to the top left corner of the frame in it
    frame: tuple  # width and height of a frame


@dataclasses.dataclass(frozen=True)
class MapImages:
    """The images of a map: one file per frame, or one sheet."""

    name: str
    files: dict  # path by frame; for a sheet one path, with the key 1
    color_space: str  # "sRGB", "linear sRGB" or "data"
    alpha: str = "none"  # or "straight", "premultiplied"
    is_codes: bool = True  # False if the samples are floating-point numbers in the unit of the map
    layered: bool = False  # True if the files contain other maps too
    packed: tuple = ()  # what each channel contains, such as ("occlusion", "1-roughness", "0")
    displacements: typing.Optional[dict] = None  # height of the value 1, as a fraction of the image width, by frame


@dataclasses.dataclass(frozen=True)
class Bake:
    """What a material needs to know of a bake."""

    source: pathlib.Path  # the JSON file
    preset: str
    description: str
    seed: int
    size: tuple  # width and height of a frame in pixels
    frames_per_second: float
    normal_y: str  # direction of positive y in the map normal: "up" or "down"
    tiles: bool  # True if every frame is periodic
    period: int  # number of frames of the loop; 0 if the foam does not loop
    maps: dict  # MapImages by name
    sheet: typing.Optional[SheetLayout] = None
    sheet_frames: tuple = ()  # the numbers of the frames in the sheet

    def fault(self, text):
        return Fault(f"'{self.source}': {text}")
