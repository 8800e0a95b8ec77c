# SPDX-License-Identifier: GPL-3.0-or-later
"""Every work that code or docs cite is in docs/references.md, and nothing else is there."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
REFERENCES = ROOT / "docs" / "references.md"
ROOTS = ("native", "addon", "python", "docs", "samples", "scripts", "tests")
ENDINGS = {".h", ".cpp", ".py", ".md"}

# One or more names, then a year: "Stam 1998", "Biermann, Levin & Zorin (2000)", "de Boor's (1978)".
NAME = r"(?:de |do |el )?[A-Z\u00c0-\u00de][a-z\u00df-\u00ff]+(?:[A-Z][a-z]+)?"
CITATION = re.compile(
    rf"({NAME}(?:(?:, |,? and |,? & ){NAME})*)(?:'s \w+)?,? \(?((?:18|19|20)\d\d)\b(?![.:-]\d)"
)
STANDARD = re.compile(r"\bMSC\.\d+\(\d+\)|\bISO[ -]10303-\d+|\bIGES 5\.3")
# What looks like a citation and is none.
NO_AUTHORS = {"Release", "Code", "Stability", "January", "May", "November", "December"}


def prose(path):
    """The text on one line, without what begins a comment's lines."""
    text = path.read_text(encoding="utf-8")
    return re.sub(r"\s*\n[ \t]*(?://|#|\*)?[ \t]*", " ", text)


def key(names, year):
    """(first author, year): the same however the names are joined."""
    return re.split(r", | and | & ", names)[0], year


def cited_in(text):
    found = {key(*match.groups()) for match in CITATION.finditer(text)}
    return {one for one in found if one[0] not in NO_AUTHORS}


def listed():
    """(names, year) of each entry, and the standards."""
    text = REFERENCES.read_text(encoding="utf-8")
    entries = re.findall(r"^- \*\*(.+?)\*\*: ", text, flags=re.M)
    works = [entry for entry in entries if re.search(r" \d{4}$", entry)]
    return {key(*entry.rsplit(" ", 1)) for entry in works}, text


def sources():
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
    ],
)
def test_citations_are_seen(text, found):
    assert cited_in(text) == found


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
