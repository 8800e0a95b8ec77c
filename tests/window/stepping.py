# SPDX-License-Identifier: GPL-3.0-or-later
"""Steps a test through Blender's own loop.

A test is a generator function `test_...(window)`. It says what the person does by `window`, and
then:

    yield               what was said is done, one action at a time; Blender is at rest again
    yield condition     the same, and then until condition() is true

so that its next lines find what a person would see then. A test that is no generator ends at once.
"""

import inspect
import time
import traceback

# Between two calls of the timer Blender handles events and draws, once or several times.
_INTERVAL = 0.01
# Calls without anything to do before the test goes on: redraws may come one after the other.
_RESTS = 3
# Longer than any condition takes on a slow machine that does much else; fits are the longest.
_PATIENCE_SECONDS = 240.0
# Of a variable in the report of a failure, in letters.
_LONGEST_VALUE = 300


class Stepper:
    """Runs one test; `step` is to be called by a timer until it returns None."""

    def __init__(self, test, window):
        self._test, self._window = test, window
        self._generator = None
        self._is_met = None
        self._deadline = 0.0
        self._rests = 0
        self.report = None  # once ended: "" or why it failed

    def step(self):
        """The seconds until it is to be called again, None when the test has ended."""
        try:
            self._advance()
        except StopIteration:
            self.report = ""
        except Exception as error:  # whatever a test raises is its failure
            self.report = _report_of(error)
        return _INTERVAL if self.report is None else None

    def _advance(self):
        if self._generator is None:
            self._generator = self._test(self._window)
            if not inspect.isgenerator(self._generator):
                raise StopIteration
        if self._window.actions:
            self._rests = 0
            self._window.actions.pop(0)()
        elif self._rests < _RESTS:
            self._rests += 1
        elif self._is_met is None or self._is_met():
            self._is_met = next(self._generator)
            self._deadline = time.monotonic() + _PATIENCE_SECONDS
            self._rests = 0
        elif time.monotonic() > self._deadline:
            self._generator.throw(TimeoutError("what the test waits for does not come about"))


def _report_of(error):
    """The traceback within the test, with its variables: an assert says no values by itself."""
    report = traceback.TracebackException.from_exception(error, capture_locals=True)
    own = [frame for frame in report.stack if not frame.filename.endswith("stepping.py")]
    report.stack = traceback.StackSummary.from_list(own or report.stack)
    for frame in report.stack:
        frame.locals = {name: _shortened(value) for name, value in (frame.locals or {}).items()}
    return "".join(report.format())


def _shortened(text):
    return text if len(text) <= _LONGEST_VALUE else f"{text[:_LONGEST_VALUE]} …"
