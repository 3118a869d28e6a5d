"""The program from outside, for the tests of this folder: PROGRAM and SOURCE are their two arguments."""
import json
import pathlib
import subprocess
import sys
import unittest

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
SOURCE = pathlib.Path(sys.argv[2]).resolve()
MODELS = SOURCE / "models"


def run(*arguments, cwd=None):
    return subprocess.run([str(PROGRAM), *map(str, arguments)], capture_output=True, text=True, cwd=cwd, timeout=120)


class Program(unittest.TestCase):
    def refused(self, code, expected, *arguments):
        """The exit code, and one line of message that holds the expected words."""
        result = run(*arguments)
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        for word in expected:
            self.assertIn(word, result.stderr)

    def json(self, *arguments):
        result = run(*arguments, "--format", "json")
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout)
