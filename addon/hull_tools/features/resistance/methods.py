# SPDX-License-Identifier: GPL-3.0-or-later
"""Rows over speeds of a ship by each method, and what of the hull they rest on. No Blender here."""

from dataclasses import asdict, dataclass, fields, replace

from ...bridge import native


@dataclass(frozen=True, eq=False)
class Found:
    """rows: of hull_native.holtrop_table() or another method's. measured: what the method asks of
    the ship as the hull has it, by its name there, whatever is given in its place. told: sentences
    about what was reckoned with."""

    rows: list
    measured: dict
    told: tuple = ()


def found(body, asked):
    """Found of a hull_native.HullBody by asked.Inputs; ValueError as the method."""
    position = {k: v for k, v in asked.where.position().items() if k != "heel"}
    return _METHODS[asked.method](body, asked, position)


def _michell(body, asked, position):
    hull_native = native.require()
    rows = hull_native.michell_table(
        body,
        asked.speeds,
        form_factor=asked.form_factor,
        water_density=asked.where.water_density,
        **position,
        **dict(asked.given),
    )
    return Found(rows, asdict(hull_native.thin_ship(body, **position)))


def _holtrop(body, asked, position):
    hull_native = native.require()
    ship = hull_native.holtrop_ship(body, **position)
    own = {"stern_coefficient": asked.stern, **_hulls(asked)}
    own["thruster_diameter"], own["thruster_coefficient"] = asked.thruster
    if asked.appendages:
        own["appendages"] = (asked.appendages,)
    propeller = hull_native.Propeller(**dict(asked.propeller)) if asked.propeller else None
    rows = hull_native.holtrop_rows(
        replace(ship, **own, **dict(asked.given)),
        asked.speeds,
        propeller=propeller,
        roughness=asked.roughness,
        water_density=asked.where.water_density,
    )
    return Found(rows, asdict(ship))


def _hulls(asked):
    """Whether hulls lie side by side, where that is given."""
    return {} if asked.side_by_side is None else {"side_by_side": asked.side_by_side}


def _savitsky(body, asked, position):
    hull_native = native.require()
    density, how = asked.where.water_density, {**position, **dict(asked.planing)}
    given = dict(asked.given)
    try:
        measured = asdict(hull_native.planing_boat(body, water_density=density, **how))
    except ValueError:
        if "deadrise_deg" not in given:
            raise
        measured = {}  # a bottom that has no deadrise: what is given counts
    boat = hull_native.planing_boat(body, water_density=density, **how, **given)
    boat = replace(boat, **_hulls(asked))
    rows = hull_native.savitsky_table(boat, asked.speeds, water_density=density)
    return Found(rows, measured)


def _delft(body, asked, position):
    hull_native = native.require()
    found = hull_native.delft_fins(body, **position)
    yacht = hull_native.delft_yacht(body, **position)
    keels, rudders = (
        hull_native.given_fins(fins, _given_of(asked.given, name), name)
        for name, fins in (("keel", found.keels), ("rudder", found.rudders))
    )
    names = {each.name for each in fields(yacht)}
    rows = hull_native.delft_table(
        replace(yacht, **_hulls(asked), **{n: value for n, value in asked.given if n in names}),
        asked.speeds,
        heel_deg=asked.heel_deg,
        keel=keels,
        rudder=rudders,
        form_factor=asked.form_factor,
        water_density=asked.where.water_density,
    )
    measured = {**asdict(yacht), **_measured("keel", found.keels)}
    measured.update(_measured("rudder", found.rudders))
    told = _told_of(replace(found, keels=keels, rudders=rudders))
    return Found(rows, measured, tuple(told))


def _given_of(given, name):
    """What is given of keels or rudders, by the names of DelftFin's fields."""
    begin = f"{name}_"
    return {each[len(begin) :]: value for each, value in given if each.startswith(begin)}


def _measured(name, fins):
    """What keels or rudders are together, 0 of none, by the names of what is given."""
    hull_native = native.require()
    one = hull_native.one_fin(fins)
    names = [each.name for each in fields(hull_native.DelftFin)]
    return {f"{name}_{each}": getattr(one, each, 0.0) for each in names}


def _told_of(fins):
    """Which appendages count as what."""
    for word, known in (("Keel", fins.keels), ("Rudder", fins.rudders)):
        if known:
            yield f"{word}: {', '.join(fin.name for fin in known)}"
    if not fins.keels and not fins.rudders:
        yield "No keel, no rudder: what is in the hull's own mesh counts as hull"
    if fins.left_out:
        yield f"Left out, as no fin in the water: {', '.join(fins.left_out)}"


_METHODS = {"HOLTROP": _holtrop, "MICHELL": _michell, "SAVITSKY": _savitsky, "DELFT": _delft}
