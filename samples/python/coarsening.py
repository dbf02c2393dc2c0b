#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Coarsening of a foam, in cells that notebooks and editors run one by one.

Makes two figures. One shows the time of a step against the number of bubbles, like Figure 5 of Kelager and Erleben
(2010). The other one shows the growth of bubbles against their number of sides, and von Neumann's law.

    samples/python/coarsening.py [--bubbles 10000] [--out FOLDER]
"""
# %% Arguments
import argparse
import math
import pathlib
import time

import matplotlib.pyplot as plt
import numpy as np

import foamtex

parser = argparse.ArgumentParser(description="Plots the coarsening of a foam.")
parser.add_argument("--bubbles", type=int, default=10000, help="bubbles at the start (default: 10000)")
parser.add_argument("--last", type=int, default=11, help="stop at so many bubbles (default: 11)")
parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out"), help="folder of the figures (default: out)")
arguments, _ = parser.parse_known_args()  # a kernel of Jupyter adds arguments of its own
if not 4 <= arguments.last < arguments.bubbles:
    parser.error("--last must be at least 4 and below --bubbles")
arguments.out.mkdir(parents=True, exist_ok=True)

# %% A foam in equilibrium
foam = foamtex.Foam.torus(arguments.bubbles, seed=1)
found = foam.relax()
print(f"{len(foam)} bubbles, energy {foam.energy:.6f}, {found}")

# %% Coarsening: steps that grow with the mean area, as the foam becomes coarser
KAPPA = 0.1
settings = foamtex.StepSettings(kappa=KAPPA)
counts, seconds, growth = [], [], {}
while len(foam) > arguments.last:
    before = foam.bubbles
    step = 0.2 * arguments.bubbles / len(foam) / KAPPA / 10
    start = time.perf_counter()
    foam.step(step, settings=settings)
    seconds.append(time.perf_counter() - start)
    counts.append(len(before))

    # Bubbles that kept their number of sides, and their growth, as a rate
    after = foam.bubbles
    _, old, new = np.intersect1d(before["identity"], after["identity"], return_indices=True)
    kept = before["sides"][old] == after["sides"][new]
    rates = (after["area"][new] - before["area"][old])[kept] / step
    for sides, rate in zip(after["sides"][new][kept], rates):
        growth.setdefault(int(sides), []).append(rate)
print(f"{len(counts)} steps in {sum(seconds):.1f} s; foam time {foam.time:.3g}; {len(foam)} bubbles are left")

# %% Figure 5 of the paper: the time of a step against the number of bubbles
figure, axes = plt.subplots(figsize=(6, 4))
axes.plot(counts, seconds, ".", label="foamtex, this machine")
axes.plot([10000, 11], [39.5, 0.084], "o", label="the paper's two figures (2 GHz laptop)")
axes.set(xscale="log", yscale="log", xlabel="bubbles", ylabel="time of a step [s]")
axes.legend()
figure.tight_layout()
figure.savefig(arguments.out / "figure_5.png", dpi=150)

# %% Von Neumann's law: dA/dt = (2 pi / 3) gamma kappa (n - 6)
gamma = foam.film_tension / 2
sides = np.array(sorted(n for n in growth if len(growth[n]) >= 5))
means = np.array([np.mean(growth[n]) for n in sides])
law = 2 * math.pi / 3 * gamma * KAPPA * (sides - 6)
figure, axes = plt.subplots(figsize=(6, 4))
axes.plot(sides, law, "-", label="von Neumann's law")
axes.plot(sides, means, "o", label="mean growth of bubbles that kept their sides")
axes.set(xlabel="sides", ylabel="growth of the area per time")
axes.legend()
figure.tight_layout()
figure.savefig(arguments.out / "von_neumann.png", dpi=150)
print(f"largest difference from von Neumann's law: {np.abs(means - law).max():.1e}")
