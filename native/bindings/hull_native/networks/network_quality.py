# SPDX-License-Identifier: GPL-3.0-or-later
"""How good the surface of a network is, and what it is afloat."""

from dataclasses import dataclass

import numpy as np

from .._core import PatchBody, tolerances

# Of an edge between two patches: places at which their normals are compared, none of which is an
# inner knot of few equal spans.
_SEAM_PLACES = (np.arange(11) + 0.5) / 11
# Degrees: seams that are smooth to less are not named; of those that are not, so many are told.
_ROUGH, _TOLD = 1.0, 3


@dataclass(frozen=True)
class NetworkReport:
    """Of NetworkPatches, in metres and degrees. curve_errors: pairs (name, how far the surface is
    from the curve at most), the largest first; spoke_error: the largest of what borders within
    regions are off; gap: between patches that share an edge; seam_angle: the largest between
    normals of patches at smooth edges, at seam_place (3,); rough_seams: tuples (curve's name,
    angle, place (3,)), the largest first, of curves along which one is above 1 degree, None for the
    name within regions; open_regions, loose_regions, missed_curves: how many are named in
    NetworkPatches.problems."""

    patches: int
    curve_errors: tuple
    spoke_error: float
    gap: float
    seam_angle: float
    seam_place: tuple
    rough_seams: tuple
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
        told += self._rough_lines()
        for count, what in (
            (self.open_regions, "regions left open"),
            (self.loose_regions, "regions not everywhere smooth"),
            (self.missed_curves, "curves missed"),
        ):
            if count:
                told.append(f"{count} {what}")
        return told

    def _rough_lines(self):
        """Which seams turn, and what helps."""
        if not self.rough_seams:
            return []
        told = []
        for name, angle, place in self.rough_seams[:_TOLD]:
            at = ", ".join(f"{value:.2f}" for value in place)
            told.append(f"{name or 'a border within a region'} by {angle:.2g}° at {at} m")
        more = len(self.rough_seams) - len(told)
        return [
            f"Not smooth along {'; '.join(told)}" + (f"; and {more} more" if more else ""),
            "Curves nearly meet there: bring them to one point, or leave one out",
        ]


def network_report(network, made):
    """The NetworkReport of a CurveNetwork and its NetworkPatches."""
    names = [curve.name for curve in network.curves]
    errors = sorted(zip(names, made.curve_errors.tolist()), key=lambda one: -one[1])
    seams = _seams(made, set(network.crease_edges))
    angle, place, _ = max(seams, key=lambda seam: seam[0], default=(0.0, (0.0, 0.0, 0.0), -1))
    kinds = [problem.kind for problem in made.problems]
    return NetworkReport(
        made.patches.patch_count,
        tuple(errors),
        made.spoke_error,
        made.patches.largest_gap,
        angle,
        place,
        _rough(seams, names, np.asarray(network.edge_curves)),
        kinds.count("open_region"),
        kinds.count("loose_region"),
        kinds.count("missed_curve"),
    )


def _rough(seams, names, curves):
    """rough_seams of a NetworkReport, of which a curve has one."""
    worst = {}
    for angle, place, edge in seams:
        name = names[curves[edge]] if edge >= 0 else None
        if angle > max(_ROUGH, worst.get(name, (0.0,))[0]):
            worst[name] = (angle, place)
    found = [(name, angle, place) for name, (angle, place) in worst.items()]
    return tuple(sorted(found, key=lambda seam: -seam[1]))


def _seams(made, creases):
    """[(degrees, place, the network's edge or -1)] of edges that are smooth: the largest angle
    between normals on both sides."""
    owners = made.edges.tolist()
    uses = {}
    for patch, sides in enumerate(made.patches.sides):
        for side, parts in enumerate(sides):
            for edge, begin, end in parts:
                if owners[edge] not in creases:
                    uses.setdefault(edge, []).append((patch, side, begin, end))
    seams = {edge: two for edge, two in uses.items() if len(two) == 2}
    if not seams:
        return []
    (one, points), (other, _) = (
        _normals(made.patches, [two[k] for two in seams.values()], is_reversed=k == 1)
        for k in (0, 1)
    )
    angles = np.arctan2(
        np.linalg.norm(np.cross(one, other), axis=-1), np.einsum("ij,ij->i", one, other)
    ).reshape(len(seams), -1)
    places = points.reshape(len(seams), -1, 3)
    worst = angles.argmax(axis=1)
    return [
        (float(np.degrees(angles[i, k])), tuple(places[i, k].tolist()), owners[edge])
        for i, (edge, k) in enumerate(zip(seams, worst.tolist()))
    ]


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
    size = np.linalg.norm(np.ptp(nodes, axis=0))
    is_half = nodes[:, 1].min() > -tolerances.ON_CENTRE_PLANE * size
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
