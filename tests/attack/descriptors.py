#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs commands with closed and full standard streams, and with few file descriptors.

The streams must not change an image. If stdout cannot be written, a command whose only result is on stdout may end with the
exit code 5; all other exit codes must stay the same. The short form tries some combinations of streams, the long form all
combinations with more commands.
"""
import itertools
import os
import resource

import lab as attack

OUT = ["--out", "out/{map}.####.png"]
BAKE = ["bake", "sea_foam", *attack.SMALL, "--set", "frames.count=2", "--maps", "lit,id", *OUT]
COMMANDS = [
    (BAKE, 0), (["bake", "nope"], 2), (["presets"], 0), (["--help"], 0), (["verify", "nothing"], 4), (["--frobnicate"], 2),
    (["compare", "a.png", "b.png"], 4),
]
MORE_COMMANDS = [(["maps"], 0), (["manual"], 0), (["completion", "bash"], 0), (["presets", "keys"], 0)]
WRITERS = {"presets", "maps", "manual", "completion", "--help"}  # commands whose only result is on stdout
STATES = ["open", "closed", "full"]


def redirect(states):
    """Returns a function that closes the standard streams of the process that calls it, or makes them full."""
    def change():
        for number, state in enumerate(states):
            if state == "full":
                full = os.open("/dev/full", os.O_RDWR)
                os.dup2(full, number)
                os.close(full)
        for number, state in enumerate(states):
            if state == "closed":
                os.close(number)
    return change


def attack_streams(lab, good, combinations, commands):
    for states, (command, code) in itertools.product(combinations, commands):
        folder = lab.folder("work")
        outcome = lab.run(command, folder, preexec_fn=redirect(states))
        allowed = {code, 5} if states[1] != "open" and command[0] in WRITERS else {code}
        lab.expect(outcome.code in allowed, f"streams {states}, {attack.show(command)}: exit {outcome.code}")
        if command is BAKE and outcome.code == 0:
            lab.expect(attack.images_in(folder) == good, f"streams {states}: other images")


def attack_limits(lab, good, limits):
    for limit in limits:
        folder = lab.folder("work")
        outcome = lab.run(BAKE, folder, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (limit, limit)))
        if outcome.code == 127:
            continue  # the libraries of the program could not be loaded
        lab.expect_documented(outcome, f"{limit} descriptors", {0, 4, 5})
        if outcome.code == 0:
            lab.expect(attack.images_in(folder) == good, f"{limit} descriptors: other images")
        for name, content in attack.images_in(folder).items():
            lab.expect(content == good[name], f"{limit} descriptors: torn image {name}")


def main():
    lab = attack.lab_from_command_line(__doc__)
    folder = lab.folder("reference")
    lab.expect(lab.run(BAKE, folder).code == 0, "the reference cannot be baked")
    good = attack.images_in(folder)
    every = list(itertools.product(STATES, repeat=3))
    some = every if lab.long else lab.random.sample(every, 4)
    attack_streams(lab, good, some, COMMANDS + MORE_COMMANDS if lab.long else COMMANDS)
    attack_limits(lab, good, range(3, 24) if lab.long else (3, 4, 5, 6, 8))
    lab.finish(f"{len(some)} combinations of streams")


main()
