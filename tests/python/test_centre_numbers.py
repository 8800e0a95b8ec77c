# SPDX-License-Identifier: GPL-3.0-or-later
"""How near to the centre plane a point is in it is told once: no source has a number of its own for
it, whether by name or beside a y."""

import ast
import re
from pathlib import Path

import hull_native as hn
import pytest
from hull_io import mirror

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ("addon", "python", "native/bindings/hull_native")
# Less is rounding; more are parts of a beam, or lengths.
_LEAST, _LARGEST = 1e-8, 1e-2
# By file: names and numbers that mean something else; the reason stands beside each there.
OWN = {
    # What hull_io has of the core's, equal to it by a test below.
    "python/hull_io/mirror.py": {"ON_CENTRE_PLANE", "NEAR_CENTRE_PLANE", "AT_CENTRE_LINE"},
    # Triangles of other programs, put there.
    "python/hull_fitting/half_meshes.py": {"_TO_CENTRE_PLANE"},
}

# Of the C++ sources: the same, by file.
OWN_NATIVE = {
    "mesh/tolerances.h": {"kOnCentrePlane", "kNearCentrePlane", "kAtCentreLine", "kInPlane"},
    # More than kOnCentrePlane, so that what is not in the plane stays out of it.
    "morphing/features/layout_fitting.cpp": {"kOffCentrePlane"},
    # Planes of sections, curves and cuts.
    "analysis/sections/section_curves.cpp": {"kOnPlane"},
    "analysis/fairness/curve_fairness.cpp": {"kPlaneCurve"},
    "production/segments/segment_grid.cpp": {"kSamePlane"},
}
_NUMBER = r"(\d[\d.]*e-\d+)"
_NAMED = re.compile(rf"\b(k\w*(?:Centre|Plane|Image|Mirror)\w*) = {_NUMBER}")
_BESIDE_Y = re.compile(rf"(\by\(\)\)?\s*[<>]=?\s*-?{_NUMBER})")


def is_small(node):
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        node = node.operand
    return (
        isinstance(node, ast.Constant)
        and isinstance(node.value, float)
        and _LEAST <= node.value <= _LARGEST
    )


def is_y(node):
    """points[:, 1], line[0, 1] or a variable of that name."""
    if isinstance(node, ast.Subscript) and isinstance(node.slice, ast.Tuple):
        last = node.slice.elts[-1]
        return isinstance(last, ast.Constant) and last.value == 1
    return isinstance(node, ast.Name) and node.id == "y"


def named_numbers(tree):
    """Names of the module with CENTRE in them that are small numbers: (name, line)."""
    for node in tree.body:
        pairs = []
        for target in node.targets if isinstance(node, ast.Assign) else ():
            if isinstance(target, ast.Tuple) and isinstance(node.value, ast.Tuple):
                pairs += zip(target.elts, node.value.elts)
            else:
                pairs.append((target, node.value))
        for name, value in pairs:
            if isinstance(name, ast.Name) and "CENTRE" in name.id and is_small(value):
                yield name.id, node.lineno


def numbers_beside_y(tree):
    """(what is compared, line) of comparisons between a y and a small number, alone or as a part
    of a size."""
    for node in ast.walk(tree):
        if not isinstance(node, ast.Compare):
            continue
        sides = [node.left, *node.comparators]
        parts = [
            [side.left, side.right]
            if isinstance(side, ast.BinOp) and isinstance(side.op, ast.Mult)
            else [side]
            for side in sides
        ]
        has_number = any(is_small(part) for one in parts for part in one)
        if has_number and any(is_y(part) for side in sides for part in ast.walk(side)):
            yield ast.unparse(node), node.lineno


def found_in(text):
    tree = ast.parse(text)
    return [*named_numbers(tree), *numbers_beside_y(tree)]


@pytest.mark.parametrize(
    "text",
    [
        "_CENTRE = 1e-6",
        "_SAME, _IN_CENTRE = 1e-7, 1e-5",
        "ok = np.abs(points[:, 1]).max() < 1e-6 * size",
        "ok = low > -1e-3 * points[:, 1].max()",
        "ok = abs(y) <= 5e-5",
    ],
)
def test_numbers_are_found(text):
    assert found_in(text)


@pytest.mark.parametrize(
    "text",
    [
        "_CENTRE = ('lcg', 'tcg')",
        "ok = np.abs(points[:, 1]).max() < tolerances.ON_CENTRE_PLANE * size",
        "ok = points[:, 0].max() < 1e-6 * size",
        "ok = points[:, 1].max() < 0.03 * beam",
    ],
)
def test_others_are_not(text):
    assert not found_in(text)


@pytest.mark.parametrize("folder", FOLDERS)
def test_no_source_has_a_number_of_its_own(folder):
    for path in sorted((ROOT / folder).rglob("*.py")):
        name = path.relative_to(ROOT).as_posix()
        found = found_in(path.read_text(encoding="utf-8"))
        wrong = [one for one in found if one[0] not in OWN.get(name, ())]
        assert wrong == [], f"{name}: use hull_native.tolerances, or hull_io.mirror"
        assert OWN.get(name, set()) <= {what for what, _ in found}, name


def found_in_native(text):
    """Names, or comparisons, as above."""
    found = [*_NAMED.findall(text), *_BESIDE_Y.findall(text)]
    return [what for what, number in found if 0.0 < float(number) <= _LARGEST]


def test_numbers_of_native_sources_are_found():
    assert found_in_native("constexpr double kOnPlane = 1e-9;  // of the size") == ["kOnPlane"]
    assert found_in_native("if (std::abs(p.y()) <= 1e-7 * size) {")
    assert not found_in_native("if (std::abs(p.y()) <= kOnCentrePlane * size) {")


@pytest.mark.parametrize("ending", ["*.h", "*.cpp"])
def test_no_native_source_has_a_number_of_its_own(ending):
    for path in sorted((ROOT / "native").rglob(ending)):
        name = path.relative_to(ROOT / "native").as_posix()
        found = set(found_in_native(path.read_text(encoding="utf-8")))
        assert found == OWN_NATIVE.get(name, set()), f"{name}: use mesh/tolerances.h"


@pytest.mark.parametrize("name", OWN["python/hull_io/mirror.py"])
def test_hull_io_and_the_core_agree(name):
    assert getattr(mirror, name) == getattr(hn.tolerances, name)
