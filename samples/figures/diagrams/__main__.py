# SPDX-License-Identifier: Apache-2.0
"""Draws the explanatory figures as SVG.

Usage: python3 -B samples/figures/diagrams [--states FOLDER] [--out FOLDER] [FIGURE]...

Draws the given figures, or, without FIGURE, all figures that need no simulation. The other figures show simulated
foams, which are read from caches in the folder given by --states. samples/figures/make.sh creates the caches with
`foamtex simulate`.
"""
import argparse
import pathlib
import sys

from bake_flow import bake_flow
from film_arc import film_arc
from ghost_bubble import ghost_bubble
from half_edges import half_edges
from rooms import rooms
from signed_area import signed_area
from t1_and_t2 import t1_and_t2

SIMULATED = {figure.__name__: figure for figure in (t1_and_t2, half_edges, ghost_bubble)}
COMPUTED = {figure.__name__: figure for figure in (film_arc, signed_area, bake_flow, rooms)}


def parse_arguments():
    parser = argparse.ArgumentParser(prog="diagrams", description="Draws the explanatory figures as SVG.")
    parser.add_argument("figures", metavar="FIGURE", nargs="*", help=", ".join([*SIMULATED, *COMPUTED]))
    parser.add_argument("--states", type=pathlib.Path, help="folder of the caches of simulated foams")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path(__file__).parents[1])
    arguments = parser.parse_args()
    for name in arguments.figures:
        if name not in SIMULATED and name not in COMPUTED:
            parser.error(f"no figure '{name}'; there are {', '.join([*SIMULATED, *COMPUTED])}")
        if name in SIMULATED and arguments.states is None:
            parser.error(f"the figure '{name}' shows a simulated foam: --states is missing")
    return arguments


def main():
    arguments = parse_arguments()
    for name in arguments.figures or COMPUTED:
        canvas = SIMULATED[name](arguments.states) if name in SIMULATED else COMPUTED[name]()
        (arguments.out / f"{name}.svg").write_text(canvas.svg(), encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main())
