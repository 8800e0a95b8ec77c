# SPDX-License-Identifier: GPL-3.0-or-later
"""A study of the coaster: variants of her form, each brought to a displacement, LCB and stability.

PYTHONPATH=build/release/python python3 scripts/coaster_study.py --table coaster.csv \
    --journal coaster.jsonl --front coaster.svg --engine processes --workers 2

Her relatives are made of her: one with a finer fore and after body, one with fuller shoulders, one
with more flare. Each variant is a member of their family, then brought to its own displacement and
LCB, and to stability enough, at the least change. --variants, --seed: how many, and which. --engine
dask: the same on a Dask cluster. docs/studies.md tells the rest.
"""

import argparse
from pathlib import Path

from hull_studies import study_from
from hull_studies.command import add_arguments, carry_out

SAMPLES = Path(__file__).resolve().parents[1] / "samples"
# Displaced volume, wetted surface: of the coaster as she is.
AS_SHE_IS = (4386.5, 1654.4)


def _shifted_at(point, shift, extent):
    field = {"base": "point", "point": point, "shift": shift, "extent": extent, "falloff": 0.6}
    return {"changes": [{"change": "fields", "fields": [field]}]}


def described(count, seed):
    """The study as plain data."""
    return {
        "name": "Study of a coaster",
        "hulls": [
            "coaster.hull.json",
            {"changes": [{"change": "sections", "part": "fair", "block": 0.72}]},
            _shifted_at([64.0, 6.2, 4.6], [0.0, 0.5, 0.0], 18.0),
            _shifted_at([78.0, 2.0, 7.0], [0.0, 0.6, 0.0], 12.0),
        ],
        "variables": {
            "finer": [-1.5, 2.0],
            "shoulders": [-1.5, 1.5],
            "flare": [-1.0, 2.0],
            "volume": [4150.0, 4750.0],
            "lcb": [-2.5, 3.0],
        },
        "sampling": {"kind": "latin", "count": count, "seed": seed},
        "changes": [
            {"change": "weights", "weights": ["$finer", "$shoulders", "$flare"]},
            {
                "change": "targets",
                "beam_scale": [0.98, 1.02],
                "targets": [
                    {"number": "displaced_volume", "value": "$volume"},
                    {"number": "lcb_percent", "value": "$lcb"},
                    {"number": "km_transverse", "value": 6.1, "sense": "at least"},
                ],
            },
        ],
    }


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    add_arguments(parser)
    parser.add_argument("--variants", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=20)
    arguments = parser.parse_args()
    try:
        study = study_from(described(arguments.variants, arguments.seed), SAMPLES)
        carry_out(
            study,
            arguments,
            labels=(("Displaced volume ∇", "m³"), ("Wetted surface", "m²")),
            marks=[(*AS_SHE_IS, "the coaster")],
        )
    except (ValueError, OSError, RuntimeError) as error:
        parser.exit(1, f"\n{error}\n")


if __name__ == "__main__":
    main()
