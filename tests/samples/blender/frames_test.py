# SPDX-License-Identifier: Apache-2.0
import pathlib
import unittest

import support  # sets the path of the modules
from model.fault import Fault
from model.frames import Sequence, format_frames, parse_frames, sequence_of


class ParseFrames(unittest.TestCase):
    def test_lists(self):
        for text, frames in (("5", [5]), ("1-4", [1, 2, 3, 4]), ("1-7x3", [1, 4, 7]), ("1-8x3", [1, 4, 7]),
                             ("1-6y3", [2, 3, 5, 6]), ("1-3,7", [1, 2, 3, 7]), ("4-2", [4, 3, 2]),
                             ("1-3,2-4", [1, 2, 3, 4]), ("1-3x1", [1, 2, 3]), ("1-3y1", [])):
            self.assertEqual(parse_frames(text), frames, text)

    def test_rejects_other_texts(self):
        for text in ("", "a", "1-", "-1", "1-4x", "1-4z2", "1,,2", "0", "1-4x0", "1-1000000"):
            with self.assertRaisesRegex(Fault, f"^frame range '{text}': ", msg=text):
                parse_frames(text)


class FormatFrames(unittest.TestCase):
    def test_lists(self):
        for text in ("5", "1-4", "1-2", "1-7x3", "1-3,7", "2,5", "1-3,7-11x2", ""):
            frames = parse_frames(text) if text else []
            self.assertEqual(format_frames(frames), text)


def files(pattern, frames):
    return {frame: pathlib.Path("folder") / pattern.format(frame) for frame in frames}


class SequenceOf(unittest.TestCase):
    def test_offset_is_the_number_before_the_first_frame(self):
        sequence = sequence_of("albedo", files("a.{:04d}.png", range(25, 49)))
        self.assertEqual(sequence, Sequence(pathlib.Path("folder/a.0025.png"), 25, 24))
        self.assertEqual(sequence.frame_offset, 24)

    def test_accepts_the_names_that_blender_finds(self):
        for pattern in ("a.{:04d}.png", "a{}.png", "{:02d}_a.png", "2k_{:03d}_a.exr"):
            self.assertEqual(sequence_of("albedo", files(pattern, range(8, 12))).count, 4, pattern)

    def test_rejects_names_that_blender_does_not_find(self):
        for pattern in ("a.{:04d}_2.png", "{:04d}_v01.png", "{}/a.png"):
            with self.assertRaisesRegex(Fault, "^map albedo: the files .* are not a sequence for Blender", msg=pattern):
                sequence_of("albedo", files(pattern, (1, 2)))

    def test_any_name_of_a_single_file(self):
        self.assertEqual(sequence_of("albedo", files("a_{}_v2.png", (7,))).count, 1)

    def test_rejects_frames_with_gaps(self):
        for frames, shown in (((1, 3, 5), "1-5x2"), ((1, 2, 4), "1-2,4")):
            with self.assertRaisesRegex(Fault, f"the frames {shown} are not consecutive.*; bake the frames 1-"):
                sequence_of("albedo", files("a.{:04d}.png", frames))


if __name__ == "__main__":
    unittest.main()
