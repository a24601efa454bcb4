#!/usr/bin/python3
"""What is wrong with the input is said, with a status that tells what kind of mistake it was; nothing hangs."""
import resource
import unittest

import h5py
import numpy

import program


def setting(*settings, deck="simple"):
    return ["run", program.deck(deck), *(word for text in settings for word in ("--set", text))]


class WrongInput(program.TestCase):
    def setUp(self):
        super().setUp()
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        self.garbage = self.output / "garbage.msh"
        self.garbage.write_text("this is no mesh\n")
        self.huge = self.output / "huge.msh"
        self.huge.write_text("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1e120 0 0\n3 0 1e120 0\n"
                             "4 0 0 1e120\n$EndNodes\n$Elements\n1\n1 4 2 0 1 1 2 3 4\n$EndElements\n")
        self.result = self.output / "results"

    def check(self, arguments, status, *messages):
        """Alone and on two ranks: the status, and what is said about it."""
        if arguments[:1] == ["run"] and "--output-folder" not in arguments:
            arguments = [*arguments, "--output-folder", self.result]
        for ranks in (None, 2):
            with self.subTest(arguments=list(map(str, arguments)), ranks=ranks):
                job = program.idiophone(*arguments, ranks=ranks)
                self.require_status(job, status)
                for message in messages:
                    self.assertIn(message, job.stderr)
                self.assertNotRegex(job.stderr, "(?i)segmentation|terminate called|signal 11|signal 6")

    def test_command_line(self):
        for arguments in ([], ["fly"], ["run"]):
            with self.subTest(arguments=arguments):
                job = program.idiophone(*arguments)
                self.assertNotIn(job.returncode, (program.FINISHED, program.WRONG_DECK, program.RESUMABLE))
                self.assertIn("required", job.stderr)
                self.assertIn("--help", job.stderr)

    def test_wrong_deck(self):
        text = program.deck("simple").read_text().replace("young:", "yuong:").replace("../../..", str(program.SOURCE))
        misspelt = self.output / "misspelt.yaml"
        misspelt.write_text(text)
        line, place = next((number, row.find("yuong") + 1) for number, row in enumerate(text.splitlines(), 1)
                           if "yuong" in row)
        self.check(["run", misspelt], program.WRONG_DECK, f"{misspelt}:{line}:{place}: ", "did you mean 'young'?")
        self.check(["check", misspelt], program.WRONG_DECK, f"{misspelt}:{line}:{place}: ")

    def test_wrong_settings(self):
        for settings, *messages in (
                ("time.durration=1", "did you mean 'duration'?"),
                ("time.duration=-1", "must be above 0"),
                ("bodies.plate.fixed.0=rin", "no group 'rin'", "did you mean 'rim'?"),
                ("loads.tap.at=[0, 0, 9]", "isn't on the body's surface", "nearest point"),
                ("bodies.plate.mesh=nowhere.geo", "no such file"),
                (f"bodies.plate={{mesh: {self.huge}, material: rubber, element: tet4}}", "at most 10000 m", "in metres"),
                ("radiation={air: {speed: 1e-10}}", "must be at least 50 and at most 100000 m/s"),
                ("materials.rubber.density=1e-320", "must be at least 0.001 and at most 1000000 kg/m3"),
                (f"bodies.plate={{mesh: {self.garbage}, material: rubber}}", "garbage.msh: ")):  # gmsh's own words follow
            self.check(setting(settings), program.WRONG_DECK, f"--set {settings}:1:", *messages)
        self.assertFalse(self.result.exists(), "a refused deck leaves nothing behind")

    def test_a_hinge_that_is_bent(self):
        self.check(setting("bodies.plate.fixed=[]", "bodies.plate.hinges=[rim]"), program.WRONG_DECK,
                   "--set bodies.plate.hinges=[rim]:1:", "the hinge 'rim' is not straight", "Physical Curve")

    def test_bodies_held_everywhere_need_a_step(self):
        self.check(setting("bodies.plate.fixed=[body]"), program.FAILED, "nothing limits the time step",
                   "set time.steps_per_sample")

    def test_check_warns_of_files_that_do_not_fit(self):
        job = program.idiophone("check", program.deck("simple"), "--set", "time.duration=86400", "--set",
                                "output={frames_per_second: 8000, surface_motion: true}", "--output-folder", self.result)
        self.require_status(job, program.FINISHED)
        self.assertRegex(job.stdout, r"the files of the run need about \d+ MB, and /\S+ has \d+ MB free")
        self.assertFalse(self.result.exists())

    def test_deck_that_is_not_there(self):
        self.check(["run", self.output / "nowhere.yaml"], program.FAILED, "nowhere.yaml", "No such file")

    def test_more_ranks_than_elements(self):
        job = program.run("simple", self.result, "--set", "bodies.plate.parameters.size=0.2", ranks=26)
        self.require_status(job, program.FAILED)
        self.assertIn("26 ranks are too many", job.stderr)
        self.assertIn("run on at most 24", job.stderr)

    def test_unstable_run_stops_soon_and_says_what_to_change(self):
        self.check(setting("loads.tap.force=[0, 0, -1e9]", "time.duration=10"), program.FAILED, "became unstable before",
                   "lower time.safety", "make the load smaller")
        with h5py.File(self.result / "simple.h5") as file:
            sound = file["audio/ear"][()]
        self.assertLess(len(sound), 1000)  # of the 80000
        self.assertTrue(numpy.isfinite(sound).all())

    def test_output_directory_that_can_not_be_made(self):
        self.check([*setting(), "--output-folder", self.garbage / "below"], program.FAILED, "garbage.msh/below",
                   "Not a directory")

    def test_files_that_are_no_results(self):
        self.require_status(program.run("simple", self.result), program.FINISHED)
        truncated = self.output / "truncated.h5"
        truncated.write_bytes((self.result / "simple.h5").read_bytes()[:3000])
        for command, no_file in (("info", "not an HDF5 file"), ("analyze", "can't read the sound file")):
            for file, message in ((self.garbage, no_file), (truncated, "is damaged"),
                                  (self.output / "nowhere.h5", "No such file")):
                with self.subTest(command=command, file=file.name):
                    job = program.idiophone(command, file)
                    self.require_status(job, program.FAILED)
                    self.assertIn(message, job.stderr)
                    self.assertIn(file.name, job.stderr)
        job = program.idiophone("analyze", self.result / "simple.h5", "--listener", "nobody")
        self.require_status(job, program.FAILED)
        self.assertIn("nobody", job.stderr)

    def test_commands_that_use_one_process(self):
        for command, *arguments in (("info", "file"), ("analyze", "file"), ("export", "map"), ("explore", "map"), ("report", "result"),
                                    ("mesh", "deck"), ("abx", "a.wav", "b.wav"),
                                    ("identify", "deck", "--measured", "lines"), ("tune", "deck", "--target", "A4", "--vary", "a=1:2"),
                                    ("play", "map"), ("proxies", "deck"), ("timbre", "scene")):
            with self.subTest(command=command):
                job = program.idiophone(command, *arguments, ranks=2)
                self.require_status(job, program.FAILED)
                self.assertIn(f"{command} uses one process; start it without mpirun", job.stderr)

    def test_old_names_of_options(self):
        for arguments, said in ((["run", program.deck("simple"), "--output", self.result], "--output was renamed: use --output-folder"),
                                (["modes", program.deck("simple"), "--count", "3"], "--count was renamed: use --modes")):
            with self.subTest(arguments=arguments[0]):
                job = program.idiophone(*arguments)
                self.assertNotIn(job.returncode, (program.FINISHED, program.WRONG_DECK, program.RESUMABLE))
                self.assertIn(said, job.stderr)
                self.assertFalse(self.result.exists())

    def test_resuming_where_there_is_no_checkpoint_begins_and_says_so(self):
        job = program.run("simple", self.result, "--resume", ranks=2)
        self.require_status(job, program.FINISHED)
        self.assertIn("no checkpoint in", job.stdout)

    def test_resuming_another_deck_is_refused_with_reasons(self):
        limit = "time.wall_clock_limit=1e-6"
        self.require_status(program.idiophone(*setting(limit), "--output-folder", self.result), program.RESUMABLE)
        job = program.idiophone(*setting(limit, "time.duration=0.02"), "--output-folder", self.result, "--resume", ranks=2)
        self.require_status(job, program.FAILED)
        self.assertIn(f"refused: other overrides: it was written by a run with --set '{limit}', this one has --set '{limit}' "
                      "--set 'time.duration=0.02'", job.stdout)
        self.assertIn("leave --resume out", job.stderr)

    def test_petsc_options(self):
        job = program.run("simple", self.result, "-log_view", ranks=2)
        self.require_status(job, program.FINISHED)
        for stage in ("motion", "surface", "radiation", "store"):
            self.assertRegex(job.stdout, rf"(?m)^ *\d+: +{stage}: ")
        job = program.run("simple", self.result, "-nonsense", "3", ranks=2)
        self.require_status(job, program.FINISHED)
        self.assertIn("-nonsense", job.stdout + job.stderr)


if __name__ == "__main__":
    unittest.main()
