# SPDX-License-Identifier: GPL-3.0-or-later
"""Run the tests of this folder inside Blender, on the installed add-on.

blender --background --python-exit-code 1 --python run_tests.py [-- PYTEST ARGUMENT...]

Blender's exit code is not zero when a test failed, or when none passed.
"""

import sys
from pathlib import Path

import pytest


class PassedCount:
    """Counts the tests that ran and passed: a run of skipped tests has shown nothing."""

    def __init__(self):
        self.passed = 0

    def pytest_runtest_logreport(self, report):
        self.passed += report.when == "call" and report.passed


def main():
    own = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
    folder = Path(__file__).resolve().parent
    count = PassedCount()
    options = ["--rootdir", str(folder), "-p", "no:cacheprovider", "-r", "fEs", "--durations", "12"]
    status = pytest.main([*options, *(own or [str(folder)])], plugins=[count])
    if status == 0 and count.passed == 0:
        print("no test passed")
        status = 5
    # Blender stays quiet about its own end: what pytest printed must be out before.
    sys.stdout.flush()
    sys.exit(int(status))


main()
