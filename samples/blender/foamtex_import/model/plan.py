# SPDX-License-Identifier: Apache-2.0
"""Chooses which image, and which channel of it, drives each input of a material."""
import dataclasses
import typing

from .bake import Bake, MapImages
from .fault import Fault
from .frames import Sequence, format_frames, sequence_of

COLOR_MAPS = ("albedo", "lit", "thin_film", "maze", "contour", "maze_solution", "caustics", "id_color")
NORMAL_MAPS = ("normal", "normal_gl", "normal_dx")
NUMBER_MAPS = ("roughness", "metallic", "occlusion", "opacity", "height")
AXES = ("X", "Y", "Z")


@dataclasses.dataclass(frozen=True)
class Channel:
    """A number in an image. The channels 0 to 3 are red, green, blue and alpha; None is the gray of the image."""

    images: MapImages
    index: typing.Optional[int] = None
    inverted: bool = False  # the number is 1 minus the channel


@dataclasses.dataclass(frozen=True)
class Normal:
    """Normals in an image (`images`), or in two or three channels of packed images (`channels`).

    Packed images contain codes from 0 to 1, even in an EXR.
    """

    y_down: bool
    signed: bool = False  # True if the image contains numbers from -1 to 1 instead of codes from 0 to 1
    images: typing.Optional[MapImages] = None
    channels: tuple = ()


@dataclasses.dataclass
class Plan:
    """The sources of a material's inputs, and how the images are played."""

    bake: Bake
    color: typing.Optional[MapImages] = None
    emission: typing.Optional[MapImages] = None
    normal: typing.Optional[Normal] = None
    numbers: dict = dataclasses.field(default_factory=dict)  # Channel or float by the name of the map
    sequences: dict = dataclasses.field(default_factory=dict)  # Sequence by the name of a used map; empty for sheets
    first: int = 1  # scene frame that shows the first image
    count: int = 1  # number of frames
    cyclic: bool = False

    @property
    def alpha_of_color(self):
        """True if the alpha channel of the color map is the opacity of the material.

        A color that is multiplied by its alpha must be divided by the same alpha, so the map opacity is not used then.
        """
        if self.color is None or self.color.packed or self.color.alpha == "none":
            return False
        return self.color.alpha == "premultiplied" or "opacity" not in self.numbers

    def used_images(self):
        """Returns each image that the material uses, once."""
        sources = [self.color, self.emission, self.normal and self.normal.images]
        channels = list(self.normal.channels) if self.normal else []
        channels += [source for source in self.numbers.values() if isinstance(source, Channel)]
        sources += [channel.images for channel in channels]
        return list({images.name: images for images in sources if images}.values())


def plan_material(bake, maps=None, cyclic=None):
    """Returns the plan of a material for a bake.

    `maps` limits the choice to maps of these names. `cyclic` says whether the frames repeat; by default they repeat if
    they are a closed loop. Throws Fault if no map can be used, or if Blender cannot play the files of a used map.
    """
    chosen = _chosen_maps(bake, maps)
    plan = Plan(bake)
    plan.color = next(filter(None, (_color_of(name, chosen) for name in COLOR_MAPS)), None)
    plan.emission = _color_of("emission", chosen)
    plan.normal = _normal_of(bake, chosen)
    sources = {name: _number_of(name, chosen) for name in NUMBER_MAPS}
    plan.numbers = {name: source for name, source in sources.items() if source is not None}
    if not plan.used_images():
        raise bake.fault("no map that a material uses; it uses a map of colors (such as albedo), normal, height, "
                         f"roughness, occlusion, opacity, emission or metallic; chosen: {', '.join(chosen) or 'none'}")
    _plan_frames(plan)
    plan.cyclic = cyclic if cyclic is not None else 0 < plan.bake.period == plan.count
    return plan


def _chosen_maps(bake, maps):
    if not maps:
        return bake.maps
    unknown = [name for name in maps if name not in bake.maps]
    if unknown:
        raise bake.fault(f"no map '{unknown[0]}'; the maps are {', '.join(bake.maps)}")
    return {name: images for name, images in bake.maps.items() if name in maps}


def _color_of(name, maps):
    """Returns the image of a map of colors, which may be a packed image with a number in its alpha channel, or None."""
    if name in maps:
        return maps[name]
    rgb = tuple(f"{name}.{channel}" for channel in "RGB")
    return next((images for images in maps.values() if images.packed[:3] == rgb), None)


def _number_of(name, maps):
    """Returns the source of a map with one channel: a Channel, a constant, or None if there is no such map."""
    if name in maps and not maps[name].packed:
        return Channel(maps[name])
    return _packed_channel(name, maps)


def _packed_channel(item, maps):
    """Returns the channel of a packed image that contains `item`, such as "roughness" or "normal.X", or None."""
    for images in maps.values():
        for index, content in enumerate(images.packed):
            if content in (item, f"1-{item}"):
                return Channel(images, index, inverted=content != item)
    return _packed_constant(item, maps)


def _packed_constant(item, maps):
    """Returns the constant in the place of a map of metals: the blue channel of an image with occlusion and roughness.

    Profiles write a constant there if the foam has no metal. Other constants have no meaning for a material.
    """
    if item != "metallic":
        return None
    for images in maps.values():
        packed = images.packed
        if len(packed) >= 3 and packed[0] == "occlusion" and packed[1] == "roughness" and _is_number(packed[2]):
            return float(packed[2])
    return None


def _is_number(text):
    try:
        float(text)
    except ValueError:
        return False
    return True


def _normal_of(bake, maps):
    found = next((maps[name] for name in NORMAL_MAPS if name in maps and not maps[name].packed), None)
    if found:
        return Normal(_points_down(bake, found.name), signed=not found.is_codes, images=found)
    for name in NORMAL_MAPS:
        channels = tuple(_packed_channel(f"{name}.{axis}", maps) for axis in AXES)
        if channels[0] and channels[1]:
            return Normal(_points_down(bake, name), channels=tuple(channel for channel in channels if channel))
    return None


def _points_down(bake, name):
    if name == "normal":
        return bake.normal_y == "down"
    return name == "normal_dx"


def _plan_frames(plan):
    if plan.bake.sheet:
        numbers = plan.bake.sheet_frames
        plan.count = len(numbers)
        is_consecutive = list(numbers) == list(range(numbers[0], numbers[0] + plan.count))
        plan.first = numbers[0] if is_consecutive else 1
        return
    used = plan.used_images()
    for images in used:
        _check_files(plan.bake, images)
        plan.sequences[images.name] = sequence_of(images.name, images.files)
    plan.first, plan.count = plan.sequences[used[0].name].first, plan.sequences[used[0].name].count
    for images in used:
        if images.files.keys() != used[0].files.keys():
            raise plan.bake.fault(f"the maps {used[0].name} and {images.name} have different frames, "
                                  f"{_frames_of(used[0])} and {_frames_of(images)}; bake them together, or choose maps")


def _check_files(bake, images):
    if images.layered:
        raise bake.fault(f"the map {images.name} is a layer of a file with several maps, which Cycles cannot read; bake "
                         "with {map} in the file name, such as --out '{preset}_{map}.####.exr'")
    missing = [str(path) for path in images.files.values() if not path.is_file()]
    if missing:
        raise Fault(f"map {images.name}: the file '{missing[0]}' is missing; bake again with --resume")


def _frames_of(images):
    return format_frames(sorted(images.files))
