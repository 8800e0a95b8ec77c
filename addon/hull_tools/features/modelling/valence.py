# SPDX-License-Identifier: GPL-3.0-or-later
"""Points with many faces around them, such as the tip of a fan of triangles, are made less so.

Two steps, as long as they help. Triangles beside one another become quadrilaterals: no point moves.
Else the point is parted in two with a new quadrilateral between them, so that each has part
of the faces, and two neighbours one more: as long as the sum of the squares of what faces are too
many or too few at these points gets less. Parted points are put so that their limits lie on the
surface of before; others stay.
"""

from dataclasses import dataclass

import bmesh

from ...bridge import native
from ...bridge.mesh.vertex_fans import fan
from ..constraints import flat_marks
from ..fitting import limit_fitting
from ..hull import hull_state

# How far new points go from the old one towards the neighbours on their side: as far apart from one
# another as from these. One on a crease or border stays there.
_APART = 1.0 / 3.0
_APART_FROM_CREASE = 0.5

# So many squares along the side of a cell it is looked at how far the surface moved.
_SAMPLES = 6


@dataclass(frozen=True)
class Reduced:
    """How many faces the worst of the chosen points had around it, how many the worst of those that
    it became has, and how many points were added. change: how far, in m, the surface is from that
    of before at most; None when the mesh has errors."""

    before: int
    after: int
    added: int
    change: object


def reduce_selected(obj, scene):
    """Reduces the irregular points that are selected in edit mode; returns what came of it.

    ValueError when none is selected, or none can be reduced.
    """
    state = hull_state.refresh(obj, scene)
    surface = None if state.status else state.ship.surface
    bm = bmesh.from_edit_mesh(obj.data)
    bm.verts.index_update()
    chosen = [vertex for vertex in bm.verts if vertex.select and not vertex.hide]
    points = [vertex for vertex in chosen if fan(bm, vertex).has_too_many()]
    if not points:
        raise ValueError("Select points with more faces around them than regular ones have")
    before, count = max(len(vertex.link_faces) for vertex in points), len(bm.verts)
    is_changed, parted = False, set()
    for vertex in points:
        is_changed |= _join_triangles(bm, vertex)
        while (new := _part(bm, vertex)) is not None:
            points.append(new)  # and goes on with it
            parted |= {new} if fan(bm, vertex).creases else {new, vertex}
            is_changed = True
    if not is_changed:
        raise ValueError(
            f"{before} faces around a point cannot be made fewer here: its neighbours would have "
            "too many instead"
        )
    bm.normal_update()
    bmesh.update_edit_mesh(obj.data)
    after, added = max(len(vertex.link_faces) for vertex in points), len(bm.verts) - count
    change = None
    if surface is not None:
        indices = [vertex.index for vertex in parted]
        limit_fitting.put_limits_on(surface, obj, scene, indices)
        change = _change(surface, hull_state.follow_edit(obj, scene))
    return Reduced(before, after, added, change)


def _change(surface, state):
    """The largest distance of a hull's surface from another one, at points all over it."""
    if state.status:
        return None
    points = state.ship.surface.tessellate(_SAMPLES).points
    return float(native.require().SurfaceTree(surface).closest_points(points).distances.max())


def _join_triangles(bm, vertex):
    """Joins pairs of triangles at a vertex that has too many faces; returns whether any were."""
    around = fan(bm, vertex)
    pairs = []
    for sector in around.sectors():
        wanted = len(sector) - 1 - around.regular_size
        if wanted > 0:
            pairs += _best_pairs(bm, around, around.inner(sector))[:wanted]
    for place in pairs:
        bmesh.utils.face_join((around.faces[place - 1], around.faces[place]))
    return bool(pairs)


def _best_pairs(bm, around, inner):
    """Places of spokes that can go, every other one at most; as many as can be."""
    free = [place for place in inner if _can_go(bm, around, place)]
    found = []
    for start in (0, 1):
        taken, used = [], set()
        for place in free[start:] + free[:start]:
            own = {around.faces[place - 1], around.faces[place]}
            if not own & used:
                taken.append(place)
                used |= own
        if len(taken) > len(found):
            found = taken
    return found


def _can_go(bm, around, place):
    """Whether a spoke is between two triangles of one kind and its far end can do without it."""
    first, second = around.faces[place - 1], around.faces[place]
    layer = bm.faces.layers.int.get(flat_marks.ATTRIBUTE)
    if len(first.verts) != 3 or len(second.verts) != 3 or first is second:
        return False
    if first.material_index != second.material_index:
        return False
    if layer is not None and first[layer] != second[layer]:
        return False
    spoke = around.spokes[place]
    far = fan(bm, spoke.other_vert(around.vertex))
    # With one face less the end of a border becomes a corner, and other points lose their hold.
    least = {4: 3, 2: 2 if far.is_open else 1, 1: 1}[far.regular_size]
    return far.sector_size(spoke) > least


def _part(bm, vertex):
    """Parts a vertex in two if that helps; returns the new BMVert, or None."""
    around, best = fan(bm, vertex), None
    if not around.has_too_many():
        return None
    for sector in around.sectors():
        inner = around.inner(sector)
        for i, first in enumerate(inner):
            for last in inner[i + 2 :]:
                change = _change_by_parting(bm, around, len(sector) - 1, first, last)
                if change < 0 and (best is None or change < best[0]):
                    best = (change, first, last)
    if best is None:
        return None
    return _parted(bm, around, *best[1:])


def _change_by_parting(bm, around, sector_size, first, last):
    """By how much the sum of squares changes when the faces from one spoke to another go to a point
    of their own."""
    count = (last - first) % len(around.spokes)
    if len(around.spokes) - count < 2 and not around.creases:
        return 0
    regular = around.regular_size
    left = sector_size - count + 1
    change = (left - regular) ** 2 - (sector_size - regular) ** 2 + (count + 1 - 4) ** 2
    for place in (first, last):
        far = fan(bm, around.spokes[place].other_vert(around.vertex))
        over = far.sector_size(around.spokes[place]) - far.regular_size
        change += (over + 1) ** 2 - over**2
    return change


def _parted(bm, around, first, last):
    vertex, count = around.vertex, len(around.spokes)
    between = [(first + k) % count for k in range(1, (last - first) % count)]
    arc = [around.faces[(first + k) % count] for k in range((last - first) % count)]
    ends = [around.spokes[place].other_vert(vertex) for place in (first, last)]
    rest = [place for place in range(count) if place not in {first, last, *between}]
    spokes = [around.spokes[place] for place in between]
    is_held = bool(around.creases)
    there = vertex.co.lerp(_mean_end(vertex, spokes), _APART_FROM_CREASE if is_held else _APART)
    here = vertex.co.copy()
    if not is_held and rest:
        others = [around.spokes[place] for place in rest]
        here = here.lerp(_mean_end(vertex, others), _APART)
    new = bm.verts.new(there)
    for face in arc:
        corners = [new if corner is vertex else corner for corner in face.verts]
        copied = bm.faces.new(corners, face)
        copied.select_set(face.select)
    bm.faces.new((vertex, ends[0], new, ends[1]), arc[0])
    bmesh.ops.delete(bm, geom=arc, context="FACES_ONLY")
    bmesh.ops.delete(bm, geom=spokes, context="EDGES")
    vertex.co = here
    new.select_set(True)
    bm.verts.index_update()
    return new


def _mean_end(vertex, spokes):
    total = sum((spoke.other_vert(vertex).co for spoke in spokes), vertex.co * 0.0)
    return total / len(spokes)
