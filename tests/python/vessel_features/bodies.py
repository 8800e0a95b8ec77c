# SPDX-License-Identifier: GPL-3.0-or-later
"""Separate bodies: canoe body, keel, rudder, demihull."""

from dataclasses import replace

import numpy as np

from .form import SAME, Form


def bodies(data):
    """For each body that hangs together: the numbers of its faces."""
    body = np.arange(len(data.points))
    corners = [np.array(face) for face in data.faces]
    changed = True
    while changed:
        before = body.copy()
        for face in corners:
            body[face] = body[face].min()
        changed = (body != before).any()
    of_face = np.array([body[face[0]] for face in corners])
    return [np.flatnonzero(of_face == number) for number in np.unique(of_face)]


def separate(form, *layers):
    """The layers are one body and all of it; its faces."""
    faces = np.sort(np.concatenate([form.faces_of(layer) for layer in layers]))
    assert any(
        np.array_equal(faces, body) for body in bodies(form.data)
    ), f"layers {', '.join(layers)} are no body of their own"
    return faces


def alone(form, faces):
    """The Form of some faces without the others."""
    data = form.data
    used = np.unique(np.concatenate([data.faces[face] for face in faces]))
    new = {int(vertex): number for number, vertex in enumerate(used)}
    part = replace(
        data,
        points=np.array(data.points)[used],
        faces=[[new[vertex] for vertex in data.faces[face]] for face in faces],
        face_layers=[data.face_layers[face] for face in faces],
        creases=[(new[a], new[b]) for a, b in data.creases if a in new and b in new],
        corners=[new[vertex] for vertex in data.corners if vertex in new],
        deck_edge=[],
        flats=[],
    )
    return Form(part)


def openings(form, faces):
    """Points of a body's borders that are not in the centre plane, of the exact surface."""
    own = {vertex for face in faces for vertex in form.data.faces[face]}
    lines = [line for line in form.lines if line.kind == "border" and line.vertices[0] in own]
    points = np.vstack([line.evaluate(np.linspace(0.0, line.edge_count, 33))[0] for line in lines])
    return points[~form.on_centre(points)]


def canoe_body(form):
    """A body of shell and transom that is open at the deck alone, without keel and rudder."""
    open_at = openings(form, separate(form, "Shell", "Transom"))
    assert open_at[:, 2].min() > form.given.draft, "open below the water"
    assert np.ptp(open_at[:, 0]) > 0.95 * form.given.length_pp, "not open along the deck"


def fin_keel_with_bulb(form, layer="Keel"):
    """A body that is open at its top alone, which is within the canoe body; a bulb thicker than
    the fin, a knuckle where they meet."""
    faces = separate(form, layer)
    open_at = openings(form, faces)
    assert np.ptp(open_at[:, 2]) < 0.02 * form.given.draft, "open elsewhere than at its top"
    canoe = alone(form, separate(form, "Shell", "Transom"))
    above = open_at[:, 2] - [canoe.bottoms(x, y)[0] for x, y, _ in open_at]
    assert above.min() > 0.0, f"the fin's top is {-above.min():.3f} m below the canoe body"
    x, top = open_at[:, 0].mean(), open_at[:, 2].min()
    breadths = form.breadths(x, np.linspace(0.01, 0.95, 200) * top)
    half_down = breadths[100:].max()
    assert breadths[:100].max() > 2.0 * half_down, "the bulb is no thicker than the fin"
    length = np.ptp(form.points_of(faces)[:, 0])
    chord = np.ptp(open_at[:, 0])
    assert length > 1.5 * chord, f"a bulb {length:.2f} m long at a fin of {chord:.2f} m"
    joints = [
        knuckle
        for knuckle in form.knuckles
        if set(knuckle.curve.vertices) <= {v for f in faces for v in form.data.faces[f]}
    ]
    assert joints and min(joint.angles.min() for joint in joints) > 30.0, "no edge at the bulb"


def spade_rudder(form, layer="Rudder"):
    """A body aft, closed but for the centre plane, plane below and thin."""
    faces = separate(form, layer)
    assert len(openings(form, faces)) == 0, "the rudder is open"
    points = form.points_of(faces)
    low, high = points.min(axis=0), points.max(axis=0)
    assert high[0] < 0.2 * form.given.length_pp, "the rudder is not aft"
    span, chord = high[2] - low[2], high[0] - low[0]
    assert span > chord and high[1] < 0.15 * chord, f"span {span:.2f}, half breadth {high[1]:.3f}"
    assert form.in_plane((0.0, 0.0, -1.0), -low[2]), "the rudder's foot is not plane"
    canoe = alone(form, separate(form, "Shell", "Transom"))
    gaps = [canoe.bottoms(x, y + SAME * form.size)[0] - z for x, y, z in points]
    assert 0.0 < min(gaps) < 0.05 * span, f"{min(gaps):.3f} m between rudder and canoe body"


def demihull(form, centre):
    """One slender body beside the centre plane, symmetric about a plane of its own."""
    assert len(bodies(form.data)) == 1
    assert form.low[1] > 0.1 * form.given.beam, "the demihull comes to the centre plane"
    assert form.high[0] - form.low[0] > 6.0 * (form.high[1] - form.low[1]), "not slender"
    for part in (0.1, 0.3, 0.5, 0.7, 0.9):
        heights = np.linspace(0.2, 2.0, 30) * form.given.draft
        outer = form.breadths(part * form.given.length_pp, heights)
        inner = form.inner_breadths(part * form.given.length_pp, heights)
        away = np.nanmax(np.abs(0.5 * (outer + inner) - centre))
        assert away < SAME * form.size, f"{away:.2e} m from symmetric at {part} of the length"
