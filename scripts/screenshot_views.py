# SPDX-License-Identifier: GPL-3.0-or-later
"""What is on the docs' pictures of the window, by the files' names. They are set up by generators
as the tests of the window are: see tests/window/stepping.py."""

from dataclasses import dataclass

import bmesh
import bpy
import export_scenes
import field_scenes
import network_scenes
import numpy as np
import plate_scenes
import tie_scenes
from addon_under_test import part
from close_views import coaster_close_by, coaster_in_window
from editing import select
from expect import edited_points
from mathutils import Vector
from screenshot_panels import are_known, fuller_forward, hull_panels, load, morph_of_pair
from screenshot_tools import save_smaller

# The view over the bow from port, where the control points are, as the angles of its turn.
_OVER_THE_BOW = (74.0, 0.0, 142.0)


@dataclass(frozen=True)
class View:
    """The whole window. scene(window) sets it up; panels: class names of those in the sidebar."""

    scene: object
    panels: tuple


def _new_hull(window, closer=1.5, words="round bilge"):
    """A hull as Add > Mesh > Ship Hull makes it, in a window that is nothing but the 3D view."""
    with window.in_view():
        bpy.ops.screen.screen_full_area()
    yield
    space = window.space
    space.show_region_toolbar, space.shading.color_type, space.lens = False, "MATERIAL", 90.0
    window.move_to_middle()
    window.search(words)
    yield
    hull = bpy.context.view_layer.objects.active
    window.open_sidebar()
    yield
    window.look(hull, _OVER_THE_BOW, is_perspective=True)
    space.region_3d.view_distance /= closer
    yield
    return hull


def _added(window):
    yield from _new_hull(window)
    region = window.region()
    window.move_to(region.x + 0.2 * region.width, region.y + 0.45 * region.height)
    window.press("F9")
    yield


def _edited(window):
    hull = yield from _new_hull(window, closer=1.6)
    with window.in_view():
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.ops.mesh.select_all(action="DESELECT")
    points = edited_points(hull)
    wanted = points.max(axis=0) * [0.75, 1.0, 0.5]
    nearest = int(np.linalg.norm(points - wanted, axis=1).argmin())
    select(hull, nearest)
    window.move_to_point(hull, Vector(points[nearest].tolist()))
    window.press("G")
    window.press("Y")
    window.move_by(6, -2)
    yield


def _pie(window):
    hull = yield from _new_hull(window, closer=1.6)
    with window.in_view():
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.ops.mesh.select_mode(type="EDGE")
        bpy.ops.mesh.select_all(action="DESELECT")
    edges = [edge for edge in bmesh.from_edit_mesh(hull.data).edges if len(edge.link_faces) == 2]
    # One along the hull, nearest to a place at the bilge forward.
    length, height = hull.dimensions.x, hull.dimensions.z
    place = Vector((0.6 * length, hull.dimensions.y, 0.3 * height))
    along = [e for e in edges if abs(e.verts[0].co.x - e.verts[1].co.x) > 0.5 * e.calc_length()]
    nearest = min(along, key=lambda edge: (edge.verts[0].co - place).length)
    select(hull, nearest.index, kind="edges")
    with window.in_view():
        bpy.ops.mesh.loop_multi_select(ring=False)
    window.press("Q", shift=True)
    window.move_by(-60, 0)
    yield


def _judged(window):
    hull = yield from _new_hull(window)
    fairness = hull.hull.fairness
    fairness.colours, fairness.comb_stations = "GAUSSIAN", True
    hull.hull.lines.show_buttocks = hull.hull.lines.show_waterlines = False
    bpy.context.view_layer.update()
    yield


def _measured(window):
    hull = yield from _new_hull(window)
    window.space.region_3d.view_location.z += 0.17 * hull.dimensions.x
    hull.hull.plots.sectional_areas, hull.hull.plots.corner = True, "TOP_LEFT"
    bpy.context.view_layer.update()
    yield
    yield lambda: are_known(hull, ("sectional_areas",))
    yield


def _ghost(window):
    hull = yield from _new_hull(window)
    window.space.overlay.show_floor = False
    with window.in_view():
        bpy.ops.hull.keep_variant(name="As built", note="as in the contract")
    window.space.region_3d.view_location.z += 0.17 * hull.dimensions.x
    fuller_forward(hull)
    hull.hull.lines.show_buttocks = hull.hull.lines.show_waterlines = False
    hull.hull.plots.sectional_areas, hull.hull.plots.corner = True, "TOP_LEFT"
    hull.hull.variants.show_ghost = True
    bpy.context.view_layer.update()
    yield lambda: _has_ghost(hull)
    yield


def _distances(window):
    hull = yield from _new_hull(window)
    window.space.overlay.show_floor = False
    with window.in_view():
        bpy.ops.hull.keep_variant(name="As built", note="as in the contract")
    fuller_forward(hull)
    lines = hull.hull.lines
    lines.show_buttocks = lines.show_waterlines = lines.show_stations = False
    hull.hull.fairness.colours = "DISTANCE"
    bpy.context.view_layer.update()
    yield lambda: part("features.hull.hull_state").state_of(hull).shown.distances is not None
    yield lambda: are_known(hull, ("differences",))
    yield


def _rows(window):
    """A row along the coaster with its comb; in the fore body it has a dent."""
    hull = yield from coaster_close_by(window, (30.0, 0.0, 160.0), (62.0, 7.0, 3.0), 42.0)
    with window.in_view():
        points, mesh_points = edited_points(hull), part("bridge.mesh.mesh_points")
        dent = np.abs(points - (67.9, 6.1, 4.9)).sum(axis=1).argmin(keepdims=True)
        mesh_points.write(hull.data, dent, points[dent] - (0.0, 0.25, 0.0))
        part("features.hull.hull_state").follow_edit(hull, bpy.context.scene)
        bm = bmesh.from_edit_mesh(hull.data)
        bm.verts.ensure_lookup_table()
        edges = [
            [vertex.index for vertex in edge.verts]
            for edge in bm.verts[int(dent[0])].link_edges
            if abs(edge.verts[0].co.x - edge.verts[1].co.x) > 0.5 * edge.calc_length()
        ]
        part("bridge.mesh.selection").select(bpy.context, hull, "edge", edges)
        bpy.ops.hull.show_rows()
    yield


def _family(window):
    """A container ship, a bulk carrier, and the morph of them to port."""
    with window.in_view():
        bpy.ops.screen.screen_full_area()
    yield
    space = window.space
    space.show_region_toolbar, space.shading.color_type, space.lens = False, "MATERIAL", 90.0
    space.overlay.show_floor = space.overlay.show_extras = False
    with window.in_view():
        made = morph_of_pair("container_ship", "bulk_carrier", layout="roro")
    first, second = (entry.source for entry in made.hull.morph.parents)
    made.location.y, second.location.y = 60.0, 120.0
    for hull in (first, second, made):
        hull.hull.show_net, lines = False, hull.hull.lines
        lines.show_buttocks = lines.show_waterlines = False
    made.hull.morph.active_parent = 1
    bpy.context.view_layer.update()
    window.open_sidebar()
    yield
    window.look(made, (66.0, 0.0, 128.0), is_perspective=True)
    space.region_3d.view_distance *= 0.72
    space.region_3d.view_location.y -= 15.0
    space.overlay.show_axis_x = space.overlay.show_axis_y = False
    for hull in (first, second, made):
        hull.select_set(False)
    yield
    return made


def _weights(window):
    made = yield from _family(window)
    made.hull.morph.parents[0].weight = 0.3
    bpy.context.view_layer.update()
    yield
    yield lambda: not part("features.hull.hull_state").state_of(made).shown.is_sliding
    yield


def _pairs(window):
    made = yield from _family(window)
    for entry in made.hull.morph.parents:
        lines = entry.source.hull.lines
        lines.show_stations = lines.show_features = False
    made.hull.morph.show_pairs = True
    bpy.context.view_layer.update()
    yield


def _members(*names, layout=None, distance=0.78):
    """The scene of two samples and three members between them, side by side."""

    def scene(window):
        with window.in_view():
            bpy.ops.screen.screen_full_area()
        yield
        space = window.space
        space.show_region_toolbar, space.show_region_ui = False, False
        space.shading.color_type, space.lens = "MATERIAL", 120.0
        overlay = space.overlay
        overlay.show_floor = overlay.show_axis_x = overlay.show_axis_y = False
        overlay.show_cursor = overlay.show_extras = False
        with window.in_view():
            hulls = _spread(morph_of_pair(*names, layout=layout))
        for hull in hulls:
            _show_stations(hull)
        bpy.context.view_layer.update()
        yield
        window.look(hulls[2], (62.0, 0.0, 128.0), is_perspective=True)
        space.region_3d.view_distance *= distance
        for hull in hulls:
            hull.select_set(False)
        yield

    return scene


def _spread(made):
    """[the first parent, members at a quarter, half and three quarters, the second parent], side by
    side; the middle one is the hull given."""
    first, second = (entry.source for entry in made.hull.morph.parents)
    copies = []
    for weight in (0.75, 0.25):
        bpy.ops.object.select_all(action="DESELECT")
        made.select_set(True)
        bpy.context.view_layer.objects.active = made
        bpy.ops.object.duplicate()
        copies.append(bpy.context.view_layer.objects.active)
        copies[-1].hull.morph.parents[0].weight = weight
    hulls = [first, copies[0], made, copies[1], second]
    widest = max(hull.hull.beam for hull in hulls)
    for number, hull in enumerate(hulls):
        hull.location.y = 1.6 * number * widest
    return hulls


def _show_stations(hull):
    hull.hull.show_net, lines = False, hull.hull.lines
    lines.show_buttocks = lines.show_waterlines = lines.show_design_waterline = False
    lines.station_count = 10


def _has_ghost(hull):
    ghosts = part("features.variants.ghosts")
    return bool(part("features.hull.hull_state").state_of(hull).of(ghosts.Ghost).groups)


def _area_curve(window):
    """A handle of the target area curve is dragged in the plot over the view."""
    with window.in_view():
        bpy.ops.screen.screen_full_area()
    yield
    hull = load(window)
    window.space.show_region_toolbar, window.space.lens = False, 90.0
    window.space.overlay.show_floor = False
    window.open_sidebar()
    yield
    window.look(hull, _OVER_THE_BOW, is_perspective=True)
    window.space.region_3d.view_distance /= 1.5
    window.space.region_3d.view_location.z -= 0.2 * hull.dimensions.x
    hull.hull.lines.show_buttocks = hull.hull.lines.show_waterlines = False
    hull.hull.plots.size = 0.9
    with window.in_view():
        bpy.ops.hull.take_area_curve()
    yield
    handles = part("features.area_curves.handles")

    def shown():
        return handles.diagram(hull, bpy.context.scene, window.area, window.region())

    yield lambda: shown() is not None
    with window.in_view():
        bpy.ops.hull.drag_area_curve("INVOKE_DEFAULT")
    for index, up in ((3, -8), (9, 6), (8, 10)):
        x, y = shown().dots(handles.points_of(hull, bpy.context.scene))[index]
        region = window.region()
        window.move_to(region.x + x, region.y + y)
        window.hold("LEFTMOUSE")
        window.move_by(0, up)
        yield
        if index != 8:
            window.let_go("LEFTMOUSE")
            yield
    yield lambda: are_known(hull, ("sectional_areas",))


def _fields(window):
    """A field at the fore shoulder with its handles, the mouse over that of the shift; the deck
    edge is protected."""
    with window.in_view():
        bpy.ops.screen.screen_full_area()
    yield
    hull = load(window)
    window.space.show_region_toolbar, window.space.overlay.show_floor = False, False
    window.open_sidebar()
    yield
    window.look(hull, (64.0, 0.0, 132.0), is_perspective=True)
    window.space.region_3d.view_location = (60.0, 5.0, 3.5)
    window.space.region_3d.view_distance = 48.0
    lines = hull.hull.lines
    lines.show_buttocks = lines.show_waterlines = lines.show_stations = False
    window.space.overlay.show_cursor = False
    with window.in_view():
        bpy.ops.hull.add_field(role="PROTECT", base="CREASE")
        bpy.ops.hull.add_field()
    deck, shoulder = hull.hull.fields.fields
    deck.name, deck.place, deck.extent = "Deck edge", (68.0, 6.5, 9.0), 2.0
    shoulder.name, shoulder.place = "Fore shoulder", (64.0, 6.7, 4.0)
    shoulder.extent, shoulder.shift = 9.0, (0.0, 1.5, 0.0)
    bpy.context.view_layer.update()
    yield
    with window.in_view():
        bpy.ops.hull.drag_field("INVOKE_DEFAULT")
    yield
    handles, drags = part("features.fields.handles"), part("features.modelling.drags")
    region = window.region()
    eye = part("features.modelling.pull_lines").eye_of(hull, 1.0, window.space.region_3d, region)
    row, base = handles.at_hand(hull, bpy.context.scene)
    tip = handles.places(row, base, eye, 1.0)["shift"]
    x, y = drags.in_picture(eye.to_clip, eye.size, tip[None])[0]
    window.move_to(region.x + x, region.y + y)
    yield


def _plan(window, path):
    """The lines plan of the new hull, as the button writes it."""
    yield from _new_hull(window)
    bpy.ops.hull.export_lines(filepath=path)
    save_smaller(path, 3)


def _scaled(window):
    """A coaster that is made longer and broader, with the panel of the operation."""
    hull = yield from coaster_in_window(window)
    window.look(hull, _OVER_THE_BOW, is_perspective=True)
    window.space.region_3d.view_distance /= 1.1
    window.space.region_3d.view_location.z -= 0.12 * hull.dimensions.x
    yield
    settings = hull.hull
    with window.in_view():
        bpy.ops.hull.set_dimensions(
            "EXEC_DEFAULT", True, length=1.1 * settings.length_pp, beam=15.0, draft=settings.draft
        )
    yield
    region = window.region()
    window.move_to(region.x + 0.55 * region.width, region.y + 0.2 * region.height)
    window.press("F9")
    yield


_NUMBERS = hull_panels(
    "hydrostatics", "hydrostatics_displacement", "hydrostatics_centres", "hydrostatics_stability"
)
_NETWORK = hull_panels(*network_scenes.PANELS)
# From below, off the port bow.
_FROM_BELOW = (112.0, 0.0, 142.0)


def _appendages(window):
    """A canoe body with a bulb keel and a rudder."""
    hull = yield from _new_hull(window, closer=1.0, words="sailing yacht")
    with bpy.context.temp_override(object=hull, active_object=hull):
        bpy.ops.hull.add_appendage(kind="BULB_KEEL")
        bpy.ops.hull.add_appendage(kind="RUDDER", x=0.06 * hull.hull.length_pp)
    yield
    window.look(hull, _FROM_BELOW, is_perspective=True)
    window.space.region_3d.view_distance /= 1.6
    yield


VIEWS = {
    "appendages": View(_appendages, hull_panels("appendages", "hydrostatics")),
    "dimensions": View(_scaled, hull_panels("hull")),
    "export": View(export_scenes.worst_spot, hull_panels("export", "patches")),
    "fields": View(_fields, hull_panels("fields")),
    "fair-rows": View(_rows, hull_panels("fair", "fair_rows")),
    "first-hull/added": View(_added, hull_panels("hull", "surface")),
    "first-hull/edited": View(_edited, _NUMBERS),
    "first-hull/pie": View(_pie, hull_panels("hull", "tags", "shape")),
    "first-hull/judged": View(_judged, hull_panels("fairness", "combs")),
    "morphing/weights": View(_weights, hull_panels("morph")),
    "morphing/ships": View(_members("container_ship", "bulk_carrier", layout="roro"), ()),
    "morphing/coasters": View(_members("coaster", "roro", layout="roro", distance=1.2), ()),
    "morphing/vessels": View(_members("research_vessel", "naval_vessel", distance=0.9), ()),
    "morphing/pairs": View(_pairs, hull_panels("morph", "morph_pairs")),
    "transformation/area-curve": View(_area_curve, hull_panels("transform", "area_curve")),
    "rulings": View(plate_scenes.rulings, hull_panels("shape")),
    "seams": View(plate_scenes.seams, hull_panels("plates")),
    "tied-points": View(tie_scenes.tied_points, hull_panels("hull", "tags", "point_groups")),
    "variants/ghost": View(_ghost, hull_panels("variants", "comparison")),
    "variants/distances": View(_distances, hull_panels("variants", "differences", "distances")),
    "first-hull/measured": View(_measured, (*_NUMBERS, "HULL_PT_plots")),
    **{name: View(scene, hull_panels("fields")) for name, scene in field_scenes.STEPS.items()},
    **{name: View(scene, _NETWORK) for name, scene in network_scenes.STEPS.items()},
}

# By the file's name a scene that writes the picture to a path itself.
DRAWINGS = {"first-hull/lines-plan": _plan}
