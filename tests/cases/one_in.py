# SPDX-License-Identifier: GPL-3.0-or-later
"""@pytest.mark.one_in(count): one in so many of a test's cases is tried, the same each time, where
all take long; with HULL_ALL_CASES=1 all are. HULL_ONE_CASE_IN=count has one in so many of every
test's tried, where another system has tried all."""

import math
import os
import zlib
from collections import defaultdict

ALL = os.environ.get("HULL_ALL_CASES") == "1"
OF_EVERY_TEST = int(os.environ.get("HULL_ONE_CASE_IN", "1"))


def _chance(item):
    return zlib.crc32(item.name.encode())


def _one_in(item):
    mark = item.get_closest_marker("one_in")
    return OF_EVERY_TEST * (mark.args[0] if mark else 1)


def pytest_collection_modifyitems(config, items):
    """The cases are chosen by a checksum of their names: by order, all could be of one kind."""
    of_test = defaultdict(list)
    for item in items:
        if _one_in(item) > 1:
            of_test[item.path, item.originalname].append(item)
    left_out = set()
    for cases in () if ALL else of_test.values():
        count = math.ceil(len(cases) / _one_in(cases[0]))
        left_out.update(sorted(cases, key=_chance)[count:])
    if left_out:
        config.hook.pytest_deselected(items=[item for item in items if item in left_out])
        items[:] = [item for item in items if item not in left_out]
