#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs commands under foreign locales, time zones and environments.

Images, printed texts, exit codes and the number of commas in each table must be the same everywhere: no decimal commas, no
dotless i. The locales are compiled with localedef, if their sources are installed (Debian package locales). The short form
tries a locale with decimal commas and one with a dotless i, the long form tries more locales.
"""
import os
import shutil
import subprocess

import lab as attack

LOCALES = ["de_DE.UTF-8", "tr_TR.UTF-8"]
MORE_LOCALES = ["fr_FR.UTF-8", "hi_IN.UTF-8", "C", "POSIX", "xx_XX.missing"]
BAKE = ["bake", "sea_foam", *attack.SMALL, "--set", "frames.count=2", "--set", "frames.time_step=0.25", "--maps", "lit,id",
        "--stats", "--out", "out/{map}.####.png"]
COMMANDS = [BAKE, ["verify", "out", "--json"], ["presets", "keys"], ["stats", "sea_foam", *attack.SMALL, "--frames", "1-2"],
            ["bake", "sea_foam", "--set", "foam.t2_area=0,5"]]


def compile_locales(lab, names):
    """Compiles locales into a folder. Returns the number of locales and the folder."""
    folder = lab.folder("locales")
    count = 0
    if shutil.which("localedef") and os.path.isdir("/usr/share/i18n/locales"):
        for name in names:
            command = ["localedef", "--quiet", "-i", name.split(".")[0], "-f", "UTF-8", folder / name]
            count += subprocess.run(command, check=False, capture_output=True).returncode == 0
    return count, folder


def results(lab, environment):
    """Returns exit codes and printed texts, images, and the number of commas in each table."""
    folder = lab.folder("work")
    outcomes = [lab.run(command, folder, env=environment) for command in COMMANDS]
    printed = [(outcome.code, outcome.out, outcome.err) for outcome in outcomes]
    printed[3] = (outcomes[3].code, "", outcomes[3].err)  # its output has the time that it took
    tables = {path.name: path.read_text().count(",") for path in folder.rglob("*.csv")}
    return printed, attack.images_in(folder), tables


def environments(names, locale_folder):
    """Yields names and environments."""
    plain = {"PATH": os.environ["PATH"]}
    for name in names:
        yield name, plain | {"LC_ALL": name, "LANG": name} | ({"LOCPATH": str(locale_folder)} if locale_folder else {})
    yield "no environment", {}
    yield "others", plain | {"TZ": "Asia/Kathmandu", "TMPDIR": "/nonexistent", "HOME": "/nonexistent", "COLUMNS": "1"}


def main():
    lab = attack.lab_from_command_line(__doc__)
    good = results(lab, {"PATH": os.environ["PATH"], "LC_ALL": "C"})
    lab.expect([code for code, _, _ in good[0]] == [0, 0, 0, 0, 2], f"the reference fails: {good[0]}")
    names = LOCALES + MORE_LOCALES if lab.long else LOCALES
    compiled, folder = compile_locales(lab, [name for name in names if "UTF-8" in name])
    for name, environment in environments(names, folder if compiled else None):
        lab.expect(results(lab, environment) == good, f"other results with {name}")
    lab.finish(f"{len(names)} locales, {compiled} of them compiled")


main()
