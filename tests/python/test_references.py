# SPDX-License-Identifier: GPL-3.0-or-later
"""Every work that code or docs cite is in docs/references.md, and nothing else is there."""

import re
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
REFERENCES = ROOT / "docs" / "references.md"
ROOTS = ("native", "addon", "python", "docs", "samples", "scripts", "tests")
ENDINGS = {".h", ".cpp", ".py", ".md"}

# One or more names, or letters, then a year: "Stam 1998", "Biermann, Levin & Zorin (2000)",
# "de Boor's (1978)", "ITTC 1957".
NAME = r"(?:de |do |el )?[A-Z\u00c0-\u00de][a-z\u00df-\u00ff]+(?:[A-Z][a-z]+)?"
NAMES = rf"{NAME}(?:(?:, |,? and |,? & ){NAME})*"
LETTERS = r"\b[A-Z]{3,6}"
CITATION = re.compile(rf"({NAMES}|{LETTERS})(?:'s? \w+)?,? \(?((?:18|19|20)\d\d)\b(?![.:-]\d)")
# What is named after somebody, and so has a source: "Lawson's iteration", "Coons' bicubic patch".
NAMED_THING = re.compile(
    r"(?:(?<=s)'|'s) (?:[a-z-]+ ){0,2}(?:rules?|line|hull|iteration|condition|method|formulas?|"
    r"theorem|algorithm|criterion|series|weights|factors|patch|twists|bound|measure|integral|"
    r"scheme|predicates)\b"
)
ITS_NAMES = re.compile(rf"({NAMES})\Z")
# Whose rules are in every textbook, and owners that are no authors.
COMMON = {
    "Newton", "Gauss", "Simpson", "Green", "Euler", "Lagrange", "Legendre", "Bernstein", "Hermite",
    "Steiner", "Runge", "Kutta", "Thomas", "Delaunay",
}  # fmt: skip
NO_OWNERS = {"Blender", "Midship", "HullData"}
STANDARD = re.compile(r"\bMSC\.\d+\(\d+\)|\bISO[ -]10303-\d+|\bIGES 5\.3")
# What looks like a citation and is none.
NO_AUTHORS = {"Release", "Code", "Stability", "January", "May", "November", "December"}


@cache
def prose(path):
    """The text on one line, without what begins a comment's lines."""
    text = path.read_text(encoding="utf-8")
    return re.sub(r"\s*\n[ \t]*(?://|#|\*)?[ \t]*", " ", text)


def divided(names):
    return re.split(r",? and |,? & |, ", names)


def surnames(names):
    return {re.sub(r"^(?:de|do|el) ", "", name) for name in divided(names)}


def key(names, year):
    """(first author, year): the same however the names are joined."""
    return divided(names)[0], year


def cited_in(text):
    found = {key(*match.groups()) for match in CITATION.finditer(text)}
    return {one for one in found if one[0] not in NO_AUTHORS}


def named_after(text):
    """The names of those after whom a rule, a line and the like are called, but for COMMON."""
    found = set()
    for thing in NAMED_THING.finditer(text):
        names = ITS_NAMES.search(text[max(0, thing.start() - 80) : thing.start()])
        found |= surnames(names[1]) if names else set()
    return found - COMMON


def listed():
    """(names, year) of each entry, and the standards."""
    text = REFERENCES.read_text(encoding="utf-8")
    entries = re.findall(r"^- \*\*(.+?)\*\*: ", text, flags=re.M)
    works = [entry for entry in entries if re.search(r" \d{4}$", entry)]
    return {key(*entry.rsplit(" ", 1)) for entry in works}, text


def listed_authors():
    entries = re.findall(r"^- \*\*(.+?) \d{4}\*\*: ", REFERENCES.read_text("utf-8"), flags=re.M)
    return {name for names in entries for name in surnames(names)}


@cache
def sources():
    return tuple(found_sources())


def found_sources():
    for root in ROOTS:
        for path in sorted((ROOT / root).rglob("*")):
            if path.suffix in ENDINGS and path not in (REFERENCES, Path(__file__).resolve()):
                yield path


@pytest.mark.parametrize(
    "text, found",
    [
        ("as Stam (1998) has it", {("Stam", "1998")}),
        ("(Biermann, Levin & Zorin 2000)", {("Biermann", "2000")}),
        ("Anderson and Bj\u00f6rck's rule (1973) of", {("Anderson", "1973")}),
        ("(do Carmo 1976, 3-3)", {("do Carmo", "1976")}),
        ("Halstead, Kass & DeRose 1993", {("Halstead", "1993")}),
        ("kMost = 2000, Release 2000", set()),
        ("by the ITTC 1957 line", {("ITTC", "1957")}),
        ("Schoenberg and Whitney's condition (1953): each", {("Schoenberg", "1953")}),
    ],
)
def test_citations_are_seen(text, found):
    assert cited_in(text) == found


@pytest.mark.parametrize(
    "text, found",
    [
        ("by Lawson's iteration, to 1e-3", {"Lawson"}),
        ("Schoenberg and Whitney's condition", {"Schoenberg", "Whitney"}),
        ("Coons' bicubic patch in", {"Coons"}),
        ("with Hoerner's form factors", {"Hoerner"}),
        ("by Newton's method on Hull's own line", {"Hull"}),
        ("Michell's (1898)", set()),
    ],
)
def test_what_is_named_after_somebody_is_seen(text, found):
    assert named_after(text) == found


def test_authors_of_what_is_named_after_them_are_listed():
    authors, missing = listed_authors(), []
    for path in sources():
        for name in sorted(named_after(prose(path)) - NO_OWNERS - authors):
            missing.append(f"{path.relative_to(ROOT)}: {name}")
    assert missing == []


def test_all_citations_are_listed_and_all_listed_are_cited():
    works, text = listed()
    assert len(works) > 20
    missing, cited = [], set()
    for path in sources():
        content = prose(path)
        here = cited_in(content)
        cited |= here
        missing += [f"{path.relative_to(ROOT)}: {' '.join(one)}" for one in sorted(here - works)]
        missing += [
            f"{path.relative_to(ROOT)}: {name}"
            for name in STANDARD.findall(content)
            if name.replace("ISO-", "ISO ") not in text
        ]
    assert missing == []
    assert works - cited == set()


def test_entries_are_in_order():
    text = REFERENCES.read_text(encoding="utf-8")
    names = re.findall(r"^- \*\*(?:de |do |el )?(.+?)\*\*: ", text, flags=re.M)
    assert names == sorted(names)
