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
