# SPDX-License-Identifier: GPL-3.0-or-later
"""Readers of the section files, from the descriptions of their formats alone: nothing is shared
with their writers. Each gives a list of (x, points (n, 2)), m, x forward."""

import re
import xml.etree.ElementTree

import numpy as np


def read_ghs(text):
    """(header as dict, sections, part's lines) of a .gf file."""
    rows = iter(text.split("\r\n"))
    header = {"name": next(rows)}
    for row in rows:
        if row == "*":
            break
        if not row.startswith("\\"):
            key, value = row.split(":")
            header[key] = value
    scale = {"M": 1.0, "F": 0.3048}[header["P"]]
    assert next(rows) == "HULL"
    sections = []
    for _ in range(int(next(rows))):
        x, count = next(rows).split(",")
        points = [[float(word) for word in next(rows).split(",")] for _ in range(int(count))]
        sections.append((-scale * float(x), scale * np.array(points)))
    assert next(rows) == "0,0,0"
    rest = list(rows)
    assert rest[0] == "**" and rest[-2:] == ["****", ""]
    return header, sections, rest


def read_archimedes(text):
    root = xml.etree.ElementTree.fromstring(text.encode())
    hull = root.find("APPENDAGE")
    sections = []
    for section in hull.findall("SECTION"):
        points = np.array(section.find("OFFSETS").text.split(), dtype=float).reshape(-1, 2)
        assert len(points) == int(section.find("OFFSET_COUNT").text)
        sections.append((float(section.find("YCOORD").text), points))
    assert len(sections) == int(hull.find("SECTION_COUNT").text)
    return root, sections


def read_section_text(text):
    lines = text.splitlines()
    at, sections = 3, []
    for _ in range(int(lines[2])):
        x, count = lines[at].split()
        rows = [[float(word) for word in row.split()] for row in lines[at + 1 :][: int(count)]]
        sections.append((float(x), np.array(rows)))
        at += 1 + int(count)
    assert at == len(lines)
    return lines[:2], sections


def read_michlet(text):
    """(the general values in order, offsets (s, w) from the bow aft, the hull's values)."""
    head, _, rest = text.partition("# Offsets\r\n")
    table, _, tail = rest.partition("#")
    offsets = np.array([row.split(",") for row in table.split()], dtype=float)

    def values(part):
        return [row for row in re.split("\r\n", part) if row and not row.startswith("#")]

    return values(head), offsets, values("#" + tail)
