# SPDX-License-Identifier: Apache-2.0
"""Functions that all attacks share: running the program, reading images, and the command line of an attack."""
import argparse
import collections
import dataclasses
import os
import pathlib
import random
import resource
import shutil
import subprocess
import sys
import tempfile

NOBODY = 65534  # the id of the user without rights
SKIPPED = 77  # the exit code that ctest counts as a skipped test
DOCUMENTED = {0, 2, 3, 4, 5, 6, 130, 143}  # the exit codes of the program, except 1, which means a bug or too little memory
PROCESSOR_TIME_LIMIT = 60  # seconds; the signal SIGXCPU ends a run that takes more
TIME_LIMIT = 1200  # seconds; a run that takes longer counts as a hang

# Options of a bake that takes a second or less.
SMALL = ["--set", "foam.bubbles=24", "--set", "foam.lloyd=2", "--size", "48", "--threads", "2", "-q"]


def limit_processor_time():
    resource.setrlimit(resource.RLIMIT_CPU, (PROCESSOR_TIME_LIMIT, PROCESSOR_TIME_LIMIT + 5))


@dataclasses.dataclass
class Outcome:
    code: int  # the exit code; minus the number of the signal that ended the program
    out: str
    err: str


class Lab:
    """A temporary folder with a copy of the program, which every user may run. Collects the faults that are found."""

    def __init__(self, arguments):
        self.random = random.Random(arguments.seed)
        self.long = arguments.long
        # The id of the user who runs the program; None: the present user.
        self.user = NOBODY if arguments.ordinary_user and is_user_root() else None
        self.root = pathlib.Path(tempfile.mkdtemp(prefix="foamtex-attack-"))
        self.root.chmod(0o755)
        self.program = self.root / "foamtex"
        shutil.copy2(arguments.program, self.program)
        self.faults = []
        self.codes = collections.Counter()  # number of finished runs by exit code

    def folder(self, name):
        """Returns a new empty folder, which belongs to the user of the program."""
        folder = self.root / name
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        if self.user is not None:
            os.chown(folder, self.user, self.user)
        return folder

    def start(self, arguments, cwd, **options):
        """Starts the program and returns the process."""
        if self.user is not None:
            options |= {"user": self.user, "group": self.user, "extra_groups": []}
        options.setdefault("stdin", subprocess.DEVNULL)
        # The new process sets its own limit, because only a privileged user may set the limit of another user's process.
        prepare = options.pop("preexec_fn", lambda: None)
        options["preexec_fn"] = lambda: (limit_processor_time(), prepare())
        return subprocess.Popen([self.program, *map(str, arguments)], cwd=cwd, **options)

    def run(self, arguments, cwd, **options):
        """Runs the program to its end. Options of subprocess.Popen may redirect its streams."""
        options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE} | options
        process = self.start(arguments, cwd, **options)
        try:
            out, err = process.communicate(timeout=TIME_LIMIT)
        except subprocess.TimeoutExpired:
            process.kill()
            out, err = process.communicate()
            self.fault(f"hangs: {show(arguments)}")
        self.codes[process.returncode] += 1
        return Outcome(process.returncode, text_of(out), text_of(err))

    def fault(self, message):
        """Records a fault and prints it."""
        self.faults.append(message)
        print(f"FAULT {message}", flush=True)

    def expect(self, holds, message):
        if not holds:
            self.fault(message)
        return holds

    def expect_documented(self, outcome, what, codes=DOCUMENTED):
        """Expects one of the given exit codes, and exactly one line on stderr after a failure."""
        self.expect(outcome.code in codes, f"{what}: exit {outcome.code}, not one of {sorted(codes)}: {outcome.err.strip()[:200]}")
        if outcome.code != 0:
            self.expect(outcome.err.count("\n") <= 1, f"{what}: more than one line: {outcome.err[:300]}")

    def finish(self, summary):
        """Prints the summary, removes the folder, and ends the script."""
        shutil.rmtree(self.root, ignore_errors=True)
        codes = ", ".join(f"{count} of exit code {code}" for code, count in sorted(self.codes.items()))
        print(f"{summary}; finished runs: {codes}; {len(self.faults)} faults")
        sys.exit(1 if self.faults else 0)


def text_of(stream):
    return "" if stream is None else stream.decode(errors="replace")


def show(arguments):
    return " ".join(map(str, arguments))


def images_in(folder):
    """Returns the bytes of all images under a folder, by their relative paths."""
    paths = sorted(path for path in pathlib.Path(folder).rglob("*") if path.suffix in (".png", ".exr"))
    return {str(path.relative_to(folder)): path.read_bytes() for path in paths}


def is_user_root():
    return os.geteuid() == 0


def lab_from_command_line(description, add_options=None):
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--program", required=True, help="path of foamtex")
    parser.add_argument("--long", action="store_true", help="the long form")
    parser.add_argument("--ordinary-user", action="store_true", help="if you are root, run the program as another user")
    parser.add_argument("--seed", type=int, default=1, help="seed of the random choices")
    if add_options:
        add_options(parser)
    arguments = parser.parse_args()
    lab = Lab(arguments)
    lab.arguments = arguments
    return lab
