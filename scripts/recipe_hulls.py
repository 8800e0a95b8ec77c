# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls before and after the recipes of shape fields, as recipe_figures.py draws them.

blender --background --python recipe_hulls.py -- FOLDER

into FOLDER: NAME-before.hull.json and NAME-after.hull.json for each of RECIPES.
"""

import sys
from pathlib import Path

import bpy

# Blender runs a file without its folder on the path.
sys.path[:0] = [str(Path(__file__).resolve().parent)]

from enabled_addon import part  # noqa: E402

# The recipe, what it is shown on (a sample, or a kind of new hull), and how often that is
# subdivided exactly before.
RECIPES = {
    "sharpen": ("SHARPEN", "coaster", 0),
    "fatten": ("FATTEN", "coaster", 0),
    "sheer": ("SHEER", "coaster", 0),
    "flare": ("FLARE", "coaster", 0),
    "bilge": ("BILGE", "container_ship", 0),
    "tunnel": ("TUNNEL", "coaster", 2),
    "bulb": ("BULB", "ROUND_BILGE", 2),
}


def write(name, recipe, hull, subdivided, folder):
    if hull.isupper():
        bpy.ops.hull.add_hull(kind=hull)
    else:
        bpy.ops.hull.load_sample(name=hull)
    for _ in range(subdivided):
        bpy.ops.hull.subdivide_exactly()
    bpy.ops.hull.export_hull(filepath=str(folder / f"{name}-before.hull.json"))
    bpy.ops.hull.add_field_recipe(recipe=recipe)
    obj = bpy.context.view_layer.objects.active
    shaping = part("features.fields.shaping")
    print(name, shaping.summary(shaping.apply(obj, bpy.context.scene)), flush=True)
    bpy.ops.hull.export_hull(filepath=str(folder / f"{name}-after.hull.json"))


def main():
    folder = Path(sys.argv[sys.argv.index("--") + 1])
    folder.mkdir(parents=True, exist_ok=True)
    for name, arguments in RECIPES.items():
        write(name, *arguments, folder)


main()
