# SPDX-License-Identifier: GPL-3.0-or-later
"""Who may use whom in native/: a folder is a layer and a namespace, and includes point one way."""

import re
from pathlib import Path

import pytest

NATIVE = Path(__file__).resolve().parents[2] / "native"

# Each layer with those that it may include beside itself, in the order of the house: below them
# come the Python module, which may use all, and the benchmarks.
USES = {
    "files": set(),
    "dxf": {"files"},
    "mesh": set(),
    "surface": {"mesh"},
    "analysis": {"surface", "mesh"},
    "resistance": {"analysis", "surface", "mesh"},
    "modelling": {"resistance", "analysis", "surface", "mesh"},
    "morphing": {"modelling", "analysis", "surface", "mesh"},
    "conversion": {"analysis", "surface", "mesh"},
    "production": {"analysis", "surface", "mesh"},
    "network": {"conversion", "modelling", "analysis", "surface", "mesh"},
    "exchange": {"conversion", "analysis", "surface", "mesh", "files"},
    "drawing": {"analysis", "surface", "mesh", "dxf", "files"},
}
ABOVE = {"bindings": set(USES), "benchmarks": set(USES)}

# Libraries that only one layer sees, by how their headers are named.
LIBRARIES = {
    "mesh": r"<opensubdiv/",
    "exchange": r"<[A-Z]\w+\.hxx>",
    "drawing": r"<cairo",
    "dxf": r"<dxflib/|<dl_",
}

# What all layers share stands in the namespace of the project.
COMMON = {NATIVE / "mesh" / name for name in ("vectors.h", "tolerances.h")}


def sources(folder):
    return sorted(path for path in folder.rglob("*") if path.suffix in (".h", ".cpp"))


def includes(path):
    return re.findall(r'^#include ([<"][^>"]+[>"])', path.read_text(), re.MULTILINE)


def outer_namespaces(path):
    """The namespaces that a file opens at the beginning of a line, outermost ones only."""
    depth, found = 0, []
    for line in path.read_text().splitlines():
        opened = re.match(r"namespace ([\w:]+) \{$", line)
        if opened or line == "namespace {":
            if depth == 0:
                found.append(opened.group(1) if opened else "")
            depth += 1
        elif re.match(r"\}  // namespace", line):
            depth -= 1
    return found


def test_all_layers_have_a_place():
    assert {path.name for path in NATIVE.iterdir() if path.is_dir()} == set(USES) | set(ABOVE)


def test_layers_use_earlier_ones():
    order = list(USES)
    for layer, used in USES.items():
        assert all(order.index(other) < order.index(layer) for other in used)


@pytest.mark.parametrize("layer", [*USES, *ABOVE])
def test_includes_point_one_way(layer):
    allowed = {layer} | (USES | ABOVE)[layer]
    for path in sources(NATIVE / layer):
        for name in includes(path):
            if name[0] == '"':
                assert name[1:].split("/")[0] in allowed, f"{path.relative_to(NATIVE)}: {name}"


@pytest.mark.parametrize("layer", LIBRARIES)
def test_heavy_libraries_stay_behind_their_layer(layer):
    own = NATIVE / layer
    found = [
        path
        for path in sources(NATIVE)
        if any(re.match(LIBRARIES[layer], name) for name in includes(path))
        and NATIVE / "benchmarks" not in path.parents
    ]
    assert found
    for path in found:
        assert own in path.parents, path.relative_to(NATIVE)


@pytest.mark.parametrize("layer", [*USES, "bindings"])
def test_a_layer_is_a_namespace(layer):
    for path in sources(NATIVE / layer):
        if path in COMMON or path.name.endswith("module.cpp"):
            continue
        spaces = outer_namespaces(path)
        assert spaces or "#define" in path.read_text(), path.relative_to(NATIVE)
        for space in spaces:
            assert re.match(rf"hull::{layer}(::|$)", space), f"{path.relative_to(NATIVE)}: {space}"
