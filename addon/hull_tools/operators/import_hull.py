# SPDX-License-Identifier: GPL-3.0-or-later
"""Hull files and samples become hull objects."""

import bpy
from bpy.props import EnumProperty, StringProperty
from bpy_extras.io_utils import ImportHelper

from ... import hull_io
from ..bridge.counts import counted
from ..features.exchange import hull_files
from ..features.hull import hull_state, samples
from .shared import (
    BaseOperator,
    collection_for_new,
    in_object_mode,
    make_active,
    native_is_there,
    show_all,
)


def _import(operator, context, path):
    """Reads a file completely, and mends it, before anything is made of it."""
    hull = hull_io.read_mended(path)
    obj = hull_files.hull_object(hull, context.scene, collection_for_new(context))
    make_active(context, obj)
    show_all(context)
    state = hull_state.state_of(obj)
    for note in (*hull.notes, *([state.status] if state.status else _doubts(state))):
        operator.tell("WARNING", note)
    operator.tell("INFO", f"{obj.name}: {counted(len(obj.data.polygons), 'face')} read")
    return {"FINISHED"}


def _doubts(state):
    return [doubt.message for doubt in state.plausible.doubts]


class HULL_OT_import_hull(bpy.types.Operator, BaseOperator, ImportHelper):
    """Read a hull from a FREE!ship file (.fbm, .ftm), a hull file (.hull.json) or a file of chines
    (.hul, .xyz, .txt)"""

    bl_idname = "hull.import_hull"
    bl_label = "Import Hull"

    filter_glob: StringProperty(
        default="*.fbm;*.ftm;*.hull.json;*.hul;*.xyz;*.txt", options={"HIDDEN"}
    )

    needs = (native_is_there, in_object_mode)

    def run(self, context):
        _import(self, context, self.filepath)


# Blender keeps no reference to the texts of a dynamic enumeration; this does.
_sample_items = []


def _list_samples(self, context):
    _sample_items[:] = [
        (name, name.replace("_", " ").replace("-", " ").capitalize(), str(path))
        for name, path in samples.sample_files().items()
    ]
    return _sample_items


class HULL_OT_load_sample(bpy.types.Operator, BaseOperator):
    """Load one of the hulls that come with the add-on"""

    bl_idname = "hull.load_sample"
    bl_label = "Load Sample Hull"

    name: EnumProperty(name="Sample", description="The hull that is loaded", items=_list_samples)

    needs = (native_is_there, in_object_mode)

    def run(self, context):
        files = samples.sample_files()
        if self.name not in files:
            raise ValueError("There is no sample hull beside the add-on")
        _import(self, context, str(files[self.name]))


def draw_import_menu(self, context):
    self.layout.operator(
        HULL_OT_import_hull.bl_idname, text="Ship hull (.fbm, .ftm, .hull.json, .hul)"
    )
    self.layout.operator(
        "hull.hull_from_file", text="Ship hull from surface or offsets (.stl, .step, .csv, …)"
    )


CLASSES = (HULL_OT_import_hull, HULL_OT_load_sample)
