# SPDX-License-Identifier: Apache-2.0
"""Reads a manifest or the JSON of a flipbook."""
import json
import math
import pathlib
import re

from .bake import Bake, MapImages, SheetLayout
from .fault import Fault
from .frames import parse_frames

READABLE = (".png", ".exr")


def read_bake(path, preset=None, size=None, seed=None):
    """Reads `manifest.json` or the JSON of a flipbook, and returns its Bake.

    A manifest can list several sets of images. The newest set that has the given preset, size and seed is returned.
    Throws Fault if the file cannot be read or has no such set.
    """
    path = pathlib.Path(path)
    document = _read_json(path)
    try:
        if document["format"] == "foamtex-manifest":
            return _bake_of_set(path, _choose_set(path, document["sets"], preset, size, seed))
        return _bake_of_flipbook(path, document)
    except (KeyError, IndexError, TypeError, ValueError, AttributeError) as error:
        raise Fault(f"'{path}': a member is missing or has an unexpected value: {error!r}") from error


def _read_json(path):
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise Fault(f"cannot read '{path}': {error.strerror}") from error
    except ValueError as error:
        raise Fault(f"'{path}' is not JSON: {error}") from error
    found = document.get("format") if isinstance(document, dict) else None
    if found not in ("foamtex-manifest", "foamtex-flipbook"):
        raise Fault(f"'{path}' is neither a manifest nor a flipbook of foamtex")
    if document.get("version") != 1:
        raise Fault(f"'{path}' has the version {document.get('version')} of the format; this add-on reads version 1")
    return document


def _choose_set(path, sets, preset, size, seed):
    wanted = {"preset": preset or None, "size": list(size) if size else None, "seed": seed}
    found = [s for s in sets if all(value is None or s[key] == value for key, value in wanted.items())]
    if not found:
        there = ", ".join(f"{s['preset']} {s['size'][0]}x{s['size'][1]} seed {s['seed']}" for s in sets) or "none"
        raise Fault(f"'{path}' has no images of the chosen preset, size and seed; it has: {there}")
    return found[-1]


def _bake_of_set(path, baked):
    maps = {entry["name"]: _map_of_set(path, baked, entry) for entry in baked["maps"]}
    return Bake(
        source=path,
        preset=baked["preset"],
        description=baked["description"],
        seed=baked["seed"],
        size=tuple(baked["size"]),
        frames_per_second=float(baked["frames_per_second"]),
        normal_y=baked["conventions"]["normal_y"],
        tiles=all(frame["tiles"] for frame in baked["foam"]),
        period=baked["loop"]["period"],
        maps={name: images for name, images in maps.items() if images.files})


def _map_of_set(path, baked, entry):
    files = [file for file in baked["files"] if entry["name"] in file["maps"]]
    return MapImages(
        **_format_of(entry),
        files={file["frame"]: _path_of(path, file["path"]) for file in files},
        layered=any(len(file["maps"]) > 1 for file in files),
        displacements=_displacements_of(baked, entry, files))


def _path_of(path, name):
    """Returns the path of an image, which the JSON gives relative to its own folder."""
    relative = pathlib.PurePosixPath(name)
    if relative.is_absolute() or ".." in relative.parts:
        raise Fault(f"'{path}': the path '{name}' leaves the folder")
    return path.parent / relative


def _format_of(entry):
    """Returns the members of MapImages that describe samples, from an entry of a manifest or a flipbook."""
    return {
        "name": entry.get("name") or entry["map"],
        "color_space": entry.get("color_space", "data"),
        "alpha": entry.get("alpha", "none"),
        "is_codes": str(entry.get("type", "uint8")).startswith("uint"),
        "packed": tuple(str(item) for item in entry.get("packed", ()))}


def _displacements_of(baked, entry, files):
    """Returns the displacements of the files of a map of heights, or None if they are unknown."""
    if all("displacement" in file for file in files):
        return {file["frame"]: file["displacement"] for file in files}
    if entry["name"] != "height" or _format_of(entry)["is_codes"]:
        return None
    if not re.search(r'^mean_bubble = "current"', baked.get("toml", ""), re.M):
        return None
    foam = {frame["frame"]: frame for frame in baked["foam"]}
    if not all(file["frame"] in foam and foam[file["frame"]]["tiles"] for file in files):
        return None
    return {file["frame"]: _bubble_diameter(foam[file["frame"]], baked["size"]) for file in files}


def _bubble_diameter(foam, size):
    """Returns the diameter of the mean bubble as a fraction of the image width.

    It is the unit of heights in an EXR. The image of a torus shows the area of all bubbles, and its pixels are square.
    """
    return math.sqrt(4 / math.pi / foam["bubbles"] * size[1] / size[0])


def _bake_of_flipbook(path, book):
    maps = [_map_of_sheet(path, image) for image in book["images"] if _is_readable(image["file"])]
    if not maps:
        raise Fault(f"'{path}': Blender cannot read texture arrays; make sheets of PNG or EXR files")
    uv = book["layout"]["uv"]
    return Bake(
        source=path,
        preset=book["preset"],
        description="",
        seed=book["seed"],
        size=tuple(book["layout"]["frame_size"]),
        frames_per_second=float(book["frames_per_second"]),
        normal_y=book["conventions"]["normal_y"],
        tiles=book["tiles"],
        period=book["frames"] if book["loop"]["closes"] else 0,
        maps={images.name: images for images in maps},
        sheet=SheetLayout(book["layout"]["columns"], tuple(uv["cell"]), tuple(uv["inset"]), tuple(uv["frame"])),
        sheet_frames=tuple(parse_frames(book["frame_numbers"])))


def _map_of_sheet(path, image):
    displacement = image.get("displacement")
    return MapImages(
        **_format_of(image),
        files={1: _path_of(path, image["file"])},
        displacements=None if displacement is None else {1: displacement})


def _is_readable(name):
    return pathlib.PurePosixPath(name).suffix.lower() in READABLE
