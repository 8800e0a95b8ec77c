# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of a hull that transformations begin with and are told by."""

from dataclasses import dataclass

from ...bridge import native
from . import parents

# Of the length between perpendiculars: shorter is no parallel middle body.
_LEAST_PARALLEL = 1e-3


@dataclass(frozen=True)
class FormParameters:
    """Of a hull as it lies in the water, m, m³ and t. lcb: x; lcb_percent: of Lpp forward of
    midship."""

    block: float
    prismatic: float
    volume: float
    displacement_t: float
    lcb: float
    lcb_percent: float


def of_hull(obj, scene):
    """(the FormParameters of a hull as it is, the length of its parallel middle body in m; 0:
    none)"""
    parent = parents.of_hull(obj, scene)
    aft, forward = parallel_body(parent)
    return of_parent(parent), forward - aft


def of_parent(parent):
    """The FormParameters of a parents.Parent."""
    where = parent.where
    return of_hydrostatics(
        native.require().hydrostatics(parent.body, **where.position(), **where.project())
    )


def of_hydrostatics(found):
    """The FormParameters of hull_native.Hydrostatics."""
    return FormParameters(
        found.project.block,
        found.project.prismatic,
        found.displaced_volume,
        found.displacement_t,
        found.lcb,
        found.lcb_percent,
    )


def parallel_body(parent):
    """(aft, forward) in m of a parents.Parent's parallel middle body, the same where there is
    none."""
    return parallel_of(parent.body, parent.position(), parent.where)


def parallel_of(body, position, where):
    """The same of a hull_native.HullBody that lies at a position, as Parent has it, in an
    Afloat."""
    aft, forward = native.require().parallel_body(body, **position)
    least = _LEAST_PARALLEL * where.length_pp
    return (aft, forward) if forward - aft > least else (aft, aft)
