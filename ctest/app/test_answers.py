#!/usr/bin/python3
"""What results and commands say of a run, for scripts: info, check, modes and analyze with --json, check --resolved."""
import json
import math
import os
import unittest
import wave

import h5py
import numpy

import program

STAGES = {"motion", "contact", "surface", "visibility", "radiation", "store"}


class Answers(program.TestCase):
    def ask(self, *arguments, ranks=None):
        """What a command says in JSON."""
        job = program.idiophone(*arguments, "--json", ranks=ranks)
        self.require_status(job, program.FINISHED)
        return json.loads(job.stdout)

    def test_a_result_says_what_the_run_was(self):
        self.require_status(program.run("rich", self.output, ranks=2), program.FINISHED)
        answer = self.ask("info", self.output / "rich.h5")
        run = answer["run"]
        self.assertAlmostEqual(run["step"] * run["steps_per_sample"] * answer["datasets"]["/audio/ears"]["rate"], 1)
        self.assertEqual(run["steps_per_sample"] % run["steps_per_read"], 0)
        for key in ("nodes", "elements", "triangles", "mass"):
            self.assertAlmostEqual(run[key], sum(body[key] for body in run["bodies"].values()))
        with h5py.File(self.output / "rich.h5") as file:
            for name, body in run["bodies"].items():
                self.assertEqual(body["nodes"], len(file[f"mesh/{name}/nodes"]))
                self.assertEqual(body["elements"], len(file[f"mesh/{name}/elements"]))
        job, = run["jobs"]
        self.assertEqual((job["ranks"], job["first_sample"]), (2, 0))
        self.assertGreaterEqual(job["last_sample"], answer["datasets"]["/audio/ears"]["shape"][0])
        self.assertEqual(set(job["stages"]), STAGES)
        self.assertGreater(job["stages"]["motion"], 0)
        self.assertAlmostEqual(job["elements_per_second"] * job["elapsed"],
                               run["elements"] * run["steps_per_sample"] * job["last_sample"], delta=1)
        for name in ("idiophone", "compiler", "mpi", "petsc", "slepc", "hdf5", "gmsh"):
            self.assertTrue(job["versions"][name], name)

    def test_a_process_alone_needs_no_folder_of_open_mpi(self):
        """All such processes would share it: one that ended took it away from one that began."""
        no_folder = self.output / "file"
        no_folder.touch()
        job = program.idiophone("timbre", program.SOURCE / "inputs/four_ways/tree.yaml", "-o", self.output / "sound.wav",
                                environment={"TMPDIR": str(no_folder)})
        self.require_status(job, program.FINISHED)

    def test_hexahedra_say_their_order_and_mass_scaling(self):
        bodies = self.ask("check", program.deck("hexahedra"))["bodies"]
        self.assertEqual(bodies["plate"]["order"], {"plane": 3, "thickness": 2})
        self.assertGreater(bodies["plate"]["mass_scaling"]["gain"], 1)
        self.assertTrue(0 < bodies["plate"]["mass_scaling"]["shift"] < 5.001)
        self.assertNotIn("mass_scaling", bodies["ball"])
        self.assertNotIn("order", bodies["bar"])
        self.require_status(program.run("hexahedra", self.output, "--set", "time.duration=0.001"), program.FINISHED)
        stored = self.ask("info", self.output / "hexahedra.h5")["run"]["bodies"]["plate"]
        for key in ("order", "mass_scaling"):
            self.assertEqual(stored[key], bodies["plate"][key])

    def test_a_channel_is_printed_by_its_name(self):
        self.require_status(program.run("rich", self.output), program.FINISHED)
        result = self.output / "rich.h5"
        with h5py.File(result) as file:
            energy = file["energy"][:]
            rate = file["energy"].attrs["rate"]
        answer = self.ask("info", result, "--channel", "energy")
        self.assertEqual(answer["rows"], energy.tolist())
        self.assertEqual((answer["path"], answer["unit"], answer["rate"]), ("/energy", "J", rate))
        table = program.idiophone("info", result, "--channel", "/energy").stdout.splitlines()
        self.assertEqual(table[0], "time (s),kinetic (J),elastic (J),contact (J),gravitational (J),work (J)")
        self.assertEqual([[float(value) for value in line.split(",")[1:]] for line in table[1:]], energy.tolist())
        self.assertAlmostEqual(float(table[-1].split(",")[0]), (len(energy) - 1) / rate, places=8)
        wrong = program.idiophone("info", result, "--channel", "energie")
        self.assertNotEqual(wrong.returncode, program.FINISHED)
        self.assertIn("there is no channel /energie (did you mean '/energy'?)", wrong.stderr)

    def test_a_resumed_run_adds_its_part(self):
        limit = "--set", "time.wall_clock_limit=1e-6"
        self.require_status(program.run("simple", self.output, *limit), program.RESUMABLE)
        program.run("simple", self.output, *limit, "--resume", ranks=2)
        first, second, *_ = self.ask("info", self.output / "simple.h5")["run"]["jobs"]  # more if mpirun itself failed at the end
        self.assertEqual((first["ranks"], second["ranks"]), (1, 2))
        self.assertEqual(second["first_sample"], first["last_sample"])
        text = program.idiophone("info", self.output / "simple.h5").stdout
        self.assertIn("job 2: 2 ranks", text)

    def test_the_resolved_deck_gives_the_same_bits(self):
        resolved = program.idiophone("check", program.deck("rich"), "--resolved", "--set", "time.duration=0.002")
        self.require_status(resolved, program.FINISHED)
        (self.output / "resolved.yaml").write_text(resolved.stdout)
        expected = program.run("rich", self.output, "--set", "time.duration=0.002")
        self.require_status(expected, program.FINISHED)
        job = program.idiophone("run", self.output / "resolved.yaml", "--output-folder", self.output / "again", ranks=1)
        self.require_status(job, program.FINISHED)
        contents = program.contents(self.output / "rich.h5")
        found = program.contents(self.output / "again" / "rich.h5")
        for path in contents.keys() - {"deck"}:
            self.assertEqual(found[path].tobytes(), contents[path].tobytes(), path)
        with h5py.File(self.output / "rich.h5") as file:
            self.assertEqual(file["run/deck"][0].decode(), resolved.stdout)

    def test_check_says_sizes_and_costs(self):
        answer = self.ask("check", program.deck("simple"), ranks=2)
        self.assertGreater(answer["bodies"]["plate"]["largest_eigenfrequency"], 1e3)
        self.assertEqual(answer["costs"]["ranks"], 2)
        self.assertAlmostEqual(answer["costs"]["steps"], answer["costs"]["samples"] * answer["steps_per_sample"])

    def test_check_counts_preparation_contact_and_sound(self):
        falling = self.ask("check", program.SOURCE / "inputs/gallery/spanner.yaml", "--set", "time.duration=0.4")["costs"]
        self.assertGreater(falling["preparation_seconds"], 0.1)
        clatter = falling["contacts"]["clatter"]
        self.assertAlmostEqual(clatter["begin"], 0.1746, delta=1e-3)  # a fall of 15 cm
        steps = (0.4 - clatter["begin"]) * 44100 * 14
        self.assertTrue(0.01 * steps < clatter["steps"] < 0.05 * steps, clatter)  # steel bounces
        self.assertGreater(clatter["step_seconds"], 0)
        self.assertFalse(clatter["certain"])
        sound = falling["least_seconds"] - falling["preparation_seconds"] - falling["motion_seconds"]
        self.assertGreater(sound, falling["motion_seconds"])  # a modal body's surface and sound take longer than it
        self.assertGreater(falling["most_seconds"], falling["seconds"])
        self.assertGreater(falling["seconds"], falling["least_seconds"])
        self.assertIsNone(self.ask("check", program.deck("fork"))["costs"]["contacts"]["clack"])  # with itself
        lying = self.ask("check", program.deck("touching"))["costs"]["contacts"]
        self.assertTrue(all(contact["begin"] < 1e-3 for contact in lying.values()), lying)

    def test_check_plays_nothing_where_the_memory_does_not_suffice(self):
        command = "check", program.deck("struck"), "--set", "radiation={model: waves, cell: 0.01}", "-n", 2
        small = program.preload("SMALL_MACHINE", MACHINE_BYTES="1000000")
        exchanges = self.output / "exchanges.json"
        job = program.idiophone(*command, "--json", "--exchanges", exchanges, environment=small)
        self.require_status(job, program.FINISHED)
        self.assertIn("the run does not fit into this memory, so its first moments were not played", job.stderr)
        self.assertIn("and there are 1 MB: use more machines", job.stderr)
        answer = json.loads(job.stdout)
        costs = answer["costs"]
        self.assertEqual(costs["contacts"], {"strike": None})
        self.assertFalse(costs["played"])
        self.assertGreater(costs["least_seconds"], 0)
        for unknown in costs["seconds"], costs["most_seconds"], costs["contact_seconds"]:
            self.assertIsNone(unknown)
        waves, played = answer["prediction"]["waves"], self.ask(*command)["prediction"]["waves"]
        for of_the_grid in "cells", "neighbours", "halo_bytes", "memory_bytes":
            self.assertGreater(waves[of_the_grid], 0)
            self.assertEqual(waves[of_the_grid], played[of_the_grid])
        for time in "step_seconds", "waiting_seconds", "speed_up":
            self.assertIsNone(waves[time])
            self.assertGreaterEqual(played[time], 0)
        self.assertIsNone(json.loads(exchanges.read_text())["waves"])
        told = program.idiophone(*command, environment=small).stdout
        for said in "the time of their steps is not known", "more than", f"waves: at most {waves['cells']:.0f} cells", \
                    "contact strike: its time is not counted: the run does not fit into this memory":
            self.assertIn(said, told)

    def test_a_prediction_is_what_a_run_has(self):
        deck = program.deck("rich")
        for ranks in program.OTHER_RANKS:
            self.require_status(program.run("rich", self.output, "--set", "time.duration=0.001", ranks=ranks),
                                program.FINISHED)
            job, = self.ask("info", self.output / "rich.h5")["run"]["jobs"]
            predicted = self.ask("check", deck, "-n", ranks)["prediction"]
            self.assertEqual(predicted["largest_part"], job["largest_part"])
            self.assertGreater(predicted["largest_part"]["ghost_nodes"], 0)
            self.assertEqual(predicted["largest_part"]["neighbours"], ranks - 1)
            for memory in () if program.SANITIZED else ("memory_bytes", "root_memory_bytes"):
                self.assertAlmostEqual(predicted[memory] / job[memory], 1, delta=0.1, msg=memory)

    def test_a_prediction_of_waves_divides_the_grid(self):
        waves = [word for setting in ("radiation={model: waves, cell: 0.03}", "time.duration=0.001")
                 for word in ("--set", setting)]
        predicted = self.ask("check", program.deck("simple"), *waves, "-n", 2)["prediction"]["waves"]
        self.assertEqual(predicted["neighbours"], 1)
        self.assertGreater(predicted["halo_bytes"], 0)
        self.assertTrue(1 < predicted["speed_up"] <= 2, predicted)
        self.assertIsNone(self.ask("check", program.deck("simple"), "-n", 2)["prediction"]["waves"])

    def test_a_predicted_speed_up_depends_on_the_network(self):
        def speed_up(*arguments):
            return self.ask("check", program.deck("simple"), "-n", 4, *arguments)["prediction"]["speed_up"]
        ideal = speed_up("--latency", 0, "--bandwidth", 1e15)
        self.assertTrue(1 < ideal < 4, ideal)
        self.assertLess(speed_up("--latency", 1e-3), 0.5 * ideal)
        self.assertLess(speed_up("--bandwidth", 1e5), 0.5 * ideal)
        processors = len(os.sched_getaffinity(0))
        for ranks, latency in ((processors, 4e-7), (processors + 1, 2e-6)):
            answer = self.ask("check", program.deck("simple"), "-n", ranks)
            self.assertEqual(answer["prediction"]["latency"], latency)
        job = program.idiophone("check", program.deck("simple"), "-n", 2, ranks=2)
        self.require_status(job, program.FAILED)
        self.assertIn("start it without mpirun", job.stderr)
        job = program.idiophone("check", program.deck("simple"), "-n", 100000)
        self.require_status(job, program.FAILED)
        self.assertIn("100000 ranks are too many", job.stderr)

    def test_modes_and_partials(self):
        modes = self.ask("modes", program.deck("simple"), "--output-folder", self.output, "--modes", 3, "--references", "1,2")
        self.assertEqual(len(modes["modes"]), 3)
        self.assertIsNone(modes["modes"][0]["cents"]["references"])
        self.require_status(program.run("simple", self.output), program.FINISHED)
        answer = self.ask("analyze", self.output / "simple.h5", "--start", 0)
        for channel in answer["channels"]:
            self.assertTrue(all(partial["frequency"] > 0 for partial in channel["partials"]))
            levels = channel["levels"]
            sum_of_bands = 10 * math.log10(sum(10 ** (0.1 * band["level"]) for band in levels["third_octaves"]))
            self.assertLess(sum_of_bands, levels["equivalent"] + 0.01)
            self.assertGreater(levels["peak"], levels["equivalent"])
            self.assertAlmostEqual(levels["loudness"]["true_peak"], 0, delta=1.5)  # the largest sample is full scale
        self.assertTrue(answer["channels"])

    def test_levels_of_the_reference_sine(self):
        sine = self.output / "sine.wav"
        samples = (10 ** (-23 / 20) * 32767 * numpy.sin(2 * numpy.pi * 1000 * numpy.arange(48000) / 48000)).round()
        with wave.open(str(sine), "wb") as file:
            file.setparams((2, 2, 48000, 0, "NONE", ""))
            file.writeframes(numpy.repeat(samples.astype("<i2"), 2).tobytes())
        for channel in self.ask("analyze", sine)["channels"]:
            levels = channel["levels"]
            self.assertEqual(levels["reference"], "full scale")
            self.assertAlmostEqual(levels["loudness"]["integrated"], -23, delta=0.1)
            self.assertAlmostEqual(levels["equivalent"], -26.01, places=2)
            self.assertAlmostEqual(levels["weighted"], -26.01, delta=0.05)
        told = program.idiophone("analyze", sine, "--levels").stdout
        self.assertRegex(told, r"LAeq +-26\.0 dB +-26\.0 dB")
        self.assertIn("loudness -23.0 LUFS", told)
        self.assertNotIn("LAeq", program.idiophone("analyze", sine).stdout)


if __name__ == "__main__":
    unittest.main()
