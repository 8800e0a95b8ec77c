# SPDX-License-Identifier: GPL-3.0-or-later
"""NACA's 6-series with camber, 6A-series, reflexed and modified sections: published ordinates (NACA
Reports 824 and 903; Abbott & Doenhoff 1959), per cent of the chord, and the theory of thin
aerofoils."""

import hull_native as hn
import numpy as np
import pytest
from scipy.integrate import quad

STATIONS = [0.5, 0.75, 1.25, 2.5, 5, 7.5, *range(10, 100, 5)]
# Upper and lower ordinates as published, at these stations of the mean line.
CAMBERED = {
    "63-412": (
        [1.071, 1.320, 1.719, 2.460, 3.544, 4.379, 5.063, 6.138, 6.929, 7.499, 7.872, 8.059,
         8.062, 7.894, 7.567, 7.125, 6.562, 5.899, 5.153, 4.344, 3.492, 2.618, 1.739, 0.881],
        [-0.871, -1.040, -1.291, -1.716, -2.280, -2.685, -2.995, -3.446, -3.745, -3.919, -3.984,
         -3.939, -3.778, -3.514, -3.164, -2.745, -2.278, -1.799, -1.265, -0.764, -0.308, 0.074,
         0.329, 0.330],
    ),
    "63-415": (
        [1.287, 1.585, 2.074, 2.964, 4.264, 5.261, 6.077, 7.348, 8.279, 8.941, 9.362, 9.559,
         9.527, 9.289, 8.871, 8.298, 7.595, 6.780, 5.877, 4.907, 3.900, 2.885, 1.884, 0.931],
        [-1.087, -1.305, -1.646, -2.220, -3.000, -3.565, -4.009, -4.656, -5.095, -5.361, -5.474,
         -5.439, -5.243, -4.909, -4.459, -3.918, -3.311, -2.660, -1.989, -1.327, -0.716, -0.193,
         0.184, 0.333],
    ),
    "64-215": (
        [1.254, 1.522, 1.945, 2.710, 3.816, 4.661, 5.356, 6.456, 7.274, 7.879, 8.290, 8.512,
         8.544, 8.319, 7.913, 7.361, 6.691, 5.925, 5.085, 4.191, 3.267, 2.349, 1.466, 0.662],
        [-1.154, -1.382, -1.731, -2.338, -3.184, -3.813, -4.322, -5.110, -5.682, -6.089, -6.346,
         -6.452, -6.402, -6.129, -5.707, -5.171, -4.549, -3.865, -3.141, -2.401, -1.675, -1.003,
         -0.432, -0.030],
    ),
    "65-218": (
        [1.382, 1.673, 2.116, 2.932, 4.178, 5.153, 5.971, 7.276, 8.270, 9.023, 9.566, 9.916,
         10.070, 9.996, 9.671, 9.103, 8.338, 7.425, 6.398, 5.290, 4.133, 2.967, 1.835, 0.805],
        [-1.282, -1.533, -1.902, -2.560, -3.546, -4.305, -4.937, -5.930, -6.676, -7.233, -7.622,
         -7.856, -7.928, -7.806, -7.465, -6.913, -6.196, -5.365, -4.454, -3.500, -2.541, -1.621,
         -0.801, -0.173],
    ),
    "65-221": (
        [1.567, 1.902, 2.402, 3.335, 4.783, 5.918, 6.865, 8.370, 9.514, 10.381, 11.007, 11.404,
         11.570, 11.461, 11.055, 10.372, 9.461, 8.390, 7.195, 5.918, 4.595, 3.270, 2.000, 0.861],
        [-1.467, -1.762, -2.188, -2.963, -4.151, -5.070, -5.831, -7.024, -7.922, -8.591, -9.063,
         -9.344, -9.428, -9.271, -8.849, -8.182, -7.319, -6.330, -5.251, -4.128, -3.003, -1.924,
         -0.966, -0.229],
    ),
}  # fmt: skip
# Slips of the copy at hand, by half thickness and mean line of the same publication: of 63-412
# 7.567 at 50 % upper, -1.799 at 65 % and 0.330 at 95 % lower, figures exchanged or alike. Two more
# are 0.0022 and 0.0018 off.
SLIPS = {("63-412", 50, 0), ("63-412", 65, 1), ("63-412", 95, 1), ("63-412", 7.5, 1),
         ("65-218", 20, 1)}  # fmt: skip
# (x, y) of 65-415 a=0.5, upper and lower side.
UPPER_65_415 = [
    (0.245, 1.233), (0.464, 1.520), (0.927, 1.965), (2.126, 2.812), (4.574, 4.099), (7.054, 5.122),
    (9.549, 5.985), (14.568, 7.386), (19.611, 8.459), (24.671, 9.280), (29.743, 9.883),
    (34.825, 10.280), (39.916, 10.470), (45.019, 10.423), (50.152, 10.106), (55.262, 9.501),
    (60.307, 8.672), (65.314, 7.684), (70.294, 6.573), (75.253, 5.387), (80.199, 4.157),
    (85.137, 2.930), (90.077, 1.755), (95.027, 0.715),
]  # fmt: skip
LOWER_65_415 = [
    (0.755, -0.957), (1.036, -1.132), (1.573, -1.377), (2.874, -1.776), (5.426, -2.335),
    (7.946, -2.746), (10.451, -3.081), (15.432, -3.591), (20.389, -3.963), (25.329, -4.232),
    (30.257, -4.411), (35.175, -4.508), (40.084, -4.526), (44.981, -4.431), (49.848, -4.226),
    (54.738, -3.929), (59.693, -3.548), (64.686, -3.104), (69.706, -2.609), (74.747, -2.083),
    (79.801, -1.545), (84.863, -1.014), (89.923, -0.527), (94.973, -0.139),
]  # fmt: skip
SYMMETRIC = {
    "64-015": [1.208, 1.456, 1.842, 2.528, 3.504, 4.240, 4.842, 5.785, 6.480, 6.985, 7.319, 7.482,
               7.473, 7.224, 6.810, 6.266, 5.620, 4.895, 4.113, 3.296, 2.472, 1.677, 0.950, 0.346],
    "64A006": [0.485, 0.585, 0.739, 1.016, 1.399, 1.684, 1.919, 2.283, 2.557, 2.757, 2.896, 2.977,
               2.999, 2.945, 2.825, 2.653, 2.438, 2.188, 1.907, 1.602, 1.285, 0.967, 0.649, 0.331],
    "64A010": [0.804, 0.969, 1.225, 1.688, 2.327, 2.805, 3.199, 3.813, 4.272, 4.606, 4.837, 4.968,
               4.995, 4.894, 4.684, 4.388, 4.021, 3.597, 3.127, 2.623, 2.103, 1.582, 1.062, 0.541],
    "65A010": [0.765, 0.928, 1.183, 1.623, 2.182, 2.650, 3.040, 3.658, 4.127, 4.483, 4.742, 4.912,
               4.995, 4.983, 4.863, 4.632, 4.304, 3.899, 3.432, 2.912, 2.352, 1.771, 1.188, 0.604],
    "63A012": [0.973, 1.173, 1.492, 2.078, 2.895, 3.504, 3.994, 4.747, 5.287, 5.664, 5.901, 5.995,
               5.957, 5.792, 5.517, 5.148, 4.700, 4.186, 3.621, 3.026, 2.426, 1.826, 1.225, 0.625],
}  # fmt: skip
# By the theory that they come from, computed anew (naca456 of PDAS) at 5, 30, 50 and 80 %: those of
# 8 and 10 % are no rows of the tables.
COMPUTED = {
    "63-010": [2.4396, 4.9374, 4.4959, 1.6146],
    "64-008": [1.8719, 3.8781, 3.6797, 1.4015],
    "64-010": [2.3406, 4.8570, 4.5834, 1.7211],
    "65-008": [1.7464, 3.8050, 3.8556, 1.6145],
    "65-010": [2.1794, 4.7605, 4.8089, 1.9850],
    "63A015": [3.6018, 7.3867, 6.8703, 2.9946],
    "64A015": [3.4601, 7.2668, 6.9761, 3.0824],
    "65A012": [2.6134, 5.6920, 5.8264, 2.7959],
}
# 0010-64 and 0012-64 are printed as 10/9 and 12/9 of 0009-64, which has 0.01 % as its last digit.
MODIFIED = [1.36, 1.84, 2.45, 2.86, 3.18, 3.65, 3.97, 4.37, 4.50, 4.37, 3.99, 3.36, 2.49, 1.40,
            0.77]  # fmt: skip
MODIFIED_STATIONS = [1.25, 2.5, 5, 7.5, 10, 15, 20, 30, 40, 50, 60, 70, 80, 90, 95]
# (x, y) of the upper side of 64A210, as published.
UPPER_64A210 = [
    (0.424, 0.856), (0.665, 1.044), (1.153, 1.342), (2.387, 1.895), (4.874, 2.685), (7.369, 3.288),
    (9.868, 3.792), (14.874, 4.592), (19.885, 5.200), (24.901, 5.656), (29.917, 5.984),
    (34.935, 6.192), (39.955, 6.274), (44.975, 6.208), (49.994, 6.014), (55.012, 5.714),
    (60.028, 5.323), (65.042, 4.852), (70.054, 4.310), (75.063, 3.702), (80.076, 3.037),
    (85.074, 2.301), (90.052, 1.551), (95.027, 0.785),
]  # fmt: skip


def points(form, lower):
    return [100 * np.array(form.point(x / 100, lower=lower)) for x in STATIONS]


@pytest.mark.parametrize("name", CAMBERED)
def test_cambered_series(name):
    """Within 0.0014: ordinates are sums of numbers that had been rounded to 0.001."""
    form = hn.SectionForm(name)
    for side, ordinates in enumerate(CAMBERED[name]):
        for x, (_, y), published in zip(STATIONS, points(form, side == 1), ordinates):
            if (name, x, side) not in SLIPS:
                assert y == pytest.approx(published, abs=1.4e-3), (x, side)


def test_places_and_ordinates_of_another_mean_line():
    form = hn.SectionForm("65-415 a=0.5")
    for lower, published in ((False, UPPER_65_415), (True, LOWER_65_415)):
        for found, printed in zip(points(form, lower), published):
            slip = 1e-3 if printed == (14.568, 7.386) else 0.0
            assert found == pytest.approx(printed, abs=2.3e-3 + slip), printed


@pytest.mark.parametrize("name", SYMMETRIC)
def test_symmetric_series(name):
    form = hn.SectionForm(name)
    found = [100 * form.half_thickness(x / 100) for x in STATIONS]
    assert found == pytest.approx(SYMMETRIC[name], abs=1e-9)
    if "A" in name:  # straight to the trailing edge, that is not sharp
        tail = 100 * form.half_thickness(1.0)
        assert tail == pytest.approx(0.0021 * int(name[-2:]), abs=1e-3)


@pytest.mark.parametrize("name", COMPUTED)
def test_between_published_thicknesses(name):
    form = hn.SectionForm(name)
    found = [100 * form.half_thickness(x) for x in (0.05, 0.3, 0.5, 0.8)]
    assert found == pytest.approx(COMPUTED[name], abs=0.018 if "A" in name else 0.008)


def test_modified_mean_line():
    form = hn.SectionForm("64A212")
    for found, printed in zip(points(hn.SectionForm("64A210"), False), UPPER_64A210):
        assert found == pytest.approx(printed, abs=2.1e-3), printed
    # It is one line: no jump of height or slope where its parts meet.
    for x in (0.8, 0.85, 0.9):
        ends = [form.mean_line(x + step) for step in (-1e-9, 1e-9)]
        slopes = [form.mean_slope(x + step) for step in (-1e-9, 1e-9)]
        assert np.ptp(ends) < 1e-9 and np.ptp(slopes) < 1e-6, x


def coefficients(form, a):
    """A0 at no angle, A1 and A2 of Glauert's series (1926) of the mean line's slope."""

    def mean(factor):
        breaks = [0.0, np.arccos(1 - 2 * a), np.pi] if 0 < a < 1 else [0.0, np.pi]
        slope = lambda t: form.mean_slope(0.5 * (1 - np.cos(t))) * factor(t)  # noqa: E731
        parts = zip(breaks, breaks[1:])
        return sum(quad(slope, *part, limit=400, epsabs=1e-10)[0] for part in parts) / np.pi

    return mean(np.ones_like), 2 * mean(np.cos), 2 * mean(lambda t: np.cos(2 * t))


@pytest.mark.parametrize("name, lift, a", [
    ("63-412", 0.4, 1.0), ("64-215", 0.2, 1.0), ("65-618", 0.6, 1.0), ("63-412 a=0.8", 0.4, 0.8),
    ("65-415 a=0.5", 0.4, 0.5), ("64-212 a=0", 0.2, 0.0), ("64A212 a=0.3", 0.2, 0.3),
])  # fmt: skip
def test_design_lift(name, lift, a):
    """At the ideal angle, where A0 is 0, the lift coefficient is π A1."""
    _, first, _ = coefficients(hn.SectionForm(name), a)
    assert np.pi * first == pytest.approx(lift, abs=1e-6)


@pytest.mark.parametrize("name, angle_deg", [("63-412", 0.0), ("63-412 a=0.8", 0.4 * 1.54)])
def test_ideal_angle(name, angle_deg):
    """Published to 0.01° for the lift coefficient 1."""
    mean, _, _ = coefficients(hn.SectionForm(name), 0.8 if "a" in name else 1.0)
    assert np.degrees(mean) == pytest.approx(angle_deg, abs=0.0025)


@pytest.mark.parametrize("name", ["22112", "23112", "24112", "25112"])
def test_reflexed_lines(name):
    """No moment about the quarter chord, highest at the digit's twentieths, lift coefficient 0.3:
    to the three digits of r and k1."""
    form = hn.SectionForm(name)
    _, first, second = coefficients(form, 0.0)
    assert abs(np.pi / 4 * (second - first)) < 2e-3
    assert np.pi * first == pytest.approx(0.3, abs=6e-3)
    assert form.mean_slope(0.05 * int(name[1])) == pytest.approx(0.0, abs=1e-12)


def test_second_cubics_of_reflexed_lines():
    """k2 / k1 as it is printed in Report 537: of third differences, behind and before r."""
    for name, printed in [("22112", 0.000764), ("23112", 0.00677), ("24112", 0.0303),
                          ("25112", 0.1355)]:  # fmt: skip
        form = hn.SectionForm(name)
        before, behind = (
            np.diff([form.mean_line(x + 0.02 * i) for i in range(4)], 3)[0] for x in (0.01, 0.8)
        )
        assert behind / before == pytest.approx(printed, rel=1.2e-3), name
        assert form.mean_line(0.0) == pytest.approx(0.0, abs=1e-15), name
        assert form.mean_line(1.0) == pytest.approx(0.0, abs=1e-15), name


@pytest.mark.parametrize("thickness", [10, 12])
def test_modified_sections(thickness):
    form = hn.SectionForm(f"00{thickness}-64")
    ratio = thickness / 9
    for x, y in zip(MODIFIED_STATIONS, MODIFIED):
        assert 100 * form.half_thickness(x / 100) == pytest.approx(ratio * y, abs=0.0055 * ratio), x
    assert form.half_thickness(1.0) == pytest.approx(0.0001 * thickness, abs=1e-12)


@pytest.mark.parametrize("nose, place", [(1, 3), (3, 4), (6, 5), (9, 6), (4, 2)])
def test_noses_and_places(nose, place):
    """The radius by the index, the largest thickness where it is wanted, and curvature as on one
    side so on the other."""
    form = hn.SectionForm(f"0012-{nose}{place}")
    radius = 1.1019 * 0.12**2 * (3.0 if nose == 9 else (nose / 6) ** 2)
    assert form.half_thickness(1e-10) ** 2 / 2e-10 == pytest.approx(radius, rel=4e-4)
    x, step = 0.1 * place, 1e-4
    y = [form.half_thickness(x + i * step) for i in range(-3, 4)]
    assert y[3] == pytest.approx(0.06, abs=1e-12) and max(y) == y[3]
    before, behind = (y[1] - 2 * y[2] + y[3]) / step**2, (y[3] - 2 * y[4] + y[5]) / step**2
    assert before == pytest.approx(behind, rel=0.02)


def test_camber_is_in_proportion_and_names_have_many_forms():
    one, two = (hn.SectionForm(name) for name in ("64-212", "64-412"))
    assert 2 * one.mean_line(0.3) == pytest.approx(two.mean_line(0.3), abs=1e-15)
    assert one.half_thickness(0.3) == two.half_thickness(0.3)
    for same in ("NACA 63-412", "63(1)-412", "631-412", "63-412 a=1", "63-412, a = 1.0"):
        form = hn.SectionForm(same)
        assert form.point(0.37) == pytest.approx(hn.SectionForm("63-412").point(0.37), abs=0)
    assert hn.SectionForm("64A-010").symmetric and not hn.SectionForm("64A110").symmetric
    plain, double = (hn.SectionForm(name) for name in ("23012", "43012"))
    assert 2 * plain.mean_line(0.2) == pytest.approx(double.mean_line(0.2), abs=1e-15)


@pytest.mark.parametrize("name", [
    "63-412", "65-618", "63-412 a=0.8", "65-415 a=0.5", "64A010", "64A410", "23112", "0012-64",
    "2412-34", "23012-64", "64-108", "25012-64", "63-412 a=0.99", "63-412 a=0.9999",
    "63-412 a=0.0002", "63-412 a=0.00005",
])  # fmt: skip
def test_splines_follow_the_outline(name):
    """Cubics of bodies: at quarters of each within 1e-6 of the chord of the outline, and not many
    more than of other sections."""
    form = hn.SectionForm(name)
    parts = np.array(form.spline())
    assert len(parts) < 140
    assert np.abs(parts[1:, 0] - parts[:-1, 3]).max() < 1e-15
    fine = 0.5 - 0.5 * np.cos(np.linspace(0.0, np.pi, 30001))
    for lower in (False, True):
        outline = np.array([form.point(x, lower=lower) for x in fine])
        half = parts[len(parts) // 2 :] if lower else parts[: len(parts) // 2]
        for t in (0.25, 0.5, 0.75):
            q = 1 - t
            powers = np.array([q**3, 3 * q * q * t, 3 * q * t * t, t**3])
            cubic = np.einsum("k,nkc->nc", powers, half)
            assert max(distance(outline, point) for point in cubic) < 1.2e-6, (lower, t)


def distance(line, point):
    """From a polygon (n, 2), to what its chords leave of its arcs."""
    nearest = np.argmin(((line - point) ** 2).sum(axis=1))
    best = np.inf
    for i in (nearest - 1, nearest):
        if 0 <= i < len(line) - 1:
            along = line[i + 1] - line[i]
            t = np.clip((point - line[i]) @ along / (along @ along), 0, 1)
            best = min(best, np.linalg.norm(line[i] + t * along - point))
    return best


def test_bodies_of_new_sections():
    """Volume of a straight foil is its section's area times the span, by the theorem of Green."""
    for name in ("63-412", "64A210", "0012-64", "23112", "65-415 a=0.5"):
        form = hn.SectionForm(name)
        foil = hn.foil(name, (0, 0, 0), (0, 0, -2), 1.0)
        x = np.linspace(0.0, 1.0, 40001) ** 2
        upper, lower = (np.array([form.point(v, lower=side) for v in x]) for side in (False, True))
        ring = np.concatenate([upper[::-1], lower])
        area = 0.5 * np.abs(np.sum(ring[:, 0] * np.roll(ring[:, 1], -1)
                                   - ring[:, 1] * np.roll(ring[:, 0], -1)))  # fmt: skip
        assert foil.volume == pytest.approx(2 * area, rel=1e-5), name
