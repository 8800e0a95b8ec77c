# SPDX-License-Identifier: GPL-3.0-or-later
"""One name is one thing: names of anonymous namespaces are used once in a folder, whose sources may
be compiled as one (cmake/units.cmake), and what headers declare bears its name alone."""

import re
from collections import defaultdict
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
# But for folders whose sources are programs of their own.
FOLDERS = sorted(
    {path.parent for top in ("native", "tests/native") for path in (ROOT / top).rglob("*.cpp")}
    - {ROOT / "native/benchmarks", ROOT / "tests/native/modelling/with_ceres"}
)


def anonymous_parts(text):
    """What stands between `namespace {` and its end."""
    return re.findall(r"^namespace \{$(.*?)^\}  // namespace$", text, re.MULTILINE | re.DOTALL)


def parameter_types(text):
    parameters = re.split(r",(?![^<(]*[>)])", re.sub(r"\s+", " ", text))
    return tuple(
        re.sub(r"(?<=[\w>&*]) ?\b\w+$", "", re.sub(r" =.*", "", one).strip()) for one in parameters
    )


def names(text):
    """Of what is defined at the margin: constants, types, and functions with the types that they
    take."""
    text = re.sub(r"//.*", "", text)
    for statement in re.findall(r"^constexpr [^;(]*;", text, re.MULTILINE):
        yield from re.findall(r"\b(k[A-Z]\w*)(?=\[| =|\{)", statement)
    yield from re.findall(r"^(?:struct|class|enum class) (\w+)[^;{]*\{", text, re.MULTILINE)
    for name, taken in re.findall(
        r"^[A-Za-z][^;{}()=]*\b(\w+)\(((?:[^(){}]|\([^()]*\))*)\)[^;{}]*\{", text, re.MULTILINE
    ):
        if not name.startswith("TEST"):
            yield name, parameter_types(taken)


TYPE = r"^(?:struct|class|enum class|enum) (\w+)(?: final)?(?: : [^;{]*)? ?\{|^using (\w+) ="


def types(text):
    """Classes, structs, enumerations and aliases at the margin: those of a namespace."""
    return {one or other for one, other in re.findall(TYPE, text, re.MULTILINE)}


def constants(text, place=""):
    """All of them; those of a namespace where `place` is the margin."""
    return {
        name
        for statement in re.findall(place + r"(?:\binline )?\bconstexpr [^;]*;", text, re.MULTILINE)
        for name in re.findall(r"\b(k[A-Z]\w*)(?=\[| =|\{)", statement)
    }


def names_of_headers(files):
    """By name the headers that declare it in a namespace. `files`: of each name its text."""
    homes = defaultdict(set)
    for name, text in files.items():
        if name.endswith(".h"):
            for declared in types(text) | constants(text, "^"):
                homes[declared].add(name)
    return homes


def second_homes(files):
    """By name the files that declare what has its name from a header, and that header."""
    homes = names_of_headers(files)
    for name, text in files.items():
        for declared in (types(text) | constants(text)) & homes.keys():
            homes[declared].add(name)
    return {name: found for name, found in homes.items() if len(found) > 1}


def native_files():
    """Without benchmarks, which are programs of their own. Comments are left out."""
    return {
        str(path.relative_to(ROOT / "native")): re.sub(r"//.*", "", path.read_text())
        for path in sorted((ROOT / "native").rglob("*"))
        if path.suffix in (".h", ".cpp") and path.parent.name != "benchmarks"
    }


def test_names_of_headers_are_found():
    header = """
inline constexpr double kFlat = 1e-6;
struct Part : Whole {
  static constexpr int kInner = 1;
};
class Ahead;
template <class T>
using Parts = std::vector<T>;
"""
    source = """
double height() {
  constexpr double kFlat = 1e-9;
  constexpr int kInner = 2;
  return kFlat * std::numeric_limits<double>::infinity();
}
class Ahead {
};
"""
    files = {"a/part.h": header, "b/other.h": "using Part = int;\n", "b/height.cpp": source}
    assert set(names_of_headers(files)) == {"kFlat", "Part", "Parts"}
    assert second_homes(files) == {
        "kFlat": {"a/part.h", "b/height.cpp"},
        "Part": {"a/part.h", "b/other.h"},
    }


def test_names_of_headers_have_one_home():
    files = native_files()
    homes = names_of_headers(files)
    assert homes["kInPlane"] == homes["kLeastSize"] == {"mesh/tolerances.h"}
    assert second_homes(files) == {}


def test_nodes_of_gauss_rules_have_one_home():
    nodes = r"0\.(1127016|2113248|0694318|0469100)"
    assert [name for name, text in native_files().items() if re.search(nodes, text)] == [
        "analysis/arithmetic/gauss.h"
    ]


def test_names_are_found():
    text = """
constexpr double kA = 1.0, kB[2] = {1.0, 2.0};  // m
struct Part {
  int kInner = 1;
};
double length(const std::vector<int>& of,
              double from = 0.0) {
  return length(of);
}
"""
    assert set(names(text)) == {
        "kA",
        "kB",
        "Part",
        ("length", ("const std::vector<int>&", "double")),
    }


@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: str(folder.relative_to(ROOT)))
def test_anonymous_names_are_used_once(folder):
    homes = defaultdict(set)
    for path in sorted(folder.glob("*.cpp")):
        for part in anonymous_parts(path.read_text()):
            for name in names(part):
                homes[name].add(path.name)
    assert {name: files for name, files in homes.items() if len(files) > 1} == {}
