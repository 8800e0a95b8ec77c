# SPDX-License-Identifier: GPL-3.0-or-later
"""The parents that a hull of a family keeps: their control points in the layout of the family, and
the family that is made of them."""

import hashlib
from dataclasses import dataclass

import numpy as np

from ...bridge import native
from ...bridge.blender import units
from ...bridge.mesh import mesh_arrays
from ...bridge.objects import hull_objects
from ..hull import hull_state

# What of a parent's settings a member has by the weights; "kg" is of its loading.
PARTICULARS = ("length_pp", "beam", "draft", "depth", "trim_m", "kg")

_LOST = (
    'The stored mesh of the parent "{}" is missing or was changed: undo, or make the hull one of '
    "its own"
)


@dataclass(frozen=True, eq=False)
class Family:
    """Parents as they are stored. native: hull_native.HullFamily, in metres; control:
    mesh_arrays.ControlArrays of the first parent; surface: of these, for reading."""

    key: tuple
    native: object
    control: object
    surface: object


@dataclass
class Known:
    """The Family of a hull that was made last, or None."""

    family: object = None


def is_member(obj):
    """Whether a hull is one of a family."""
    return len(obj.hull.morph.parents) > 0


def family_of(obj, scale, factors=(1.0, 1.0, 1.0)):
    """The Family of a hull; scale: metres of Blender's unit; factors: by which all parents are
    scaled. ValueError where what is stored of it does not make one."""
    found = [_stored(entry) for entry in obj.hull.morph.parents]
    key = (scale, tuple(factors), obj.hull.scheme, *(_key(data) for data in found))
    state = hull_state.state_of(obj)
    known = Known() if state is None else state.of(Known)
    if known.family is None or known.family.key != key:
        known.family = _made(found, key, obj.hull.scheme, scale * np.asarray(factors))
    return known.family


def _stored(entry):
    if entry.mesh is None:
        raise ValueError(_LOST.format(entry.name))
    return mesh_arrays.read_mesh(entry.mesh)


def _key(data):
    return data.topology_digest(), data.points_digest()


def _made(found, key, scheme, scale):
    hull_native = native.require()
    control = mesh_arrays.control_arrays(found[0], scale)
    mesh = hull_native.ControlMesh(*control.arguments())
    surfaces = [hull_native.LimitSurface(mesh, scheme)]
    for data in found[1:]:
        if len(data.points) != len(found[0].points):
            raise ValueError("The stored parents have not the same points: undo")
        points = mesh_arrays.moved_arrays(control, data, scale).points
        surfaces.append(hull_native.LimitSurface(mesh.with_points(points), scheme))
    return Family(key, hull_native.HullFamily(surfaces), control, surfaces[0])


def source_key(obj):
    """What a hull was when it was fitted, as text: its geometry as computed last, and what a member
    has of its settings; "" where it has no surface."""
    state = hull_state.state_of(obj)
    if state is None or state.status or state.ship.geometry_key is None:
        return ""
    (topology, excluded, half, scheme), points, scale = state.ship.geometry_key
    told = (topology, sorted(excluded), half, scheme, points, scale, particulars_of(obj))
    return hashlib.blake2b(repr(told).encode(), digest_size=16).hexdigest()


def particulars_of(obj):
    """(length_pp, beam, draft, depth, trim_m, kg) of a hull as they are stored."""
    settings = obj.hull
    values = [getattr(settings, name) for name in PARTICULARS[:-1]]
    return (*map(units.as_stored, values), units.as_stored(settings.loading.kg))


def is_there(source):
    """Whether the hull that a parent was fitted to is there still."""
    return source is not None and hull_objects.is_hull(source) and len(source.users_scene) > 0


def changed(morph):
    """Names of the hulls that are not what they were when they were fitted; those that were
    deleted are not told."""
    told = [(morph.layout_source, morph.layout_key, morph.layout_name)]
    told += [(entry.source, entry.source_key, entry.name) for entry in morph.parents]
    names = [name for source, key, name in told
             if is_there(source) and source_key(source) not in ("", key)]  # fmt: skip
    return list(dict.fromkeys(names))


def gone(morph):
    """Names of the parents that were deleted."""
    return [entry.name for entry in morph.parents if not is_there(entry.source)]


def blended(morph, weights, factors):
    """{name: value} of PARTICULARS by weights, in Blender's units, with the factors (3,) of length,
    beam and draft."""
    length, beam, draft = factors
    of_factors = {"length_pp": length, "beam": beam}
    found = {}
    for name in PARTICULARS:
        values = [units.as_stored(getattr(entry, name)) for entry in morph.parents]
        mean = values[0] if len(set(values)) == 1 else float(np.dot(weights, values))
        found[name] = mean * of_factors.get(name, draft)
    return found
