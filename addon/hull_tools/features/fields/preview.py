# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull shown as its shape fields make it while they are changed: surface, lines and numbers
follow as they do when points are moved. Where the points were is kept with the mesh.

`placed` moves the points before anything is computed of them, but after what holds them was put
into effect: only then it is seen whether something else has moved them.
"""

from dataclasses import dataclass, replace

import bpy
import numpy as np

from ...bridge.blender import units
from ...bridge.mesh import mesh_points, start_points
from ...bridge.objects import curve_lines, field_faces, field_rows, hull_mesh, hull_objects
from ..constraints import kept_points, move_limits, tie_keeping
from ..hull import hull_state
from ..modelling import exact_subdivision, row_insertion
from . import field_list, prepared, shaping

_SHARED = (
    'Fields of "{}" are previewed too, which shares this mesh: Apply or Cancel them there, or make '
    "the mesh single-user (Object ▸ Relations)"
)
_FOREIGN = (
    "Points or faces were changed while the fields are previewed: Apply keeps the hull as it is, "
    "or undo"
)


@dataclass
class Preview:
    """Of a hull that is previewed. applied: the shaping.Applied that is shown, None where fields
    shift nothing; problem: why the hull does not show the fields as they are, or ""."""

    applied: object = None
    problem: str = ""
    key: tuple = None  # what the hull was shown for
    shown: bytes = None  # the digest of its points then, which undo takes back alone
    own: object = None  # the Prepared, None where the hull is not as fields make it
    waits: bool = False  # for another hull that shares the mesh

    def put_off(self, problem, waits=False):
        """The hull stays as it is for now."""
        self.problem, self.waits = problem, waits
        self.applied = self.key = self.own = None


def of_hull(obj):
    """The Preview of a hull, None where it is not previewed."""
    state = hull_state.state_of(obj)
    return state.of(Preview) if state is not None and obj.hull.fields.is_previewed else None


def begin(obj, scene):
    """Shows the hull as its fields make it from now on, as they are changed."""
    # What holds points may have been changed by settings: then they are not there yet.
    hull_state.follow_edit(obj, scene, is_by_hand=False).checked()
    other = _also_previewed(obj)
    if other is not None:
        raise ValueError(_SHARED.format(other.name))
    # A mesh that was taken off its hull while it was previewed knows where its points were.
    if start_points.read(obj.data) is None or not _is_as_shown(obj):
        start_points.store(obj.data, hull_mesh.read(obj).data.points)
    _switch_on(obj)
    follow(obj, scene)


def take_up(obj):
    """After undo: that of edit mode takes back the mesh of a hull and none of its settings. A hull
    whose mesh shows fields is previewed again; `follow` ends a preview that the mesh knows nothing
    of."""
    if not obj.data.is_editmode or obj.hull.fields.is_previewed or _also_previewed(obj):
        return
    is_shown = start_points.read(obj.data) is not None and _is_as_shown(obj)
    if is_shown and hull_state.state_of(obj) is not None:
        _switch_on(obj)


def follow(obj, scene):
    """Brings a hull that is previewed up to date with its fields."""
    if obj.hull.fields.is_previewed:
        hull_state.follow_edit(obj, scene, is_by_hand=False, placed=placed)


def notice_moves(obj):
    """After what is kept for another hull that shares the mesh was put in its place: a hull that is
    previewed says so where its points moved by that."""
    preview = of_hull(obj)
    if preview is None or preview.problem or start_points.read(obj.data) is None:
        return
    if not _is_as_shown(obj):
        preview.put_off(_FOREIGN)


def placed(obj, scene, found, keep):
    """For hull_state.follow_edit: has the points of a hull that is previewed go where its fields,
    where they changed, take them. What cannot be leaves them as they are, with a problem."""
    preview = of_hull(obj)
    if preview is None or hull_objects.locked(obj):
        return found
    start = start_points.read(obj.data)
    if start is None:  # the mesh is another one now
        obj.hull.fields.is_previewed = False
        return found
    if not obj.hull.fields.fields:  # nothing is left to be previewed
        _end(obj, is_kept=not start_points.are_as_shown(obj.data, found.data.points))
        return keep()
    other = _also_previewed(obj)
    if other is not None:
        preview.put_off(_SHARED.format(other.name), waits=True)
        return found
    if not start_points.are_as_shown(obj.data, found.data.points):
        preview.put_off(_FOREIGN)
        return found
    scale = units.metres_per_unit(scene)
    key = (_values(obj), start.tobytes(), found.topology_key, scale, _held(obj, start))
    if (preview.key, preview.shown) == (key, found.points_digest):
        return found
    tie_keeping.hold_from(obj, start)
    preview.key, preview.shown = key, found.points_digest
    preview.problem, preview.waits = "", False
    try:
        at_start = found.with_points(replace(found.data, points=start))
        # What was prepared of other faces must not be taken for these where they are refused.
        known, preview.own = preview.own, None
        preview.own = prepared.of_hull(obj, at_start, scale, known)
        preview.applied = _solved(obj, preview.own)
    except ValueError as error:
        preview.problem = str(error)
        return found
    return _shown(obj, start, preview, keep)


def end(obj, scene, is_kept):
    """Ends the preview; is_kept: the hull stays as it is shown, else all its points are where they
    were before, bit by bit. ValueError where points were changed by something else since then and
    would be lost."""
    if not is_kept and start_points.read(obj.data) is not None and not _is_as_shown(obj):
        raise ValueError(_FOREIGN)
    for hull in _end(obj, is_kept):
        hull_state.follow_edit(hull, scene, is_by_hand=False)


def _end(obj, is_kept):
    """Returns the hulls that are not previewed any longer."""
    start, hulls = start_points.read(obj.data), [obj]
    if start is not None and not is_kept:
        tie_keeping.hold_from(obj, start)
        mesh_points.write(obj.data, np.arange(len(start)), start)
    start_points.forget(obj.data)
    obj.hull.fields.is_previewed = False
    while (other := _also_previewed(obj)) is not None:  # which waited, and has no start now
        other.hull.fields.is_previewed = False
        hulls.append(other)
    return hulls


def _solved(obj, own):
    try:
        rows = field_list.in_use(obj)
    except ValueError:  # none shifts: the hull is shown as it was
        return None
    return shaping.solve(obj, rows, own)


def _shown(obj, start, preview, keep):
    """The HullMesh with its points where the fields take them, as far as what holds them lets."""
    points = start.astype(np.float64)
    if preview.applied is not None:
        which, places = shaping.moved_points(preview.applied.result.moves, preview.own)
        points[which] = places
    mesh_points.write(obj.data, np.arange(len(points)), points)
    found = keep()
    preview.shown = found.points_digest
    start_points.set_shown(obj.data, found.data.points)
    return found


def _switch_on(obj):
    obj.hull.fields.is_previewed = True
    of_hull(obj).key = None  # of a preview before, which showed the same


def _is_as_shown(obj):
    return start_points.are_as_shown(obj.data, hull_mesh.read(obj).data.points)


def _also_previewed(obj):
    """Another hull whose preview would show its fields on the same mesh; None without."""
    if obj.data.users <= 1:
        return None
    return next((other for other in hull_objects.hulls(bpy.data.objects) if other != obj
                 and other.data == obj.data and other.hull.fields.is_previewed
                 and other.users_scene), None)  # fmt: skip


def subdivide(obj, scene):
    """Subdivides the start of a hull that is previewed exactly, so that it has more control points
    to follow its fields, and previews it again; returns the exact_subdivision.Subdivided.
    ValueError where that cannot be: the preview stays then."""
    return _with_another_start(obj, scene, lambda: exact_subdivision.subdivide(obj, scene))


def insert_row(obj, scene):
    """The same by a row of points where the residual is largest, which changes the start a little;
    returns the row_insertion.Inserted. ValueError where that cannot be, and where there is no
    residual."""
    applied = of_hull(obj).applied
    if applied is None:
        raise ValueError("The fields shift nothing of the hull that a row could help to follow")
    place = applied.result.largest_place
    return _with_another_start(obj, scene, lambda: row_insertion.insert_near(obj, scene, place))


def _with_another_start(obj, scene, change):
    """What change() returns, which works on the hull as it was before its preview."""
    end(obj, scene, is_kept=False)
    try:
        return change()
    finally:
        begin(obj, scene)


def concerned(changed, view_layer):
    """The hulls in a view layer that are previewed with fields whose curves are among changed
    objects or were deleted, of which nothing else is told, or wait for another hull that shares
    their mesh."""
    known = (obj for obj, _ in hull_state.known_hulls(view_layer))
    hulls = [obj for obj in known if obj.hull.fields.is_previewed]
    return [obj for obj in hulls if of_hull(obj).waits or has_other_curves(obj, changed)]


def has_other_curves(obj, changed):
    """Whether curves of a hull's fields are among changed objects or were deleted."""
    return any(changed.intersection(own) or any(map(_is_deleted, own)) for own in _curves_of(obj))


def _is_deleted(curve):
    return curve is not None and not curve.users_collection


def _curves_of(obj):
    return ({field.curve, field.becomes} for field in obj.hull.fields.fields)


def _held(obj, start):
    """What the points, from where they were at the start, may do: the fields go by that too. Equal
    where it is the same."""
    limits = move_limits.of_hull(obj, np.arange(len(start)), start)
    return *limits.key(), kept_points.read(obj.data).places.tobytes()


def _values(obj):
    """All of the fields that a preview goes by; curves and faces by what they are now, names for
    what is said of them."""
    return tuple((field.name, values_of(field, obj)) for field in obj.hull.fields.fields)


def values_of(field, obj):
    """All of a field by which the hull is shown; equal where that is the same."""
    return (
        *(field.use, field.role, field.base, tuple(field.place), field.axis, field.extent),
        *(field.falloff, tuple(field.shift), tuple(field.axes), field.varies, field.extent_end),
        *(field.falloff_end, tuple(field.shift_end), field_rows.goes_along_surface(field)),
        *base_of(field, obj),
        _points_of(field.becomes, obj) if field_rows.becomes_another(field) else None,
    )


def base_of(field, obj):
    """What a field's base is that is not told by its settings; equal where that is the same."""
    return (
        _points_of(field.curve, obj) if field.base == "CURVE" else None,
        field_faces.of_field(obj, field).tobytes() if field.base == "FACES" else None,
    )


def _points_of(curve, obj):
    """Equal for a curve object that shows the same; of one that is no line what is said of it."""
    if curve is None:
        return None
    try:
        points, is_closed = curve_lines.points_of(curve, obj)
    except ValueError as error:
        return curve.name_full, str(error)
    return points.tobytes(), is_closed
