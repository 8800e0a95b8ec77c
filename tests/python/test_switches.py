# SPDX-License-Identifier: GPL-3.0-or-later
"""Variables of the environment that tests read are told in docs/building.md, and no others."""

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
_READ = re.compile(r'environ(?:\.get\(|\[)"(HULL_\w+)"|"(HULL_\w+)" in os\.environ')
# By these a test tells a program that it runs what to do.
_BETWEEN_PROCESSES = {"HULL_FOUND", "HULL_FREECAD_FILES", "HULL_FREECAD_REPORT", "HULL_MODELS"}


def test_each_switch_is_told():
    read = set()
    for path in (ROOT / "tests").rglob("*.py"):
        if path.name != Path(__file__).name:
            read.update(a or b for a, b in _READ.findall(path.read_text()))
    text = (ROOT / "docs" / "building.md").read_text()
    told = set()
    for row in re.findall(r"^\| (`HULL_.*?) \|", text, re.MULTILINE):
        told.update(re.findall(r"HULL_\w+", row))
    assert len(read) > 10 and told == read - _BETWEEN_PROCESSES
