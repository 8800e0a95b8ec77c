# SPDX-License-Identifier: GPL-3.0-or-later
"""New hulls after a type ship: the form of a ship that is there, brought to other dimensions."""

from dataclasses import dataclass, replace

# Modules, not what is in them: in the add-on they run only when that is called.
from .. import scaling, ship_data, wanted


@dataclass(frozen=True)
class TypeShip:
    """sample: the name of the sample hull whose bow, stern and sections it has."""

    name: str
    description: str
    sample: str


TYPE_SHIPS = {
    "COASTER": TypeShip("Coaster", "Pram stern, round bilges, raked stem", "coaster"),
    "CONTAINER_SHIP": TypeShip(
        "Container Ship", "Bulbous bow, boss aft, wide flare and counter", "container_ship"
    ),
    "BULK_CARRIER": TypeShip(
        "Bulk Carrier", "Full, long parallel middle body, bulb and boss", "bulk_carrier"
    ),
    "RORO": TypeShip("RoRo Vessel", "Pram stern with a skeg, bulbous bow, knuckled side", "roro"),
    "RESEARCH_VESSEL": TypeShip(
        "Research Vessel",
        "Spoon bow for ice, tunnels aft, sides of three planes",
        "research_vessel",
    ),
    "NAVAL_VESSEL": TypeShip(
        "Naval Vessel", "Slender, sonar dome, tumblehome above a knuckle", "naval_vessel"
    ),
}


def as_new(data, name, length, beam, draft, depth):
    """A new HullData with the control mesh of this one, its layers, tags, flats, ties and groups,
    brought to main dimensions in m: heights by the depth, the draft where the new hull floats.
    Nothing else of the ship comes along: neither weights, loads and openings, resistance, plating
    and appendages nor lines, targets, fields and variants.

    ValueError for dimensions that no hull can have, and as scaling.to_dimensions.
    """
    if not draft < depth:
        raise ValueError(
            f"A depth of {depth:.6g} m leaves no freeboard at a draft of {draft:.6g} m: give more"
        )
    made = scaling.to_dimensions(data, length_pp=length, beam=beam, draft=draft, depth=depth)
    return replace(
        made, name=name, afloat=ship_data.Afloat(), load=ship_data.Load(), load_cases=[],
        weights=ship_data.Weights(), downflooding_points=[], wind=None,
        resistance=ship_data.Resistance(), lines=None, targets=wanted.Targets(), area_target=None,
        fields=[], appendages=[], plating=None, variants=[], source="", notes=[],
    )  # fmt: skip
