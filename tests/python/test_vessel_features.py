# SPDX-License-Identifier: GPL-3.0-or-later
"""Every sample vessel has what its list of features tells of: by its tags and exact surface."""

from functools import lru_cache

import pytest
import vessels
from vessel_features.form import Form
from vessel_features.spoils import SPOILS
from vessel_features.table import CHECKS

CASES = [(name, feature) for name, checks in CHECKS.items() for feature in checks]


@lru_cache(maxsize=None)
def form(name):
    return Form(vessels.vessel(name).data)


@pytest.mark.parametrize("name", vessels.sources.names())
def test_every_feature_has_its_check(name):
    checked = {feature for feature in CHECKS[name] if not feature.isupper()}
    assert checked == set(vessels.sources.source(name).FEATURES)


@pytest.mark.parametrize("name, feature", CASES, ids=lambda part: part)
def test_feature(name, feature):
    CHECKS[name][feature](form(name))


@pytest.mark.parametrize(
    "name, feature, spoil", SPOILS, ids=lambda part: getattr(part, "__name__", part)
)
def test_feature_is_missed_where_it_is_not(name, feature, spoil):
    spoilt = Form(spoil(vessels.vessel(name).data))
    with pytest.raises(AssertionError):
        CHECKS[name][feature](spoilt)


def test_every_check_has_a_hull_to_miss_its_feature_in():
    assert {(name, feature) for name, feature, _ in SPOILS} == set(CASES)
