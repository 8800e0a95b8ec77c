# SPDX-License-Identifier: GPL-3.0-or-later
"""NACA sections against published ordinates: NACA Reports 460, 537 and 824, per cent of the
chord."""

import hull_native as hn
import numpy as np
import pytest

# Upper and lower ordinates of the symmetric forms as published, at these stations.
STATIONS = [0.5, 1.25, 2.5, 5, 7.5, 10, 15, 20, 25, 30, 40, 50, 60, 70, 80, 90, 95, 100]
PUBLISHED = {
    "0012": [None, 1.894, 2.615, 3.555, 4.200, 4.683, 5.345, 5.737, 5.941, 6.002, 5.803, 5.294,
             4.563, 3.664, 2.623, 1.448, 0.807, 0.126],
    "0018": [None, 2.841, 3.922, 5.332, 6.300, 7.024, 8.018, 8.606, 8.912, 9.003, 8.705, 7.941,
             6.845, 5.496, 3.935, 2.172, 1.210, 0.189],
    "63-012": [0.985, 1.519, 2.102, 2.925, 3.542, 4.039, 4.799, 5.342, 5.712, 5.930, 5.920, 5.370,
               4.420, 3.210, 1.902, 0.707, 0.250, 0.0],
    "64-012": [0.978, 1.490, 2.035, 2.810, 3.394, 3.871, 4.620, 5.173, 5.576, 5.844, 5.981, 5.480,
               4.548, 3.350, 2.029, 0.786, 0.288, 0.0],
    "65-012": [0.923, 1.387, 1.875, 2.606, 3.172, 3.647, 4.402, 4.975, 5.406, 5.716, 5.997, 5.757,
               4.943, 3.743, 2.345, 0.947, 0.356, 0.0],
}  # fmt: skip
# The 6-series by the theory that they come from, computed anew (public domain program naca456 of
# PDAS): the published ordinates are within 1e-4 of the chord of these.
COMPUTED = {
    "63-012": [0.9837, 1.5181, 2.0980, 2.9256, 3.5432, 4.0386, 4.8003, 5.3431, 5.7115, 5.9304,
               5.9220, 5.3698, 4.4206, 3.2113, 1.9002, 0.7076, 0.2521, 0.0],
    "64-012": [0.9755, 1.4904, 2.0331, 2.8075, 3.3914, 3.8668, 4.6159, 5.1704, 5.5721, 5.8381,
               5.9752, 5.4788, 4.5462, 3.3488, 2.0289, 0.7862, 0.2883, 0.0],
    "65-012": [0.9147, 1.3824, 1.8792, 2.6091, 3.1756, 3.6490, 4.4035, 4.9758, 5.4070, 5.7172,
               5.9990, 5.7573, 4.9445, 3.7427, 2.3433, 0.9461, 0.3533, 0.0],
}  # fmt: skip
# x, y of the upper and the lower side as published (Reports 460, 537).
CAMBERED = {
    "2412": [(1.25, 2.15, -1.65), (2.5, 2.99, -2.27), (5, 4.13, -3.01), (7.5, 4.96, -3.46),
             (10, 5.63, -3.75), (15, 6.61, -4.10), (20, 7.26, -4.23), (25, 7.67, -4.22),
             (30, 7.88, -4.12), (40, 7.80, -3.80), (50, 7.24, -3.34), (60, 6.36, -2.76),
             (70, 5.18, -2.14), (80, 3.75, -1.50), (90, 2.08, -0.82), (95, 1.14, -0.48),
             (100, 0.13, -0.13)],
    "23012": [(1.25, 2.67, -1.23), (2.5, 3.61, -1.71), (5, 4.91, -2.26), (7.5, 5.80, -2.61),
              (10, 6.43, -2.92), (15, 7.19, -3.50), (20, 7.50, -3.97), (25, 7.60, -4.28),
              (30, 7.55, -4.46), (40, 7.14, -4.48), (50, 6.41, -4.17), (60, 5.47, -3.67),
              (70, 4.36, -3.00), (80, 3.08, -2.16), (90, 1.68, -1.23), (95, 0.92, -0.70),
              (100, 0.13, -0.13)],
}  # fmt: skip
# Of 23012, computed by hand in 1935, two digits are further off than the others: the lower side at
# 1.25 % by 0.030 and the upper at 70 % by 0.025. The file below has what the formula gives there.
SLIPS = {("23012", 1.25, True), ("23012", 70, False)}
# 2412 as the table of Abbott & von Doenhoff's book was computed anew from the formulas (the public
# domain program naca456 of PDAS, whose author found "numerous computing and typographic errors").
RECOMPUTED_2412 = [
    (0.5, 1.4269, -1.0396), (0.75, 1.7090, -1.2852), (1.25, 2.1606, -1.6513),
    (2.5, 2.9863, -2.2684), (5, 4.1304, -3.0054), (7.5, 4.9677, -3.4580), (10, 5.6291, -3.7608),
    (15, 6.6073, -4.1022), (20, 7.2607, -4.2278), (25, 7.6695, -4.2209), (30, 7.8785, -4.1286),
    (35, 7.9163, -3.9819), (40, 7.8030, -3.8030), (45, 7.5685, -3.5931), (50, 7.2425, -3.3462),
    (55, 6.8341, -3.0720), (60, 6.3506, -2.7784), (65, 5.7972, -2.4710), (70, 5.1778, -2.1540),
    (75, 4.4949, -1.8305), (80, 3.7497, -1.5017), (85, 2.9422, -1.1681), (90, 2.0711, -0.8289),
    (95, 1.1341, -0.4821),
]  # fmt: skip

# Places on the outline of 23012, in chords, as a file of another origin has them (Selig).
UIUC_23012 = {
    False: [(0.00015, 0.00956), (0.00628, 0.0203), (0.01865, 0.03176), (0.0373, 0.04324),
            (0.06203, 0.05382), (0.0923, 0.06265), (0.12732, 0.06915), (0.16604, 0.0732),
            (0.20738, 0.07524), (0.25131, 0.07597), (0.29796, 0.07554), (0.39733, 0.0715),
            (0.50117, 0.06397), (0.60496, 0.05405), (0.70417, 0.04285), (0.79449, 0.03145),
            (0.87197, 0.02079), (0.93324, 0.01176), (0.97563, 0.00518), (0.9973, 0.0017)],
    True: [(0.00533, -0.00792), (0.01557, -0.01401), (0.03029, -0.0187), (0.04915, -0.02248),
           (0.07195, -0.02586), (0.09868, -0.02922), (0.12954, -0.03282), (0.16483, -0.0366),
           (0.20483, -0.04016), (0.24869, -0.04283), (0.29531, -0.04446), (0.39476, -0.04482),
           (0.49883, -0.04188), (0.60296, -0.03655), (0.70257, -0.02975), (0.7933, -0.02235),
           (0.87118, -0.01512), (0.93279, -0.0088), (0.97543, -0.0041), (0.99722, -0.00158)],
}  # fmt: skip


def height_at(form, x, lower):
    """y of the outline where its own x is this, by bisection."""
    low, high = 0.0, 1.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if form.point(middle, lower=lower)[0] < x else (low, middle)
    return form.point(low, lower=lower)[1]


@pytest.mark.parametrize("name", PUBLISHED)
def test_symmetric_sections(name):
    """To the last digit that is printed; 0012 has 5.737 for 5.73754 at 20 %."""
    form = hn.SectionForm(name)
    for x, y in zip(STATIONS, PUBLISHED[name]):
        if y is not None:
            assert 100 * form.half_thickness(x / 100) == pytest.approx(y, abs=0.00055), x


@pytest.mark.parametrize("name", COMPUTED)
def test_tables_against_theory(name):
    form = hn.SectionForm(name)
    found = [100 * form.half_thickness(x / 100) for x in STATIONS]
    assert np.abs(np.subtract(found, COMPUTED[name])).max() < 0.01


@pytest.mark.parametrize("name", CAMBERED)
def test_cambered_sections(name):
    """Printed to 0.01 %, computed by hand: 2412's and 23012's lower sides are up to 0.018 % off
    their own formulas, as the tests below tell."""
    form = hn.SectionForm(name)
    for station, upper, lower in CAMBERED[name]:
        x = min(station / 100, 0.99999)
        for printed, side in ((upper, False), (lower, True)):
            if (name, station, side) not in SLIPS:
                assert 100 * height_at(form, x, side) == pytest.approx(printed, abs=0.02), station


def test_every_digit_of_the_table_computed_anew():
    """From 7.5 % on; before it that table's own interpolation is up to 0.003 % off."""
    form = hn.SectionForm("2412")
    for x, upper, lower in RECOMPUTED_2412:
        if x < 7.5:
            assert 100 * height_at(form, x / 100, False) == pytest.approx(upper, abs=3e-3), x
            assert 100 * height_at(form, x / 100, True) == pytest.approx(lower, abs=3e-3), x
            continue
        assert 100 * height_at(form, x / 100, False) == pytest.approx(upper, abs=1.1e-4), x
        assert 100 * height_at(form, x / 100, True) == pytest.approx(lower, abs=1.1e-4), x


def test_printed_digits_that_are_off_are_slips():
    """Of the printed 2412 the mean of both sides leaves the formula's by 0.002, 0.014, 0.008, 0.001
    and 0.009 % of the chord at 50 to 90 %: more than rounding explains at 60, 70 and 90, nothing at
    50 and 80. Half the difference of both, the thickness, is within 0.006 %."""
    form = hn.SectionForm("2412")
    off = []
    for x, upper, lower in CAMBERED["2412"]:
        if 50 <= x <= 90:
            ours = [100 * height_at(form, x / 100, side) for side in (False, True)]
            off.append(0.5 * (upper + lower) - 0.5 * sum(ours))
            assert 0.5 * (upper - lower) == pytest.approx(0.5 * (ours[0] - ours[1]), abs=0.0065)
    assert off == pytest.approx([0.0019, 0.0139, 0.0081, 0.0010, 0.0089], abs=1.5e-4)


def test_cambered_section_against_another_program():
    """23012 as naca456 (PDAS) computes it, whose mean line has r and k1 to more digits."""
    form = hn.SectionForm("23012")
    for x, upper, lower in [
        (0.025, (0.019153, 0.032148), (0.030847, -0.018822)),
        (0.1, (0.097113, 0.063761), (0.102887, -0.029716)),
        (0.3, (0.301326, 0.075471), (0.298674, -0.044534)),
        (0.5, (0.501170, 0.063976), (0.498830, -0.041878)),
        (0.8, (0.800580, 0.030644), (0.799420, -0.021805)),
    ]:
        assert form.point(x) == pytest.approx(upper, abs=2e-5), x
        assert form.point(x, lower=True) == pytest.approx(lower, abs=2e-5), x


@pytest.mark.parametrize("lower", UIUC_23012)
def test_five_digits_against_a_published_file(lower):
    """To its five digits, as distances from the outline."""
    form = hn.SectionForm("23012")
    stations = np.linspace(0.0, 1.0, 4001) ** 2
    outline = np.array([form.point(x, lower=lower) for x in stations])
    starts, sides = outline[:-1], np.diff(outline, axis=0)
    for place in np.array(UIUC_23012[lower]):
        shares = ((place - starts) * sides).sum(1) / (sides**2).sum(1)
        feet = starts + np.clip(shares, 0.0, 1.0)[:, None] * sides
        assert np.linalg.norm(feet - place, axis=1).min() < 1e-5, place


@pytest.mark.parametrize("name", ["0012", "2412", "23012", "63-012", "65-018"])
def test_splines_follow_the_outline(name):
    """The cubics of bodies: at their middles within 1e-6 of the chord of the outline."""
    form = hn.SectionForm(name)
    parts = np.array(form.spline())
    assert np.abs(parts[1:, 0] - parts[:-1, 3]).max() < 1e-15
    middles = (parts[:, 0] + 3 * parts[:, 1] + 3 * parts[:, 2] + parts[:, 3]) / 8
    for i, (x, y) in enumerate(middles):
        if x < 2e-3:
            continue  # at the leading edge x does not rise along the outline of cambered ones
        lower = i >= len(parts) // 2
        assert height_at(form, x, lower) == pytest.approx(y, abs=1e-6), (i, x)


@pytest.mark.parametrize(
    "name",
    [
        "",
        "12",
        "0000",
        "0a12",
        "2012",
        "26112x",
        "21112",
        "23212",
        "66-012",
        "63-1",
        "63-400",
        "0012-04",
        "0012-67",
        "63-412 a=1.2",
        "63-412 a",
        "64A0100",
        "x",
    ],
)
def test_unknown_names(name):
    with pytest.raises(ValueError, match="is no section that is known"):
        hn.SectionForm(name)


@pytest.mark.parametrize("name", ["63-412 a=0.98", "63-412 a=0.99", "65-618 a=0.99999"])
def test_foils_reach_their_trailing_edges(name):
    """Where the load begins to fall next to it, too."""
    parts = np.array(hn.SectionForm(name).spline())
    assert parts[0, 0] == pytest.approx((1.0, 0.0), abs=1e-9)
    assert parts[-1, 3] == pytest.approx((1.0, 0.0), abs=1e-9)


def test_places_where_formulas_meet_are_knots():
    """That of the mean line, 0.391, and that of the thickness, 0.4, next to one another."""
    parts = np.array(hn.SectionForm("25012-64").spline())
    form = hn.SectionForm("25012-64")
    for place in (0.391, 0.4):
        end = np.array(form.point(place))
        assert np.linalg.norm(parts[:, 0] - end, axis=1).min() < 1e-12, place
