"""Long work tells where it is: one line that is rewritten on a terminal, a line every five seconds elsewhere, stages with --verbose, nothing with --quiet."""
import os
import pty
import re
import subprocess
import sys
import unittest

from program import MODELS, PROGRAM, Program

LONG = ["stability", MODELS / "three_springs.toml", "--vary", "spin=0:12000rpm:100000", "-o", os.devnull, "--format", "csv"]


class Progress(Program):
    def on_a_terminal(self, *arguments):
        ours, theirs = pty.openpty()
        process = subprocess.Popen([str(PROGRAM), *map(str, arguments)], stdout=subprocess.DEVNULL, stderr=theirs)
        os.close(theirs)
        text = b""
        while True:
            try:
                piece = os.read(ours, 65536)
            except OSError:  # the other end is closed
                break
            if not piece:
                break
            text += piece
        self.assertEqual(process.wait(timeout=60), 0)
        os.close(ours)
        return text.decode()

    def test_terminal(self):
        text = self.on_a_terminal(*LONG)
        lines = text.split("\r\x1b[K")
        told = [line for line in lines if "cells" in line]
        self.assertTrue(any(re.fullmatch(r"gyromode: cells: \d+ of 100000 \(\d+ %\), about \d+ s left", line) for line in told), text)
        self.assertNotIn("\n", text)
        self.assertEqual(lines[-1], "")  # taken away in the end
        self.assertTrue(all(len(line) < 80 for line in lines))

    def test_short_work_says_nothing(self):
        self.assertEqual(self.on_a_terminal("modes", MODELS / "geos.toml"), "")

    def test_quiet(self):
        self.assertEqual(self.on_a_terminal(*LONG, "--quiet"), "")

    def test_verbose(self):
        err = subprocess.run([PROGRAM, "modes", MODELS / "wiresaw.toml", "--verbose"], capture_output=True, text=True, timeout=60).stderr
        for words in ("10 coordinates read in", "index balance closed: n₋(K) = 0", "found 10, counted 10", "largest residual", "counts at the ends of the window: "):
            self.assertIn(words, err)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=0)
