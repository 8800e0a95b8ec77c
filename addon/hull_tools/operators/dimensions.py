# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls scaled to main dimensions, with all that belongs to them."""

import bpy
from bpy.props import BoolProperty, EnumProperty

from ...hull_io import keeping
from ..bridge.blender import units
from ..bridge.objects import hull_objects
from ..features.dimensions import dimensions, keeping_task
from .shared import (
    BaseOperator,
    HullOperator,
    asked_length,
    can_change,
    in_object_mode,
    native_is_there,
)
from .tasks import TaskOperator

# m; what the ends of the hull miss less is rounding of single precision.
_ENDS_TOLD = 1e-5


def _dimension(name, description):
    return asked_length(name, description, minimum=0.0)


def _keeping(name, description):
    return BoolProperty(name=name, description=description, options={"SKIP_SAVE"})


def _of_another_kind(settings, context):
    """Numbers of the other kind would scale the hull by what the two kinds differ."""
    settings.length = settings.beam = settings.depth = 0.0


class HULL_OT_set_dimensions(bpy.types.Operator, TaskOperator):
    """Scale the hull to main dimensions: drafts, loads, openings, flats, lines and all else that
    belongs to it follow"""

    bl_idname = "hull.set_dimensions"
    bl_label = "Scale to Dimensions"
    bl_options = {"REGISTER", "UNDO"}

    needs = (*HullOperator.needs, in_object_mode)

    measured: EnumProperty(
        name="Measured",
        description="What length, beam and depth are",
        options={"SKIP_SAVE"},
        items=(
            ("PARTICULARS", "Particulars", "Lpp, beam and depth, as the panel Hull has them"),
            ("SURFACE", "Surface", "From end to end of the surface, from side to side, and its "
             "highest point above the base line"),
        ),
        update=_of_another_kind,
    )  # fmt: skip
    length: _dimension("Length", "That the hull is to have; 0: as it is")
    beam: _dimension("Beam", "That the hull is to have; 0: as it is")
    draft: _dimension("Draft", "At which the hull is to float; 0: in proportion to the heights")
    depth: _dimension(
        "Depth", "That heights are scaled to; 0: heights are in proportion to the draft"
    )
    keep_bilge: _keeping(
        "Bilge Radius",
        "The bilge of the largest section moves as a whole: the bottom beside it becomes wider, "
        "and the side above it higher",
    )
    keep_bulb: _keeping(
        "Bulb",
        "What is forward of the fore perpendicular moves as a whole: the hull aft of it becomes "
        "longer",
    )
    keep_knuckles: _keeping(
        "Knuckle Heights",
        "Knuckles below the deck edge stay at their heights: what is above them becomes higher",
    )

    def invoke(self, context, event):
        self._is_in_window = not bpy.app.background
        return self.reporting(self._open, context)

    def _open(self, context):
        scale = units.metres_per_unit(context.scene)
        now = dimensions.present(hull_objects.hull_of(context.object), context.scene)
        present = (("length", now.length_pp), ("beam", now.beam), ("draft", now.draft))
        for name, value in present:
            if not self.properties.is_property_set(name):
                setattr(self, name, value / scale)
        return context.window_manager.invoke_props_dialog(self, width=320)

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.prop(self, "measured")
        is_surface = self.measured == "SURFACE"
        column = layout.column(align=True)
        column.prop(self, "length", text="Length" if is_surface else "Lpp")
        column.prop(self, "beam")
        column.prop(self, "draft")
        column.prop(self, "depth")
        column = layout.column(align=True, heading="Keep")
        for name in ("keep_bilge", "keep_bulb", "keep_knuckles"):
            column.prop(self, name)
        row = layout.row()
        row.active = False
        row.label(text="0: as it is, or in proportion")

    def run_on(self, hull, context):
        asked = self._asked(context.scene)
        if asked.keep:
            return super().run_on(hull, context)
        start = dimensions.Start(hull, context.scene, asked)
        self.tell("INFO", _told(start.write(hull, context.scene, None)))

    def begin(self, hull, scene):
        return keeping_task.KeepingTask(hull, scene, self._asked(scene))

    def outcome(self, kept, scene):
        return _told(self._task.write(scene)), False

    def _asked(self, scene):
        scale = units.metres_per_unit(scene)
        wanted = {
            name: units.as_typed(getattr(self, name)) * scale or None
            for name in ("length", "beam", "draft", "depth")
        }
        keep = tuple(name for name in keeping.KEPT if getattr(self, f"keep_{name}"))
        return dimensions.Asked(**wanted, of_surface=self.measured == "SURFACE", keep=keep)


def _told(brought):
    return _report(brought.factors, "Scaled by") if brought.kept is None else _kept_report(brought)


def _report(factors, begin):
    x, y, z = factors
    return f"{begin} {x:.6g} × {y:.6g} × {z:.6g}: volume and masses × {x * y * z:.6g}"


def _kept_report(brought):
    kept = brought.kept
    x, y, z = kept.surface.largest_place
    text = _report(brought.factors, "Stretched by") + (
        f"; RMS off what was asked for {units.format_mm(kept.surface.rms)}, largest "
        f"{units.format_mm(kept.surface.largest)} at x {x:.2f}, y {y:.2f}, z {z:.2f} m"
    )
    if kept.surface.ends_missed > _ENDS_TOLD:
        text += f"; its ends are up to {units.format_mm(kept.surface.ends_missed)} off"
    if kept.radii is not None:
        before, after = kept.radii
        now = "none" if after is None else f"{after:.4g} m"
        text += f"; bilge radius {before:.4g} m before, {now} now"
    return text


def _was_scaled(cls, context):
    hull = hull_objects.hull_of(context.object)
    if hull is None:
        cls.poll_message_set("Select a hull first")
        return False
    if dimensions.unapplied(hull) is None and dimensions.noticed(hull) is None:
        cls.poll_message_set("The hull was not scaled since its particulars were given")
        return False
    return True


class HULL_OT_follow_scale(bpy.types.Operator, BaseOperator):
    """Let particulars, drafts, loads, openings, flats and lines follow the scale that the hull was
    given by Blender's own tools; a scale that is not applied yet is applied"""

    bl_idname = "hull.follow_scale"
    bl_label = "Let Dimensions Follow"

    needs = (native_is_there, _was_scaled, can_change, in_object_mode)

    def run(self, context):
        hull = hull_objects.hull_of(context.object)
        factors = dimensions.follow_scale(hull, context.scene)
        self.tell("INFO", _report(factors, "All followed the scale"))


class HULL_OT_put_keel_on_base_line(bpy.types.Operator, HullOperator):
    """Move the hull up or down until its keel is at z = 0, from which drafts are measured, with
    openings, flats, appendages and what else lies in space"""

    bl_idname = "hull.put_keel_on_base_line"
    bl_label = "Put Keel on Base Line"

    needs = (in_object_mode, *HullOperator.needs)

    draft_stays: BoolProperty(
        name="Heights from Keel",
        description="Draft, depth, VCG and waterlines were measured from the keel, and keep their "
        "values; else they go along, and the water stays where it is at the hull",
        default=True,
    )

    def run_on(self, hull, context):
        scene = context.scene
        lift = dimensions.put_keel_on_base_line(hull, scene, self.draft_stays)
        draft = units.format_value(scene, hull.hull.draft * units.metres_per_unit(scene), "m")
        way = "up" if lift > 0.0 else "down"
        distance = units.format_value(scene, abs(lift), "m")
        self.tell("INFO", f"The hull was moved {way} by {distance}; its draft is {draft} now")


CLASSES = (HULL_OT_set_dimensions, HULL_OT_follow_scale, HULL_OT_put_keel_on_base_line)
