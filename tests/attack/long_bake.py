#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Bakes thousands of tiny frames and measures the memory of the program.

Apart from the list of files for the manifest, memory must not grow with the number of frames. It must stay below 1.1 times
a base plus 4 KiB per frame. The base is the largest memory of a bake of two frames or, if that is more, the largest memory in
the first tenth of the time. The state of a frame takes more than 10 KiB, so this test fails if the program keeps the state of
every frame. The short form bakes 400 frames, the long form 10,000.
"""
import os
import subprocess
import time

import lab as attack

COMMAND = ["bake", "sea_foam", "-q", "--size", "16", "--set", "foam.bubbles=60", "--set", "loop.kind=none", "--set",
           "dynamics.kappa=0", "--maps", "albedo", "--threads", "2", "--out", "out/{map}.#####.png"]
KIB_PER_FRAME = 4


def peak_kib_of_two_frames(lab):
    """Returns the largest memory of a bake of two frames, in KiB."""
    process = lab.start([*COMMAND, "--set", "frames.count=2"], lab.folder("short"), stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    lab.expect(process.returncode == 0, f"exit {process.returncode} of the bake of two frames")
    return usage.ru_maxrss


def resident_kib(process):
    """Returns the resident memory of a process, or None if it has ended."""
    try:
        with open(f"/proc/{process.pid}/status", encoding="ascii") as status:
            return next((int(line.split()[1]) for line in status if line.startswith("VmRSS:")), None)
    except OSError:
        return None


def measure(process):
    """Returns pairs of (seconds since the start, resident memory in KiB) until the process ends."""
    start = time.monotonic()
    samples = []
    while process.poll() is None:
        kib = resident_kib(process)
        if kib is not None:
            samples.append((time.monotonic() - start, kib))
        time.sleep(0.02 if len(samples) < 100 else 0.5)
    return samples


def main():
    lab = attack.lab_from_command_line(__doc__)
    frames = 10000 if lab.long else 400
    started = peak_kib_of_two_frames(lab)
    folder = lab.folder("work")
    process = lab.start([*COMMAND, "--set", f"frames.count={frames}"], folder, stdout=subprocess.DEVNULL)
    samples = measure(process)
    lab.expect(process.returncode == 0, f"exit {process.returncode}")
    lab.expect(lab.run(["verify", "out"], folder).code == 0, "the bake does not pass verify")
    lab.expect(len(attack.images_in(folder)) == frames, "frames are missing")
    first = max(started, *(kib for at, kib in samples if at <= 0.1 * samples[-1][0]))
    most = max(kib for _, kib in samples)
    lab.expect(most < 1.1 * first + KIB_PER_FRAME * frames,
               f"memory grows from a base of {first} KiB to {most} KiB")
    lab.finish(f"{frames} frames in {samples[-1][0]:.0f} s, base of {first} KiB, {most} KiB at most")



main()
