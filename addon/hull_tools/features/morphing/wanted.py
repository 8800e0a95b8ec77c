# SPDX-License-Identifier: GPL-3.0-or-later
"""Weights, and factors of length, beam and draft, with which a member of a family has the numbers
that its panel Targets asks for."""

import numpy as np

from ...bridge import limits
from ...bridge.background import jobs
from ...bridge.blender import units
from ...bridge.mesh.mesh_editing import check_single_user
from ...bridge.objects import hull_objects
from ..conversion import conversions
from ..dimensions import dimensions
from ..hull import form_before, hull_state
from ..targets import asked, reports, rows
from . import members, parents, weights

_CHANGED = "The hull was changed meanwhile, and stays as it is: look for weights again"


class Finding(jobs.JobTask):
    """The task of finding them for a hull as it is now; see conversion.conversions. result():
    (weights, hull_native.TargetsReached)."""

    text = "Finding weights"

    def __init__(self, obj, scene):
        self.state = hull_state.up_to_date(obj, scene)
        if not members.is_of_family(obj):
            raise ValueError(members.NOT_OF_FAMILY)
        self._scale = units.metres_per_unit(scene)
        if len(obj.hull.morph.local):
            raise ValueError(
                "Weights for targets are those of the whole hull: remove its local parents first"
            )
        wanted_rows = rows.in_use(obj)
        conversions.clear_way(obj)
        morph, self._key = obj.hull.morph, self.state.ship.geometry_key
        family = parents.family_of(obj, self._scale, members.factors_of(morph)).native
        # Rows and KG may be others when it is written.
        self._told, self._kg = asked.told(obj), rows.kg_of(obj, self._scale)
        targets = [asked.form_target(row, obj, self._scale) for row in wanted_rows]
        start = weights.read(morph)
        options = asked.options(obj, self.state.ship.source, self._scale)
        self._job = jobs.Job(
            lambda progress: family.wanted_weights(start, targets, progress=progress, **options)
        )
        conversions.watch(self)

    def write(self, scene):
        """Makes the hull the member that was found, at the draft that it has; returns the
        reports.Report. ValueError, all being as it was, when the hull is no longer what it was, and
        where that member is folded or too far beyond its parents."""
        found, reached = self.result()
        obj = hull_state.hull_with(self.state, scene)
        if not hull_objects.is_hull(obj):
            raise ValueError(_CHANGED)
        if self.state.ship.geometry_key != self._key or not members.is_of_family(obj):
            raise ValueError(_CHANGED)
        check_single_user(obj.data)
        for weight in found:
            limits.within(weight, "A weight that would be needed", *limits.MORPH_WEIGHTS)
        surface = self.state.ship.source.new_surface()
        form_before.note(obj, surface)
        with rows.kg_stays(obj, self._told):
            _show(obj, scene, found, np.asarray(reached.scale))
        state = hull_state.follow_edit(obj, scene, is_by_hand=False)
        return reports.note(
            obj, state, reached, reports.rows_reached(self._told, reached, self._kg)
        )


def _show(obj, scene, found, factors):
    """The member of weights, scaled by further factors (3,)."""
    morph = obj.hull.morph
    before = [entry.weight for entry in morph.parents], tuple(morph.factors)
    followed = morph.follows_particulars
    try:
        with weights.writing():
            morph.follows_particulars = False  # wanted numbers are at the draft that the hull has
            morph.factors = np.array(morph.factors) * factors
        weights.write(morph, found)
        points = members.member_points(obj, scene, weights.read(morph))
    except ValueError:
        with weights.writing():
            morph.follows_particulars, morph.factors = followed, before[1]
        weights.write(morph, before[0])
        raise
    if np.any(factors != 1.0):
        dimensions.scale_hull(obj, scene, factors)
    members.write(obj, points / units.metres_per_unit(scene))
    weights.remember_shares(morph)
