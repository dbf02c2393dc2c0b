# SPDX-License-Identifier: Apache-2.0
"""Lists of frames, and the names of the files of an image sequence."""
import dataclasses
import pathlib
import re

from .fault import Fault

LAST_FRAME = 999999  # the largest number of a frame in foamtex
RANGE = re.compile(r"(\d+)(?:-(\d+)(?:([xy])(\d+))?)?")


def parse_frames(text):
    """Returns the frames of a list such as "5", "1-48", "1-48x2", "1-10y3" or "1-3,7" in the order of the list.

    1-48x2 is every second frame, 1-10y3 is all frames but every third. A frame that occurs twice is returned once.
    """
    frames = {}
    for part in text.split(","):
        match = RANGE.fullmatch(part.strip())
        if not match:
            raise Fault(f"frame range '{text}': must be a list such as 5, 1-10, 1-10x2, 1-10y3 or 1-3,7")
        frames.update(dict.fromkeys(_frames_of(match, text)))
    return list(frames)


def _frames_of(match, text):
    first = int(match[1])
    last = int(match[2] or first)
    step = int(match[4] or 1)
    if not all(1 <= number <= LAST_FRAME for number in (first, last, step)):
        raise Fault(f"frame range '{text}': frames and steps must be from 1 to {LAST_FRAME}")
    direction = 1 if last >= first else -1
    frames = range(first, last + direction, direction)
    return [frame for k, frame in enumerate(frames) if (k % step == 0) != (match[3] == "y")]


def format_frames(frames):
    """Returns increasing frames as a list of ranges, for messages: [1, 2, 3, 7] is "1-3,7", [1, 3, 5] is "1-5x2"."""
    parts = []
    while frames:
        length = _run_length(frames)
        step = frames[1] - frames[0] if length > 1 else 1
        if length == 2 and step > 1:
            length = 1
        last = f"-{frames[length - 1]}" if length > 1 else ""
        parts.append(f"{frames[0]}{last}{f'x{step}' if last and step > 1 else ''}")
        frames = frames[length:]
    return ",".join(parts)


def _run_length(frames):
    """Returns the length of the longest arithmetic progression at the start of the list."""
    length = min(len(frames), 2)
    while length < len(frames) and frames[length] - frames[length - 1] == frames[1] - frames[0]:
        length += 1
    return length


@dataclasses.dataclass(frozen=True)
class Sequence:
    """Files of consecutive frames, as an image sequence of Blender. A single file is a sequence of one frame."""

    path: pathlib.Path  # the file of the first frame
    first: int
    count: int

    @property
    def frame_offset(self):
        """The number that Blender adds to the index of a frame, from 1, to get the number in the file name."""
        return self.first - 1


def sequence_of(name, files):
    """Returns the sequence of the files of a map. `files` maps the number of a frame to its path.

    Throws Fault if frames are not consecutive, or if Blender would look for files of other names. Blender replaces the
    last digits in the name of the first file, before its extension, by the number of the frame.
    """
    frames = sorted(files)
    first, count = frames[0], len(frames)
    if frames[-1] - first + 1 != count:
        raise Fault(f"map {name}: the frames {format_frames(frames)} are not consecutive, but Blender plays only "
                    f"consecutive frames; bake the frames {first}-{frames[-1]}")
    if count > 1:
        _check_names(name, files, first)
    return Sequence(files[first], first, count)


def _check_names(name, files, first):
    path = files[first]
    match = re.fullmatch(r"(.*?)(\d+)(\D*)", path.stem)
    for frame, file in files.items():
        stem = f"{match[1]}{frame:0{len(match[2])}d}{match[3]}" if match else path.stem
        if file != path.with_name(stem + path.suffix):
            raise Fault(f"map {name}: the files '{path.name}', '{file.name}', ... are not a sequence for Blender; the "
                        "last digits of a file name must be the frame, as in --out '{preset}_{map}.####.png'")
