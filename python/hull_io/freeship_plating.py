# SPDX-License-Identifier: GPL-3.0-or-later
"""Thickness and density of layers' plating, as FREE!ship's files have them and as hulls do.

FREE!ship weighs area x thickness x density of each layer, and a layer without one of the two not at
all; a hull weighs those of the shell, and what a layer does not say is as the hull's Weights.
"""

from .freeship_units import as_typed, plating_units
from .limits import DENSEST, THICKEST
from .ship_data import Weights


def give_plating(layers, model, notes):
    """Gives Layers the plating of a freeship_model.Model's; what can't be one is not given, and
    noted."""
    metre, density_unit = plating_units(model.imperial)
    for layer, stored in zip(layers, model.layers):
        of = f"of layer {layer.name}"
        layer.thickness = _within(stored.thickness, metre, THICKEST, f"thickness {of}", notes)
        layer.density = _within(stored.density, density_unit, DENSEST, f"density {of}", notes)
        if layer.in_hydrostatics and layer.thickness and not layer.density:
            notes.append(
                f"Layer {layer.name} has a thickness and no density: it is weighed with "
                f"{Weights.density:g} t/m³."
            )


def _within(stored, unit, most, what, notes):
    if 0.0 <= stored * unit <= most:
        return as_typed(stored) * unit
    notes.append(f"The file's {what}, {stored:g}, was taken as not given.")
    return 0.0


def plating(layer, data):
    """(thickness in m, density in t/m3) of a Layer of a HullData, those of the hull where it is of
    the shell and has none of its own."""
    if not layer.in_hydrostatics:
        return layer.thickness, layer.density
    thickness = layer.thickness or data.weights.thickness
    return thickness, layer.density or (data.weights.density if thickness else 0.0)
