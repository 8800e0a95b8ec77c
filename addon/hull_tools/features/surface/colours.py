# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface object coloured by curvature, slope or distance: an attribute of its mesh, which the
solid view and a material show, and the scale that tells what the colours mean."""

import numpy as np

from ...bridge import native
from ...bridge.blender.units import as_typed
from . import materials

ATTRIBUTE = "Hull colours"

# By Object.hull.fairness.colours.
FIELDS = {
    "GAUSSIAN": "gaussian",
    "MEAN": "mean",
    "MAXIMUM": "maximum",
    "MINIMUM": "minimum",
    "SLOPE": "slope",
    "DISTANCE": "distance",
}
# For a legend, by field.
TITLES = {
    "gaussian": "Gaussian curvature",
    "mean": "Mean curvature",
    "maximum": "Maximum curvature",
    "minimum": "Minimum curvature",
    "slope": "Slope",
    "distance": "Distance",
}
# Of limits, by field, as units of tables; of others "1/m".
_UNITS = {"gaussian": "1/m2", "slope": "deg", "distance": "mm"}
_PART_INSIDE = 0.98  # of the surface, of a range that is not given


def wanted(fairness):
    """What decides on the colours; None when there are none."""
    if fairness.colours == "NONE":
        return None
    is_curvature = fairness.colours not in ("SLOPE", "DISTANCE")
    mapping = "logarithmic" if fairness.logarithmic and is_curvature else "linear"
    return FIELDS[fairness.colours], mapping, as_typed(fairness.colour_limit)


def unit_of(fairness):
    """The unit of tables that the limit of the colours is in; None when there are none."""
    kind = FIELDS.get(fairness.colours)
    return kind and _UNITS.get(kind, "1/m")


def coloured(surface, tessellation, choice, values=None):
    """(hull_native.ColourScale, sRGB (l, 3) of each of a tessellation's normals). values: (l,) of
    distances, m."""
    hull_native = native.require()
    kind, mapping, limit = choice[:3]
    if values is None:
        values = hull_native.surface_field(surface, tessellation, kind=kind)
    limits = _limits(kind, limit) if limit > 0.0 else None
    scale = hull_native.colour_scale(
        values,
        kind=kind,
        weights=hull_native.field_weights(tessellation),
        mapping=mapping,
        percentile=_PART_INSIDE,
        limits=limits,
    )
    return scale, scale.colours(values)


def _limits(kind, limit):
    """(low, high) of a scale by a limit in the unit that the legend has in metric scenes."""
    if kind == "slope":
        return 0.0, np.radians(min(limit, 180.0))
    if kind == "distance":
        limit *= 1e-3
    return -limit, limit


def write_colours(shown, corner_colours):
    """Gives the surface object `shown` colours, linear (faces, 4, 3), and shows them."""
    mesh = shown.data
    attribute = mesh.color_attributes.get(ATTRIBUTE)
    if attribute is None:
        attribute = mesh.color_attributes.new(ATTRIBUTE, "FLOAT_COLOR", "CORNER")
        mesh.color_attributes.active_color = attribute
    colours = np.ones((len(mesh.loops), 4), dtype=np.float32)
    colours[:, :3] = corner_colours.reshape(-1, 3)
    attribute.data.foreach_set("color", colours.reshape(-1))
    slot = shown.material_slots[0] if shown.material_slots else None
    if slot is not None and slot.link != "OBJECT":
        slot.link = "OBJECT"
        slot.material = materials.attribute_material(ATTRIBUTE)
    mesh.update()


def has_colours(mesh):
    """Whether a surface object's mesh has an attribute for the colours."""
    attribute = mesh.color_attributes.get(ATTRIBUTE)
    return attribute is not None and len(attribute.data) == len(mesh.loops)


def remove_colours(shown):
    """Gives the surface object its own material back."""
    attribute = shown.data.color_attributes.get(ATTRIBUTE)
    if attribute is not None:
        shown.data.color_attributes.remove(attribute)
    for slot in shown.material_slots:
        own = slot.material if slot.link == "OBJECT" else None
        if own is not None and materials.has_attribute(own, ATTRIBUTE):
            slot.link = "DATA"


def linear(srgb):
    """Colours as Blender keeps them."""
    srgb = np.asarray(srgb, dtype=np.float32)
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)
