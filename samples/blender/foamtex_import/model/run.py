# SPDX-License-Identifier: Apache-2.0
"""Runs the program foamtex without waiting for it."""
import dataclasses
import json
import os
import pathlib
import queue
import signal
import subprocess
import tempfile
import threading

from .fault import Fault

NO_WINDOW = getattr(subprocess, "CREATE_NO_WINDOW", 0)  # only Windows would open one
PHASES = {  # what a user reads while a phase lasts
    "seeding": "placing bubbles",
    "equilibrium": "finding the first equilibrium",
    "warm_up": "warming up",
    "loop_closing": "closing the loop",
    "states": "simulating earlier frames",
    "ranges": "measuring ranges",
    "frames": "drawing frames",
}


@dataclasses.dataclass(frozen=True)
class BakeOptions:
    """The options of `foamtex bake` that the panel offers. Empty values leave the defaults of the preset."""

    program: str
    preset: str
    folder: str
    maps: str = ""  # names, separated by commas
    frames: str = ""
    size: int = 0
    seed: int = 0


def bake_command(options):
    """Returns the arguments of the program, with its path first. Throws Fault if a needed option is empty."""
    for name in ("program", "preset", "folder"):
        if not getattr(options, name).strip():
            raise Fault(f"the {name} is empty; give one in the panel")
    pattern = str(pathlib.Path(options.folder) / "{preset}_{map}.####.png")
    command = [options.program, "bake", options.preset, "--json", "--progress", "json", "--out", pattern]
    maps = ",".join(name.strip() for name in options.maps.split(",") if name.strip())
    for option, value in (("--maps", maps), ("--frames", options.frames.strip()), ("--size", options.size),
                          ("--seed", options.seed)):
        if value:
            command += [option, str(value)]
    return command


@dataclasses.dataclass(frozen=True)
class Progress:
    """The last report of a run."""

    text: str = "starting"
    fraction: float = 0.0  # of the phase


def read_progress(line):
    """Returns the progress that a line of stderr reports, or None if the line is not such a report."""
    if not line.startswith("{"):
        return None
    try:
        report = json.loads(line)
        done, total = report.get("done"), report.get("total")
        text = PHASES.get(report["phase"], report["phase"])
    except (ValueError, KeyError, TypeError, AttributeError):
        return None
    if not total:
        return Progress(text)
    return Progress(f"{text}: {done} of {total}", min(done / total, 1.0))


def error_of(lines, code):
    """Returns the message of a failed run, which is its last line on stderr that is no note and no warning."""
    messages = [line.removeprefix("foamtex: ") for line in lines if line.strip() and not line.startswith("{")]
    errors = [line for line in messages if not line.startswith(("note: ", "warning: "))]
    return errors[-1].strip() if errors else f"foamtex ended with the exit code {code}"


class Run:
    """A run of the program. Call `poll` repeatedly; a thread reads stderr, so that the program never waits for us."""

    def __init__(self, command):
        """Starts the program. Throws Fault if that fails."""
        self.progress = Progress()
        self._lines = []
        self._new_lines = queue.SimpleQueue()
        self._canceled = False
        self._results = tempfile.TemporaryFile()
        try:
            self._process = subprocess.Popen(
                command, stdin=subprocess.DEVNULL, stdout=self._results, stderr=subprocess.PIPE, text=True,
                encoding="utf-8", errors="replace", creationflags=NO_WINDOW)
        except OSError as error:
            self._results.close()
            raise Fault(f"cannot run '{command[0]}': {error.strerror}; set the path of foamtex in the panel") from error
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self):
        with self._process.stderr as stream:
            for line in stream:
                self._new_lines.put(line)

    def poll(self):
        """Updates `progress`. Returns True when the program has ended."""
        ended = self._process.poll() is not None
        if ended:
            self._reader.join()
        while not self._new_lines.empty():
            line = self._new_lines.get()
            self.progress = read_progress(line) or self.progress
            self._lines.append(line)
        return ended

    def wait(self, timeout=None):
        """Waits for the end of the program."""
        self._process.wait(timeout)
        self.poll()

    def cancel(self):
        """Asks the program to stop after its present step. It then records in the manifest that it was interrupted."""
        self._canceled = True
        if self._process.poll() is None:
            self._process.send_signal(signal.SIGTERM if os.name == "nt" else signal.SIGINT)

    def manifest(self):
        """Returns the path of the manifest that the ended program has written. Throws Fault if the program failed."""
        code = self._process.returncode
        self._results.seek(0)
        text = self._results.read()
        self._results.close()
        if code != 0:
            raise Fault("canceled" if self._canceled else error_of(self._lines, code))
        return pathlib.Path(json.loads(text)["manifest"])


def preset_names(program):
    """Returns the names of the shipped presets, or no names if the program does not run."""
    try:
        found = subprocess.run([program, "presets", "--json"], stdin=subprocess.DEVNULL, capture_output=True, timeout=10,
                               check=True, encoding="utf-8", creationflags=NO_WINDOW)
        return [preset["name"] for preset in json.loads(found.stdout)["presets"]]
    except (OSError, subprocess.SubprocessError, ValueError, KeyError):
        return []
