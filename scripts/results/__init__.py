# SPDX-License-Identifier: GPL-3.0-or-later
"""All kinds of results of a vessel, by the public functions of hull_native.

SUBJECTS names them; each takes a vessels.Vessel and yields pairs of a name and a result: numbers,
texts, arrays, objects of hull_native, and lists of these.
"""

from .afloat import hydrostatic_results, stability_results
from .calls import RENAMED
from .files import conversion_results, drawing_results
from .shape import fairness_results, modelling_results, section_results, surface_results

__all__ = ["RENAMED", "SUBJECTS"]

SUBJECTS = {
    "surface": surface_results,
    "sections": section_results,
    "fairness": fairness_results,
    "hydrostatics": hydrostatic_results,
    "stability": stability_results,
    "conversion": conversion_results,
    "drawing": drawing_results,
    "modelling": modelling_results,
}
