# SPDX-License-Identifier: GPL-3.0-or-later
"""Pulling the surface: the point lands on its target, and what is to stay stays."""

import bmesh
import bpy
import numpy as np
import pytest
from addon_under_test import part, sample, state_of
from edited_hulls import at, centre_normals, edit, grid_hull, select

SEED = 1122


def edited_points(hull):
    return part("bridge.mesh.mesh_points").read(hull.data)


def pull_of(hull, **options):
    return part("features.modelling.pulling").SurfacePull(hull, bpy.context.scene, **options)


def place_now(hull, grip):
    """Where the place of a grip is on the surface of the mesh as it is now, computed anew, in m."""
    arrays, native = part("bridge.mesh.mesh_arrays"), part("bridge.native").require()
    scale = part("bridge.blender.units").metres_per_unit(bpy.context.scene)
    control = arrays.control_arrays(arrays.read_mesh(hull.data), scale)
    surface = native.LimitSurface(native.ControlMesh(*control.arguments()), hull.hull.scheme)
    return surface.positions([grip.cell], grip.uv[None])[0]


def test_a_point_lands_on_its_target():
    """Blender keeps points in single precision: at 80 m that is 8e-6 m each, and yet."""
    hull = sample()
    size = max(hull.dimensions)
    random = np.random.default_rng(SEED)
    misses = []
    for _ in range(60):
        pull = pull_of(hull)
        cell = int(random.integers(pull.surface.cell_count))
        grip = pull.grip(cell, random.uniform(0.1, 0.9, 2))
        target = grip.point + 0.002 * size * random.normal(size=3)
        try:
            pull.pull(grip, target)
        except ValueError:
            continue  # all around is of creases or on the centre plane
        misses.append(np.linalg.norm(place_now(hull, grip) - target))
        pull.restore()
    assert len(misses) > 40
    assert np.median(misses) < 1e-9 * size
    assert max(misses) < 1e-7 * size


@pytest.mark.parametrize("mode", ["OBJECT", "EDIT"])
def test_the_operator_pulls_and_the_ship_follows(mode):
    hull = grid_hull()
    if mode == "EDIT":
        edit(hull)
    before = edited_points(hull)
    grip = pull_of(hull).nearest((2.6, 1.9, 1.7))
    target = np.float32(grip.point + (0.0, 0.25, 0.0))
    point = grip.point.tolist()
    assert bpy.ops.hull.pull_surface(point=point, target=target.tolist()) == {"FINISHED"}
    assert np.linalg.norm(place_now(hull, grip) - target) < 1e-6  # the point is single precision
    surface = state_of(hull).ship.surface
    assert np.linalg.norm(surface.positions([grip.cell], grip.uv[None])[0] - target) < 1e-6
    moved = np.abs(edited_points(hull) - before).max(axis=1) > 1e-5
    assert 0 < np.count_nonzero(moved) <= 16
    assert not moved[
        [at(i, j) for i in range(6) for j in range(5) if i in (0, 5) or j in (0, 4)]
    ].any()


def test_with_a_radius_more_points_follow_and_the_target_is_met():
    hull = sample("naval_vessel")
    pull = pull_of(hull)
    grip = pull.nearest((0.5 * max(hull.dimensions), 50.0, 0.6 * hull.hull.draft))
    target = grip.point + 0.2 * grip.normal
    before = edited_points(hull)
    counts, steepest = [], []
    for radius in (0.0, 9.0, 40.0):
        counts.append(pull.pull(grip, target, radius)[0])
        assert np.linalg.norm(place_now(hull, grip) - target) < 1e-6
        moves = np.linalg.norm(edited_points(hull) - before, axis=1)
        near = np.linalg.norm(before - grip.point, axis=1) < radius
        near[pull._ids[grip.controls]] = True
        assert not moves[~near & (moves > 1e-5)].any()
        edges = np.array([edge.vertices[:] for edge in hull.data.edges])
        steepest.append(np.abs(np.diff(moves[edges], axis=1)).max())
    pull.restore()
    assert np.array_equal(edited_points(hull), before)
    assert 0 < counts[0] < counts[1] < counts[2]
    assert steepest[2] < 0.5 * steepest[0]


def test_the_operator_takes_a_radius():
    hull = sample("naval_vessel")
    grip = pull_of(hull).nearest((0.5 * max(hull.dimensions), 50.0, 0.6 * hull.hull.draft))
    before = edited_points(hull)
    target = np.float32(grip.point + 0.2 * grip.normal)
    place = {"point": grip.point.tolist(), "target": target.tolist()}
    assert bpy.ops.hull.pull_surface(**place, radius=20.0) == {"FINISHED"}
    # The point itself is single precision.
    assert np.linalg.norm(place_now(hull, grip) - target) < 1e-5
    assert np.count_nonzero(np.abs(edited_points(hull) - before).max(axis=1) > 1e-5) > 16


def test_moves_are_those_of_the_core():
    hull = grid_hull()
    pull = pull_of(hull)
    native = part("bridge.native").require()
    grip = pull.nearest((2.6, 1.9, 1.7))
    before = edited_points(hull)
    target = grip.point + (0.1, 0.3, -0.2)
    border = np.flatnonzero(pull.surface.mesh.vertex_kinds > 0)
    wanted = native.pull_surface(
        pull.surface, [grip.cell], grip.uv[None], target[None], locked=border
    )
    count, longest = pull.pull(grip, target)
    moves = edited_points(hull) - before
    assert count == len(wanted.points)
    np.testing.assert_allclose(moves[wanted.points], wanted.moves, atol=1e-5)
    assert longest == pytest.approx(np.linalg.norm(wanted.moves, axis=1).max())


def test_locked_points_stay():
    hull = grid_hull()
    edit(hull)
    locked = [at(2, 2), at(3, 1)]
    select(hull, "vertex", locked)
    assert bpy.ops.hull.lock_points() == {"FINISHED"}
    assert part("features.constraints.point_locks").locked_points(hull.data).tolist() == sorted(
        locked
    )
    before = edited_points(hull)
    grip = pull_of(hull).nearest((2.6, 1.9, 1.7))
    bpy.ops.hull.pull_surface(point=grip.point, target=grip.point + (0.0, 0.5, 0.0))
    after = edited_points(hull)
    assert (after[locked] == before[locked]).all() and (after != before).any()
    bpy.ops.object.mode_set(mode="OBJECT")
    assert part("features.constraints.point_locks").locked_points(hull.data).tolist() == sorted(
        locked
    )
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="DESELECT")
    bpy.ops.hull.select_locked()
    chosen = [v.index for v in bmesh.from_edit_mesh(hull.data).verts if v.select]
    assert chosen == sorted(locked)
    bpy.ops.hull.unlock_points()
    assert not len(part("features.constraints.point_locks").locked_points(hull.data))


def test_flats_stay_flat():
    hull = grid_hull()
    edit(hull, (False, False, True))
    bm = bmesh.from_edit_mesh(hull.data)
    chosen = [f.index for f in bm.faces if 1 <= f.calc_center_median().x <= 4]
    select(hull, "face", chosen)
    bpy.ops.hull.make_flat(kind="SIDE", place="POSITION", position=2.25)
    (region,) = part("features.constraints.flats").regions(hull)
    grip = pull_of(hull).nearest((2.5, 2.25, 2.0))
    with pytest.raises(RuntimeError, match="cannot be pulled this way"):
        bpy.ops.hull.pull_surface(point=grip.point, target=grip.point + (0.0, 0.5, 0.0))
    assert (edited_points(hull)[region.points, 1] == 2.25).all()
    target = grip.point + (0.2, 0.0, 0.1)
    pull = pull_of(hull)
    pull.pull(grip, target)
    assert (edited_points(hull)[region.points, 1] == 2.25).all()
    assert np.linalg.norm(place_now(hull, grip) - target) < 1e-7


def test_nothing_is_flung_about_beside_a_flat():
    hull = grid_hull(columns=9, rows=9)
    edit(hull, (False, False, True))
    bm = bmesh.from_edit_mesh(hull.data)
    select(hull, "face", [f.index for f in bm.faces if f.calc_center_median().x < 5])
    bpy.ops.hull.make_flat(kind="SIDE", place="POSITION", position=2.25)
    before = edited_points(hull)
    pull = pull_of(hull)
    beside = pull.nearest((4.3, 2.25, 4.0))
    with pytest.raises(ValueError, match="times as far"):
        pull.pull(beside, beside.point + (0.0, 0.2, 0.0))
    assert (edited_points(hull) == before).all()
    away = pull.nearest((6.0, 2.5, 4.0))
    pull.pull(away, away.point + (0.0, 0.2, 0.0))
    assert np.abs(edited_points(hull) - before).max() < 8 * 0.2
    assert np.linalg.norm(place_now(hull, away) - away.point - (0.0, 0.2, 0.0)) < 1e-7


def test_creases_stay_unless_the_point_is_on_one():
    hull = grid_hull()
    edit(hull, (False, True, False))
    row = [at(i, 2) for i in range(6)]
    select(hull, "edge", list(zip(row, row[1:])))
    bpy.ops.hull.tag_crease()
    before = edited_points(hull)
    pull = pull_of(hull)
    beside = pull.nearest((2.5, 1.9, 2.6))
    assert not beside.moves_creases
    pull.pull(beside, beside.point + (0.0, 0.2, 0.0))
    assert (edited_points(hull)[row] == before[row]).all()
    pull.restore()
    assert (edited_points(hull) == before).all()
    on_crease = pull.nearest(before[row[2]])
    assert on_crease.moves_creases
    pull.pull(on_crease, on_crease.point + (0.0, 0.2, 0.0))
    assert np.linalg.norm(place_now(hull, on_crease) - on_crease.point - (0.0, 0.2, 0.0)) < 1e-6
    assert (edited_points(hull)[row[1:4]] != before[row[1:4]]).any(axis=1).all()


def test_points_on_the_centre_plane_stay_there():
    hull = sample()
    points = edited_points(hull)
    on_centre = np.flatnonzero(points[:, 1] == 0.0)
    pull = pull_of(hull, hold_creases=False)
    keel = pull.grip(*on_centre_place(pull))
    pull.pull(keel, keel.point + (0.1, 0.0, -0.2))
    assert (edited_points(hull)[on_centre, 1] == 0.0).all()
    with pytest.raises(ValueError, match="cannot be pulled this way"):
        pull.pull(keel, keel.point + (0.0, 0.3, 0.0))


@pytest.mark.parametrize("radius", [0.0, 12.0])
def test_a_smooth_keel_stays_smooth(radius):
    """The bottom of the run, which crosses the centre plane smoothly, pulled close beside it."""
    hull = sample("container_ship")
    pull = pull_of(hull)
    was_square = np.abs(centre_normals(pull.surface)[:, 1]) < 1e-6
    assert was_square.sum() > 40
    grip = pull.nearest((3.0, 1.0, 13.8))
    moved, longest = pull.pull(grip, grip.point + (0.0, 0.2, -0.5), radius)
    assert moved and longest > 0.3
    part("features.hull.hull_state").refresh(hull, bpy.context.scene)
    normals = centre_normals(state_of(hull).ship.surface)
    assert np.abs(normals[was_square, 1]).max() < 1e-5  # points are in single precision


def on_centre_place(pull):
    """(cell, uv) of a point of the surface on the centre plane, off the corners of cells."""
    for cell in range(pull.surface.cell_count):
        for uv in ((0.4, 0.0), (0.0, 0.4)):
            if pull.surface.positions([cell], [uv])[0, 1] < 1e-12:
                return cell, uv
    raise AssertionError("no cell has a side on the centre plane")


def test_the_other_side_of_a_half_hull_is_pulled_as_in_a_mirror():
    hull = sample()
    pull = pull_of(hull)
    grip = pull.nearest(np.array([0.5 * max(hull.dimensions), -50.0, 3.0]))
    assert grip.is_image and grip.point[1] < 0.0
    target = grip.point + (0.0, -0.1, 0.0)
    pull.pull(grip, target)
    assert np.linalg.norm(place_now(hull, grip) * (1, -1, 1) - target) < 1e-6


def test_a_coordinate_is_given_by_numbers():
    hull = sample()
    x, z = 0.45 * max(hull.dimensions), 2.0
    bpy.ops.hull.surface_to_coordinate(axis="Y", place=(x, 0.0, z), value=6.25)
    native, pull = part("bridge.native").require(), pull_of(hull)
    tree = native.SurfaceTree(pull.surface)
    hits = tree.all_ray_hits(np.array([x, -50.0, z]), np.array([0.0, 1.0, 0.0]))
    assert np.abs(hits.points[:, 1] - 6.25).min() < 1e-6
    with pytest.raises(RuntimeError, match="does not meet the surface"):
        bpy.ops.hull.surface_to_coordinate(axis="Y", place=(x, 0.0, 500.0), value=6.25)


def test_a_pull_from_nowhere_is_refused():
    grid_hull()
    with pytest.raises(RuntimeError, match="give point and target"):
        bpy.ops.hull.pull_surface(point=(1.0, 1.0, 1.0))


def test_scene_units_count():
    bpy.context.scene.unit_settings.scale_length = 0.5
    hull = grid_hull()
    grip = pull_of(hull).nearest(0.5 * np.array((2.6, 1.9, 1.7)))
    target = grip.point + (0.0, 0.1, 0.0)
    bpy.ops.hull.pull_surface(point=grip.point / 0.5, target=target / 0.5)
    assert np.linalg.norm(place_now(hull, grip) - target) < 1e-6


def test_a_pull_is_one_undo_step():
    hull = grid_hull()
    before = edited_points(hull)
    name = hull.name
    bpy.ops.ed.undo_push(message="before")
    grip = pull_of(hull).nearest((2.6, 1.9, 1.7))
    bpy.ops.hull.pull_surface(point=grip.point, target=grip.point + (0.0, 0.5, 0.0))
    bpy.ops.ed.undo_push(message="after")  # scripts do it themselves
    bpy.ops.ed.undo()
    assert (edited_points(bpy.data.objects[name]) == before).all()


# What the mouse does


def eye_from_port(hull, size=(800, 600), width=20.0):
    """An orthographic view to starboard: x to the right, z upwards, about the hull's middle."""
    drawn = width / np.array([size[0] / size[0], size[0] / size[1]])
    middle = edited_points(hull).mean(axis=0)
    to_clip = np.array(
        [
            [-2 / drawn[0], 0, 0, 2 * middle[0] / drawn[0]],
            [0, 0, 2 / drawn[1], -2 * middle[2] / drawn[1]],
            [0, -0.01, 0, 0],
            [0, 0, 0, 1],
        ]
    )
    return part("features.modelling.pull_lines").Eye(to_clip, size)


def test_a_hull_that_is_scaled_to_nothing_has_no_depth():
    eye = eye_from_port(grid_hull())
    assert np.array_equal(eye.from_clip, np.linalg.inv(eye.to_clip))
    flat = type(eye)(eye.to_clip @ np.diag([1.0, 0.0, 1.0, 1.0]), eye.size)
    assert flat.from_clip is None


def test_the_eyes_ray_goes_through_what_is_seen():
    hull = grid_hull()
    eye, drags = eye_from_port(hull), part("features.modelling.drags")
    random = np.random.default_rng(SEED)
    for point in random.uniform(-3, 3, (20, 3)):
        (mouse,) = drags.in_picture(eye.to_clip, eye.size, point[None])
        origin, direction = eye.ray(mouse)
        assert np.linalg.norm(np.cross(point - origin, direction)) < 1e-12
        assert drags.on_plane(origin, direction, point, direction) == pytest.approx(point)
        normal = random.normal(size=3)
        on_plane = drags.on_plane(origin, direction, point + normal, normal)
        assert abs((on_plane - point - normal) @ normal) < 1e-9
        along = drags.on_line(origin, direction, point, np.array([1.0, 0.2, 0.3]))
        assert along == pytest.approx(point, abs=1e-9)
    assert drags.on_line(origin, direction, point, direction) is None
    assert drags.on_plane(origin, direction, point, np.cross(direction, normal)) is None


def test_the_surface_is_held_where_the_eye_sees_it():
    hull = grid_hull()
    eye, drags = eye_from_port(hull), part("features.modelling.drags")
    pull = pull_of(hull)
    (mouse,) = drags.in_picture(eye.to_clip, eye.size, np.array([[2.6, 1.9, 1.7]]))
    grip = part("features.modelling.pull_lines").grip_at(pull, eye, mouse)
    assert grip.plane is None and not grip.is_image
    assert grip.point[[0, 2]] == pytest.approx((2.6, 1.7))
    assert part("features.modelling.pull_lines").grip_at(pull, eye, (1.0, 1.0)) is None


def test_a_section_line_is_held_exactly():
    hull = grid_hull()
    for kind, switch in part("features.lines.lines").SWITCHES.items():
        setattr(hull.hull.lines, switch, kind == "station")
    part("features.hull.hull_state").refresh(hull, bpy.context.scene)
    eye, drags = eye_from_port(hull), part("features.modelling.drags")
    pull = pull_of(hull)
    for section in state_of(hull).lines.groups["station"].sections:
        for curve in section.curves:
            points = 0.5 * (curve.points[1:] + curve.points[:-1])
            for mouse in drags.in_picture(eye.to_clip, eye.size, points)[
                :: max(1, len(points) // 5)
            ]:
                grip = part("features.modelling.pull_lines").grip_at(pull, eye, mouse + (2.0, 1.0))
                assert grip.plane is not None
                surface = part("features.modelling.pull_lines").grip_at(
                    pull, eye, mouse + (2.0, 1.0), takes_lines=False
                )
                assert surface is None or surface.plane is None
                assert abs(grip.point @ section.cut.plane[:3] - section.cut.plane[3]) < 1e-9


def test_rounding_keeps_the_sum():
    rounded = part("bridge.mesh.single_rounding").rounded
    random = np.random.default_rng(SEED)
    weights = random.uniform(0.0, 1.0, 16) ** 4
    weights /= weights.sum()
    points = random.uniform(10.0, 100.0, (16, 3))
    is_free = np.ones((16, 3), dtype=bool)
    is_free[:, 2] = False
    singles = rounded(points, weights, is_free)
    assert singles.dtype == np.float32
    left = np.abs(weights @ (singles.astype(np.float64) - points))
    assert (left[:2] < 1e-3 * np.spacing(np.float32(100.0))).all()
    assert (singles[:, 2] == points[:, 2].astype(np.float32)).all()
    assert np.abs(singles - points).max() < 10 * np.spacing(np.float32(100.0))
