# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the fuzzer's first inputs: every kind of mesh of mesh_from_bytes, with random edits."""

import argparse
import base64
import random
from pathlib import Path

SEED = 20
PER_KIND = 12

# Inputs that found something; mended since, and tried in every run.
FOUND = {
    "ray_along_a_flat_piece": (
        "AgAB/CmAoRO4N0DVtcH++AKNhxTTY2mGgrQoTJEnD38OAmAV9qhrFUiHjFCM"
        "t5DNhOwtDwDDY8/M/oH8nVqEbxeNYW0mW0o/JA=="
    ),
}


def two_bytes(number):
    return number.to_bytes(2, "big")


def inputs():
    """Bytes as mesh_from_bytes reads them: what to make, of which kind and size, the edits."""
    draw = random.Random(SEED)
    for body in (0, 1, 2):  # nonsense, two bodies, one body
        for kind in range(5):
            for edits in range(PER_KIND):
                yield (
                    bytes([body])
                    + two_bytes(kind)
                    + bytes([draw.randrange(256)])
                    + draw.randbytes(8 * edits + 60 * (body == 0))
                )


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    folder = parser.parse_args().folder
    folder.mkdir(parents=True, exist_ok=True)
    for number, content in enumerate(inputs()):
        (folder / f"seed_{number:03d}").write_bytes(content)
    for name, content in FOUND.items():
        (folder / f"found_{name}").write_bytes(base64.b64decode(content))


if __name__ == "__main__":
    main()
