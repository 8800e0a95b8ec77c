# SPDX-License-Identifier: GPL-3.0-or-later
"""Versions of the C library's symbols that a shared object asks for, read and lowered.

Of ELF files for 64 bits, little-endian (System V ABI, chapter 4; Linux Standard Base Core 5.0,
"Symbol Versioning").
"""

import struct
from dataclasses import dataclass

_SHT_DYNSYM, _SHT_VERNEED, _SHT_VERSYM = 11, 0x6FFFFFFE, 0x6FFFFFFF
_VERSION_BITS = 0x7FFF


@dataclass(frozen=True)
class Need:
    """A version, such as GLIBC_2.34, of a library that is asked for; symbols: by which names. at:
    where its entry is in the file."""

    library: str
    version: str
    symbols: tuple
    at: int


@dataclass(frozen=True)
class _Section:
    kind: int
    offset: int
    size: int
    link: int
    count: int


def needs(data):
    """All Needs of a file's bytes; ValueError where it is no shared object of the kind."""
    if data[:6] != b"\x7fELF\x02\x01":
        raise ValueError("no ELF file for 64 bits, little-endian")
    sections = _sections(data)
    of_kind = {section.kind: section for section in sections}
    if _SHT_VERNEED not in of_kind:
        return []
    symbols = _symbols_by_version(data, sections, of_kind)
    section = of_kind[_SHT_VERNEED]
    strings = sections[section.link].offset
    found, at = [], section.offset
    for _ in range(section.count):
        _, count, library, first, following = struct.unpack_from("<HHIII", data, at)
        entry = at + first
        for _ in range(count):
            _, _, index, name, next_entry = struct.unpack_from("<IHHII", data, entry)
            names = tuple(symbols.get(index & _VERSION_BITS, ()))
            version = _text(data, strings + name)
            found.append(Need(_text(data, strings + library), version, names, entry))
            entry += next_entry
        at += following
    return found


def lowered(data, need, instead):
    """The bytes with a Need exchanged for another version of the same library, which the file must
    ask for too. Which symbols these are is the caller's to look at."""
    found = [(one.library, one.version) for one in needs(data)]
    if (need.library, instead) not in found:
        raise ValueError(f"{need.library}: {instead} is not asked for beside {need.version}")
    other = needs(data)[found.index((need.library, instead))]
    changed = bytearray(data)
    # Hash and name; flags and the index, by which symbols refer to it, stay.
    for first, last in ((0, 4), (8, 12)):
        changed[need.at + first : need.at + last] = data[other.at + first : other.at + last]
    return bytes(changed)


def _sections(data):
    (table,) = struct.unpack_from("<Q", data, 0x28)
    size, count = struct.unpack_from("<HH", data, 0x3A)
    found = []
    for at in range(table, table + size * count, size):
        _, kind, _, _, offset, length, link, info = struct.unpack_from("<IIQQQQII", data, at)
        found.append(_Section(kind, offset, length, link, info))
    return found


def _symbols_by_version(data, sections, of_kind):
    """Names of dynamic symbols by the index of their version."""
    table, versions = of_kind[_SHT_DYNSYM], of_kind[_SHT_VERSYM]
    strings = sections[table.link].offset
    found = {}
    for number in range(versions.size // 2):
        (index,) = struct.unpack_from("<H", data, versions.offset + 2 * number)
        (name,) = struct.unpack_from("<I", data, table.offset + 24 * number)
        found.setdefault(index & _VERSION_BITS, []).append(_text(data, strings + name))
    return found


def _text(data, at):
    return data[at : data.index(b"\0", at)].decode("ascii")
