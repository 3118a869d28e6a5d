"""Ctrl-C from outside: long work ends with exit code 130 and with what is known by then, marked."""
import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from program import MODELS, PROGRAM, Program

SPRINGS, GEOS = MODELS / "three_springs.toml", MODELS / "geos.toml"


class Interrupts(Program):
    def interrupted(self, *arguments, how=signal.SIGINT):
        """What is written; asked later again where nothing was known yet."""
        for after in (0.7, 2, 6):
            out = self.stopped(arguments, after, how)
            if out or "-o" in arguments:
                return out
        self.fail("nothing was written")

    def stopped(self, arguments, after, how):
        process = subprocess.Popen([str(PROGRAM), *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        time.sleep(after)
        self.assertIsNone(process.poll(), "done before it could be interrupted")
        process.send_signal(how)
        out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130, err)
        self.assertIn("interrupted", err)
        return out

    def document(self, *arguments):
        document = json.loads(self.interrupted(*arguments, "--format", "json"))
        self.assertIs(document["interrupted"], True)
        return document

    def test_modes_of_booms_below_the_place_of_stopping(self):
        r = self.document("modes", GEOS, "--lowest", 19000)
        self.assertEqual(r["coverage"]["status"], "incomplete")
        self.assertIn("interrupted", r["coverage"]["reason"])
        self.assertGreater(len(r["modes"]), 10)
        # All modes below that place: the count there agrees.
        end = r["coverage"]["window"][1]
        self.assertEqual(self.json("count", GEOS, "--below", end)["count"], len(r["modes"]))

    def test_maps(self):
        r = self.document("stability", SPRINGS, "--vary", "spin=0:12000rpm:100000")
        self.assertEqual(len(r["map"]), 100000)
        self.assertEqual(r["map"][0]["stability"], "stable")
        self.assertEqual(r["map"][-1]["reason"], "interrupted")
        self.assertEqual(r["stability"], "unstable" if self.json("stability", SPRINGS)["stability"] == "unstable" else r["stability"])

    def test_motion_over_time_and_over_frequency(self):
        r = self.document("response", SPRINGS, "--force", "impulse:y=1", "--until", 4000, "--step", 0.001)
        self.assertGreater(len(r["t"]), 10)
        self.assertLess(r["t"][-1], 4000)
        r = self.document("response", SPRINGS, "--force", "x=1", "--frequencies", "10Hz:200Hz:1000000")
        self.assertGreater(len(r["points"]), 10)
        self.assertLess(len(r["points"]), 1000000)

    def test_the_file_is_written_and_a_term_signal_counts_as_well(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "modes.json"
            self.interrupted("modes", GEOS, "--lowest", 19000, "-o", file, how=signal.SIGTERM)
            self.assertTrue(json.loads(file.read_text())["interrupted"])

    def test_too_many_modes_at_a_time_are_refused_at_once(self):
        self.refused(2, ["100000 modes", "20000", "windows"], "modes", GEOS, "--lowest", 100000)
        self.refused(2, ["the window holds", "20000", "narrower"], "modes", GEOS, "--below", 100000)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=0)
