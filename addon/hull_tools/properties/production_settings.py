# SPDX-License-Identifier: GPL-3.0-or-later
"""Object.hull.model and panel_mesh: the model that is printed or milled, and the panels of programs
that compute waves and flow. Lengths are in mm on the model, or as their names say."""

import bpy
from bpy.props import BoolProperty, FloatProperty, IntProperty

from .shared import changed


def scale(**more):
    return FloatProperty(
        name="Scale 1 :",
        description="How many times smaller than the ship the model is",
        default=100.0,
        min=0.1,
        max=10000.0,
        **more,
    )


def tolerance(**more):
    return FloatProperty(
        name="Tolerance mm",
        description="How far the model's triangles may be from the surface, on the model",
        default=0.05,
        min=0.0005,
        max=10.0,
        precision=4,
        **more,
    )


def layer(**more):
    return FloatProperty(
        name="Layers mm",
        description="Thickness of the layers, on the model",
        default=0.2,
        min=0.001,
        max=1000.0,
        precision=3,
        **more,
    )


def wall(**more):
    return FloatProperty(
        name="Wall mm",
        description="Thickness of the wall of a hollow model; 0: it is solid",
        default=0.0,
        min=0.0,
        max=1000.0,
        precision=2,
        **more,
    )


def in_segments(**more):
    return BoolProperty(
        name="In segments",
        description="Cut the model into segments that a machine takes, each with a plane to lie on "
        "and all other faces within the tool's reach",
        default=False,
        **more,
    )


def machine(axis, default, **more):
    where = "Along the tool" if axis == "Z" else "Across the tool"
    return FloatProperty(
        name=f"Machine {axis} mm",
        description=f"{where}, the largest size of a segment",
        default=default,
        min=1.0,
        max=100000.0,
        precision=0,
        **more,
    )


def dowel(**more):
    return FloatProperty(
        name="Dowels mm",
        description="Diameter of holes for dowels in the segments' joints, three times as deep as "
        "that; 0: none",
        default=0.0,
        min=0.0,
        max=200.0,
        precision=2,
        **more,
    )


def along(**more):
    return IntProperty(
        name="Panels along",
        description="How many of the largest panels the length between perpendiculars has",
        default=60,
        min=4,
        max=1000,
        **more,
    )


def grading(**more):
    return FloatProperty(
        name="At water and ends",
        description="Size of panels at the water's surface and at the ends, of that of the largest",
        default=0.5,
        min=0.1,
        max=1.0,
        **more,
    )


def part_tolerance(**more):
    return FloatProperty(
        name="Parts mm",
        description="How far the triangles of named parts may be from the surface, in mm at true "
        "size",
        default=5.0,
        min=0.01,
        max=10000.0,
        precision=2,
        **more,
    )


class HullModel(bpy.types.PropertyGroup):
    scale: scale(update=changed)
    tolerance: tolerance(update=changed)
    wall: wall(update=changed)
    in_segments: in_segments(update=changed)
    machine_x: machine("X", 300.0, update=changed)
    machine_y: machine("Y", 200.0, update=changed)
    machine_z: machine("Z", 100.0, update=changed)
    dowel: dowel(update=changed)
    layer: layer(update=changed)


class HullPanelMesh(bpy.types.PropertyGroup):
    along: along(update=changed)
    grading: grading(update=changed)
    part_tolerance: part_tolerance(update=changed)


CLASSES = (HullModel, HullPanelMesh)
