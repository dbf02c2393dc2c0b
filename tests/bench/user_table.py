#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures how long users wait: frames of maps, first frames of presets, a whole animation.

    tests/bench/user_table.py                                   # all rows, with build/release/texgen/foamtex
    tests/bench/user_table.py --against OLD/foamtex lit exr     # rows whose names contain lit or exr, and the ratio to OLD

Every row is measured over several presets. With --against, the two programs run alternately, so that other work on the
machine affects both. Times of maps are processor times of one frame, drawn with one thread from a cache and written;
all other times are elapsed times with all threads. Memory is the largest of all runs of a row.
"""
import argparse
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

EIGHT_MAPS = "albedo,height,normal,occlusion,curvature,roughness,motion,id"
RELIEF_MAPS = "height,normal,occlusion,curvature"


def run(arguments, folder):
    """Runs a command; returns elapsed seconds, processor seconds and the peak memory in MB."""
    start = time.monotonic()
    with subprocess.Popen(arguments, cwd=folder, stdout=subprocess.DEVNULL) as process:
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"failed with exit code {process.returncode}: {' '.join(map(str, arguments))}")
    return time.monotonic() - start, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1000


class Lab:
    """A folder with the states of presets, simulated when they are first needed."""

    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def cache(self, preset):
        cache = pathlib.Path(self.folder) / f"{preset}.cache"
        if not cache.exists():
            run([self.program, "simulate", preset, "--frames", "1-2", "--cache", cache, "-q"], self.folder)
        return cache

    def frame(self, program, preset, maps, suffix="png", threads=1, size=2048):
        """Draws and writes frame 1."""
        return run([program, "render", self.cache(preset), "--frames", "1", "--size", str(size), "--maps", maps,
                    "--threads", str(threads), "-q", "--out", f"out/{{map}}.{suffix}"], self.folder)

    def first_frame(self, program, preset):
        return run([program, "bake", preset, "--frames", "1", "--size", "1024", "-q", "--out", "out/{map}.png"],
                   self.folder)

    def animation(self, program, preset):
        return run([program, "simulate", preset, "--force", "-q", "--cache", "animation"], self.folder)


def presets_of(program):
    listed = subprocess.run([program, "presets", "list"], check=True, capture_output=True, text=True).stdout
    return [line.split()[0] for line in listed.splitlines() if line.strip()]


def presets_with(program, name):
    """Returns the presets that list a map."""
    def lists(preset):
        shown = subprocess.run([program, "presets", "show", preset], check=True, capture_output=True, text=True).stdout
        return any(line.startswith("maps") and f'"{name}"' in line for line in shown.splitlines())
    return [preset for preset in presets_of(program) if lists(preset)]


def rows_of(lab):
    """Returns the rows: a name, the presets, the kind of time (0 elapsed, 1 processor), and what is measured."""
    lit = presets_with(lab.program, "lit")
    solid = ["sea_foam", "pebbles", "leather", "lava"]
    rows = [("lit, 2048², one thread", lit, 1, lambda program, preset: lab.frame(program, preset, "lit"))]
    for name, presets in [("thin_film", ["bath_bubbles", "iridescent"]), ("curvature", solid), ("motion", solid),
                          ("height", solid), ("normal", solid), (RELIEF_MAPS, solid)]:
        rows.append((f"{name}, 2048², one thread", presets, 1,
                     lambda program, preset, name=name: lab.frame(program, preset, name)))
    for suffix in ("exr", "png"):
        rows.append((f"eight maps as {suffix.upper()}, 2048², two threads", solid, 0,
                     lambda program, preset, suffix=suffix: lab.frame(program, preset, EIGHT_MAPS, suffix, 2)))
    rows.append(("first frame, 1024²", presets_of(lab.program), 0, lab.first_frame))
    rows.append(("simulation of coarsening, 96 frames", ["coarsening"], 0, lab.animation))
    return rows


def print_row(row, program, against, repeats):
    name, presets, kind, measure = row
    seconds, ratios, memory = {}, [], 0.0
    for preset in presets:
        ours, theirs = [], []
        for _ in range(repeats):
            result = measure(program, preset)
            ours.append(result[kind])
            memory = max(memory, result[2])
            if against:
                theirs.append(measure(against, preset)[kind])
        seconds[preset] = statistics.median(ours)
        if against:
            ratios.append(statistics.median(theirs) / seconds[preset])
    worst = max(seconds, key=seconds.get)
    cells = [name, f"{statistics.median(seconds.values()):.2f} s", f"{seconds[worst]:.2f} s ({worst})", f"{memory:.0f} MB"]
    if against:
        cells.append(f"{min(ratios):.1f} to {max(ratios):.1f}")
    print(f"| {' | '.join(cells)} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("rows", nargs="*", help="words that the names of the rows contain")
    parser.add_argument("--program", default="build/release/texgen/foamtex")
    parser.add_argument("--against", help="another version of the program; its time is divided by that of the program")
    parser.add_argument("--repeats", type=int, default=3, help="runs per preset, of which the median counts")
    arguments = parser.parse_args()
    program = os.path.abspath(arguments.program)
    against = os.path.abspath(arguments.against) if arguments.against else None
    with tempfile.TemporaryDirectory() as folder:
        titles = ["what a user does", "median of presets", "worst preset", "memory"] + (["ratio"] if against else [])
        print(f"| {' | '.join(titles)} |\n|{'---|' * len(titles)}")
        for row in rows_of(Lab(program, folder)):
            if not arguments.rows or any(word in row[0] for word in arguments.rows):
                print_row(row, program, against, arguments.repeats)


if __name__ == "__main__":
    main()
