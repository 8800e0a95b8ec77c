# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the time goes while a control point is dragged, measured in Blender's window.

blender --python live_benchmark.py -- [--points N] [--moves N] [--samples N] [--no-lines]
        [--no-combs] [--drag one|all|weight] [--draw-every N] [--ghost] [--profile]

A half hull, that of native/benchmarks/half_hull.h, is in edit mode; points are moved by random
steps of a fixed seed, as a transform moves them: the edit mesh changes, Blender evaluates, the
add-on's handlers run, and the window is drawn. With `--drag weight` it is a morph of this hull and
a longer, higher one in object mode, whose slider is moved. Own time is the processor's from the
change to all results in place, on the graphics card too, without Blender's own; so is what the
add-on draws in each frame, where a graphics card does most of what the processor does here. With
`taskset -c 0` before it, all of it is on one processor.
"""

import argparse
import cProfile
import functools
import math
import os
import pstats
import random
import sys
import time
import traceback
from collections import defaultdict
from pathlib import Path

import bmesh
import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))
from enabled_addon import part  # noqa: E402

SEED = 7
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
DRAWN = ("lines", "ghost", "marks", "tags", "legend", "spots", "morph_pairs", "status")
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


def half_hull(stations, girth):
    """(points, faces, creases) of native/benchmarks/half_hull.h with so many spaces each way."""
    points, faces, creases = [], [], []
    for i in range(stations + 1):
        fullness = max(math.sin(3.14159265 * (0.12 + 0.88 * i / stations)), 0.0) ** 0.45
        for j in range(girth + 1):
            t = j / girth
            y = 9.0 * fullness * math.sin(0.5 * math.pi * t) ** 0.6 if j else 0.0
            points.append((100.0 * i / stations, y, 10.0 * t * t))

    def at(i, j):
        return i * (girth + 1) + j

    for i in range(stations):
        for j in range(girth):
            a, b, c, d = at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)
            if (i + 2 * j) % 12 == 5:
                faces += [(a, b, c), (a, c, d)]
            else:
                faces.append((a, b, c, d))
    knuckle = 6 * girth // 9
    creases += [(at(i, knuckle), at(i + 1, knuckle)) for i in range(stations // 2, stations)]
    return points, faces, creases


def make_hull(options):
    """The half hull of about so many points, with all that follows it switched on; in edit mode, or
    as a morph in object mode."""
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)
    girth = max(9, round(math.sqrt(0.65 * options.points)) - 1)
    stations = max(13, round(options.points / (girth + 1)) - 1)
    points, faces, creases = half_hull(stations, girth)
    mesh = bpy.data.meshes.new("benchmark")
    mesh.from_pydata(points, [], faces)
    part("bridge.mesh.mesh_arrays").write_tags(mesh, creases, [])
    hull = bpy.data.objects.new("benchmark", mesh)
    bpy.context.scene.collection.objects.link(hull)
    bpy.context.view_layer.objects.active = hull
    hull.select_set(True)
    bpy.ops.hull.make_hull(half=True)
    if options.drag == "weight":
        hull = _morph_of(hull)
    settings = hull.hull
    settings.samples = options.samples
    settings.length_pp, settings.draft, settings.beam = 100.0, 6.0, 18.0
    _switch_lines(settings, not options.no_lines, not options.no_combs)
    settings.plots.sectional_areas = not (options.no_lines or options.no_combs)
    if options.ghost:
        _show_ghost(settings)
    bpy.context.view_layer.update()
    if options.drag != "weight":
        bpy.ops.object.mode_set(mode="EDIT")
    return hull


def _morph_of(hull):
    """A morph of a hull and a longer, higher one, both of which are hidden then."""
    other = hull.copy()
    other.data = hull.data.copy()
    for vertex in other.data.vertices:
        vertex.co.x *= 1.2
        vertex.co.z *= 1.1
    bpy.context.scene.collection.objects.link(other)
    other.hull.length_pp = 120.0
    bpy.context.view_layer.update()
    hull.select_set(True)
    other.select_set(True)
    bpy.ops.hull.make_morph()
    for parent in (hull, other):
        parent.hide_set(True)
    return bpy.context.view_layer.objects.active


def _show_ghost(settings):
    """Of the hull as it is, behind the one that changes."""
    bpy.ops.hull.keep_variant(name="before")
    settings.variants.show_ghost = True


def _switch_lines(settings, on, with_combs):
    lines, fairness = settings.lines, settings.fairness
    lines.station_count = 20
    lines.waterlines = "0.75:9.75:0.9"
    lines.buttocks = "1:7:1"
    for name in ("stations", "waterlines", "buttocks", "design_waterline", "flats", "features"):
        setattr(lines, f"show_{name}", on)
    for name in ("stations", "waterlines", "buttocks"):
        setattr(fairness, f"comb_{name}", on and with_combs)


class Benchmark:
    def __init__(self, options):
        self.options = options
        self.hull = make_hull(options)
        self.clock = Clock()
        self.random = random.Random(SEED)
        self.profile = cProfile.Profile()
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
        for name in DRAWN:
            handler = part(f"overlays.{name}")._handler
            handler.unregister()
            handler._draw = self.clock.timed(self._profiled(handler._draw), f"drawing {name}")
            handler.register()
        plots = part("overlays.plots")
        plots.unregister()
        plots._draw = self.clock.timed(self._profiled(plots._draw), "drawing plots")
        plots.register()

    def _profiled(self, function):
        if not self.options.profile:
            return function
        return lambda *arguments: self.profile.runcall(function, *arguments)

    def move(self, is_drawn):
        """One step of a drag; processor seconds by label."""
        self.clock.spent.clear()
        if self.options.drag == "weight":
            self._move_weight()
        else:
            self._move_points()
        spent = {"Blender's update": self._others(bpy.context.view_layer.update)}
        if is_drawn:
            spent["Blender's drawing"] = self._others(self._draw)
        return {**spent, **self.clock.spent}

    def _move_weight(self):
        weight = self.random.uniform(-0.2, 1.2)
        slide = self.clock.timed(self._profiled(self._slide), "other weights")
        slide(weight)

    def _slide(self, weight):
        self.hull.hull.morph.parents[0].weight = weight

    def _move_points(self):
        bm = bmesh.from_edit_mesh(self.hull.data)
        bm.verts.ensure_lookup_table()
        is_one = self.options.drag == "one"
        for index in [self.random.randrange(len(bm.verts))] if is_one else range(len(bm.verts)):
            vertex = bm.verts[index]
            vertex.co.x += self.random.uniform(-0.02, 0.02)
            if vertex.co.y > 0.1:
                vertex.co.y += self.random.uniform(-0.02, 0.02)
        bmesh.update_edit_mesh(self.hull.data, loop_triangles=False, destructive=False)

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
            self.move(index % 5 == 4)
        self.profile.clear()
        every = self.options.draw_every
        moves = [self.move(every and i % every == 0) for i in range(self.options.moves)]
        self.report(moves)

    def report(self, moves):
        state = part("features.hull.hull_state").state_of(self.hull)
        if state.status or state.hydrostatics.values is None:
            raise RuntimeError(f"no results: {state.status} {state.hydrostatics.status}")
        shown = self.hull.hull.surface_object.data
        counts = ", ".join(
            f"{len(one.sections)} {name}" for name, one in state.lines.groups.items()
        )
        print(
            f"\n{len(state.ship.source.control.points)} control points of which "
            f"{'one moves' if self.options.drag == 'one' else 'all move'}, "
            f"{len(shown.vertices)} surface points\nlines: {counts or 'off'}\n\n"
            f"{'milliseconds of processor time':<34}{'median':>9}{'90 %':>9}"
        )
        labels = sorted({label for move in moves for label in move}, key=self._order)
        for label in labels:
            if label not in NOT_OURS:
                _print_line(label, [move[label] for move in moves if label in move])
        drawn = [move for move in moves if "Blender's drawing" in move]
        _print_line("OWN TIME", [_own(move, is_drawing=False) for move in drawn or moves])
        _print_line("of each frame", [_own(move, is_drawing=True) for move in drawn])
        for label in NOT_OURS:
            _print_line(label, [move[label] for move in moves if label in move])
        if self.options.profile:
            pstats.Stats(self.profile).sort_stats("tottime").print_stats(40)

    @staticmethod
    def _order(label):
        known = [step[2] for step in STEPS]
        return known.index(label) if label in known else len(known), label


def _own(move, is_drawing):
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
    parser.add_argument("--drag", choices=("one", "all", "weight"), default="one")
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
