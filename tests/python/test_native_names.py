# SPDX-License-Identifier: GPL-3.0-or-later
"""Names of anonymous namespaces are used once in a folder: its sources may be compiled as one
(cmake/units.cmake)."""

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
