#!/usr/bin/python3
"""tools/detail_over_cost: what a budget loses, with two bodies."""

import pathlib
import subprocess
import tempfile
import unittest

import program
import yaml


class DetailOverCost(unittest.TestCase):
    def measure(self, folder, *options):
        subprocess.run([program.SOURCE / "tools/detail_over_cost", "--program", program.PROGRAM, "--folder", folder, *options],
                       check=True, capture_output=True)

    def test_bodies_take_turns(self):
        with tempfile.TemporaryDirectory() as folder:
            self.measure(folder, "--bodies", "6", "--sounding", "2", "--budgets", "10")
            events = yaml.safe_load((pathlib.Path(folder) / "score.yaml").read_text())["events"]
        begins, ends = {}, {}
        for event in events:
            if "speed" in event:
                begins.setdefault(event["body"], event["time"])
            elif "friction" in event:
                ends[event["body"]] = event["time"]
        for step in range(100):
            time = 0.05 + 0.1 * step
            self.assertEqual(sum(begin <= time < ends.get(body, 10.0) for body, begin in begins.items()), 2, time)

    def test_small_budgets_lose_more_and_large_ones_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            self.measure(folder, "--bodies", "2", "--budgets", "0.0001", "10")
            rows = [line.strip("| \n").split(" | ") for line in (pathlib.Path(folder) / "detail.md").read_text().splitlines()]
            self.assertTrue((pathlib.Path(folder) / "detail_over_cost.png").stat().st_size > 1000)
        errors = [(float(row[1]), float(row[3])) for row in rows[3:]]
        self.assertEqual(len(errors), 10)  # five ways to choose, two budgets
        for budget, error in errors:
            if budget > 1:
                self.assertLess(error, -100)
            else:
                self.assertGreater(error, -20)


if __name__ == "__main__":
    unittest.main()
