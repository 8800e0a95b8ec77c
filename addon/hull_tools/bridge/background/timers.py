# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's timers. In the background nobody pauses, and none runs."""

import sys
import traceback

import bpy


class Timer:
    """Calls a function some seconds after it was asked to, and as often again as that returns True,
    until it is stopped. An error ends it, so that what asks next starts it anew; but where it
    `looks` for what others have done, it goes on, and the same error is told once."""

    def __init__(self, seconds, function, looks=False):
        self._seconds, self._function, self._looks = seconds, function, looks
        self._told = ""
        self._call = self._called  # the very object that Blender knows it by

    def _called(self):
        try:
            return self._seconds if self._function() else None
        except Exception:
            if not self._looks:
                raise
            text = traceback.format_exc()
            if text != self._told:
                print(text, file=sys.stderr)
                self._told = text
            return self._seconds

    def is_running(self):
        return bpy.app.timers.is_registered(self._call)

    def start(self):
        """Goes on where it is running."""
        if not bpy.app.background and not self.is_running():
            bpy.app.timers.register(self._call, first_interval=self._seconds)

    def put_off(self):
        """Begins anew: what is asked for again and again waits for a pause."""
        self.stop()
        self.start()

    def stop(self):
        if self.is_running():
            bpy.app.timers.unregister(self._call)
