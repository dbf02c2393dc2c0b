#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Kills bakes and simulations with SIGKILL at random moments, and resumes or repeats them.

No killed bake may leave an incomplete image or manifest, and a resumed bake must have the same images as a bake that was
not killed, byte for byte. The short form kills the program 10 times, the long form 100 times.
"""
import json
import subprocess
import time

import lab as attack

FRAMES = 16
BAKE = ["bake", "soap_raft", *attack.SMALL, "--set", f"frames.count={FRAMES}", "--maps", "albedo,height,id"]
SIMULATE = ["simulate", "soap_raft", *attack.SMALL, "--set", f"frames.count={FRAMES}", "--cache", "foam"]
RENDER = ["render", "foam", "-q", "--maps", "albedo,height,id"]
OUT = ["--out", "out/{map}.####.png"]


def kill_after(lab, arguments, folder, seconds):
    """Runs the program and kills it, unless it ends before."""
    process = lab.start(arguments, folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    time.sleep(seconds)
    process.kill()
    return process.wait() != 0


def check_killed(lab, folder, good):
    """Checks the files that a killed bake left: complete images with the right pixels, and a readable manifest."""
    for name, content in attack.images_in(folder / "out").items():
        lab.expect(content == good[name], f"torn image {name}")
    manifest = folder / "out" / "manifest.json"
    if manifest.exists():
        json.loads(manifest.read_text())


def attack_bake(lab, good, duration):
    folder = lab.folder("killed")
    kills = 0
    for _ in range(lab.random.randint(1, 3)):
        kills += kill_after(lab, [*BAKE, *OUT, "--resume"], folder, lab.random.uniform(0, duration))
        check_killed(lab, folder, good)
    lab.expect(lab.run([*BAKE, *OUT, "--resume"], folder).code == 0, "a killed bake cannot be resumed")
    lab.expect(attack.images_in(folder / "out") == good, "a resumed bake has other images")
    lab.expect(lab.run(["verify", "out"], folder).code == 0, "a resumed bake does not pass verify")
    return kills


def attack_simulation(lab, good, duration):
    folder = lab.folder("killed")
    killed = kill_after(lab, SIMULATE, folder, lab.random.uniform(0, duration))
    lab.expect_documented(lab.run([*RENDER, *OUT], folder), "render of a cache whose simulation was killed")
    lab.expect(lab.run([*SIMULATE, "--force"], folder).code == 0, "a killed simulation cannot be repeated")
    lab.expect(lab.run([*RENDER, *OUT], folder).code == 0, "a repeated simulation cannot be drawn")
    lab.expect(attack.images_in(folder / "out") == good, "a repeated simulation has other images")
    return killed


def main():
    lab = attack.lab_from_command_line(__doc__)
    reference = lab.folder("reference")
    start = time.monotonic()
    lab.expect(lab.run([*BAKE, *OUT], reference).code == 0, "the reference cannot be baked")
    duration = time.monotonic() - start
    good = attack.images_in(reference / "out")
    lab.expect(len(good) == 3 * FRAMES, f"the reference has {len(good)} images")
    wanted = 100 if lab.long else 10
    kills = 0
    while kills < wanted and not lab.faults:
        one = attack_simulation if kills % 5 == 4 else attack_bake
        kills += one(lab, good, duration)
    parts = len(list(lab.root.rglob("*.part")))
    lab.finish(f"{kills} kills; {parts} temporary files were left at the end")


main()
