#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints a table of coverage from a file in the format of lcov, which tests/coverage.sh makes.

Usage: tests/coverage_table.py FILE.lcov [--missing] [--reader TARGET]

Prints one row per folder, and fails if the tests execute fewer than 92 % of the lines. --missing also lists the lines that
are not executed. --reader prints one row, for the sources that the fuzz target TARGET must cover.
"""
import argparse
import collections
import itertools
import os
import sys

SMALLEST_SHARE = 0.92  # of the lines of core and texgen

# The sources of the reader that a fuzz target attacks.
READERS = {
    "cache_file": ["texgen/cache/packed_file.cpp"],
    "cache_info": ["texgen/cache/cache_files.cpp"],
    "cache_state": ["texgen/cache/state_codec.cpp", "texgen/cache/frame_codec.cpp", "texgen/cache/byte_stream.h"],
    "dds": ["texgen/image/dds.cpp", "texgen/image/texture_limits.cpp"],
    "earlier_sheets": ["texgen/sheet/earlier_sheets.cpp"],
    "evolver": ["core/io/evolver_expression.cpp", "core/io/evolver_header.cpp", "core/io/evolver_loops.cpp",
                "core/io/evolver_mesh.cpp", "core/io/evolver_reader.cpp", "core/io/evolver_tokens.cpp"],
    "exr": ["texgen/image/exr_decode.cpp", "texgen/image/exr_stream.h"],
    "file_pattern": ["texgen/bake/file_pattern.cpp"],
    "flipbook": ["texgen/sheet/flipbook_json.cpp", "texgen/sheet/map_sequence.cpp"],
    "foam_state": ["core/io/foam_json_reader.cpp", "core/io/json_item.cpp", "core/io/json_tree.cpp"],
    "frame_range": ["texgen/bake/frame_range.cpp"],
    "job_file": ["texgen/cli/job_file.cpp"],
    "ktx2": ["texgen/image/ktx2.cpp", "texgen/image/texture_limits.cpp"],
    "loop_start": ["texgen/animation/loop_start.cpp"],
    "manifest": ["texgen/manifest/manifest_reader.cpp", "texgen/json/json_value.cpp"],
    "png": ["texgen/image/png_decode.cpp", "texgen/image/png_session.h"],
    "preset": ["texgen/preset/assignment.cpp", "texgen/preset/preset_io.cpp", "texgen/preset/event_io.cpp",
               "texgen/preset/rejection.cpp"],
    "profile": ["texgen/material/profile.cpp"],
    "set_argument": ["texgen/preset/assignment.cpp"],
    "studio": ["texgen/studio/access.cpp", "texgen/studio/settings.cpp"],
    "svg_outline": ["texgen/pictures/svg_drawing.cpp", "texgen/pictures/svg_path.cpp", "texgen/pictures/svg_text.cpp"],
    "tolerances": ["texgen/verify/tolerances.cpp", "texgen/verify/limit_keys.cpp"],
    "wkt_polygon": ["core/foam/outline.cpp"],
}

# Functions in these sources that are not part of the reader: they write, describe keys, open files, or serve another
# reader. Their lines are not counted.
NOT_OF_READER = {
    "cache_file": ["libdeflate_compressor", "compressed", "write_packed", "read_packed"],
    "cache_info": ["is_cache", "state_path", "pressures_path", "write_info", "read_info"],
    "cache_state": ["pack_numbers", "unpack_numbers"],
    "dds": ["level_bytes", "encode_dds"],
    "frame_range": ["closes_loop"],
    "ktx2": ["pad", "animation_value", "key_value_data", "level_of", "compressed", "append_offset_and_size",
             "header_of", "encode_ktx2"],
    "loop_start": ["stored_loop_start"],
    "preset": ["read_value", "read_set_argument", "describe_event_keys", "preset_tables", "describe_keys",
               "describe_table", "describe_conditions"],
    "profile": ["text_in", "load_profile", "profile_assignments"],
    "set_argument": ["collect", "collect_tables", "collect_node", "read_assignments", "parse"],
    "tolerances": ["read_tolerances", "write", "option_name", "value_of_argument"],
    "wkt_polygon": ["disc_outline", "rectangle_outline", "clipped", "is_apart", "is_apart_from_rings", "box_around",
                    "touch"],
}


class Counts:
    """How many lines and branches there are, and how many were executed."""

    def __init__(self):
        self.lines = {}  # executions by the number of the line
        self.functions = []  # first line and mangled name of each function
        self.branches = [0, 0]  # number of branches, and of those that were taken

    def leave_out(self, names):
        """Forgets the lines of the functions with these names, and of the lambda expressions in them."""
        firsts = sorted({first for first, _ in self.functions})
        for first, mangled in self.functions:
            if any(f"{len(name)}{name}" in mangled for name in names):
                next_first = min((line for line in firsts if line > first), default=1 << 30)
                self.lines = {line: count for line, count in self.lines.items() if not first <= line < next_first}

    def row(self, name):
        lines, executed = len(self.lines), sum(count > 0 for count in self.lines.values())
        all_branches, taken = self.branches
        return f"| {name} | {lines} | {share(executed, lines)} | {share(taken, all_branches)} |"


def share(part, whole):
    return f"{part / whole:.1%}" if whole else "-"


def read_lcov(path):
    """Returns the counts of each source, by its path from the root of the checkout."""
    sources = collections.defaultdict(Counts)
    with open(path, encoding="utf-8") as file:
        for line in file:
            kind, _, rest = line.strip().partition(":")
            if kind == "SF":
                # The compiler may see a source through a link (build/*/rooms) or a relative path.
                counts = sources[os.path.relpath(os.path.realpath(rest))]
            elif kind == "FN":
                first, _, name = rest.partition(",")
                counts.functions.append((int(first), name))
            elif kind == "DA":
                number, executions = map(int, rest.split(",")[:2])
                counts.lines[number] = max(executions, counts.lines.get(number, 0))
            elif kind == "BRDA":
                counts.branches[0] += 1
                counts.branches[1] += rest.split(",")[3] not in ("-", "0")
    return {path: counts for path, counts in sources.items() if path.startswith(("core/", "texgen/"))}


def total(all_counts):
    """Returns the sum of the counts of several sources."""
    result = Counts()
    for k, counts in enumerate(all_counts):
        result.lines |= {(k, number): executions for number, executions in counts.lines.items()}
        result.branches = [a + b for a, b in zip(result.branches, counts.branches)]
    return result


def ranges(numbers):
    """Returns line numbers as text, such as 7, 12-15."""
    groups = itertools.groupby(enumerate(sorted(numbers)), lambda item: item[1] - item[0])
    runs = [[number for _, number in group] for _, group in groups]
    return ", ".join(str(run[0]) if len(run) == 1 else f"{run[0]}-{run[-1]}" for run in runs)


def print_missing(sources):
    for path, counts in sorted(sources.items()):
        missing = [number for number, executions in counts.lines.items() if executions == 0]
        if missing:
            print(f"{path}: {ranges(missing)}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("lcov")
    parser.add_argument("--missing", action="store_true")
    parser.add_argument("--reader")
    arguments = parser.parse_args()
    sources = read_lcov(arguments.lcov)
    if arguments.reader:
        sources = {path: sources[path] for path in READERS[arguments.reader]}
        for counts in sources.values():
            counts.leave_out(NOT_OF_READER.get(arguments.reader, []))
        print(total(sources.values()).row(arguments.reader))
    else:
        print("| folder | lines | executed | branches taken |\n|---|---|---|---|")
        for folder, paths in itertools.groupby(sorted(sources, key=os.path.dirname), os.path.dirname):
            print(total(sources[path] for path in paths).row(folder))
        print(total(sources.values()).row("core and texgen"))
    if arguments.missing:
        print_missing(sources)
    every = total(sources.values()).lines.values()
    return 0 if arguments.reader or sum(count > 0 for count in every) >= SMALLEST_SHARE * len(every) else 1


if __name__ == "__main__":
    os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    sys.exit(main())
