#!/usr/bin/python3
"""A program on a processor that lacks its instructions says so, and one for a newer processor is started where it can run."""
import os
import pathlib
import shutil
import subprocess
import unittest

import program

HAS_AVX512 = " avx512vl " in pathlib.Path("/proc/cpuinfo").read_text()


class InstructionSet(program.TestCase):
    @unittest.skipIf(program.SANITIZED, "valgrind can't run sanitizers")
    def test_missing_instructions_are_named(self):
        """The processor that valgrind shows to programs has AVX2, but not AVX-512."""
        job = subprocess.run(["valgrind", "--tool=none", program.PROGRAM, "--version"], capture_output=True, text=True,
                             timeout=program.TIMEOUT)
        if job.returncode == program.FAILED:
            self.assertIn("instructions that this one lacks: avx512f", job.stderr)
        else:
            self.require_status(job, program.FINISHED)
            self.assertRegex(job.stdout, r"\d+\.\d+\.\d+")

    @unittest.skipUnless(HAS_AVX512, "needs a processor with AVX-512")
    def test_a_program_for_a_newer_processor_is_started(self):
        installed = self.output / "bin/idiophone"
        faster = self.output / "libexec/idiophone/x86-64-v4/idiophone"
        installed.parent.mkdir()
        faster.parent.mkdir(parents=True)
        shutil.copy(program.PROGRAM, installed)
        faster.write_text('#!/bin/sh\necho "for a newer processor: $@"\n')
        faster.chmod(0o755)
        for chosen, said in ((None, "for a newer processor: --version"), ("x86-64-v4", "for a newer processor: --version"),
                             ("x86-64-v3", "0.")):
            environment = dict(os.environ) | ({"IDIOPHONE_INSTRUCTION_SET": chosen} if chosen else {})
            job = subprocess.run([installed, "--version"], capture_output=True, text=True, env=environment)
            self.require_status(job, program.FINISHED)
            self.assertTrue(job.stdout.startswith(said), job.stdout)


if __name__ == "__main__":
    unittest.main()
