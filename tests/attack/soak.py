#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Bakes tiny animations of random presets with random values of all keys.

A bake must end with the exit code 0, or with one line that names the reason and the exit code 2 (a combination of values
that is not allowed) or 3 (no equilibrium, or a loop that does not close). Every finished bake must pass verify, except
perhaps its check of the loop. The short form bakes 20 presets, the long form 2,000; preset K depends only on K.
"""
import json
import random
import shutil

import lab as attack
from random_preset import PresetMaker


def bake(lab, schema, seed):
    folder = lab.folder(f"preset-{seed}")
    text = PresetMaker(schema, random.Random(seed)).make()
    (folder / "foam.toml").write_text(text)
    outcome = lab.run(["bake", "foam.toml", "-q", "--threads", "1"], folder)
    before = len(lab.faults)
    lab.expect_documented(outcome, f"preset {seed}", {0, 2, 3})
    if outcome.code in (2, 3):
        lab.expect(len(outcome.err) > len("foamtex: \n"), f"preset {seed}: no reason")
        lab.reasons[outcome.err.strip()[-60:]] = lab.reasons.get(outcome.err.strip()[-60:], 0) + 1
    if outcome.code == 0:
        verified = lab.run(["verify", "out"], folder)
        failed = [line for line in verified.out.splitlines() if "FAILED" in line]
        # Loops have at most five frames here. Without any fault, the step from the last frame to the first may be much
        # larger than the few other steps.
        lab.expect(verified.code == 0 or (failed and all("does not loop" in line for line in failed)),
                   f"preset {seed}: verify: {verified.out[-600:]} {verified.err}")
    if len(lab.faults) > before and lab.arguments.keep:
        shutil.copy(folder / "foam.toml", f"{lab.arguments.keep}/soak-{seed}.toml")
    shutil.rmtree(folder)


def add_options(parser):
    parser.add_argument("--count", type=int, help="number of presets")
    parser.add_argument("--keep", help="existing folder for the presets that found a fault")


def main():
    lab = attack.lab_from_command_line(__doc__, add_options)
    lab.reasons = {}
    schema = json.loads(lab.run(["presets", "keys", "--json-schema"], lab.root).out)
    count = lab.arguments.count or (2000 if lab.long else 20)
    for seed in range(lab.arguments.seed, lab.arguments.seed + count):
        bake(lab, schema, seed)
        if lab.long and seed % 100 == 0:
            print(f"preset {seed}", flush=True)
    if lab.long:
        for reason, times in sorted(lab.reasons.items(), key=lambda item: -item[1])[:20]:
            print(f"{times:5} {reason}")
    lab.finish(f"{count} presets")


main()
