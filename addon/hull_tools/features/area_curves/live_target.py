# SPDX-License-Identifier: GPL-3.0-or-later
"""The target curve follows its settings, and stands beside the hull's own curve in the plot."""

from dataclasses import dataclass, field

import numpy as np

from ...bridge.blender import units
from .. import analyses
from ..curves_of_form import beside
from ..hull import hull_state
from . import stored, target_curve

ANALYSIS, _WHOSE = "sectional_areas", "target"
_NAME = "Target"
_LEAST_VOLUME = 1e-9  # m³


@dataclass
class LiveTarget:
    """Of one hull. curve: the TargetCurve, None without one; status: why not though there are
    points, or ""; volume, centre: of the curve, m³ and x in m; frame: the ranges of the plot's axes
    that are kept while handles are dragged, or None."""

    curve: object = None
    status: str = ""
    volume: float = 0.0
    centre: float = 0.0
    frame: tuple = None
    _key: tuple = None
    _known: tuple = field(default=(None, None, None))

    def follow(self, obj, scene, state):
        """Brings the curve and what is drawn of it up to date."""
        settings = obj.hull.area_target
        if self._key is None and not settings.area_points:
            return
        scale = units.metres_per_unit(scene)
        base, handles = stored.numbers(obj)
        key = base.tobytes(), handles.tobytes(), scale, settings.show_target, self.frame
        if key == self._key:
            return
        self._key, self.curve, self.status = key, None, ""
        if len(handles):
            try:
                self.curve = stored.curve_of(base, handles, scale)
                self.volume, self.centre = self.curve.volume()
            except ValueError as error:
                self.status = str(error)
        state.of(beside.Beside).put(ANALYSIS, _WHOSE, self._drawn(settings.show_target))

    def _drawn(self, is_shown):
        """The beside.Curve, or None."""
        if self.curve is None or not is_shown:
            return None
        handles = np.column_stack([self.curve.x, self.curve.areas])
        return beside.Curve(_NAME, *self.curve.drawn(), handles, self.frame)

    def difference(self, areas):
        """The target_curve.Difference of a hull's sectional_areas.Areas; None without a target."""
        if self.curve is None:
            return None
        known_areas, known_curve, found = self._known
        if known_areas is not areas or known_curve is not self.curve:
            found = target_curve.difference(areas.positions, areas.areas, self.curve)
            self._known = areas, self.curve, found
        return found


def follow(obj, scene):
    """Brings what is known of a hull's target up to date; returns the LiveTarget."""
    state = hull_state.state_of(obj) or hull_state.refresh(obj, scene)
    live = state.of(LiveTarget)
    live.follow(obj, scene, state)
    return live


def known(obj):
    """The LiveTarget of a hull as it was last looked at, or None."""
    return hull_state.known(obj, LiveTarget)


def present(obj, scene):
    """The sectional_areas.Result of a hull as it was last computed, or None."""
    outcome, _ = analyses.last_outcome(obj, scene, ANALYSIS)
    return None if outcome is None else outcome.result


def volume_of(obj, result):
    """(m³, x of its centre in m) of the hull whose areas a sectional_areas.Result has: they are
    those of the hull alone, its hydrostatics those of its appendages, too."""
    if not hull_state.state_of(obj).ship.source.is_joined:
        return result.hydrostatics.displaced_volume, result.hydrostatics.lcb
    x, areas = result.areas.positions, result.areas.areas
    parts = 0.5 * np.diff(x) * (areas[1:] + areas[:-1])
    volume = max(parts.sum(), _LEAST_VOLUME)
    return float(volume), float(parts @ (0.5 * (x[1:] + x[:-1])) / volume)
