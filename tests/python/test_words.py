# SPDX-License-Identifier: GPL-3.0-or-later
"""One word for one thing in all that is read: draft, and no labels that begin with "Its"."""

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = ("docs", "addon", "python", "native", "samples", "scripts")
ENDINGS = {".md", ".py", ".h", ".cpp", ".toml", ".json"}

# Files that may have the other word, what may stand there, and why.
EXCEPTIONS = {
    "docs/conventions.md": r"\| draught \|",  # tells which word is not taken
    "python/hull_io/section_files/archimedes.py": r"_DRAUGHT_MARK",  # Archimedes' keyword
    "scripts/results/calls.py": r"immersed_draught",  # as the module of before calls it
}


def texts():
    files = [path for folder in FOLDERS for path in sorted((ROOT / folder).rglob("*"))]
    for path in (ROOT / "README.md", ROOT / "CONTRIBUTING.md", *files):
        if path.suffix in ENDINGS and "__pycache__" not in path.parts:
            yield path.relative_to(ROOT).as_posix(), path.read_text(encoding="utf-8")


def test_the_word_is_draft():
    found, names = [], set()
    for name, text in texts():
        names.add(name)
        if name in EXCEPTIONS:
            text, count = re.subn(EXCEPTIONS[name], "", text)
            assert count, f"{name}: the exception is not needed any longer"
        found += [
            f"{name}: {line.strip()}" for line in text.split("\n") if "draught" in line.lower()
        ]
    assert not found
    assert set(EXCEPTIONS) <= names and "docs/networks.md" in names


def labels(tree):
    """Texts that calls give as a name: the first argument, and `name` and `text`."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Call):
            named = [word.value for word in node.keywords if word.arg in ("name", "text")]
            for value in [*node.args[:1], *named]:
                if isinstance(value, ast.Constant) and isinstance(value.value, str):
                    yield value.value


@pytest.mark.parametrize("folder", ["panels", "properties", "operators", "overlays"])
def test_no_label_begins_with_its(folder):
    paths = sorted((ROOT / "addon" / "hull_tools" / folder).rglob("*.py"))
    found = [text for path in paths for text in labels(ast.parse(path.read_text()))]
    assert len(found) > 20 and not [text for text in found if text.startswith("Its ")]


ADDON = ROOT / "addon" / "hull_tools"
MASS, VOLUME = re.compile(r"[Dd]isplacement|Δ"), re.compile(r"[Dd]isplaced volume|∇")
IN_MASS, IN_VOLUME = re.compile(r"\bt$|\bin t\b"), re.compile(r"\bm3\b|m³")


def texts_that_belong_together(tree):
    """Lists of texts: of each row of a table, and of each call."""
    for node in ast.walk(tree):
        parts = []
        if isinstance(node, ast.Tuple):
            parts = node.elts
        elif isinstance(node, ast.Call):
            parts = [*node.args, *(word.value for word in node.keywords)]
        found = [p.value for p in parts if isinstance(p, ast.Constant) and isinstance(p.value, str)]
        if found:
            yield found


def confused(texts):
    """Whether a displacement is given as a volume, or the other way round."""
    says = [any(pattern.search(text) for text in texts)
            for pattern in (MASS, VOLUME, IN_MASS, IN_VOLUME)]  # fmt: skip
    mass, volume, in_mass, in_volume = says
    return (mass and not volume and in_volume) or (volume and not mass and in_mass)


def test_displacement_is_a_mass_and_displaced_volume_a_volume():
    rows = [
        (path.name, texts)
        for path in sorted(ADDON.rglob("*.py"))
        for texts in texts_that_belong_together(ast.parse(path.read_text(encoding="utf-8")))
    ]
    assert not [row for row in rows if confused(row[1])]
    told = [texts for _, texts in rows if any(MASS.search(text) for text in texts)]
    assert sum(any(IN_MASS.search(text) for text in texts) for texts in told) > 4
    number = r" (of |is |by )?[\d.,]+ ?"
    wrong = re.compile(rf"[Dd]isplacement{number}m³|[Dd]isplaced volume{number}t\b")
    assert not [name for name, text in texts() if wrong.search(text)]


def test_confused_rows_are_found():
    assert confused(["volume", "Displacement", "m3"]) and confused(["Displaced volume ∇", "t"])
    assert not confused(["Displacement Δ", "displacement", "t"])
    assert not confused(["∇ in m³", "Displaced volume wanted"])
    assert not confused(["Shift the sections to a displacement", "by this"])
