# SPDX-License-Identifier: GPL-3.0-or-later
"""The density of sea water, the default of all functions, is one number: in the core, and in
hull_io, which does without the core."""

import ast
import re
from pathlib import Path

import hull_native as hn
from hull_io.limits import SEA_WATER_DENSITY

ROOT = Path(__file__).resolve().parents[2]
HOMES = {"native/analysis/immersion/sea_water.h", "python/hull_io/limits.py"}


def numbers(path):
    """The numbers in a source: what comments and texts say is none."""
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".py":
        yield from (
            node.value
            for node in ast.walk(ast.parse(text))
            if isinstance(node, ast.Constant) and type(node.value) in (int, float)
        )
        return
    text = re.sub(r'//.*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', "", text)
    yield from map(float, re.findall(r"(?<![\w.])\d+\.\d+(?:e[-+]?\d+)?(?![\w.])", text))


def test_hull_io_and_the_core_agree():
    assert SEA_WATER_DENSITY == hn.SEA_WATER_DENSITY


def test_numbers_are_found(tmp_path):
    source = tmp_path / "source.cpp"
    source.write_text('f(1.5, "2.5", 3e-3); // 4.5\ng(-0.25e2, a1.5);')
    assert list(numbers(source)) == [1.5, 25.0]
    source = tmp_path / "source.py"
    source.write_text('f(1.5, "2.5", True)  # 4.5')
    assert list(numbers(source)) == [1.5]


def test_no_other_place_has_the_number():
    sources = [
        path
        for folder in ("addon", "python", "native")
        for ending in ("py", "h", "cpp")
        for path in (ROOT / folder).rglob(f"*.{ending}")
    ]
    found = {
        path.relative_to(ROOT).as_posix() for path in sources if SEA_WATER_DENSITY in numbers(path)
    }
    assert found == HOMES
