# SPDX-License-Identifier: GPL-3.0-or-later
"""Lists of numbers as people type them: with blanks between, ranges as first:last:step."""

from math import isfinite, radians

from .limits import MAX_LISTED


def numbers(text, name):
    """The numbers of a text such as "0 0.5 1:9:1"; a decimal comma counts as a point.

    ValueError that begins with `name` where it can't be understood.
    """
    found = []
    for word in _words(text):
        try:
            parts = [float(part) for part in word.split(":")]
        except ValueError:
            parts = []
        if len(parts) not in (1, 3) or not all(map(isfinite, parts)):
            raise ValueError(
                f'{name}: "{word}" should be numbers with blanks between, or first:last:step'
            )
        found += parts if len(parts) == 1 else _range(*parts, word, name)
        if len(found) > MAX_LISTED:
            raise ValueError(f"{name}: there are more than {MAX_LISTED} numbers: list fewer")
    return tuple(found)


def scaled(text, factor):
    """A list of lengths or of diagonals, such as "1 0:80:10" or "5.2/35", with its lengths times a
    factor, to five digits, and angles as they are; ValueError where it can't be understood."""
    return " ".join(_scaled_word(word, factor) for word in _words(text))


def _scaled_word(word, factor):
    lengths, slash, angle = word.partition("/")
    return ":".join(f"{factor * float(part):.5g}" for part in lengths.split(":")) + slash + angle


def _words(text):
    return text.replace(";", " ").replace(",", ".").split()


def _range(first, last, step, word, name):
    if not step > 0.0 or not first <= last:
        raise ValueError(f'{name}: "{word}" should rise, as 1:9:2 does')
    steps = (last - first) / step * (1.0 + 1e-9)
    if not steps < MAX_LISTED:
        raise ValueError(f'{name}: "{word}" has more than {MAX_LISTED} numbers: widen the step')
    return [first + k * step for k in range(int(steps) + 1)]


def diagonals(text):
    """Pairs (height in m, angle in rad) of a text such as "5.2/35 4/50", the angle in degrees."""
    pairs = []
    for word in _words(text):
        height, _, angle_deg = word.partition("/")
        try:
            pair = (float(height), radians(float(angle_deg)))
        except ValueError:
            pair = ()
        if not pair or not all(map(isfinite, pair)):
            raise ValueError(
                f'Diagonals: "{word}" should be a height in m, a slash, and an angle in degrees '
                "below the horizontal, such as 5.2/35"
            )
        pairs.append(pair)
    return tuple(pairs)
