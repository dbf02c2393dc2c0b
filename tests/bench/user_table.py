#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures how long users wait: frames of maps, first frames of presets, a whole animation, foams from files and seeds.

    tests/bench/user_table.py                                   # all rows, with build/release/texgen/foamtex
    tests/bench/user_table.py --against OLD/foamtex lit exr     # rows whose names contain lit or exr, and the ratio to OLD
    tests/bench/user_table.py 1,000,000                         # a raw diagram of a million bubbles, left out by default
    tests/bench/user_table.py --tables                          # all rows, and the tables of three other benchmarks

Every row is measured over several presets, files or seeds. With --against, the two programs run alternately, so that
other work on the machine affects both. Times of maps are processor times of one frame, drawn with one thread from a cache
and written. Times of raw diagrams and of files of Surface Evolver are processor times of all threads, from file to file for
the latter; beside them is the time of Surface Evolver, if it is installed. All other times are elapsed times with all
threads. Memory is the largest of all runs of a row. Raw diagrams need the program raw_table, which is run if it was built
with the program. With --tables, the tables of solver_table (frames of a coarsening foam), raster_peers (beside cairo, AGG
and OpenCV) and png_bench (beside libpng) follow.
"""
import argparse
import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

MILLION = 1_000_000
TABLES = ("solver_table", "raster_peers/raster_peers", "png_bench")  # programs beside raw_table
EIGHT_MAPS = "albedo,height,normal,occlusion,curvature,roughness,motion,id"
RELIEF_MAPS = "height,normal,occlusion,curvature"
EVOLVER_FILES = pathlib.Path(__file__).resolve().parents[1] / "data" / "evolver"
# Commands with which Surface Evolver brings the foams in EVOLVER_FILES to equilibrium.
EVOLVER_COMMANDS = """M 2
augmented_hessian on
conj_grad on
g 10
conj_grad off
hessian_seek
hessian_seek
hessian_seek
hessian
hessian
print total_energy
q
q
"""


def run(arguments, folder, stdin=None, errors=None):
    """Runs a command; returns elapsed seconds, processor seconds and the peak memory in MB."""
    start = time.monotonic()
    with subprocess.Popen(arguments, cwd=folder, stdin=stdin, stdout=subprocess.DEVNULL,
                          stderr=errors) as process:
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

    def relax(self, program, name):
        return run([program, "relax", EVOLVER_FILES / f"{name}.fe", "-o", "relaxed.fe", "-q"], self.folder)

    def evolver(self, name):
        """Brings a foam to equilibrium with Surface Evolver; returns processor seconds, or None without Evolver."""
        evolver = shutil.which("evolver-nox-d") or shutil.which("evolver")
        if evolver is None:
            return None
        with tempfile.TemporaryFile("w+") as commands:
            commands.write(EVOLVER_COMMANDS)
            commands.seek(0)
            return run([evolver, EVOLVER_FILES / f"{name}.fe"], self.folder, commands, subprocess.DEVNULL)[1]

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
    rows.append(("relax a file of Surface Evolver", ["torus1024", "cluster331"], 1, lab.relax, lab.evolver))
    return rows


def print_row(row, program, against, repeats):
    name, presets, kind, measure, *peer = row
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
    peer_seconds = {preset: peer[0](preset) for preset in presets} if peer else {}
    cells.append(", ".join(f"{preset}: {theirs:.2f} s, {theirs / seconds[preset]:.0f} x"
                           for preset, theirs in peer_seconds.items() if theirs is not None))
    print(f"| {' | '.join(cells)} |", flush=True)


def print_raw_row(name, raw_table, bubbles, against):
    """Prints the row of raw diagrams of the seeds 1 to 5, or 1 alone if it has a million bubbles."""
    seeds = "5" if bubbles < MILLION else "1"
    printed = subprocess.run([raw_table, seeds, str(bubbles)], check=True, capture_output=True, text=True).stdout
    _, _, reached, median, worst, _, memory, _ = (cell.strip() for cell in printed.splitlines()[-1].split("|"))
    cells = [f"{name} ({reached} seeds)", median, worst, memory]
    print(f"| {' | '.join(cells + ([''] if against else []) + [''])} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("rows", nargs="*", help="words that the names of the rows contain")
    parser.add_argument("--program", default="build/release/texgen/foamtex")
    parser.add_argument("--against", help="another version of the program; its time is divided by that of the program")
    parser.add_argument("--repeats", type=int, default=3, help="runs per preset, of which the median counts")
    parser.add_argument("--tables", action="store_true", help=f"also print the tables of {', '.join(TABLES)}")
    arguments = parser.parse_args()
    program = os.path.abspath(arguments.program)
    against = os.path.abspath(arguments.against) if arguments.against else None
    benchmarks = pathlib.Path(program).parents[1] / "tests" / "bench"
    tables = [benchmarks / name for name in TABLES] if arguments.tables else []
    for table in tables:
        if not table.exists():
            sys.exit(f"{table} is not built")

    def is_wanted(name):
        return not arguments.rows or any(word in name for word in arguments.rows)

    with tempfile.TemporaryDirectory() as folder:
        titles = ["what a user does", "median", "worst", "memory"] + (["ratio"] if against else []) + ["Surface Evolver"]
        print(f"| {' | '.join(titles)} |\n|{'---|' * len(titles)}")
        for row in rows_of(Lab(program, folder)):
            if is_wanted(row[0]):
                print_row(row, program, against, arguments.repeats)
        raw_table = benchmarks / "raw_table"
        if raw_table.exists():
            for bubbles in (1000, 10000, 20000, 30000, 100000, MILLION):
                name = f"equilibrium from a raw diagram, {bubbles:,} bubbles"
                if is_wanted(name) and (bubbles < MILLION or f"{MILLION:,}" in arguments.rows):
                    print_raw_row(name, raw_table, bubbles, against)
    for table in tables:
        print(f"\n{table.name}:\n", flush=True)
        subprocess.run([table], check=True)


if __name__ == "__main__":
    main()
