# SPDX-License-Identifier: GPL-3.0-or-later
"""What can be pressed and typed in the panel Stability stands still while results come, change and
are refused."""

from types import SimpleNamespace

import bpy
from addon_under_test import add_hull, compute, part
from test_panels import Drawn, context

PANELS = {
    "HULL_PT_stability": "stability",
    "HULL_PT_levers": "stability",
    "HULL_PT_load_cases": "load_cases",
}
ANALYSES = ("righting_levers", "load_cases")


class Rows:
    """Stands for a layout; knows how many rows it is high, and in which one each field stands."""

    def __init__(self, is_across=False):
        self._is_across, self._parts = is_across, []

    def _part(self, is_across):
        self._parts.append(Rows(is_across))
        return self._parts[-1]

    def row(self, **unused):
        return self._part(True)

    def split(self, **unused):
        return self._part(True)

    def column(self, **unused):
        return self._part(False)

    def separator(self):
        self._parts.append("")

    def label(self, **unused):
        self._parts.append("")

    def prop(self, data, name, **unused):
        self._parts.append(name)

    def operator(self, name, **unused):
        self._parts.append(name)
        return SimpleNamespace()

    def template_list(self, name, *unused, **more_unused):
        self._parts.append(name)

    @property
    def height(self):
        heights = [one.height if isinstance(one, Rows) else 1 for one in self._parts]
        return (max if self._is_across else sum)(heights or [0])

    def places(self, top=0):
        """Pairs (row, field or button)."""
        found = []
        for one in self._parts:
            found += one.places(top) if isinstance(one, Rows) else [(top, one)] * bool(one)
            if not self._is_across:
                top += one.height if isinstance(one, Rows) else 1
        return found


def drawn():
    """By panel its height and places."""
    found, now = {}, context()
    now.region.width = 300  # as the sidebar usually has it: texts take several lines
    for name, module in PANELS.items():
        panel = Drawn(getattr(part(f"panels.{module}"), name))
        panel.layout = Rows()
        panel.draw(now)
        found[name] = (panel.layout.height, panel.layout.places())
    return found


def changed(hull, **loading):
    """What is drawn once a load is computed that was changed so."""
    for name, value in loading.items():
        setattr(hull.hull.loading, name, value)
    bpy.context.view_layer.update()
    compute([(hull.name, name) for name in ANALYSES])
    return drawn()


def drawn_hydrostatics():
    found, now = {}, context()
    now.region.width = 300
    panels = part("panels.hydrostatics")
    for cls in panels.CLASSES:
        if cls.poll(now):
            panel = Drawn(cls)
            panel.layout = Rows()
            panel.draw(now)
            found[cls.__name__] = (panel.layout.height, panel.layout.places())
    return found


def test_errors_of_the_mesh_move_nothing_in_hydrostatics():
    hull = add_hull()
    hull.hull.draft = 1.0
    state = part("features.hull.hull_state").refresh(hull, bpy.context.scene)
    before = drawn_hydrostatics()
    for vertex in hull.data.vertices:
        vertex.co.y = -vertex.co.y
    hull.data.update()
    part("features.hull.hull_state").refresh(hull, bpy.context.scene)
    assert "starboard" in state.status
    assert drawn_hydrostatics() == before and len(before) > 3


def test_results_and_refusals_move_nothing():
    hull = add_hull()
    hull.hull.draft, loading = 1.0, hull.hull.loading
    loading.use_displacement, loading.mass_t = False, 40.0
    bpy.ops.hull.add_load_case()
    case = loading.load_cases[0]
    case.mass_t, case.lcg, case.vcg = 40.0, 5.0, 0.5
    bpy.context.view_layer.update()
    before = drawn()
    computed = changed(hull, kg=0.5)
    case.mass_t = 1e4
    refused = changed(hull, mass_t=1e4)
    for name in ANALYSES:
        outcome, _ = part("features.analyses").last_outcome(hull, bpy.context.scene, name)
        told = outcome.message or outcome.result[0].message
        assert told.startswith("Sinks: ") or "displaces" in told, told
    case.mass_t, case.vcg = 40.0, 30.0
    capsizing = changed(hull, mass_t=40.0)
    for name in PANELS:
        assert before[name] == computed[name] == refused[name] == capsizing[name], name
        assert before[name][0] > 5
