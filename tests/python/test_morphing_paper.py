# SPDX-License-Identifier: GPL-3.0-or-later
"""Merged meshes of Kang & Lee 2012 by count."""

import numpy as np
from morphing_checks import check_all
from morphing_discs import SQUARE, mapped, random_disc

SEED = 20261124


def test_borders_of_figure_8():
    """Sides of four and of five points have seven together."""
    points = np.array([(0, 0, 0), (0.4, 0, 0), (0.7, 0, 0), (1, 0, 0), (0.5, 1, 0)])
    first = mapped(points, [(0, 1, 4), (1, 2, 4), (2, 3, 4)], [0, 3, 4], points[[0, 3, 4], :2])
    points = np.array([(0, 0, 0), (0.2, 0, 0), (0.6, 0, 0), (0.8, 0, 0), (1, 0, 0), (0.5, 1, 0)])
    second = mapped(points, [(0, 1, 5), (1, 2, 5), (2, 3, 5), (3, 4, 5)], [0, 4, 5], first.polygon)
    merged = check_all((first, second))
    side = np.sort(merged.places[merged.places[:, 1] == 0, 0])
    assert np.abs(side - [0, 0.2, 0.4, 0.6, 0.7, 0.8, 1]).max() < 1e-15
    assert (merged.shared_count, merged.crossing_count) == (3, 0)
    assert (len(merged.places), len(merged.triangles)) == (8, 6)


def test_crossings_of_figure_9():
    """BE and BD of one disc and AC of the other cross in G and F: seven points, twelve edges and
    a thirteenth that cuts the one part that is no triangle, seven triangles."""
    a, b, c, d, e = (0, 1, 0), (1, 0, 0), (3, 0.5, 0), (2.25, 1.5, 0), (0.75, 3.5, 0)
    first = mapped([a, b, c, d, e], [(0, 1, 4), (1, 3, 4), (1, 2, 3)], [0, 1, 2, 4],
                   [a[:2], b[:2], c[:2], e[:2]])  # fmt: skip
    second = mapped([a, b, c, e], [(0, 1, 2), (0, 2, 3)], [0, 1, 2, 3], first.polygon)
    merged = check_all((first, second))
    assert (merged.shared_count, merged.crossing_count) == (4, 2)
    assert (len(merged.places), len(merged.triangles)) == (7, 7)
    assert np.unique(merged.parents, axis=0).shape == (6, 2)


def test_parents_of_the_paper_s_size():
    """550 and 559 points of 993 triangles each have borders of 105 and 123 points by Euler's
    formula. Merged they had 4,900 points and 9,788 triangles, as is told: as a disc a border of 10
    points, less than either parent. Whatever the number of points, ours has triangles for all of
    both borders."""
    assert 2 * 550 - 993 - 2 == 105 and 2 * 559 - 993 - 2 == 123 and 2 * 4900 - 9788 - 2 == 10
    random = np.random.default_rng(SEED)
    maps = []
    for points, border in ((550, 105), (559, 123)):
        of = random_disc(random, border, points - border)
        assert (len(of[0]), len(of[1])) == (points, 993)
        maps.append(mapped(*of[:2], [0, border // 4, border // 2, 3 * border // 4], SQUARE))
    merged = check_all(maps, exact=False)
    on_border = 105 + 123 - 4
    assert len(merged.triangles) == 2 * len(merged.places) - on_border - 2
