#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures how long users wait: frames of maps, first frames of presets, a whole animation, foams from files and seeds.

    tests/bench/user_table.py                                   # all rows, with build/release/texgen/foamtex
    tests/bench/user_table.py --against OLD/foamtex lit exr     # rows whose names contain lit or exr, and the ratio to OLD
    tests/bench/user_table.py 1,000,000                         # a raw diagram of a million bubbles, left out by default
    tests/bench/user_table.py --tables                          # all rows, and the tables of four other benchmarks

Every row is measured over several presets, files or seeds. With --seeds N, rows of few presets are measured with N seeds of
each. With --against, the two programs run alternately, so that other work on the machine affects both. Times are elapsed
times with all threads, with these exceptions: rows that end in "one thread" or "two threads" use this number of threads;
frames that are drawn from a cache with one thread, raw diagrams, and files of Surface Evolver are processor times of all
threads. Files are relaxed from file to file; beside them is the time of Surface Evolver, if it is installed. Memory is the
largest of all runs of a row; in rows of frames of a foam it includes the way to equilibrium. Raw diagrams and frames of a
coarsening foam need the program raw_table, which is run if it was built with the program. With --tables, the tables of
solver_table, raster_peers (beside cairo, AGG and OpenCV), png_bench (beside libpng) and exr_bench (beside OpenEXR's own
compressor) follow.
"""
import argparse
import json
import math
import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

MILLION = 1_000_000
TABLES = ("solver_table", "raster_peers/raster_peers", "png_bench", "exr_bench")  # programs beside raw_table
COARSENING_FRAMES = 10  # per foam
SIZES = (1000, 10000, 20000, 30000, 100000, MILLION)  # of raw diagrams, bubbles
RELAXATIONS = "relaxations of the whole foam in all frames of a shipped preset"
EIGHT_MAPS = "albedo,height,normal,occlusion,curvature,roughness,motion,id"
RELIEF_MAPS = "height,normal,occlusion,curvature"
SURFACE_MAPS = "albedo,height,normal,lit"
MANY_BUBBLES = ("foam.bubbles=100000", "loop.kind=none", "loop.current=0")
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
    """A folder with the states of presets, simulated when they are first needed.

    A foam is the name of a preset, or the name, a space and a seed.
    """

    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def cache(self, foam, sets=()):
        cache = pathlib.Path(self.folder) / f"{foam.replace(' ', '_')}{'_'.join(sets)}.cache"
        if not cache.exists():
            run([self.program, "simulate", *arguments_of(foam, sets), "--frames", "1-2", "--cache", cache, "-q"], self.folder)
        return cache

    def frame(self, program, foam, maps, suffix="png", threads=1, size=2048, sets=()):
        """Draws and writes frame 1."""
        return run([program, "render", self.cache(foam, sets), "--frames", "1", "--size", str(size), "--maps", maps,
                    "--threads", str(threads), "-q", "--out", f"out/{{map}}.{suffix}"], self.folder)

    def first_frame(self, program, foam):
        return run([program, "bake", *arguments_of(foam), "--frames", "1", "--size", "1024", "-q", "--out", "out/{map}.png"],
                   self.folder)

    def animation(self, program, foam):
        return run([program, "bake", *arguments_of(foam), "-q", "--out", "out/{map}.####.png"], self.folder)

    def frames(self, program, foam, threads):
        """Bakes the first 24 frames."""
        return run([program, "bake", *arguments_of(foam), "--frames", "1-24", "--size", "1024", "--maps", SURFACE_MAPS,
                    "--threads", str(threads), "-q", "--out", "out/{map}.####.png"], self.folder)

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


def arguments_of(foam, sets=()):
    """Returns the arguments for a foam: the preset, and --seed if the foam has a seed of its own."""
    preset, *seed = foam.split()
    return [preset, *(["--seed", *seed] if seed else []), *(word for one in sets for word in ("--set", one))]


def with_seeds(presets, seeds):
    """Returns each preset with its own seed, and with others: 101, 102 and so on."""
    return [f"{preset} {100 + seed}" if seed else preset for preset in presets for seed in range(seeds)]


def presets_of(program):
    listed = subprocess.run([program, "presets", "list"], check=True, capture_output=True, text=True).stdout
    return [line.split()[0] for line in listed.splitlines() if line.strip()]


def presets_with(program, name):
    """Returns the presets that list a map."""
    def lists(preset):
        shown = subprocess.run([program, "presets", "show", preset], check=True, capture_output=True, text=True).stdout
        return any(line.startswith("maps") and f'"{name}"' in line for line in shown.splitlines())
    return [preset for preset in presets_of(program) if lists(preset)]


def rows_of(lab, seeds):
    """Returns the rows: a name, the foams, the kind of time (0 elapsed, 1 processor), and what is measured."""
    lit = presets_with(lab.program, "lit")
    solid = with_seeds(["sea_foam", "pebbles", "leather", "lava"], seeds)
    glossy = with_seeds(["bath_bubbles", "iridescent"], seeds)
    rows = [("bake coarsening, 96 frames of 10,000 bubbles", with_seeds(["coarsening"], seeds), 0, lab.animation),
            ("lit, 2048², one thread", lit, 1, lambda program, foam: lab.frame(program, foam, "lit")),
            ("lit of bath_bubbles, 2048², two threads", with_seeds(["bath_bubbles"], seeds), 0,
             lambda program, foam: lab.frame(program, foam, "lit", threads=2))]
    for name, foams in [("thin_film", glossy), ("curvature", solid), ("motion", solid), ("height", solid), ("normal", solid),
                        ("occlusion", solid), (RELIEF_MAPS, solid), (SURFACE_MAPS, solid)]:
        rows.append((f"{name}, 2048², one thread", foams, 1,
                     lambda program, foam, name=name: lab.frame(program, foam, name)))
    for suffix in ("exr", "png"):
        rows.append((f"eight maps as {suffix.upper()}, 2048², two threads", solid, 0,
                     lambda program, foam, suffix=suffix: lab.frame(program, foam, EIGHT_MAPS, suffix, 2)))
    for threads, name in ((1, "one thread"), (2, "two threads")):
        rows.append((f"bake 24 frames of {SURFACE_MAPS}, 1024², elapsed with {name}", solid, 0,
                     lambda program, foam, threads=threads: lab.frames(program, foam, threads)))
    rows.append(("first frame, 1024²", presets_of(lab.program), 0, lab.first_frame))
    rows.append(("first frame of fizz, potion, leather, beer_head, 1024²",
                 with_seeds(["fizz", "potion", "leather", "beer_head"], seeds), 0, lab.first_frame))
    rows.append(("albedo of 100,000 bubbles, 16384², two threads", ["sea_foam"], 0,
                 lambda program, foam: lab.frame(program, foam, "albedo", threads=2, size=16384, sets=MANY_BUBBLES)))
    rows.append(("relax a file of Surface Evolver", ["torus1024", "cluster331"], 1, lab.relax, lab.evolver))
    return rows


def print_row(row, program, against, repeats):
    name, foams, kind, measure, *peer = row
    seconds, ratios, memory = {}, [], 0.0
    for foam in foams:
        ours, theirs = [], []
        for _ in range(repeats):
            result = measure(program, foam)
            ours.append(result[kind])
            memory = max(memory, result[2])
            if against:
                theirs.append(measure(against, foam)[kind])
        seconds[foam] = statistics.median(ours)
        if against:
            ratios.append(statistics.median(theirs) / seconds[foam])
    worst = max(seconds, key=seconds.get)
    cells = [name, f"{statistics.median(seconds.values()):.2f} s", f"{seconds[worst]:.2f} s ({worst})", f"{memory:.0f} MB"]
    if against:
        cells.append(f"{min(ratios):.1f} to {max(ratios):.1f}")
    peer_seconds = {foam: peer[0](foam) for foam in foams} if peer else {}
    cells.append(", ".join(f"{foam}: {theirs:.2f} s, {theirs / seconds[foam]:.0f} x"
                           for foam, theirs in peer_seconds.items() if theirs is not None))
    print(f"| {' | '.join(cells)} |", flush=True)


def print_relaxations(program, folder, against):
    """Prints how often a step relaxes the whole foam, in all frames of the shipped presets."""
    relaxations = {}
    for preset in presets_of(program):
        cache = pathlib.Path(folder) / "relaxations.cache"
        printed = subprocess.run([program, "simulate", preset, "--cache", cache, "--force", "--json", "-q"], check=True,
                                 capture_output=True, text=True).stdout
        relaxations[preset] = json.loads(printed)["relaxations"]
    worst = max(relaxations, key=relaxations.get)
    print(f"| {RELAXATIONS} | {statistics.median(relaxations.values()):.0f} | {relaxations[worst]} ({worst}) | |"
          f"{' |' if against else ''} |", flush=True)


def print_raw_rows(raw_table, against, is_wanted, with_million):
    """Prints the rows of raw diagrams and of frames of coarsening foams, of the seeds 1 to 5, or 1 of a million bubbles."""
    def print_raw_row(name, bubbles, *options):
        seeds = "5" if bubbles < MILLION else "1"
        printed = subprocess.run([raw_table, *options, seeds, str(bubbles)], check=True, capture_output=True,
                                 text=True).stdout
        _, _, reached, median, worst, _, memory, _ = (cell.strip() for cell in printed.splitlines()[-1].split("|"))
        print(f"| {' | '.join([f'{name} ({reached} seeds)', median, worst, memory] + ([''] if against else []) + [''])} |",
              flush=True)
        return float(median.split()[0])

    for bubbles in SIZES:
        name = f"equilibrium from a raw diagram, {bubbles:,} bubbles"
        if is_wanted(name) and (bubbles < MILLION or with_million):
            print_raw_row(name, bubbles)
    frames = {}
    for bubbles in (1000, 10000, 100000):
        name = f"a frame of {bubbles:,} bubbles"
        if is_wanted(name):
            frames[bubbles] = print_raw_row(name, bubbles, "--frames", str(COARSENING_FRAMES))
    if {1000, 100000} <= frames.keys():
        exponent = math.log10(frames[100000] / frames[1000]) / 2
        print(f"| growth of a frame's time from 1,000 to 100,000 bubbles, exponent | {exponent:.2f} | | |"
              f"{' |' if against else ''} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("rows", nargs="*", help="words that the names of the rows contain")
    parser.add_argument("--program", default="build/release/texgen/foamtex")
    parser.add_argument("--against", help="another version of the program; its time is divided by that of the program")
    parser.add_argument("--repeats", type=int, default=3, help="runs per preset, of which the median counts")
    parser.add_argument("--seeds", type=int, default=1, help="seeds of each foam in rows of few presets, the shipped one first")
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
        for row in rows_of(Lab(program, folder), arguments.seeds):
            if is_wanted(row[0]):
                print_row(row, program, against, arguments.repeats)
        if is_wanted(RELAXATIONS):
            print_relaxations(program, folder, against)
        raw_table = benchmarks / "raw_table"
        if raw_table.exists():
            print_raw_rows(raw_table, against, is_wanted, f"{MILLION:,}" in arguments.rows)
    for table in tables:
        print(f"\n{table.name}:\n", flush=True)
        subprocess.run([table], check=True)


if __name__ == "__main__":
    main()
