# SPDX-License-Identifier: Apache-2.0
import sys
import textwrap
import time
import unittest

import support
from model.fault import Fault
from model.run import BakeOptions, Progress, Run, bake_command, error_of, preset_names, read_progress


class Command(unittest.TestCase):
    def test_only_options_that_are_given(self):
        command = bake_command(BakeOptions("foamtex", "sea_foam", "out"))
        self.assertEqual(command, ["foamtex", "bake", "sea_foam", "--json", "--progress", "json", "--out",
                                   "out/{preset}_{map}.####.png"])

    def test_all_options(self):
        command = bake_command(BakeOptions("foamtex", "a", "out", " albedo, normal,", "1-4", 256, 7))
        self.assertEqual(command[8:], ["--maps", "albedo,normal", "--frames", "1-4", "--size", "256", "--seed", "7"])

    def test_rejects_an_empty_folder(self):
        with self.assertRaisesRegex(Fault, "the folder is empty"):
            bake_command(BakeOptions("foamtex", "a", " "))


class ProgressLines(unittest.TestCase):
    def test_reports(self):
        for line, expected in (('{"phase":"frames","done":3,"total":12}\n', Progress("drawing frames: 3 of 12", 0.25)),
                               ('{"phase":"seeding","done":0,"total":null}\n', Progress("placing bubbles")),
                               ('{"phase":"new_phase","done":0,"total":0}\n', Progress("new_phase"))):
            self.assertEqual(read_progress(line), expected)

    def test_other_lines(self):
        for line in ("foamtex: note: the frames 1-4 alone do not loop\n", "{", '{"x":1}', "{}", "", "[1]"):
            self.assertIsNone(read_progress(line))

    def test_error_is_the_last_message(self):
        lines = ["{}\n", "foamtex: warning: a\n", "foamtex: preset 'x': must be a name\n", "foamtex: note: b\n"]
        self.assertEqual(error_of(lines, 2), "preset 'x': must be a name")
        self.assertEqual(error_of([], 1), "foamtex ended with the exit code 1")


class RunOfAProgram(support.FolderTest):
    def run_python(self, script):
        return Run([sys.executable, "-c", textwrap.dedent(script)])

    def test_missing_program(self):
        with self.assertRaisesRegex(Fault, "cannot run '/no/foamtex': No such file"):
            Run(["/no/foamtex"])

    def test_success(self):
        run = self.run_python('print(\'{"manifest": "out/manifest.json"}\')')
        run.wait(60)
        self.assertEqual(str(run.manifest()), "out/manifest.json")

    def test_failure(self):
        run = self.run_python("import sys; sys.exit('foamtex: it failed')")
        run.wait(60)
        with self.assertRaisesRegex(Fault, "^it failed$"):
            run.manifest()

    def test_a_program_that_writes_much_does_not_stop(self):
        run = self.run_python("""
            import sys
            sys.stderr.write('x' * 1000000)
            print('{"manifest": "m"}', ' ' * 1000000)""")
        run.wait(60)
        self.assertEqual(str(run.manifest()), "m")

    def test_progress_and_cancel(self):
        run = self.run_python("""
            import sys, time
            print('{"phase":"frames","done":1,"total":2}', file=sys.stderr, flush=True)
            time.sleep(60)""")
        end = time.monotonic() + 60
        while not run.poll() and run.progress.fraction == 0 and time.monotonic() < end:
            time.sleep(0.01)
        self.assertEqual(run.progress, Progress("drawing frames: 1 of 2", 0.5))
        run.cancel()
        run.wait(30)
        with self.assertRaisesRegex(Fault, "^canceled$"):
            run.manifest()


class PresetNames(unittest.TestCase):
    def test_without_a_program(self):
        self.assertEqual(preset_names("/no/foamtex"), [])
        self.assertEqual(preset_names("true"), [])

    @support.needs_program
    def test_of_the_program(self):
        self.assertIn("sea_foam", preset_names(support.PROGRAM))


@support.needs_program
class RunOfFoamtex(support.FolderTest):
    def test_bake(self):
        options = BakeOptions(support.PROGRAM, "sea_foam", str(self.folder), "albedo", "1", 32)
        run = Run(bake_command(options) + support.SMALL[:-1])
        run.wait(120)
        self.assertEqual(run.manifest(), self.folder / "manifest.json")
        self.assertEqual(run.progress, Progress("drawing frames: 1 of 1", 1.0))

    def test_error_of_the_program(self):
        run = Run(bake_command(BakeOptions(support.PROGRAM, "sea_fom", str(self.folder))))
        run.wait(60)
        with self.assertRaisesRegex(Fault, "^preset 'sea_fom': .* did you mean 'sea_foam'"):
            run.manifest()


if __name__ == "__main__":
    unittest.main()
