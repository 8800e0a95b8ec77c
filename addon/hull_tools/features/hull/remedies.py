# SPDX-License-Identifier: GPL-3.0-or-later
"""What helps where a hull has a surface, and no volume or a doubtful one."""

# What is said of what each helps with: by the core of faces, by flotation.hydrostatics of shells.
_TURN, _CLOSE = "turned inwards", "not closed below the water"
_JOINING = ("JOIN", "POINTS")


def of_volume(obj, state):
    """Kinds of what helps, as mesh_check.Problem has them, and TURN, BORDERS and MAKE_HALF."""
    found = state.hydrostatics
    said = found.status if found.values is None else found.values.remark
    if not said or state.status:
        return []
    problems = state.ship.check.problems
    kinds = [problem.remedy for problem in problems if problem.remedy in _JOINING]
    if _TURN in said:
        return kinds + ["TURN"]
    if _CLOSE not in said:
        return []
    return kinds + ["BORDERS"] + ([] if obj.hull.half else ["MAKE_HALF"])
