# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers and names as the files of other programs take them."""


def decimal(value, digits=5):
    """A number with so many decimals; no minus before a zero."""
    text = f"{value:.{digits}f}"
    return text[1:] if text.startswith("-") and not text.strip("-0.") else text


def plain_name(name, longest=58):
    """A name in one line of ASCII, "?" for other letters, "Hull" where there is none."""
    text = " ".join(name.encode("ascii", errors="replace").decode().split())
    return text[:longest].strip() or "Hull"
