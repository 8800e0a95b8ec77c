# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface of a network: measured, and written for CAD systems."""

import os

import bpy
from bpy.props import BoolProperty, EnumProperty, StringProperty
from bpy_extras.io_utils import ExportHelper

from ..bridge.counts import counted
from ..bridge.objects import networks
from ..features.exchange import endings
from ..features.networks import surface_tasks
from .networks import NetworkTask


class HULL_OT_measure_network(bpy.types.Operator, NetworkTask):
    """Tell how near the surface is to the curves, how smooth it is over its seams, and what it is
    afloat at the draft"""

    bl_idname = "hull.measure_network"
    bl_label = "Measure Surface"

    def begin(self, network, scene):
        return surface_tasks.Measuring(network, scene)

    def outcome(self, measured, scene):
        name, line = self._task.write()
        return f'"{name}": {line}', False


class HULL_OT_export_network(bpy.types.Operator, NetworkTask, ExportHelper):
    """Write the surface of the network as one shell of B-spline faces in a STEP or IGES file"""

    bl_idname = "hull.export_network"
    bl_label = "Export Surface"

    filename_ext = ".step"
    check_extension = None
    filter_glob: StringProperty(default="*.step;*.stp;*.igs;*.iges", options={"HIDDEN"})
    format: EnumProperty(
        name="Format",
        description="What the file is, where its name does not end in one of these",
        items=[
            (".step", "STEP", "AP214, as most CAD systems read it"),
            (".igs", "IGES", "Version 5.3, of B-rep entities"),
        ],
    )
    is_whole: BoolProperty(
        name="Both Sides", description="Of half a hull the mirror image, too", default=False
    )

    def invoke(self, context, event):
        self._is_in_window = not bpy.app.background
        if not self.properties.is_property_set("filepath"):
            name = bpy.path.clean_name(networks.at_hand(context).name)
            self.filepath = bpy.path.abspath("//") + name + self.format
        return ExportHelper.invoke(self, context, event)

    def check(self, context):
        before = self.filepath
        base, ending = os.path.splitext(before)
        if ending.lower() in (".step", ".igs"):
            self.filepath = base + self.format
        return self.filepath != before

    def draw(self, context):
        self.layout.prop(self, "format", expand=True)
        self.layout.prop(self, "is_whole")

    def begin(self, network, scene):
        path = self.filepath
        endings.check_named(path)
        if not path.lower().endswith((".step", ".stp", ".igs", ".iges")):
            path += self.format
        return surface_tasks.Writing(network, scene, path, self.is_whole)

    def outcome(self, result, scene):
        report, problems = result
        text = f"{report['format']} written: {counted(report['faces'], 'face')}"
        if not problems:
            return text, False
        return f"{text}, {counted(len(problems), 'problem')}: {problems[0]}", True


CLASSES = (HULL_OT_measure_network, HULL_OT_export_network)
