# SPDX-License-Identifier: GPL-3.0-or-later
"""New hulls after type ships: a sample brought to main dimensions, then to a wanted form."""

from dataclasses import dataclass
from functools import cache

import bpy

from ....hull_io.new_hulls.type_ships import TYPE_SHIPS, as_new
from ....hull_io.reading import read_hull
from ....hull_io.shell import shell_arrays
from ...bridge import native
from ..hull import hull_creation, samples
from . import form_parameters, parents, section_shifts

# The smoothest way first; it reaches less far.
_PARTS = ("fair", "whole")


@dataclass(frozen=True)
class Form:
    """What is wanted, None: as it comes with the dimensions. block: on Lpp, beam and draft;
    lcb_percent: forward of midship in percent of Lpp; parallel: length of the parallel middle body
    in m."""

    block: object = None
    lcb_percent: object = None
    parallel: object = None

    @property
    def is_wanted(self):
        return any(value is not None for value in (self.block, self.lcb_percent, self.parallel))


@cache
def _sample(kind):
    return read_hull(samples.sample_files()[TYPE_SHIPS[kind].sample])


@cache
def usual(kind):
    """(FormParameters, Form) of the type ship as she is."""
    data, hull_native = _sample(kind), native.require()
    ship, shell = data.particulars, shell_arrays(data)
    surface = hull_native.LimitSurface(hull_native.ControlMesh(*shell.arguments()), data.scheme)
    body = hull_native.HullBody(surface, mirrored=data.half)
    found = hull_native.hydrostatics(
        body, draft=ship.draft, length_pp=ship.length_pp, beam=ship.beam
    )
    aft, forward = hull_native.parallel_body(body, draft=ship.draft)
    return ship, Form(found.project.block, found.lcb_percent, forward - aft)


def add(kind, lengths, form, scene, collection):
    """A new hull object after a type ship, in a collection: (object,
    form_parameters.FormParameters).

    lengths: Lpp, beam, draft and depth in m; form: a Form, which sections are shifted to along the
    ship. What of displacement and LCB is not wanted stays as it is without. ValueError where that
    can't be, with what can: nothing is added then.
    """
    data = as_new(_sample(kind), TYPE_SHIPS[kind].name, *lengths)
    obj = hull_creation.hull_object(data, scene, collection)
    try:
        parent = parents.of_hull(obj, scene)
        found = form_parameters.of_parent(parent)
        if form.is_wanted:
            found = _shifted(obj, scene, form, found, parent.where.length_pp)
    except ValueError:
        _discard(obj)
        raise
    return obj, found


def _shifted(obj, scene, form, before, length):
    block = before.block if form.block is None else form.block
    percent = before.lcb_percent if form.lcb_percent is None else form.lcb_percent
    for part in _PARTS:
        wanted = section_shifts.Wanted(
            {"block": block},
            length * (0.5 + 0.01 * percent),
            part,
            "FREE" if form.parallel is None else "LENGTH",
            form.parallel or 0.0,
        )
        try:
            return section_shifts.shift(obj, scene, wanted).after
        except ValueError:
            if part == _PARTS[-1]:
                raise


def _discard(obj):
    for one in (obj.hull.surface_object, obj):
        if one is not None:
            mesh = one.data
            bpy.data.objects.remove(one)
            bpy.data.meshes.remove(mesh)
