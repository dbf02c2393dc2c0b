#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs two tiny bakes under valgrind's memcheck: a torus with every map, and a patch as EXR. Only has a long form."""
import shutil
import sys

import lab as attack

VALGRIND = ["--quiet", "--error-exitcode=99", "--leak-check=full", "--errors-for-leak-kinds=definite"]
SMALL = ["--set", "foam.bubbles=8", "--size", "16", "--threads", "2", "-q", "--set", "frames.count=2"]


def main():
    lab = attack.lab_from_command_line(__doc__)
    valgrind = shutil.which("valgrind")
    if valgrind is None or not lab.long:
        print("skipped: valgrind is not installed" if lab.long else "skipped: needs --long")
        sys.exit(attack.SKIPPED)
    names = [line.split()[0] for line in lab.run(["maps"], lab.root).out.splitlines() if line[:1].isalpha()]
    bakes = {"torus": ["sea_foam", "--maps", ",".join(names), "--stats", "--out", "torus/{map}.##.png"],
             "patch": ["soap_raft", "--maps", "albedo,height,id,motion", "--out", "patch/all.##.exr"]}
    program, lab.program = lab.program, valgrind
    attack.PROCESSOR_TIME_LIMIT = 1200
    for name, arguments in bakes.items():
        outcome = lab.run([*VALGRIND, program, "bake", *arguments, *SMALL], lab.root)
        lab.expect(outcome.code == 0, f"{name}: exit {outcome.code}: {outcome.err[:3000]}")
        lab.expect(len(attack.images_in(lab.root / name)) > 0, f"{name}: no images")
    lab.finish(f"{len(names)} maps")


main()
