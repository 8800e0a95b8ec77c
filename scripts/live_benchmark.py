# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the time goes when a control point is dragged, measured in Blender's window.

blender --enable-event-simulate --python live_benchmark.py -- [--points N] [--moves N] [--samples N]
        [--no-lines] [--profile]

A half hull of 140 points or more is edited; points are moved by random steps (of a fixed seed) as a
transform moves them: the edit mesh changes, Blender evaluates, handlers run, the window is drawn.
Own time is that of the add-on's handlers and of its drawing, without Blender's own. The processor
should be one: run it below `taskset -c 0`.
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

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import bmesh  # noqa: E402
import bpy
import numpy as np
from enabled_addon import part

SEED = 7
WARM_UP = 5
# Functions whose time is told apart: (module, name, what for). Those that call one another count
# without what they call.
STEPS = (
    ("handlers.follow", "after_update", "handler, the rest"),
    ("bridge.mesh_arrays", "read_mesh", "control mesh read"),
    ("bridge.hull_state", "_update_ship", "surface and body moved"),
    ("bridge.hull_state", "_show_surface", "surface object"),
    ("bridge.surface_object", "move_surface", "surface object written"),
    ("bridge.hull_state", "_update_hydrostatics", "hydrostatics"),
    ("bridge.hull_state", "_update_lines", "lines"),
    ("bridge.hull_state", "_update_fairness", "combs"),
    ("bridge.live_analyses", "show_plots", "plots"),
)


class Clock:
    """Seconds by label, each without what is told apart within it."""

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
    """(points, faces, creases) of the hull of native/benchmarks/half_hull.h."""
    points, faces, creases = [], [], []
    for i in range(stations + 1):
        fullness = math.sin(math.pi * (0.12 + 0.88 * i / stations)) ** 0.45 if i < stations else 0.0
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
    for i in range(stations // 2, stations):
        creases.append((at(i, knuckle), at(i + 1, knuckle)))
    return points, faces, creases


def make_hull(points, options):
    """The half hull of about so many points, with all that follows it switched on; in edit mode."""
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)
    girth = max(9, round(math.sqrt(points * 0.7)) - 1)
    stations = max(13, round(points / (girth + 1)) - 1)
    corners, faces, creases = half_hull(stations, girth)
    mesh = bpy.data.meshes.new("benchmark")
    mesh.from_pydata(corners, [], faces)
    mesh.update()
    part("bridge.mesh_arrays").write_tags(mesh, creases, [])
    hull = bpy.data.objects.new("benchmark", mesh)
    bpy.context.scene.collection.objects.link(hull)
    bpy.context.view_layer.objects.active = hull
    hull.select_set(True)
    bpy.ops.hull.make_hull(half=True)
    settings = hull.hull
    settings.samples = options.samples
    settings.length_pp, settings.draft, settings.beam = 100.0, 6.0, 18.0
    _switch_lines(settings, not options.no_lines)
    settings.plots.sectional_areas = not options.no_lines
    bpy.context.view_layer.update()
    bpy.ops.object.mode_set(mode="EDIT")
    return hull


def _switch_lines(settings, on):
    lines, fairness = settings.lines, settings.fairness
    lines.station_count = 20
    lines.waterlines = "0.75:9.75:0.9"
    lines.buttocks = "1:7:1"
    for name in ("stations", "waterlines", "buttocks", "design_waterline", "flats", "features"):
        setattr(lines, f"show_{name}", on)
    for name in ("stations", "waterlines", "buttocks"):
        setattr(fairness, f"comb_{name}", on)


class Benchmark:
    def __init__(self, options):
        self.options = options
        self.hull = make_hull(options.points, options)
        self.clock = Clock()
        self.random = random.Random(SEED)
        self.profile = cProfile.Profile() if options.profile else None
        self.moves = []
        self._time_steps()

    def _time_steps(self):
        for module, name, label in STEPS:
            module = part(module)
            function = getattr(module, name)
            timed = self.clock.timed(function, label)
            setattr(module, name, timed)
            if name == "after_update":
                handlers = bpy.app.handlers.depsgraph_update_post
                handlers.remove(function)
                handlers.append(self._profiled(timed))
        for overlay in part("overlays").DRAWN if hasattr(part("overlays"), "DRAWN") else ():
            self._time_drawing(overlay)
        for module in ("lines", "marks", "legend", "spots"):
            handler = getattr(part(f"overlays.{module}"), "_handler", None)
            if handler is not None:
                handler.unregister()
                handler._draw = self.clock.timed(handler._draw, f"drawing: {module}")
                handler.register()

    def _profiled(self, function):
        if self.profile is None:
            return function
        return lambda *arguments: self.profile.runcall(function, *arguments)

    def move(self):
        """One step of a drag; seconds by label."""
        self.clock.spent.clear()
        bm = bmesh.from_edit_mesh(self.hull.data)
        bm.verts.ensure_lookup_table()
        count = len(bm.verts)
        chosen = {
            "one": [self.random.randrange(count)],
            "all": range(count),
        }[self.options.drag]
        for index in chosen:
            vertex = bm.verts[index]
            vertex.co.x += self.random.uniform(-0.02, 0.02)
            if vertex.co.y > 0.1:
                vertex.co.y += self.random.uniform(-0.02, 0.02)
        bmesh.update_edit_mesh(self.hull.data, loop_triangles=False, destructive=False)
        begin = time.thread_time()
        bpy.context.view_layer.update()
        evaluated = time.thread_time()
        bpy.ops.wm.redraw_timer(type="DRAW_WIN_SWAP", iterations=1)
        drawn = time.thread_time()
        spent = dict(self.clock.spent)
        spent["whole update"] = evaluated - begin
        spent["whole drawing"] = drawn - evaluated
        return spent

    def run(self):
        for _ in range(WARM_UP):
            self.move()
        if self.profile:
            self.profile = self.profile.__class__() if False else self.profile
            self.profile.clear()
        self.moves = [self.move() for _ in range(self.options.moves)]
        self.report()

    def report(self):
        state = part("bridge.hull_state").state_of(self.hull)
        if state.status or state.hydrostatics is None:
            raise RuntimeError(f"no results: {state.status} {state.hydrostatics_status}")
        labels = sorted({label for move in self.moves for label in move})
        own = [label for label in labels if not label.startswith("whole")]
        shown = self.hull.hull.surface_object.data
        print(
            f"\n{len(self.hull.data.vertices)} control points, {len(shown.vertices)} surface points, "
            f"lines: {', '.join(f'{n} {len(g.sections)}' for n, g in state.lines.items()) or 'off'}"
        )
        print(f"{'milliseconds of':<28}{'median':>9}{'90 %':>9}")
        for label in (*own, "whole update", "whole drawing"):
            self._print(label, [move.get(label, 0.0) for move in self.moves])
        self._print("OWN TIME", [sum(move.get(name, 0.0) for name in own) for move in self.moves])
        if self.profile:
            pstats.Stats(self.profile).sort_stats("tottime").print_stats(40)

    @staticmethod
    def _print(label, seconds):
        low, high = 1e3 * np.percentile(seconds, [50, 90])
        print(f"{label:<28}{low:>9.2f}{high:>9.2f}")


def parsed():
    parser = argparse.ArgumentParser(prog="live_benchmark.py")
    parser.add_argument("--points", type=int, default=140)
    parser.add_argument("--moves", type=int, default=200)
    parser.add_argument("--samples", type=int, default=16)
    parser.add_argument("--drag", choices=("one", "all"), default="one")
    parser.add_argument("--no-lines", action="store_true")
    parser.add_argument("--profile", action="store_true")
    return parser.parse_args(sys.argv[sys.argv.index("--") + 1 :])


def main():
    try:
        Benchmark(parsed()).run()
    except Exception:  # Blender would go on, and wait for the user
        traceback.print_exc()
        sys.stdout.flush()
        os._exit(1)
    sys.stdout.flush()
    os._exit(0)


bpy.context.preferences.view.show_splash = False
bpy.app.timers.register(main, first_interval=1.0)
