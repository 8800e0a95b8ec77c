# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.morph: the parents of a hull that is a member of a family, with their weights, and
what a new family is made by."""

import bpy
from bpy.props import (
    BoolProperty,
    CollectionProperty,
    EnumProperty,
    FloatProperty,
    FloatVectorProperty,
    IntProperty,
    PointerProperty,
    StringProperty,
)

from ..bridge import limits
from ..bridge.objects import hull_objects
from ..features.morphing import members
from .shared import changed, length, switch


def _weight_changed(entry, context):
    members.weight_changed(entry.id_data, entry, context.scene)
    changed(entry, context)


def _member_changed(settings, context):
    members.settings_changed(settings.id_data, context.scene)
    changed(settings, context)


class HullMorphPair(bpy.types.PropertyGroup):
    """Features of the layout and of a parent, by their numbers, which are one line in the family,
    or are held apart."""

    first: IntProperty(name="Of Layout", description="The number of the layout's line")
    second: IntProperty(name="Of Parent", description="The number of the parent's line")
    name: StringProperty(name="Name", description="Both lines, as they are told")
    is_given: BoolProperty(name="By Hand", description="The lines were paired by hand")
    colour: FloatVectorProperty(
        name="Colour",
        description="In which both lines are shown",
        subtype="COLOR",
        min=0.0,
        max=1.0,
        default=(0.9, 0.5, 0.1),
    )


class HullMorphFeature(bpy.types.PropertyGroup):
    """A feature of a hull by its number, and as it is told."""

    name: StringProperty(name="Name", description="The line with its place")
    number: IntProperty(name="Number", description="By which the line is told from others")


class HullMorphParent(bpy.types.PropertyGroup):
    """A parent as it was fitted: lengths in Blender's units, and its control points in the layout
    of the family, as a mesh that no object shows."""

    name: StringProperty(name="Name", description="The parent's name", update=changed)
    source: PointerProperty(
        name="Parent", description="The hull that was fitted", type=bpy.types.Object
    )
    mesh: PointerProperty(
        name="Mesh", description="The parent's control mesh in the family", type=bpy.types.Mesh
    )
    source_key: StringProperty(name="State", description="Of the parent when it was fitted")
    fit: StringProperty(name="Fit", description="How well the parent is met")
    shortfall: StringProperty(
        name="Shortfall", description="Why it is met no better, and what to do; blank: it is met"
    )
    weight: FloatProperty(
        name="Weight",
        description="The parent's part in this hull. All weights sum to 1: the others follow. "
        "Below 0 and above 1 hulls beyond the parents are made",
        soft_min=-0.5,
        soft_max=1.5,
        min=limits.MORPH_WEIGHTS[0],
        max=limits.MORPH_WEIGHTS[1],
        precision=3,
        step=1,
        update=_weight_changed,
    )
    shown_weight: FloatProperty(name="Shown Weight", description="That of the member that is shown")
    share: FloatProperty(
        name="Share", description="Of what the others leave, where all those weights are 0"
    )
    length_pp: length("Lpp", "Of the parent", minimum=None, update=None)
    beam: length("Beam", "Of the parent", minimum=None, update=None)
    draft: length("Draft", "Of the parent", minimum=None, update=None)
    depth: length("Depth", "Of the parent", minimum=None, update=None)
    trim_m: length("Trim", "Of the parent", minimum=None, update=None)
    kg: length("KG", "Of the parent", minimum=None, update=None)

    pairs: CollectionProperty(type=HullMorphPair)
    apart: CollectionProperty(type=HullMorphPair)
    features: CollectionProperty(type=HullMorphFeature)
    active_pair: IntProperty(name="Pair", description="The one chosen in the list", update=changed)
    feature: StringProperty(
        name="Of the Parent", description="A feature of the chosen parent", update=changed
    )


class HullMorphLocal(bpy.types.PropertyGroup):
    """A parent that counts alone around a shape field of the hull."""

    field: StringProperty(
        name="Field", description="A shape field of this hull, by its name", update=changed
    )
    parent: StringProperty(
        name="Parent",
        description="The parent that the hull is there, by name; for a field that protects none",
        update=changed,
    )


class HullMorph(bpy.types.PropertyGroup):
    """A hull with parents is a member of their family; one without is none."""

    parents: CollectionProperty(type=HullMorphParent)
    active_parent: IntProperty(
        name="Parent", description="The one chosen in the list", min=0, update=changed
    )
    local: CollectionProperty(type=HullMorphLocal)
    active_local: IntProperty(
        name="Local Parent", description="The one chosen in the list", update=changed
    )
    shown_local: StringProperty(
        name="Shown Locally", description="A digest of the fields of the member that is shown"
    )
    shown_mesh: StringProperty(
        name="Shown", description="A digest of the mesh of the member that is shown"
    )
    subdivisions: IntProperty(
        name="Subdivided", description="How often the layout was subdivided for the parents"
    )
    layout_name: StringProperty(
        name="Layout", description="The name of the hull whose layout the family has"
    )
    layout_source: PointerProperty(
        name="Layout", description="The hull whose layout the family has", type=bpy.types.Object
    )
    layout_key: StringProperty(
        name="State", description="What the layout was when parents were fitted"
    )
    features: CollectionProperty(type=HullMorphFeature)
    has_other_pairs: BoolProperty(
        name="Corrected", description="Pairs were corrected since the parents were fitted"
    )
    feature: StringProperty(
        name="Of the Layout", description="A feature of the hull that gave the layout",
        update=changed,
    )  # fmt: skip
    factors: FloatVectorProperty(
        name="Factors",
        description="Of length, beam and draft, beside the weights",
        default=(1.0, 1.0, 1.0),
        min=0.1,
        max=10.0,
        precision=5,
        update=_member_changed,
    )
    follows_particulars: BoolProperty(
        name="Drafts Follow",
        description="Lpp, beam, draft, depth, trim and KG are the parents' by their weights",
        default=True,
        update=_member_changed,
    )
    show_pairs: switch(
        "Show Pairs", "Paired features in one colour each on both hulls, while both are seen"
    )
    layout_hull: PointerProperty(
        name="Layout",
        description="The hull whose control mesh the family gets: without one, the active one",
        type=bpy.types.Object,
        poll=lambda settings, obj: hull_objects.is_hull(obj),
        update=changed,
    )
    tolerance: FloatProperty(
        name="Tolerance ‰ of L",
        description="Where a parent is missed by more than this part of its length, root mean "
        "square, the layout is subdivided",
        default=0.1,
        min=limits.MORPH_TOLERANCES[0],
        max=limits.MORPH_TOLERANCES[1],
        precision=3,
        update=changed,
    )
    most_subdivisions: IntProperty(
        name="Subdivisions",
        description="How often the layout may be subdivided at most",
        default=1,
        min=0,
        max=limits.MOST_MORPH_SUBDIVISIONS,
        update=changed,
    )
    steps: IntProperty(
        name="Steps",
        description="Of a series, from its first member to its last",
        default=10,
        min=1,
        max=limits.MOST_SERIES_STEPS,
        update=changed,
    )
    series_from: IntProperty(
        name="From", description="The parent that a series begins with", default=1, min=1,
        update=changed,
    )  # fmt: skip
    series_to: IntProperty(
        name="To", description="The parent that a series ends with", default=2, min=1,
        update=changed,
    )  # fmt: skip
    series_format: EnumProperty(
        name="Files",
        description="What each member of a series is written as",
        items=(
            ("HULL", "Hull Files", "Hull files (.hull.json)"),
            ("STEP", "STEP", "As the panel Export has it"),
            ("IGES", "IGES", "As the panel Export has it"),
        ),
        update=changed,
    )


CLASSES = (HullMorphPair, HullMorphFeature, HullMorphParent, HullMorphLocal, HullMorph)
