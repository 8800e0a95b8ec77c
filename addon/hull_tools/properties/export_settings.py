# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.export: how the surface is converted to B-spline patches, and what CAD files hold."""

from math import radians

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty

from ..bridge.blender import units
from ..features.conversion import conversions
from ..features.hull import hull_state
from ..features.lines import lines
from .shared import angle


def _length_mm(settings):
    """The hull's largest extent; 0 while it has no surface."""
    state = hull_state.state_of(settings.id_data)
    return (
        0.0
        if state is None or state.ship.surface is None
        else 1e3 * lines.size_of(state.ship.surface)
    )


def _tolerance_mm(settings):
    return units.as_typed(settings.tolerance) * _length_mm(settings)


def _set_tolerance_mm(settings, value):
    length = _length_mm(settings)
    if length > 0.0:
        settings.tolerance = value / length


def _percent_done(settings):
    task = conversions.running(settings.id_data)
    return 0.0 if task is None else 100.0 * task.share


def _choice_changed(settings, context):
    """Beside a file dialog of STEP and IGES files the report is of the choice as it is."""
    if context.space_data is not None and context.space_data.type == "FILE_BROWSER":
        conversions.request(settings.id_data)


class HullExport(bpy.types.PropertyGroup):
    """Nothing here changes what is shown of the hull."""

    conversion: EnumProperty(
        name="Conversion",
        description="How the surface becomes B-spline patches",
        # Files keep the numbers.
        items=(
            ("AUTOMATIC", "Automatic", "Exact patches, or one a cell where exact ones make a file "
             "of more than twice the size, as of meshes of triangles", 2),
            ("EXACT", "Exact", "Few large patches that are the surface itself but for vanishing "
             "squares at irregular points", 0),
            ("PER_CELL", "One a cell", "One patch for each cell of the control mesh, an "
             "approximation near irregular points", 1),
        ),
        default="AUTOMATIC",
        update=_choice_changed,
    )  # fmt: skip
    control_points: IntProperty(
        name="Control points",
        description="Along each side of the patch of a cell",
        default=5,
        min=4,
        max=7,
        update=_choice_changed,
    )
    tolerance: FloatProperty(
        name="Of the length",
        description="Largest distance of the patches from the surface as a part of the hull's "
        "length; 0.000001 is 0.1 mm on 100 m",
        default=1e-6,
        min=1e-10,
        max=0.01,
        precision=6,
        step=0.0001,
        update=_choice_changed,
    )
    tolerance_mm: FloatProperty(
        name="Tolerance mm",
        description="Largest distance of the patches from the surface in mm; it is kept as a part "
        "of the hull's length",
        get=_tolerance_mm,
        set=_set_tolerance_mm,
        min=0.0,
        precision=5,
        step=1,
    )
    seam_angle: angle(
        "Seam angle",
        "Largest angle between the normals of neighbouring patches where the surface is smooth; "
        "0: what goes with the tolerance, 0.02° at a millionth of the length",
        0.0,
        0.0,
        radians(5.0),
        _choice_changed,
    )
    matched_knots: BoolProperty(
        name="Matched knots",
        description="Neighbouring patches have the same knots along the border they share, and "
        "more of them: for systems that join no others",
        update=_choice_changed,
    )
    most_control_points: IntProperty(
        name="Most points",
        description="Largest number of control points of a patch; patches that need more are "
        "divided. 0: as many as there are",
        min=0,
        max=1000000,
        update=_choice_changed,
    )
    bezier: BoolProperty(
        name="Bézier patches",
        description="Patches are divided at their knots, into 4 × 4 control points each: for "
        "systems that take no others. There are very many",
        update=_choice_changed,
    )
    progress: FloatProperty(
        name="Progress",
        description="Of the conversion or the file that is being made",
        get=_percent_done,
        min=0.0,
        max=100.0,
        subtype="PERCENTAGE",
        precision=0,
    )

    extent: EnumProperty(
        name="Extent",
        description="How much of the hull is written",
        items=(
            ("BOTH", "Both sides", "The half hull and its mirror image, joined on the centre line"),
            ("HALF", "Half hull", "The control mesh's own side"),
            ("SOLID", "Closed solid", "Both sides with deck and other openings capped: for CFD and "
             "Boolean operations"),
            ("HALF_SOLID", "Closed half", "The control mesh's own side, with the centre plane "
             "capped too"),
        ),
    )  # fmt: skip
    unit: EnumProperty(
        name="Unit",
        description="The unit of the numbers in the file, which is at the ship's true size",
        items=(
            ("m", "Metres", "1 in the file is 1 m"),
            ("cm", "Centimetres", "1 in the file is 1 cm"),
            ("mm", "Millimetres", "1 in the file is 1 mm"),
            ("ft", "Feet", "1 in the file is 304.8 mm"),
            ("in", "Inches", "1 in the file is 25.4 mm"),
        ),
    )
    schema: EnumProperty(
        name="STEP",
        description="The protocol of STEP files",
        items=(
            ("AP214", "AP214", "What every CAD system reads"),
            ("AP242", "AP242", "The newer one"),
        ),
    )
    with_sections: BoolProperty(
        name="Lines of Sections",
        description="The lines that Sections shows are written too, as B-spline curves on layers",
    )
    with_features: BoolProperty(
        name="Knuckles, borders",
        description="Knuckles and borders are written too, as B-spline curves on a layer",
    )


CLASSES = (HullExport,)
