# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers of a hull's form by name, and their derivatives by the control points: values are those
of hydrostatics(), derivatives agree with differences on all samples."""

from pathlib import Path

import hull_io
import hull_native as hn
import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[2]
SAMPLES = sorted(path.name.split(".")[0] for path in (ROOT / "samples").glob("*.hull.json"))
SEED = 20261123
# Differences of fourth order with steps of these parts of the size: with the large one an edge of a
# transom may dip meanwhile, with the small one rounding counts, most in areas of sections. What the
# better one leaves, in parts of what a shift may change the number by.
DIFFERENCES = 1e-8
STEPS = (1e-4, 1e-6)
# Extents go over from one farthest point to another while they are looked at with other points, and
# so does the largest section where there is a parallel body.
CHOSEN = ("waterline_length", "waterline_beam", "immersed", "largest")


class Sample:
    def __init__(self, name):
        data = hull_io.read_hull(ROOT / "samples" / f"{name}.hull.json")
        shell = hull_io.shell_arrays(data)
        self.surface = hn.LimitSurface(hn.ControlMesh(*shell.arguments()))
        particulars = data.particulars
        self.dimensions = {
            "length_pp": particulars.length_pp,
            "beam": particulars.beam,
            "design_draft": particulars.draft,
        }
        self.draft = particulars.draft
        self.half = data.half
        self.body = hn.HullBody(self.surface, mirrored=data.half)
        self.derivatives = hn.BodyDerivatives(self.body)
        self.size = np.linalg.norm(np.ptp(self.surface.mesh.points, axis=0))

    def numbers(self, trim=0.0):
        return hn.FormNumbers(self.derivatives, draft=self.draft, trim=trim, **self.dimensions)

    def hydrostatics(self, trim=0.0):
        return hn.hydrostatics(self.body, draft=self.draft, trim=trim, **self.dimensions)

    def smooth_shifts(self, random):
        """(n, 3): fields with the hull's own length, that keep the centre plane."""
        points = self.surface.mesh.points
        places = (points - points.min(axis=0)) / np.ptp(points, axis=0).max()
        shifts = np.zeros_like(points)
        for axis in range(3):
            waves = random.normal(0, 2, (3, 3))
            shifts[:, axis] = np.sin(places @ waves.T + random.uniform(0, 6, 3)).sum(axis=1)
        shifts[:, 1] *= np.clip(np.abs(points[:, 1]) / (0.1 * np.ptp(points[:, 1])), 0, 1)
        return shifts

    def differences(self, shifts, measured):
        """(steps, …)"""
        return np.array([self.difference(shifts, measured, s * self.size) for s in STEPS])

    def difference(self, shifts, measured, step):
        points = self.surface.mesh.points.copy()

        def at(t):
            self.surface.set_points(points + t * shifts)
            self.body.update()
            return measured()

        slope = (8 * (at(step) - at(-step)) - (at(2 * step) - at(-2 * step))) / (12 * step)
        self.surface.set_points(points)
        self.body.update()
        return slope


def of_hydrostatics(hydrostatics, name):
    for part in name.split("."):
        hydrostatics = getattr(hydrostatics, part)
    return hydrostatics


@pytest.mark.parametrize("name", SAMPLES)
def test_values_are_those_of_hydrostatics(name):
    sample = Sample(name)
    for trim in (0.0, 0.01):
        numbers, hydrostatics = sample.numbers(trim), sample.hydrostatics(trim)
        for number in hn.FORM_NUMBERS:
            expected = of_hydrostatics(hydrostatics, number)
            assert numbers.value(number) == pytest.approx(expected, rel=1e-12, abs=1e-12), number


@pytest.mark.parametrize("name", SAMPLES)
def test_derivatives_agree_with_differences(name):
    sample = Sample(name)
    random = np.random.default_rng([SEED, SAMPLES.index(name)])
    shifts = sample.smooth_shifts(random)
    numbers = sample.numbers()
    names = [n for n in hn.FORM_NUMBERS if not n.startswith(CHOSEN)]
    gradients = np.array([numbers.gradient(n) for n in names])
    slopes = sample.differences(
        shifts, lambda: np.array([sample.numbers().value(n) for n in names])
    )
    for n, gradient, found in zip(names, gradients, slopes.T):
        most = np.abs(gradient * shifts).sum()
        assert np.abs((gradient * shifts).sum() - found).min() <= DIFFERENCES * most, (SEED, n)


@pytest.mark.parametrize("name", SAMPLES)
def test_section_areas_have_their_derivatives(name):
    sample = Sample(name)
    random = np.random.default_rng([SEED, 100 + SAMPLES.index(name)])
    shifts = sample.smooth_shifts(random)
    for share in random.uniform(0.1, 0.9, 5):
        x = share * sample.dimensions["length_pp"]
        gradient = sample.numbers().section_area_gradient(x)
        slopes = sample.differences(shifts, lambda: sample.numbers().section_area(x))
        most = max(np.abs(gradient * shifts).sum(), sample.size)
        assert np.abs((gradient * shifts).sum() - slopes).min() <= DIFFERENCES * most


def test_the_largest_section_has_the_derivatives_of_the_station_there():
    sample = Sample("naval_vessel")
    numbers = sample.numbers()
    x = sample.hydrostatics().largest_section.position
    assert np.array_equal(
        numbers.gradient("largest_section.area"), numbers.section_area_gradient(x)
    )


def test_extents_have_the_derivatives_of_their_ends():
    """The yacht has no flats: each end is a single point, which stays the farthest."""
    sample = Sample("sailing_yacht")
    shifts = sample.smooth_shifts(np.random.default_rng([SEED, 200]))
    for name in ("waterline_length", "waterline_beam", "immersed_draft"):
        gradient = sample.numbers().gradient(name)
        slope = sample.difference(shifts, lambda: sample.numbers().value(name), 1e-5 * sample.size)
        # Extents are known to 1e-10 of the size, which the step makes 1e-5 of.
        assert (gradient * shifts).sum() == pytest.approx(slope, abs=3e-5), name
