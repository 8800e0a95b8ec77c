# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/architecture.md agrees with the tree: what it names is there, and what is there it names."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
TOPS = ("native", "python", "addon", "samples", "scripts", "tests", "docs", "cmake")
# Folders whose own folders all have a row.
PARENTS = (
    "native", "native/surface", "native/analysis", "native/conversion", "native/drawing",
    "native/bindings", "native/modelling", "native/morphing", "python", "addon/hull_tools",
    "addon/hull_tools/bridge",
    "addon/hull_tools/features", "tests",
)  # fmt: skip
# What tests keep for themselves.
WITHOUT_ROW = {"tests/__pycache__"}

NAMED = re.findall(r"`([\w./-]+)`", PAGE)
PATHS = sorted({name for name in NAMED if name.split("/")[0] in TOPS})
ROWS = re.findall(r"^\| (?:.*?; )?`([\w./-]+)` \|", PAGE, flags=re.M)


@pytest.mark.parametrize("path", PATHS)
def test_what_is_named_is_there(path):
    assert (ROOT / path).exists()


def test_short_names_of_features_are_there():
    for name in NAMED:
        if name.startswith("features/"):
            assert (ROOT / "addon" / "hull_tools" / name).is_dir(), name


@pytest.mark.parametrize("parent", PARENTS)
def test_what_is_there_is_named(parent):
    folders = {
        f"{parent}/{path.name}"
        for path in (ROOT / parent).iterdir()
        if path.is_dir() and any(path.rglob("*.[hcp]*")) and path.name != "__pycache__"
    }
    assert folders
    assert folders - set(PATHS) - WITHOUT_ROW == set()


def test_top_folders_are_named():
    there = {
        path.name
        for path in ROOT.iterdir()
        if path.is_dir() and path.name[0] != "." and path.name not in ("build", "out")
    }
    assert there == set(TOPS)
    assert set(TOPS) <= set(ROWS)


def test_classes_of_the_flow_are_in_their_folders():
    for name, folder in re.findall(r"`(\w+)(?:\.\w+)?` \(`(native/[\w/]+)`\)", PAGE):
        headers = (ROOT / folder).rglob("*.h")
        assert any(re.search(rf"^class {name}\b", path.read_text(), re.M) for path in headers), name


def test_layers_use_what_the_page_says():
    """The table of layers against the test that reads the includes."""
    from test_native_layers import USES

    rows = re.findall(r"^\| `native/(\w+)` \| .* \| ([\w, ]*?) ?\|$", PAGE, flags=re.M)
    told = {layer: {use for use in uses.split(", ") if use} for layer, uses in rows}
    assert {layer: told[layer] for layer in USES} == USES
