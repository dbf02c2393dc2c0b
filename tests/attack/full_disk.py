#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes to disks that are too small.

A command must end with the exit code 5 and one line, or with 0. No image may be incomplete. After the bake has been resumed
with enough space, it must have the same images as a bake that always had enough space. The disk is a tmpfs, which only root
may mount; if it cannot be mounted, the largest size of a file is limited instead. The short form tries 8 sizes, the long
form 60 (or all 11 limits of the file size).
"""
import contextlib
import resource
import signal
import subprocess

import lab as attack

BAKE = ["bake", "sea_foam", *attack.SMALL, "--set", "frames.count=6", "--maps", "albedo,height,id"]
COMMANDS = [
    [*BAKE, "--out", "disk/{map}.####.png"],
    [*BAKE, "--stats", "--out", "disk/{map}.####.exr"],
    ["simulate", "sea_foam", *attack.SMALL, "--set", "frames.count=6", "--cache", "disk/foam"],
    ["preview", "done", "-q", "--as", "contact,tiling", "--out", "disk"],
    ["flipbook", "done", "-q", "--out", "disk"],
]


@contextlib.contextmanager
def small_disk(folder, kib):
    owner = folder.stat().st_uid
    options = f"size={kib}k,uid={owner},gid={owner}"
    subprocess.run(["mount", "-t", "tmpfs", "-o", options, "tmpfs", folder], check=True, capture_output=True)
    try:
        yield
    finally:
        subprocess.run(["umount", folder], check=True)


def can_mount(folder):
    try:
        with small_disk(folder, 64):
            return True
    except (OSError, subprocess.CalledProcessError):
        return False


def limit_files(kib):
    """Returns a function that limits the largest size of a file in the process that calls it."""
    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (kib * 1024, kib * 1024))
    return limit


def check_images(lab, disk, good, what):
    for name, content in attack.images_in(disk).items():
        if name in good:
            lab.expect(content == good[name], f"{what}: torn image {name}")


def attack_with(lab, kib, work, good, mounted):
    """Runs all commands with little space, and lets the first one resume with enough space."""
    for command in COMMANDS:
        disk = lab.folder("work/disk")
        with small_disk(disk, kib) if mounted else contextlib.nullcontext():
            options = {} if mounted else {"preexec_fn": limit_files(kib)}
            what = f"{kib} KiB, {command[0]}"
            outcome = lab.run(command, work, **options)
            lab.expect_documented(outcome, what, {0, 5})
            check_images(lab, disk, good, what)
            if command is COMMANDS[0]:
                if mounted:
                    subprocess.run(["mount", "-o", "remount,size=64m", disk], check=True)
                lab.expect(lab.run([*command, "--resume"], work).code == 0, f"{what}: cannot be resumed")
                lab.expect(attack.images_in(disk) == good, f"{what}: the resumed bake has other images")


def main():
    lab = attack.lab_from_command_line(__doc__)
    work = lab.folder("work")
    lab.folder("work/disk")
    mounted = can_mount(work / "disk")
    # The images contain the pattern of their names, so the reference has the same pattern.
    lab.expect(lab.run(COMMANDS[0], work).code == 0, "the reference cannot be baked")
    (work / "disk").rename(work / "done")
    good = attack.images_in(work / "done")
    most = 240 if mounted else 12  # KiB
    count = 60 if lab.long else 8
    for kib in sorted(lab.random.sample(range(1, most), min(count, most - 1))):
        attack_with(lab, 4 * kib if mounted else kib, work, good, mounted)
    lab.finish("disks of tmpfs" if mounted else "limits of the file size, because a tmpfs cannot be mounted")


main()
