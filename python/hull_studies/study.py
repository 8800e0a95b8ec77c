# SPDX-License-Identifier: GPL-3.0-or-later
"""A study as plain data: hulls, variables, how these are sampled, changes, and wanted numbers.

    {
      "name": "Fuller and finer",
      "hulls": ["coaster.hull.json", {"changes": [ … ]}],
      "variables": {"fuller": [0, 1], "lcb": [-1, 1]},
      "sampling": {"kind": "latin", "count": 2000, "seed": 20},
      "changes": [{"change": "weights", "weights": ["$fuller"]}, … ],
      "water": {"draft": 5.2},
      "numbers": ["displaced_volume", "km_transverse"]
    }

Hulls are files, or made of the first one by changes of their own. Changes: changes.py; sampling:
sampling.py. The water is that of the hull's particulars, upright, openings closed, where nothing
else is said; its draft is then the design draft, and follows that.
"""

import hashlib
import json
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

import hull_native as hn
from hull_io.bytes_on_disk import read_bytes
from hull_io.checked_json import CheckedJson
from hull_io.limits import MAX_FILE_BYTES, MAX_HULL_FILE_BYTES

from . import sampling, values
from .changes import checked_changes

# Goes into digests: rows of another one are not this one's.
VERSION = 1
MOST_VARIABLES, MOST_HULLS, MOST_NUMBERS = 100, 100, 100
_KEYS = {"name", "hulls", "variables", "sampling", "changes", "water", "numbers"}
_WATER = {"draft", "trim", "water_density", "openings"}
_OPENINGS = ("closed", "open")
USUAL_NUMBERS = (
    "displaced_volume", "displacement_t", "lcb", "lcb_percent", "kb", "wetted_surface",
    "waterplane_area", "lcf", "km_transverse", "km_longitudinal", "waterline_length",
    "waterline_beam", "project.block", "project.prismatic", "project.midship",
    "project.waterplane", "half_angle_of_entrance",
)  # fmt: skip


@dataclass(frozen=True)
class Study:
    """A study that was checked. variables: {name: (low, high)}; hulls: [Path, or changes]; water,
    changes, sampling: with all of their keys, None for what follows the hull; numbers: names in
    hull_native.Hydrostatics; digest: of all of it and of the files, so that what has the same
    digest has the same rows."""

    name: str
    hulls: list
    variables: dict
    sampling: dict
    changes: list
    water: dict
    numbers: tuple
    digest: str
    parts: dict = field(default_factory=dict)  # {key of the description: its digest}

    @cached_property
    def variants(self):
        """[tuple of floats]: of the variables in their order."""
        return sampling.variants(self.sampling, self.variables)


def known_numbers():
    """Names of all numbers of hull_native.Hydrostatics, those of its parts with dots."""
    parts = {
        "project": hn.FormCoefficients, "immersed": hn.FormCoefficients,
        "midship_section": hn.SectionArea, "largest_section": hn.SectionArea,
    }  # fmt: skip

    def own(kind):
        return {name for name, held in vars(kind).items() if isinstance(held, property)}

    names = own(hn.Hydrostatics) - set(parts)
    for part, kind in parts.items():
        names |= {f"{part}.{name}" for name in own(kind) - {"centroid"}}
    return names


def read_study(path):
    """The Study that a JSON file describes; hulls are sought from its folder on."""
    path = Path(path)
    data = read_bytes(path, MAX_HULL_FILE_BYTES)
    return study_from(CheckedJson(path.name).parse(data), path.parent, path.name)


def study_from(description, folder=".", name="the study"):
    """The Study that a dictionary describes. folder: from which files are sought. HullFileError
    (a ValueError), with the key, for what is none; name: of the study in that."""
    check = CheckedJson(name)
    description = check.object(_plain(check, description), "the study", _KEYS)
    variables = _checked_variables(check, description.get("variables", {}))
    hulls, contents = _checked_hulls(check, description.get("hulls"), Path(folder))
    changes = checked_changes(check, description.get("changes", []), variables, len(hulls))
    checked = {
        "name": check.text(description.get("name", "Study"), "name"),
        "variables": variables,
        "sampling": sampling.checked_sampling(check, description.get("sampling"), variables),
        "changes": changes,
        "water": _checked_water(check, description.get("water", {}), variables),
        "numbers": _checked_numbers(check, description.get("numbers", list(USUAL_NUMBERS))),
    }
    unused = set(variables) - values.used_variables([changes, checked["water"]])
    if unused:
        raise check.error(
            f"variables.{min(unused)}", "nothing varies with it", "use it in a change, or drop it"
        )
    _check_draft(check, checked)
    parts = {key: _digest(held) for key, held in {**checked, "hulls": contents}.items()}
    return Study(hulls=hulls, digest=_digest([VERSION, parts]), parts=parts, **checked)


def _plain(check, description):
    """What JSON makes of it: lists of tuples, and nothing else than plain data."""
    try:
        return json.loads(json.dumps(description, allow_nan=False))
    except (TypeError, ValueError, RecursionError) as error:
        raise check.error(
            "the study", f"it is no plain data ({error})", "write numbers, texts, lists and objects"
        ) from error


def _digest(content):
    text = json.dumps(content, sort_keys=True, separators=(",", ":"), allow_nan=False)
    return hashlib.sha256(text.encode()).hexdigest()


def _checked_variables(check, value):
    value = check.object(value, "variables")
    if len(value) > MOST_VARIABLES:
        raise check.error("variables", f"there are {len(value)}", f"{MOST_VARIABLES} are the most")
    found = {}
    for name, bounds in value.items():
        where = f"variables.{check.text(name, 'variables')}"
        if not name or name.startswith(values.MARK):
            raise check.error(where, "that is no name", 'write it without "$" here')
        bounds = check.list(bounds, where, 2)
        low, high = (check.number(one, where, -1e300, 1e300) for one in bounds)
        if low > high:
            raise check.error(where, f"{low:g} is above {high:g}", "write the lower bound first")
        found[name] = (low, high)
    return found


def _checked_hulls(check, value, folder):
    """([Path, or list of changes], [the digest of a file's bytes, or the changes])."""
    value = check.list(value, "hulls", most=MOST_HULLS)
    if not value or not isinstance(value[0], str):
        raise check.error("hulls", "the first is no file", "write the path of a hull file first")
    hulls, contents = [], []
    for k, one in enumerate(value):
        if isinstance(one, str):
            path = folder / check.text(one, f"hulls[{k}]")
            contents.append(file_digest(path))
            hulls.append(path)
        else:
            one = check.object(one, f"hulls[{k}]", {"changes"})
            within = check.within(f"hulls[{k}].")
            hulls.append(checked_changes(within, one.get("changes"), {}, 1))
            contents.append(hulls[-1])
    return hulls, contents


def file_digest(path):
    return hashlib.sha256(read_bytes(Path(path), MAX_FILE_BYTES)).hexdigest()


def _checked_water(check, value, variables):
    value = check.object(value, "water", _WATER)
    return {
        key: None if value.get(key) is None else values.number(check, value[key], where, variables)
        for key, where in ((key, f"water.{key}") for key in ("draft", "trim", "water_density"))
    } | {"openings": check.choice(value.get("openings", "closed"), "water.openings", _OPENINGS)}


def _check_draft(check, study):
    """Targets scale the water with the hull, which a draft of the study's own does not follow."""
    for k, change in enumerate(study["changes"]):
        if study["water"]["draft"] is not None and change.get("draft_scale", [1, 1]) != [1, 1]:
            raise check.error(
                f"changes[{k}].draft_scale",
                "it would scale the water, whose draft the study fixes",
                "take it out, or water.draft",
            )


def _checked_numbers(check, value):
    known = known_numbers()
    found = check.list(value, "numbers", most=MOST_NUMBERS)
    for k, name in enumerate(found):
        if not isinstance(name, str) or name not in known:
            raise check.error(
                f"numbers[{k}]",
                "it is no number of hydrostatics",
                f"there are {', '.join(sorted(known))}",
            )
    return tuple(dict.fromkeys(found))
