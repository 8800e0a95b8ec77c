# SPDX-License-Identifier: GPL-3.0-or-later
"""Sections as plain text, from aft forward, for PIAS and other programs that know hulls by frames.

    name
    length between perpendiculars, beam, draft
    how many frames
    for each frame:  x  how many points
    for each point:  half-breadth  height  1 on a knuckle, else 0

Points run upwards from the centre plane, as frames are entered there; metres, blanks between
numbers. The layout is this project's own, in the order in which PIAS asks for frames.
"""

from .numbers_as_text import decimal, plain_name


def section_text(stations):
    """The text of a Stations."""
    sizes = (stations.length_pp, stations.beam, stations.draft)
    rows = [
        plain_name(stations.name),
        " ".join(decimal(size) for size in sizes),
        str(len(stations.lines)),
    ]
    for line in sorted(stations.lines, key=lambda line: line.x):
        rows.append(f"{decimal(line.x)} {len(line.points)}")
        for (y, z), knuckle in zip(line.points.tolist(), line.knuckles.tolist()):
            rows.append(f"{decimal(y)} {decimal(z)} {int(knuckle)}")
    return "\n".join(rows) + "\n"
