# SPDX-License-Identifier: GPL-3.0-or-later
"""How good the surface of a network is, and what it is afloat."""

from dataclasses import dataclass

import numpy as np

from ._core import PatchBody

# Of an edge between two patches: places at which their normals are compared, none of which is an
# inner knot of few equal spans.
_SEAM_PLACES = (np.arange(11) + 0.5) / 11
# Of the size: a network all of which is to port of the centre plane, but for this, is half a hull.
_CENTRE = 1e-6


@dataclass(frozen=True)
class NetworkReport:
    """Of NetworkPatches, in metres and degrees. curve_errors: pairs (name, how far the surface is
    from the curve at most), the largest first; spoke_error: the largest of what borders within
    regions are off; gap: between patches that share an edge; seam_angle: the largest between
    normals of patches at smooth edges, at seam_place (3,); open_regions, loose_regions,
    missed_curves: how many are named in NetworkPatches.problems."""

    patches: int
    curve_errors: tuple
    spoke_error: float
    gap: float
    seam_angle: float
    seam_place: tuple
    open_regions: int
    loose_regions: int
    missed_curves: int

    def lines(self):
        """What a person is told, a line each."""
        told = [f"{self.patches} patches"]
        if self.curve_errors:
            name, error = self.curve_errors[0]
            told.append(f"Curves met within {1e3 * error:.3g} mm ({name})")
        told.append(f"Largest gap {1e3 * self.gap:.1g} mm")
        place = ", ".join(f"{value:.2f}" for value in self.seam_place)
        told.append(f"Seams smooth to {self.seam_angle:.2g}° (worst at {place} m)")
        for count, what in (
            (self.open_regions, "regions left open"),
            (self.loose_regions, "regions not everywhere smooth"),
            (self.missed_curves, "curves missed"),
        ):
            if count:
                told.append(f"{count} {what}")
        return told


def network_report(network, made):
    """The NetworkReport of a CurveNetwork and its NetworkPatches."""
    names = [curve.name for curve in network.curves]
    errors = sorted(zip(names, made.curve_errors.tolist()), key=lambda one: -one[1])
    angle, place = _worst_seam(made, set(network.crease_edges))
    kinds = [problem.kind for problem in made.problems]
    return NetworkReport(
        made.patches.patch_count,
        tuple(errors),
        made.spoke_error,
        made.patches.largest_gap,
        angle,
        place,
        kinds.count("open_region"),
        kinds.count("loose_region"),
        kinds.count("missed_curve"),
    )


def _worst_seam(made, creases):
    """(degrees, place) of the largest angle between normals on both sides of edges that are
    smooth."""
    owners = made.edges.tolist()
    uses = {}
    for patch, sides in enumerate(made.patches.sides):
        for side, parts in enumerate(sides):
            for edge, begin, end in parts:
                if owners[edge] not in creases:
                    uses.setdefault(edge, []).append((patch, side, begin, end))
    seams = [two for two in uses.values() if len(two) == 2]
    if not seams:
        return 0.0, (0.0, 0.0, 0.0)
    (one, points), (other, _) = (
        _normals(made.patches, [two[k] for two in seams], is_reversed=k == 1) for k in (0, 1)
    )
    angles = np.arctan2(
        np.linalg.norm(np.cross(one, other), axis=-1), np.einsum("ij,ij->i", one, other)
    )
    worst = int(np.argmax(angles))
    return float(np.degrees(angles[worst])), tuple(points[worst].tolist())


def _normals(patches, uses, is_reversed):
    """((k, 3) unit normals, (k, 3) points) along parts of sides of patches, part after part."""
    numbers, places = [], []
    shares = 1.0 - _SEAM_PLACES if is_reversed else _SEAM_PLACES
    for patch, side, begin, end in uses:
        t = begin + shares * (end - begin)
        zero, one = np.zeros_like(t), np.ones_like(t)
        u, v = ((t, zero), (one, t), (1.0 - t, one), (zero, 1.0 - t))[side]
        numbers.append(np.full(len(t), patch))
        places.append(np.stack([u, v], axis=1))
    points, by_u, by_v, *_ = patches.evaluate(np.concatenate(numbers), np.concatenate(places))
    normals = np.cross(by_u, by_v)
    lengths = np.linalg.norm(normals, axis=1, keepdims=True)
    return normals / np.where(lengths > 0.0, lengths, 1.0), points


def network_immersion(network, made, draft):
    """The Immersion of a network's surface upright at a draft, m; that of half a hull counts twice.
    ValueError as PatchBody raises."""
    nodes = np.asarray(network.nodes)
    is_half = nodes[:, 1].min() > -_CENTRE * np.ptp(nodes, axis=0).max()
    return PatchBody(made.patches, mirrored=bool(is_half)).immersion((0.0, 0.0, 1.0), draft)


def immersion_lines(afloat):
    """What a person is told of an Immersion upright, a line each."""
    volume = afloat.volume
    if not volume > 0.0:
        return ["Nothing is immersed"]
    x, _, z = afloat.centre_of_buoyancy
    told = [
        f"Displaced volume {volume:.3f} m³",
        f"Centre of buoyancy {x:.3f}, {z:.3f} m",
        f"Wetted surface {afloat.wetted_surface:.2f} m²",
    ]
    if afloat.waterplane_area > 0.0:
        across, along = afloat.waterplane_second[1, 1], afloat.waterplane_second[0, 0]
        told += [
            f"Waterplane {afloat.waterplane_area:.2f} m², its centre at "
            f"{afloat.centre_of_flotation[0]:.3f} m",
            f"KM {z + across / volume:.3f} m, longitudinal {z + along / volume:.2f} m",
        ]
    return told
