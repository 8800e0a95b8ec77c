# SPDX-License-Identifier: GPL-3.0-or-later
"""Hull objects from hull_io's HullData, and hull files of them, with all that hull files hold."""

from ....hull_io import write_hull_file
from ..hull import hull_creation, hull_to_data
from ..variants import variant_data


def hull_object(hull, scene, collection):
    """A new hull object from a HullData, with its variants, in a collection; returns it, up to
    date."""
    obj = hull_creation.hull_object(hull, scene, collection)
    variant_data.give_variants(obj, hull, scene)
    return obj


def export_hull_file(obj, scene, path):
    """Writes the hull as a hull file (.hull.json), which reads back as the same hull."""
    data = hull_to_data.hull_data(obj, scene)
    data.variants = variant_data.take_variants(obj, scene)
    write_hull_file(data, path)
