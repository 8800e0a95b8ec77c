# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the time goes while a control point is dragged, measured in Blender's window.

blender --python live_benchmark.py -- [--points N] [--moves N] [--samples N] [--no-lines]
        [--no-combs] [--drag one|all|fields|weight] [--draw-every N] [--ghost] [--profile]

A half hull is in edit mode; points are moved by random steps, as a transform moves them: the edit
mesh changes, Blender evaluates, the add-on's handlers run, and the window is drawn. With `--drag
fields` it is previewed with three shape fields, and their settings change; with `--drag weight` it
is a morph of this hull and a longer, higher one, whose slider is moved. Own time is the
processor's from the change to all results in place, on the graphics card too, without Blender's
own; so is what the add-on draws in each frame, where a graphics card does most of what the
processor does here. With `taskset -c 0` before it, all of it is on one processor.
"""

import argparse
import cProfile
import functools
import os
import pstats
import sys
import time
import traceback
from collections import defaultdict
from pathlib import Path

import bpy
import numpy as np

# Blender runs a file without its folder on the path.
sys.path[:0] = [str(Path(__file__).resolve().parent)]
import live_changes  # noqa: E402
import live_hull  # noqa: E402
from enabled_addon import part  # noqa: E402

WARM_UP = 10
# Functions and methods whose time is told apart: (module, name, what for). Those that call one
# another count without what they call.
STEPS = (
    ("features.morphing.members", "member_points", "member of the family, folds"),
    ("features.morphing.members", "write", "control points, drafts written"),
    ("features.morphing.members", "show", "member, the rest"),
    ("features.morphing.members", "follow", "member looked after"),
    ("bridge.mesh.mesh_arrays", "read_mesh", "control mesh read"),
    ("features.constraints.flat_keeping", "keep", "flats kept"),
    ("features.fields.prepared", "of_hull", "fields: hull prepared"),
    ("features.fields.shaping", "solve", "fields: solved"),
    ("features.fields.preview", "placed", "fields: preview, the rest"),
    ("features.fields.before", "follow", "fields: hull of before"),
    ("features.fields.seen", "follow", "fields: bases and lines"),
    ("features.flotation.live_ship", "LiveShip.follow", "surface and body moved"),
    ("features.surface.shown_surface", "ShownSurface.follow", "surface object computed"),
    ("features.surface.surface_mesh", "move_surface", "surface object written"),
    (
        "features.flotation.live_hydrostatics",
        "LiveHydrostatics.follow",
        "hydrostatics",
    ),
    ("features.lines.live_lines", "LiveLines.follow", "lines"),
    ("features.fairness.live_fairness", "LiveFairness.follow", "combs"),
    ("features.variants.ghosts", "Ghost.follow", "ghost"),
    ("features.analyses.live_analyses", "show_plots", "sectional areas, plots"),
    ("overlays.lines", "batch_of", "lines to the graphics card"),
    ("overlays.lines", "_comb_batches_of", "combs to the graphics card"),
)
# Modules of overlays and their handlers.
DRAWN = (
    ("lines", "_handler"),
    ("ghost", "_handler"),
    ("fields", "_lines"),
    ("fields", "_marks"),
    ("marks", "_handler"),
    ("tags", "_handler"),
    ("legend", "_handler"),
    ("spots", "_handler"),
    ("plots", "_handler"),
    ("morph_pairs", "_handler"),
    ("status", "_handler"),
)
NOT_OURS = ("Blender's update", "Blender's drawing")


class Clock:
    """Processor seconds by label, each without what is told apart within it."""

    def __init__(self):
        self.spent = defaultdict(float)
        self._inner = [0.0]

    def timed(self, function, label):
        @functools.wraps(function)
        def wrapper(*arguments, **named):
            begin = time.thread_time()
            self._inner.append(0.0)
            try:
                return function(*arguments, **named)
            finally:
                whole = time.thread_time() - begin
                self.spent[label] += whole - self._inner.pop()
                self._inner[-1] += whole

        return wrapper


class Benchmark:
    def __init__(self, options):
        self.options = options
        self.hull = live_hull.make_hull(options)
        self.clock = Clock()
        self.profile = cProfile.Profile()
        self.change = live_changes.changes(self.hull, options.drag)
        if options.drag in live_changes.OF_SETTINGS:  # which may be answered at once
            self.change = self.clock.timed(self._profiled(self.change), "settings changed")
        for module, name, label in STEPS:
            *owners, function = name.split(".")
            owner = functools.reduce(getattr, owners, part(module))
            setattr(owner, function, self.clock.timed(getattr(owner, function), label))
        self._time_handlers()
        self._time_drawing()

    def _time_handlers(self):
        handlers = bpy.app.handlers.depsgraph_update_post
        own = part("handlers").__name__
        for index, function in enumerate(handlers):
            if function.__module__.startswith(own):
                handlers[index] = self.clock.timed(self._profiled(function), "handlers, the rest")

    def _time_drawing(self):
        for name, attribute in DRAWN:
            handler = getattr(part(f"overlays.{name}"), attribute)
            handler.unregister()
            handler._draw = self.clock.timed(self._profiled(handler._draw), f"drawing {name}")
            handler.register()

    def _profiled(self, function):
        if not self.options.profile:
            return function
        return lambda *arguments: self.profile.runcall(function, *arguments)

    def step(self, number, is_drawn):
        """One change; (its kind, processor seconds by label)."""
        self.clock.spent.clear()
        kind = self.change(number)
        spent = {"Blender's update": self._others(bpy.context.view_layer.update)}
        if is_drawn:
            spent["Blender's drawing"] = self._others(self._draw)
        return kind, {**spent, **self.clock.spent}

    def _others(self, function):
        """Processor seconds that a function takes, without those of the add-on within it."""
        own = sum(self.clock.spent.values())
        begin = time.process_time()
        function()
        return time.process_time() - begin - (sum(self.clock.spent.values()) - own)

    @staticmethod
    def _draw():
        bpy.ops.wm.redraw_timer(type="DRAW_WIN", iterations=1)

    def run(self):
        for index in range(WARM_UP):
            self.step(index, index % 5 == 4)
        self.profile.clear()
        every = self.options.draw_every
        self.report([self.step(i, every and i % every == 0) for i in range(self.options.moves)])

    def report(self, steps):
        kinds, moves = zip(*steps)
        state = part("features.hull.hull_state").state_of(self.hull)
        if state.status or state.hydrostatics.values is None:
            raise RuntimeError(f"no results: {state.status} {state.hydrostatics.status}")
        shown = self.hull.hull.surface_object.data
        counts = ", ".join(
            f"{len(one.sections)} {name}" for name, one in state.lines.groups.items()
        )
        print(
            f"\n{len(state.ship.source.control.points)} control points, changed: "
            f"{', '.join(dict.fromkeys(kinds))}; {len(shown.vertices)} surface points\n"
            f"lines: {counts or 'off'}\n\n"
            f"{'milliseconds of processor time':<34}{'median':>9}{'90 %':>9}"
        )
        labels = sorted({label for move in moves for label in move}, key=self._order)
        for label in labels:
            if label not in NOT_OURS:
                _print_line(label, [move[label] for move in moves if label in move])
        drawn = [move for move in moves if "Blender's drawing" in move]
        for kind in dict.fromkeys(kinds):
            own = [_own(move) for one, move in steps if one == kind]
            _print_line(f"OWN TIME, {kind}", own)
        _print_line("of each frame", [_own(move, is_drawing=True) for move in drawn])
        for label in NOT_OURS:
            _print_line(label, [move[label] for move in moves if label in move])
        if self.options.profile:
            pstats.Stats(self.profile).sort_stats("tottime").print_stats(40)

    @staticmethod
    def _order(label):
        known = [step[2] for step in STEPS]
        return known.index(label) if label in known else len(known), label


def _own(move, is_drawing=False):
    return sum(
        seconds
        for label, seconds in move.items()
        if label not in NOT_OURS and label.startswith("drawing") == is_drawing
    )


def _print_line(label, seconds):
    if seconds:
        median, most = 1e3 * np.percentile(seconds, [50, 90])
        print(f"{label:<34}{median:>9.2f}{most:>9.2f}")


def parsed():
    parser = argparse.ArgumentParser(prog="live_benchmark.py")
    parser.add_argument("--points", type=int, default=140)
    parser.add_argument("--moves", type=int, default=200)
    parser.add_argument("--samples", type=int, default=16)
    parser.add_argument("--drag", choices=("one", "all", "fields", "weight"), default="one")
    parser.add_argument("--draw-every", type=int, default=1, help="moves; 0: never")
    parser.add_argument("--no-lines", action="store_true")
    parser.add_argument("--no-combs", action="store_true", help="and no plot: lines and numbers")
    parser.add_argument("--ghost", action="store_true", help="of the hull as it was")
    parser.add_argument("--profile", action="store_true")
    return parser.parse_args(sys.argv[sys.argv.index("--") + 1 :])


def main():
    result = 1
    try:
        Benchmark(parsed()).run()
        result = 0
    except Exception:  # Blender would go on, and wait for the user
        traceback.print_exc()
    sys.stdout.flush()
    os._exit(result)


bpy.context.preferences.view.show_splash = False
bpy.app.timers.register(main, first_interval=1.0)
