#!/usr/bin/env python3
"""Fault injection finds each way in which fake_program.py writes its report wrong, and nothing in the right way."""
import contextlib
import io
import pathlib
import random
import shutil
import sys
import unittest
import unittest.mock

import fake_program
import inject

FAKE = pathlib.Path(fake_program.__file__).resolve()


def complaints(way):
    """What is said of a program that writes in this way."""
    trial = inject.Trial([sys.executable, "-S", "-E", str(FAKE), way], "report")
    try:
        with contextlib.redirect_stdout(io.StringIO()):
            trial.try_all(1, random.Random(1))
    finally:
        shutil.rmtree(trial.folder)
    return trial.faults


class Injected(unittest.TestCase):
    def assert_said(self, way, fault, words):
        said = complaints(way)
        self.assertTrue(any(fault in line and words in line for line in said), said)

    def test_a_careful_program_is_not_blamed(self):
        self.assertEqual(complaints("careful"), [])

    def test_a_report_written_in_place_is_not_whole(self):
        self.assert_said("in_place", "write:error=ENOSPC", "what it leaves is not whole")

    def test_a_write_whose_failure_is_ignored(self):
        self.assert_said("deaf", "write:error=ENOSPC", "what it leaves is not whole; status 0")

    def test_success_is_claimed_and_the_old_file_stays(self):
        self.assert_said("idle", "write:error=ENOSPC", "not done, and the status says that it is")

    def test_a_temporary_file_that_stays(self):
        self.assert_said("untidy", "rename:error=EIO", "left ['report.html.")
        self.assert_said("untidy", "rename:signal=KILL", "the next run ends with 0 and leaves ['report.html.")

    def test_a_failure_without_a_word(self):
        self.assert_said("mute", "rename:error=EIO", "no word of it")

    def test_a_signal(self):
        self.assert_said("signalled", "fsync:error=EIO", "not a documented status")


    def test_an_end_that_never_comes(self):
        with unittest.mock.patch.object(inject, "PATIENCE_SECONDS", 5):
            self.assert_said("endless", "rename:error=EIO", "it does not end")


class Places(unittest.TestCase):
    def test_few_are_all_tried(self):
        self.assertEqual(list(inject.places(3, 63, 40, random.Random(1))), list(range(4, 64)))

    def test_of_many_one_in_so_many_is_drawn(self):
        drawn = inject.places(10, 410, 40, random.Random(1))
        self.assertEqual(len(set(drawn)), 10)
        self.assertTrue(all(10 < place <= 410 for place in drawn))

    def test_another_seed_draws_others_and_the_same_seed_the_same(self):
        def draw(seed):
            return inject.places(0, 4000, 40, random.Random(seed))
        self.assertNotEqual(draw(1), draw(2))
        self.assertEqual(draw(1), draw(1))


if __name__ == "__main__":
    unittest.main()
