# SPDX-License-Identifier: GPL-3.0-or-later
"""Bodies joined to hulls and cut out of them: closed forms, sums of volumes, and rays as another
way."""

import math

import boxes_of_points
import hull_native as hn
import numpy as np
import pytest
from transformation_hulls import Sample

UP = (0.0, 0.0, 1.0)
LENGTH, BEAM, DEPTH = 10.0, 4.0, 3.0


def boxes(*ends):
    """ControlMesh of boxes between corners (low, high), all edges knuckles, all points corners."""
    points, faces = boxes_of_points.points_and_faces(ends)
    sides = {tuple(sorted(s)) for f in faces for s in zip(f, f[1:] + f[:1])}
    return hn.ControlMesh(
        np.array(points),
        np.full(len(faces), 4),
        np.ravel(faces),
        creases=np.array(sorted(sides)),
        corners=np.arange(len(points)),
    )


def box_body(*ends, **how):
    surface = hn.LimitSurface(boxes(*ends))
    return surface, hn.HullBody(surface, mirrored=False, **how)


def box_hull(**how):
    return box_body(((0, -BEAM / 2, 0), (LENGTH, BEAM / 2, DEPTH)), **how)


def whole_volume(body):
    """m³ of a body in water far above it."""
    points = body.surface.mesh.points
    return body.immersion(UP, points[:, 2].max() + np.ptp(points[:, 0])).volume


RADIUS = 0.4
TUNNEL = {"start": (7.0, -3.0, 1.2), "end": (7.0, 3.0, 1.2), "radius": RADIUS, "cut": True}


def test_cylinder_through_box():
    """∇ less πr²B to 1e-9, the wetted surface likewise."""
    _, body = box_hull()
    before = body.immersion(UP, 2.5)
    body.join([hn.cylinder(**TUNNEL)])
    found = body.immersion(UP, 2.5)
    hole = math.pi * RADIUS**2 * BEAM
    assert found.volume == pytest.approx(before.volume - hole, abs=1e-9)
    area = before.wetted_surface + 2 * math.pi * RADIUS * (BEAM - RADIUS)
    assert found.wetted_surface == pytest.approx(area, abs=1e-9)
    moment = before.volume * before.centre_of_buoyancy - hole * np.array([7.0, 0.0, 1.2])
    assert found.centre_of_buoyancy == pytest.approx(moment / found.volume, abs=1e-9)
    assert found.waterplane_area == pytest.approx(LENGTH * BEAM, abs=1e-9)


@pytest.mark.parametrize("height", [0.5, 0.85, 1.1, 1.2, 1.55, 1.6])
def test_water_within_tunnel(height):
    """Upright water through the tunnel: circle segments."""
    _, body = box_hull()
    body.join([hn.cylinder(**TUNNEL)])
    found = body.immersion(UP, height)
    deep = min(max(height - 1.2, -RADIUS), RADIUS)
    angle = math.acos(-deep / RADIUS)
    segment = RADIUS**2 * (angle - math.sin(angle) * math.cos(angle))
    assert found.volume == pytest.approx(BEAM * (LENGTH * height - segment), abs=1e-9)
    width = 2 * RADIUS * math.sin(angle)
    assert found.waterplane_area == pytest.approx(BEAM * (LENGTH - width), abs=1e-8)
    wet = LENGTH * BEAM + 2 * height * (LENGTH + BEAM) - 2 * segment + 2 * angle * RADIUS * BEAM
    assert found.wetted_surface == pytest.approx(wet, abs=1e-8)


def test_heeled_and_trimmed_water():
    """Any water: the tunnel's water by another quadrature."""
    _, body = box_hull()
    _, alone = box_hull()
    body.join([hn.cylinder(**TUNNEL)])
    normal = np.array([0.05, 0.3, 1.0])
    normal /= np.linalg.norm(normal)
    offset = normal @ (7.0, 0.2, 1.3)

    def area(y):
        """Of the circle below the line that the water is at y."""
        slope = math.hypot(normal[0], normal[2])
        deep = (offset - normal @ (7.0, y, 1.2)) / slope
        deep = min(max(deep, -RADIUS), RADIUS)
        angle = math.acos(-deep / RADIUS)
        return RADIUS**2 * (angle - math.sin(angle) * math.cos(angle))

    at = np.linspace(-1.9, 1.9, 40)
    wet = _quad()(area, -2, 2, epsabs=1e-12, limit=500, points=at)[0]
    less = alone.immersion(normal, offset).volume - body.immersion(normal, offset).volume
    assert less == pytest.approx(wet, abs=1e-9)


def _quad():
    """Integrals by QUADPACK."""
    return pytest.importorskip(
        "scipy.integrate", reason="compared with SciPy, which is not there"
    ).quad


def section_area(name):
    form = hn.SectionForm(name)
    return 2 * _quad()(lambda s: 2 * s * form.half_thickness(s * s), 0, 1, epsabs=1e-14)[0]


def test_keel_and_box_counted_once():
    """The union's volume by inclusion and exclusion, and by the keel's closed form."""
    keel = {
        "section": "0012", "root": (6.0, 0.0, 0.5), "tip": (6.0, 0.0, -1.5), "root_chord": 2.0,
    }  # fmt: skip
    area = 2.0**2 * section_area("0012")
    alone = hn.foil(**keel)
    assert alone.volume == pytest.approx(2.0 * area, rel=1e-7)
    _, both = box_hull()
    both.join([alone])
    _, less = box_hull()
    less.join([hn.foil(**keel, cut=True)])
    hull = LENGTH * BEAM * DEPTH
    shared = -less.joined_volume
    assert hull + both.joined_volume == pytest.approx(hull + alone.volume - shared, abs=1e-9)
    assert shared == pytest.approx(0.25 * alone.volume, abs=1e-9)


def test_bodies_of_one_mesh_that_overlap():
    """A hull of two boxes that overlap: once joined, the common part counts once."""
    surface, body = box_body(((0, -2, 0), (10, 2, 3)), ((8, -1, 1), (12, 1, 2)))
    assert body.immersion(UP, 2.5).volume == pytest.approx(100 + 8, abs=1e-9)
    body.join([])
    found = body.immersion(UP, 2.5)
    assert found.volume == pytest.approx(100 + 4, abs=1e-9)
    assert found.wetted_surface == pytest.approx(40 + 28 * 2.5 + 2 * (2 + 1) * 2, abs=1e-9)
    surface.set_points(surface.mesh.points + (0.0, 0.0, 0.25))
    body.update()
    assert body.immersion(UP, 2.75).volume == pytest.approx(104, abs=1e-9)


@pytest.mark.parametrize(
    "corners",
    [
        [(9, -1, 0.5), (11, -1, 0.5), (11, -1, 2.5), (9, -1, 2.5)],  # square to an axis
        [(9, -1.1, 0.5), (11, -0.9, 0.5), (11, -0.7, 2.5), (9, -0.9, 2.5)],
    ],
)
def test_sheets_among_the_hull_s_bodies_have_no_volume(corners):
    """A flat fin through the transom: what is joined counts as it does without the fin."""
    box = boxes(((0, -BEAM / 2, 0), (LENGTH, BEAM / 2, DEPTH)))
    points = np.concatenate([np.array(box.points), corners])
    sizes, faces = np.array(box.face_sizes), np.array(box.face_vertices)
    creases = np.concatenate(
        [np.array(box.creases), 8 + np.array([[0, 1], [1, 2], [2, 3], [0, 3]])]
    )
    mesh = hn.ControlMesh(
        points, np.append(sizes, 4), np.append(faces, 8 + np.arange(4)),
        creases=creases, corners=np.arange(12),
    )  # fmt: skip
    surface = hn.LimitSurface(mesh)
    body = hn.HullBody(surface, mirrored=False)
    _, bare = box_hull()
    for appendages in ([], [hn.cylinder(**TUNNEL)]):
        body.join(appendages)
        bare.join(appendages)
        assert body.joined_volume == pytest.approx(bare.joined_volume, abs=1e-9)


def test_many_bodies_of_a_hull():
    """Three hundred boxes side by side, and a tunnel through one: that patches are there does not
    count as surfaces that lie in one another."""
    ends = [((2 * i, 2 * j, 0), (2 * i + 1, 2 * j + 1, 1)) for i in range(15) for j in range(20)]
    _, body = box_body(*ends)
    body.join([])
    assert body.joined_volume == 0.0
    body.join([hn.cylinder((0.5, -0.1, 0.5), (0.5, 1.1, 0.5), 0.2, cut=True)])
    assert body.joined_volume == pytest.approx(-math.pi * 0.04, abs=1e-9)


def test_foils_have_finite_thicknesses():
    for which in ("root_thickness", "tip_thickness"):
        for thickness in (math.inf, math.nan, -0.1):
            with pytest.raises(ValueError, match="(root|tip)'s thickness"):
                hn.foil("0012", (6, 0, 0), (6, 0, -1), 2.0, **{which: thickness})


def test_surfaces_in_one_another_are_refused():
    _, body = box_hull()
    with pytest.raises(ValueError, match="lie in one another"):
        body.join([hn.foil("0012", (6, 0, 0), (6, 0, -1), 2.0)])
    assert body.joined_volume is None


@pytest.mark.parametrize(
    "name, keel",
    [
        # Through the yacht's own keel, at small angles; sharp trailing edges.
        ("sailing_yacht", {"section": "63-012", "root": (7.0, 0, 1.2), "tip": (6.7, 0, -0.6),
                           "root_chord": 2.0, "tip_chord": 1.5}),
        ("naval_vessel", {"section": "0012", "root": (60.0, 0, 1.5), "tip": (59.0, 0, -1.5),
                          "root_chord": 8.0, "tip_chord": 6.0}),
    ],
)  # fmt: skip
def test_union_with_a_sample(name, keel):
    """Inclusion and exclusion: what the keel adds and what it shares are its volume."""
    body, changes = Sample(name).body, {}
    for cut in (False, True):
        body.join([hn.foil(**keel, cut=cut)])
        changes[cut] = body.joined_volume
    own = hn.foil(**keel).volume
    assert 0.0 < -changes[True] < own
    assert changes[False] - changes[True] == pytest.approx(own, rel=1e-9)


def test_thruster_of_a_sample_by_rays():
    """The coaster's tunnel: what it takes off is the integral of chords over the circle."""
    sample = Sample("coaster")
    x, z, radius = 0.93 * sample.ship.length_pp, 2.0, 0.7
    tree = hn.SurfaceTree(sample.surface)
    rule, weights = np.polynomial.legendre.leggauss(24)
    around = (np.arange(48) + 0.5) * (2 * math.pi / 48)
    total = 0.0
    for node, weight in zip(rule, weights):
        r = radius * 0.5 * (node + 1)
        places = np.stack([x + r * np.cos(around), z + r * np.sin(around)], axis=-1)
        # The port half, from the centre plane on.
        widths = [tree.all_ray_hits((px, -1e-9, pz), (0, 1, 0)).distances[-1] for px, pz in places]
        total += weight * 0.5 * radius * r * np.mean(widths) * 2 * math.pi
    body = sample.body
    before = whole_volume(body)
    reach = 0.6 * sample.ship.beam
    body.join([hn.cylinder((x, -reach, z), (x, reach, z), radius, cut=True)])
    assert before - whole_volume(body) == pytest.approx(2 * total, rel=1e-6)
    assert body.joined_volume == pytest.approx(whole_volume(body) - before, rel=1e-9)
