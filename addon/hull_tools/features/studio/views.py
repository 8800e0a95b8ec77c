# SPDX-License-Identifier: GPL-3.0-or-later
"""From where the studio's cameras look."""

from dataclasses import dataclass


@dataclass(frozen=True)
class View:
    """Where from a camera looks: degrees from ahead to port, and above the horizon. lens: mm; 0
    for an orthographic one. below: whether it shows only what is below the water, if there is any.
    """

    label: str
    description: str
    bearing: float
    elevation: float
    lens: float = 0.0
    below: bool = False


VIEWS = {
    "BOW": View("Bow quarter", "From off the starboard bow", -37.0, 8.5, 55.0),
    "STERN": View("Stern quarter", "From off the starboard quarter", -142.0, 9.0, 55.0),
    "PROFILE": View("Profile", "From starboard, level, to scale", -90.0, 0.0),
    "PLAN": View("Plan", "From above, to scale", -90.0, 90.0),
    "BODY": View("Body", "From ahead, level, to scale", 0.0, 0.0),
    "UNDERWATER": View(
        "Underwater", "From below the bow, what is under water", -38.0, -15.0, 45.0, below=True
    ),
    "TURNTABLE": View("Turntable", "From a camera that goes round the hull", -40.0, 7.5, 60.0),
}
FIRST, TURNTABLE = "BOW", "TURNTABLE"
