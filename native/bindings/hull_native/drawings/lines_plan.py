# SPDX-License-Identifier: GPL-3.0-or-later
"""The lines plan with positions as people give them: one by one or by a spacing, in m or frames."""

from math import ceil, floor, pi

import numpy as np

from .._drawing import write_lines_plan

# A spacing that would give more lines than this is a slip of the keyboard.
MOST_LINES = 400
VIEWS = ("profile", "half_breadth", "body_plan")


def line_positions(given, low, high, *, name="lines", with_ends=False):
    """Positions (n,) from what a user gives: None for none, (n,) as they are, or one number.

    One number is a spacing: its multiples between low and high, which themselves count only
    with_ends.
    """
    if given is None:
        return np.empty(0)
    if np.ndim(given) > 0:
        return np.asarray(given, dtype=float)
    spacing = float(given)
    if not (np.isfinite(spacing) and spacing > 0.0):
        raise ValueError(f"The spacing of {name} must be above zero, not {spacing}.")
    if (high - low) / spacing > MOST_LINES:
        raise ValueError(
            f"A spacing of {spacing:.4g} gives more than {MOST_LINES} {name}: widen it."
        )
    margin = 1e-6 * spacing * (-1.0 if with_ends else 1.0)
    first = floor((low + margin) / spacing) + 1
    last = ceil((high - margin) / spacing) - 1
    return spacing * np.arange(first, last + 1)


def write_lines_drawing(
    surface,
    path,
    *,
    mirrored,
    stations=None,
    waterlines=None,
    buttocks=None,
    diagonals=(),
    diagonal_angle=0.25 * pi,
    stations_in="m",
    draft=None,
    length=None,
    station_spacing=None,
    frame_spacing=None,
    frames=None,
    offsets=True,
    title="",
    title_block=(),
    particulars=(),
    paper="A3",
    scale=None,
    dxf_unit="m",
    tolerance=None,
    views=VIEWS,
    lengths_in="m",
    progress=None,
):
    """Draw the lines plan of a LimitSurface on one sheet; path ends in .pdf, .svg, .png or .dxf.

    stations (x), waterlines (z) and buttocks (y >= 0): (n,) positions in m in any order, or one
    number, their spacing. stations_in="frames" takes stations as numbers of frames of
    frame_spacing (m), or of a FrameTable (frames), and names them so. diagonals: pairs of the
    height at the centre plane (m) and the angle below the horizontal (rad), or one number, the
    spacing of heights at diagonal_angle. Lines beyond the hull are left out.

    mirrored: the surface is the half y >= 0. draft (m) adds the design waterline; length (m,
    between perpendiculars from x = 0) AP, FP and midship; frame_spacing the frames, frame 0 at
    x = 0, or frames, by its ranges, in place of those. A station's number is its x in units of
    station_spacing (m; default: the stations' distance, where all are multiples of it). offsets:
    the table of offsets is drawn too.

    title_block: up to 8 pairs (name, value) of texts below the title; particulars: up to 16.
    paper: "A4" to "A0", or (width, height) in mm. scale: 100 for 1:100; by default the largest of
    1:10, 12.5, 20, 25, 30, 50, 75, 100, ... that fits. dxf_unit: "m" or "mm", of a DXF file, which
    is at true size. tolerance (m): how far the curves may be from the surface's; by default as far
    as the paper does not show, and 1e-6 of the hull's size for the splines of DXF. views: those of
    VIEWS that are drawn, one at least. lengths_in: "m", or "ft" for a plan that tells places in
    decimal feet and offsets in feet, inches and eighths (5-3-4+: and a sixteenth); what is given is
    in m all the same. progress: a callable that takes the share done, 0 to 1; what it raises ends
    the work.

    The file is complete, or one of the same name is untouched. Raises ValueError if nothing can be
    drawn, the plan does not fit the paper at the scale, or lines would run together; OSError if the
    file can't be written.
    """
    low, high = surface.mesh.points.min(axis=0), surface.mesh.points.max(axis=0)
    unit = 1.0
    if stations_in == "frames" and frames is not None:
        numbers = stations
        if np.ndim(stations) == 0:
            numbers = line_positions(
                stations, frames.numbers[0], frames.numbers[-1], name="stations", with_ends=True
            )
        stations = frames.places(numbers)
    elif stations_in == "frames":
        if frame_spacing is None or not frame_spacing > 0.0:
            raise ValueError("Stations in frames need a frame_spacing above zero.")
        unit = frame_spacing
        station_spacing = frame_spacing if station_spacing is None else station_spacing
    elif stations_in != "m":
        raise ValueError(f'stations_in is "m" or "frames", not "{stations_in}".')
    aft = min(low[0], 0.0 if length else low[0]) / unit
    fore = max(high[0], length or high[0]) / unit
    if np.ndim(diagonals) == 0:
        heights = line_positions(diagonals, low[2], high[2], name="diagonals")
        diagonals = [(height, diagonal_angle) for height in heights]
    write_lines_plan(
        surface,
        path,
        stations=unit * line_positions(stations, aft, fore, name="stations", with_ends=True),
        waterlines=line_positions(waterlines, low[2], high[2], name="waterlines"),
        buttocks=line_positions(buttocks, 0.0, max(-low[1], high[1]), name="buttocks"),
        diagonals=[tuple(pair) for pair in diagonals],
        mirrored=mirrored,
        draft=draft,
        length=length,
        station_spacing=station_spacing,
        frame_spacing=frame_spacing,
        frames=None if frames is None else _drawn_frames(frames),
        in_frames=stations_in == "frames",
        offsets=offsets,
        title=title,
        title_rows=list(title_block),
        particulars=list(particulars),
        paper=paper,
        scale=scale,
        dxf_unit=dxf_unit,
        tolerance=tolerance,
        views=list(views),
        lengths_in=lengths_in,
        progress=progress,
    )


def _drawn_frames(table):
    return int(table.numbers[0]), table.positions.tolist(), list(table.names)
