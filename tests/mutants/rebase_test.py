#!/usr/bin/env python3
"""A list of defects follows its texts through moves, formatting and new names, and else is left alone."""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
CLIP = """float left_of(Box box) {
    return box.middle - box.width / 2;
}

float right_of(Box box) {
    return box.middle + box.width / 2;
}
"""
SNAP = """int snapped(float place, int steps) {
    const float scaled = place * steps;
    return round_to_even(scaled);
}
"""
LIST = """# A list.

## places

the left side is the right one
name: left_is_right
file: rasterizer/clip.cpp
find: box.middle - box.width / 2
put:  box.middle + (box.width / 2)

places are cut off
name: cut_off
file: rasterizer/snap.cpp
find: return round_to_even(scaled);
put:  return int(scaled);
"""


class Rebase(unittest.TestCase):
    def setUp(self):
        self.root = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.list = self.root / "tests/mutants/catalogue.txt"
        self.list.parent.mkdir(parents=True)
        for name in ("score", "planting.py", "rebase.py", "trials.py"):
            shutil.copy(HERE / name, self.list.parent)
        self.write(self.list, LIST)
        self.write("rasterizer/clip.cpp", CLIP)
        self.write("rasterizer/snap.cpp", SNAP)
        self.git("init", "-q")
        self.git("add", ".")
        self.git("-c", "user.name=t", "-c", "user.email=t@t", "commit", "-q", "-m", "all")

    def git(self, *words):
        subprocess.run(["git", "-C", str(self.root), *words], check=True)

    def write(self, name, text):
        (self.root / name).parent.mkdir(parents=True, exist_ok=True)
        (self.root / name).write_text(text)

    def rebase(self, status):
        words = [sys.executable, str(self.list.parent / "score"), "--rebase"]
        done = subprocess.run(words, capture_output=True, text=True)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done.stdout

    def assert_list(self, *changes):
        """The list as it was but for these texts."""
        expected = LIST
        for before, now in changes:
            self.assertIn(before, expected)
            expected = expected.replace(before, now)
        self.assertEqual(self.list.read_text(), expected)

    def test_a_text_that_stays_is_left_alone(self):
        self.assertEqual(self.rebase(0), "")
        self.assert_list()

    def test_a_file_that_is_renamed_and_formatted_is_followed(self):
        self.git("mv", "rasterizer/clip.cpp", "rasterizer/sides.cpp")
        self.write("rasterizer/sides.cpp", CLIP.replace("- box.width / 2", "\n        - box.width/2"))
        self.assertIn("left_is_right: file: rasterizer/clip.cpp -> rasterizer/sides.cpp", self.rebase(0))
        self.assert_list(("rasterizer/clip.cpp", "rasterizer/sides.cpp"),
                         ("- box.width / 2", "- box.width/2"), ("(box.width / 2)", "(box.width/2)"))

    def test_a_function_that_moves_to_another_file_is_followed(self):
        self.write("rasterizer/clip.cpp", CLIP.split("\n\n")[1])
        self.write("rasterizer/snap.cpp", SNAP + "\n" + CLIP.split("\n\n")[0] + "\n")
        self.rebase(0)
        self.assert_list(("rasterizer/clip.cpp", "rasterizer/snap.cpp"))

    def test_names_that_change_are_followed_in_the_replacement_too(self):
        self.write("rasterizer/snap.cpp", SNAP.replace("scaled", "in_steps"))
        self.rebase(0)
        self.assert_list(("even(scaled)", "even(in_steps)"), ("int(scaled)", "int(in_steps)"))

    def test_two_places_that_are_as_likely_are_refused(self):
        (self.root / "rasterizer/clip.cpp").unlink()
        self.write("rasterizer/one.cpp", CLIP)
        self.write("rasterizer/two.cpp", CLIP)
        self.assertIn("rasterizer/one.cpp:2 and rasterizer/two.cpp:2 are as likely", self.rebase(3))
        self.assert_list()

    def test_a_text_whose_words_change_is_refused(self):
        self.write("rasterizer/snap.cpp", SNAP.replace("even(scaled)", "even(scaled + 1)"))
        self.assertIn("its words have changed: return round_to_even ( scaled + 1 ) ;", self.rebase(3))
        self.assert_list()

    def test_what_can_be_found_is_mended_beside_what_cannot(self):
        self.write("rasterizer/clip.cpp", "")
        self.write("rasterizer/snap.cpp", SNAP.replace("(scaled);", "( scaled );"))
        self.assertIn("left_is_right: undecided", self.rebase(3))
        self.assert_list(("even(scaled)", "even( scaled )"), ("int(scaled)", "int( scaled )"))


if __name__ == "__main__":
    unittest.main()
