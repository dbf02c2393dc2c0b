#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Bakes into folders that are read-only or vanish, and where a file or folder is in the way; runs two bakes in one folder.

Root may write everywhere, so root runs the program as an ordinary user as well.
"""
import fcntl
import os
import pathlib
import shutil
import subprocess
import time

import lab as attack

OUT = ["--out", "out/{map}.####.png"]
BAKE = ["bake", "sea_foam", *attack.SMALL, "--set", "frames.count=4", "--maps", "lit,id", *OUT]
LONGER = ["bake", "soap_raft", *attack.SMALL, "--set", "frames.count=40", "--maps", "albedo,height,id", *OUT]


def read_only_folder(lab, folder):
    (folder / "out").mkdir()
    os.chmod(folder / "out", 0o555)
    allowed = {5} if lab.user is not None or not attack.is_user_root() else {0}
    lab.expect_documented(lab.run(BAKE, folder), "a read-only folder", allowed)


def read_only_files(lab, folder):
    lab.expect(lab.run(BAKE, folder).code == 0, "cannot bake")
    for path in (folder / "out").iterdir():
        path.chmod(0o444)
    lab.expect_documented(lab.run(BAKE, folder), "read-only files, which are replaced", {0})


def unreadable_inputs(lab, folder):
    (folder / "foam.toml").write_text('extends = "sea_foam"\n')
    (folder / "foam.toml").chmod(0)
    allowed = {2} if lab.user is not None or not attack.is_user_root() else {0}
    lab.expect_documented(lab.run([*BAKE[:1], "foam.toml", *BAKE[2:]], folder), "an unreadable preset", allowed)


def file_in_the_way(lab, folder):
    (folder / "out").write_text("a file")
    lab.expect_documented(lab.run(BAKE, folder), "a file in place of the folder", {5})
    lab.expect((folder / "out").read_text() == "a file", "the file in the way was changed")


def folder_in_the_way(lab, folder):
    (folder / "out" / "lit.0002.png").mkdir(parents=True)
    if lab.user is not None:
        for path in (folder / "out", folder / "out" / "lit.0002.png"):
            os.chown(path, lab.user, lab.user)
    lab.expect_documented(lab.run(BAKE, folder), "a folder in place of an image", {5})


def loop_of_links(lab, folder):
    (folder / "out").symlink_to("again")
    (folder / "again").symlink_to("out")
    lab.expect_documented(lab.run(BAKE, folder), "a loop of links", {5})


def long_path(lab, folder):
    pattern = "x" * 300 + "/{map}.####.png"
    lab.expect_documented(lab.run([*BAKE[:-1], pattern], folder), "a name that is too long", {5})
    pattern = "/".join(["y" * 200] * 30) + "/{map}.####.png"
    lab.expect_documented(lab.run([*BAKE[:-1], pattern], folder), "a path that is too long", {5})


def vanishing_folder(lab, folder):
    process = lab.start(LONGER, folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    while process.poll() is None and not (folder / "out" / "albedo.0001.png").exists():
        time.sleep(0.002)
    time.sleep(lab.random.uniform(0, 0.05))
    shutil.rmtree(folder / "out", ignore_errors=True)
    _, err = process.communicate(timeout=attack.TIME_LIMIT)
    lab.expect_documented(attack.Outcome(process.returncode, "", attack.text_of(err)), "a folder that vanishes", {0, 5})


def vanished_working_folder(lab, folder):
    gone = folder / "gone"
    gone.mkdir()
    script = 'cd "$1" && rmdir "$1" && shift && exec "$@"'
    command = ["sh", "-c", script, "sh", gone, lab.program, *BAKE]
    options = {"user": lab.user, "group": lab.user, "extra_groups": []} if lab.user is not None else {}
    if lab.user is not None:
        os.chown(gone, lab.user, lab.user)
    done = subprocess.run(command, check=False, capture_output=True, timeout=attack.TIME_LIMIT, **options)
    outcome = attack.Outcome(done.returncode, "", attack.text_of(done.stderr))
    lab.expect_documented(outcome, "a working folder that was removed", {5})


def two_bakes(lab, folder):
    """Runs two bakes in one folder at the same time: first of different presets, then of the same preset."""
    for presets in (("sea_foam", "soap_raft"), ("sea_foam", "sea_foam")):
        commands = [[*BAKE[:1], preset, *BAKE[2:-1], "both/{preset}_{map}.####.png"] for preset in presets]
        running = [lab.start(one, folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) for one in commands]
        for process in running:
            _, err = process.communicate(timeout=attack.TIME_LIMIT)
            lab.expect(process.returncode == 0, f"two bakes of {presets}: {process.returncode} {err}")
        verified = lab.run(["verify", "both"], folder)
        lab.expect(verified.code == 0, f"two bakes of {presets} do not pass verify: {verified.out} {verified.err}")


def held_lock(lab, folder):
    """Another program holds the lock of the manifest and never releases it."""
    (folder / "out").mkdir()
    if lab.user is not None:
        os.chown(folder / "out", lab.user, lab.user)
    with open(folder / "out" / "manifest.json.lock", "w", encoding="utf-8") as file:
        os.fchmod(file.fileno(), 0o666)
        fcntl.flock(file, fcntl.LOCK_EX)
        outcome = lab.run(BAKE, folder)
    lab.expect_documented(outcome, "a lock that is never released", {5})
    lab.expect("another program has locked" in outcome.err, f"a held lock is not named: {outcome.err}")


SITUATIONS = [read_only_folder, read_only_files, unreadable_inputs, file_in_the_way, folder_in_the_way,
              vanishing_folder, vanished_working_folder, two_bakes]
MORE_SITUATIONS = [loop_of_links, long_path]
SLOW_SITUATIONS = [held_lock]  # a minute each


def main():
    lab = attack.lab_from_command_line(__doc__)
    situations = SITUATIONS + MORE_SITUATIONS if lab.long else SITUATIONS
    users = [None, attack.NOBODY] if attack.is_user_root() else [None]
    for user in users:
        lab.user = user
        for k in range(20 if lab.long else 1):
            for situation in situations + (SLOW_SITUATIONS if lab.long and k == 0 else []):
                folder = lab.folder(pathlib.Path("work"))
                before = len(lab.faults)
                situation(lab, folder)
                if len(lab.faults) > before:
                    print(f"  in {situation.__name__}, as {'user ' + str(user) if user else 'the present user'}")
    lab.finish(f"{len(situations)} situations for {len(users)} users")


main()
