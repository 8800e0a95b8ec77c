# SPDX-License-Identifier: GPL-3.0-or-later
"""In which order points that follow one another are placed, and which can't be."""

# Why a tie does not count: the point is a copy of another one that has it, a point that it follows
# is gone, or it would follow itself.
REASONS = COPY, GONE, CYCLE = ("copy", "gone", "cycle")


def levels(followed):
    """(lists of points, each of which follows points of lists before it, or none that follows; {of
    the others: one of REASONS}).

    followed: {point: (the point that has its name, the points that it follows, None of those that
    are gone)}.
    """
    lost = {}
    for point, (owner, leaders) in followed.items():
        if owner != point:
            lost[point] = COPY
        elif None in leaders:
            lost[point] = GONE
    left = {point: leaders for point, (_, leaders) in followed.items() if point not in lost}
    found = []
    while left:
        ready = [point for point, leaders in left.items() if not left.keys() & set(leaders)]
        if not ready:
            break
        found.append(sorted(ready))
        for point in ready:
            del left[point]
    # What hangs on a cycle is lost with it.
    lost.update(dict.fromkeys(left, CYCLE))
    return found, lost


def cycle_through(point, leaders_of):
    """The points by which one would follow itself, from it on; [] where it does not. leaders_of:
    {point: points that it follows}."""
    paths, seen = [[point]], set()
    while paths:
        path = paths.pop()
        for leader in leaders_of.get(path[-1], ()):
            if leader == point:
                return path
            if leader not in seen:
                seen.add(leader)
                paths.append([*path, leader])
    return []
