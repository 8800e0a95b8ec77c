# SPDX-License-Identifier: GPL-3.0-or-later
"""What is on the docs' pictures of panels, by the files' names. They are set up by generators
as the tests of the window are: see tests/window/stepping.py."""

from dataclasses import dataclass

import bpy
import network_scenes
import numpy as np
from addon_under_test import part


@dataclass(frozen=True)
class PanelShot:
    """Panels alone. panels: class names; prepare(hull): what is set before; in_edit_mode;
    analyses: those that are shown."""

    panels: tuple
    prepare: object = None
    in_edit_mode: bool = False
    analyses: tuple = ()


def hull_panels(*names):
    return tuple(f"HULL_PT_{name}" for name in names)


def load(window, name="coaster"):
    with window.in_view():
        bpy.ops.hull.load_sample(name=name)
    return bpy.context.view_layer.objects.active


def panel_scene(window, shot):
    hull = load(window)
    if shot.prepare is not None:
        shot.prepare(hull)
    bpy.context.view_layer.update()
    if shot.in_edit_mode:
        bpy.ops.object.mode_set(mode="EDIT")
    # Only what is drawn asks for analyses that take their time.
    window.open_sidebar()
    yield
    yield lambda: are_known(hull, shot.analyses)
    yield


def are_known(hull, analyses):
    last_outcome = part("features.analyses").last_outcome
    return all(last_outcome(hull, bpy.context.scene, name)[1] for name in analyses)


def _with_combs(hull):
    hull.hull.fairness.comb_stations = True
    hull.hull.fairness.colours = "GAUSSIAN"
    with bpy.context.temp_override(object=hull, active_object=hull):
        bpy.ops.hull.count_marks()
        bpy.ops.hull.show_mark(step=1)


def _with_opening(hull):
    hull.hull.loading.kg = 5.0
    with bpy.context.temp_override(object=hull, active_object=hull):
        bpy.ops.hull.add_downflooding_point()
    hatch = hull.hull.loading.downflooding_points[0]
    hatch.name, hatch.position = "Hatch, fore end", (58.0, 4.2, 8.6)


def _with_weights(hull):
    weights = hull.hull.weights
    weights.thickness = 0.018
    for name, mass, lcg, vcg in (("Outfit", 310.0, 38.0, 9.2), ("Machinery", 145.0, 12.5, 4.1)):
        with bpy.context.temp_override(object=hull, active_object=hull):
            bpy.ops.hull.add_weight()
        item = weights.items[-1]
        item.name, item.mass_t, item.lcg, item.vcg = name, mass, lcg, vcg


def _with_load_cases(hull):
    _with_opening(hull)
    loading, hull.hull.wind.source = hull.hull.loading, "HULL"
    for name, mass, vcg in (("Ballast, arrival", 2600.0, 4.1), ("Full load", 4400.0, 5.0)):
        with bpy.context.temp_override(object=hull, active_object=hull):
            bpy.ops.hull.add_load_case()
        case = loading.load_cases[-1]
        case.name, case.mass_t, case.vcg = name, mass, vcg
    loading.loaded, loading.loaded_case = "CASE", loading.load_cases[-1].name


def _with_fit(hull):
    """The hull fitted to faces between points of its own surface, somewhat fuller."""
    grid = part("features.hull.hull_state").state_of(hull).ship.surface.tessellate(12)
    mesh = bpy.data.meshes.new("Scan")
    mesh.from_pydata((np.array(grid.points) * [1.0, 1.01, 1.0]).tolist(), [], grid.quads.tolist())
    hull.hull.fit.use_edges = True
    hull.hull.fit.target = bpy.data.objects.new(mesh.name, mesh)
    bpy.context.collection.objects.link(hull.hull.fit.target)
    bpy.context.view_layer.update()
    with bpy.context.temp_override(object=hull, active_object=hull):
        bpy.ops.hull.fit()


def _with_targets(hull):
    """More displacement further forward, and stability enough: solved."""
    values = part("features.hull.hull_state").state_of(hull).hydrostatics.values
    wanted = (
        ("DISPLACEMENT", 1.02 * values.displacement_t, "equal"),
        ("LCB_PERCENT", values.lcb_percent + 0.2, "equal"),
        ("KMT", values.kmt - 0.1, "at least"),
    )
    with bpy.context.temp_override(object=hull, active_object=hull):
        for quantity, value, sense in wanted:
            bpy.ops.hull.add_target()
            row = hull.hull.targets.rows[-1]
            row.quantity, row.value, row.sense = quantity, value, sense
        bpy.ops.hull.solve_targets()


def _with_model(hull):
    """In segments, made."""
    hull.hull.model.in_segments, hull.hull.model.dowel = True, 6.0
    with bpy.context.temp_override(object=hull, active_object=hull):
        bpy.ops.hull.make_model()


def _with_panels(hull):
    with bpy.context.temp_override(object=hull, active_object=hull):
        bpy.ops.hull.make_panels()


def _with_fields(hull):
    """A waterline that is fuller forward, with the deck edge protected."""
    bpy.context.scene.cursor.location = (68.0, 6.5, 4.0)
    with bpy.context.temp_override(object=hull, active_object=hull):
        bpy.ops.hull.add_field(role="PROTECT", base="CREASE")
        bpy.ops.hull.add_field()
    deck, shoulder = hull.hull.fields.fields
    deck.name, deck.place, deck.extent = "Deck edge", (68.0, 6.5, 9.0), 2.0
    shoulder.name, shoulder.base, shoulder.axis = "Fore waterline", "SECTION", "Z"
    shoulder.varies, shoulder.extent, shoulder.extent_end = True, 5.0, 5.0
    shoulder.shift_end, shoulder.axes = (0.0, 0.3, 0.0), (False, True, False)
    with bpy.context.temp_override(object=hull, active_object=hull):
        bpy.ops.hull.preview_fields()


def fuller_forward(hull):
    """Gives the fore body of a hull up to a sixth more breadth."""
    length = hull.dimensions.x
    for vertex in hull.data.vertices:
        along = min(max(vertex.co.x / length - 0.5, 0.0) / 0.3, 1.0)
        vertex.co.y *= 1.0 + along**2 / 6.0
    hull.data.update()
    bpy.context.view_layer.update()


def _with_variants(hull):
    """Two, the first of them as it is behind the hull."""
    with bpy.context.temp_override(object=hull, active_object=hull):
        bpy.ops.hull.keep_variant(name="As built", note="as in the contract")
        bpy.ops.hull.keep_variant(name="Second", note="to be forgotten")
    fuller_forward(hull)
    hull.hull.variants.active, hull.hull.variants.show_ghost = 0, True


def _with_kept_bow(hull):
    """Finer, so that marks can be compared, and an area curve wanted."""
    hull.hull.transform.kept_fore = 4.0
    values = part("features.hull.hull_state").state_of(hull).hydrostatics.values
    with bpy.context.temp_override(object=hull, active_object=hull):
        block = values.project_block - 0.02
        bpy.ops.hull.shift_sections(measure="BLOCK", block=block, lcb_as="NONE", part="FAIR")
        bpy.ops.hull.count_marks(compare=True)
        bpy.ops.hull.take_area_curve()
    _fuller_shoulder(hull)


def _fuller_shoulder(hull):
    """Somewhat more area wanted at the fore shoulder, and less at the after one."""
    for index, factor in ((3, 0.985), (8, 1.05), (9, 1.04)):
        hull.hull.area_target.area_points[index].area *= factor
    bpy.context.view_layer.update()


def _with_dent_faired(hull):
    """A dent of one point in the fore body, faired out, and two control curves through it."""
    mesh_points, fairing = part("bridge.mesh.mesh_points"), part("features.fairing.region_fairing")
    points = mesh_points.read(hull.data)
    point = np.abs(points - (67.9, 6.1, 4.9)).sum(axis=1).argmin(keepdims=True)
    ends = [tuple(edge.vertices) for edge in hull.data.edges if point[0] in edge.vertices]
    ends.sort(key=lambda edge: np.ptp(points[list(edge), 0]))
    bpy.ops.object.mode_set(mode="EDIT")
    for name, edge in (("Side", ends[-1]), ("Shoulder", ends[0])):
        part("bridge.mesh.selection").select(bpy.context, hull, "edge", [edge])
        part("features.fairing.control_curves").add(hull, bpy.context.scene, name)
    mesh_points.write(hull.data, point, points[point] - (0.0, 0.052, 0.0))
    part("features.hull.hull_state").follow_edit(hull, bpy.context.scene)
    part("bridge.mesh.selection").select(bpy.context, hull, "vertex", point.tolist())
    fairing.fair_selected(hull, bpy.context.scene, fairing.Asked(7.5e-3))
    bpy.ops.object.mode_set(mode="OBJECT")


def loaded(*names):
    """Samples, the only hulls there."""
    for obj in list(bpy.data.objects):
        bpy.data.objects.remove(obj)
    hulls = []
    for name in names:
        bpy.ops.hull.load_sample(name=name)
        hulls.append(bpy.context.view_layer.objects.active)
    return hulls


def morph_of_pair(first, second, layout=None):
    """A morph of two samples by the layout of the first, or of another sample; the active hull."""
    names = list(dict.fromkeys([first, second, layout or first]))
    hulls = dict(zip(names, loaded(*names)))
    parents = [hulls[first], hulls[second]]
    with bpy.context.temp_override(
        object=parents[0], active_object=parents[0], selected_objects=parents
    ):
        bpy.ops.hull.make_morph(layout=hulls[layout or first].name)
    for name in names[2:]:
        hulls[name].hide_set(True)
    return bpy.context.view_layer.objects.active


def _with_morph(hull):
    made = morph_of_pair("container_ship", "bulk_carrier", layout="roro")
    made.hull.morph.parents[0].weight, made.hull.morph.active_parent = 0.3, 1
    with bpy.context.temp_override(object=made, active_object=made):
        bpy.ops.hull.add_field(base="PLANE")
        field = made.hull.fields.fields[0]
        field.name, field.axis, field.place, field.extent = "Bow", "X", (240.0, 0.0, 0.0), 60.0
        bpy.ops.hull.add_local_parent()
        bpy.ops.hull.add_target()


def _with_studio(hull):
    part("features.studio").make(hull, bpy.context.scene)


def _of_a_mesh(hull):
    """The hull's own surface as a mesh, and a hull made of that, active."""
    state = part("features.hull.hull_state").up_to_date(hull, bpy.context.scene)
    grid = state.ship.surface.tessellate(6)
    mesh = bpy.data.meshes.new("scan")
    mesh.from_pydata(np.array(grid.points).tolist(), [], np.array(grid.quads).tolist())
    scan = bpy.data.objects.new("scan", mesh)
    bpy.context.collection.objects.link(scan)
    hull.select_set(False)
    bpy.context.view_layer.objects.active = scan
    with bpy.context.temp_override(object=scan, active_object=scan):
        bpy.ops.hull.hull_from_mesh(points=90)


def _with_keel(hull):
    with bpy.context.temp_override(object=hull, active_object=hull):
        bpy.ops.hull.add_appendage(kind="BULB_KEEL")


def with_plates(hull):
    """Broad strakes and a keel strake, laid out; frames in two ranges."""
    settings = hull.hull.plates
    with bpy.context.temp_override(object=hull, active_object=hull):
        bpy.ops.hull.suggest_seams()
        settings.rules[0].value, settings.rules[1].value = 4.0, 30.0
        bpy.ops.hull.change_plate_list(action="ADD_RULE")
        settings.rules[2].kind, settings.rules[2].value = "from_centre", 1.2
        for last, spacing in ((10, 0.55), (140, 0.65)):
            bpy.ops.hull.change_plate_list(action="ADD_RANGE")
            settings.ranges[-1].last, settings.ranges[-1].spacing = last, spacing
        bpy.ops.hull.lay_out_plates()


def _with_propeller(hull):
    """Power by a propeller, beside a variant that is narrower, and one input that is given."""
    with bpy.context.temp_override(object=hull, active_object=hull):
        bpy.ops.hull.keep_variant(name="narrow")
    for vertex in hull.data.vertices:
        vertex.co.y *= 1.08
    hull.data.update()
    own = hull.hull.resistance
    own.speed_from, own.speed_step = 8.0, 2.0
    own.propeller_diameter, own.open_water_efficiency, own.shaft_efficiency = 3.6, 0.62, 0.98
    own.holtrop.entrance_angle_deg = 32.0


PANELS = {
    "panels/appendages": PanelShot(hull_panels("appendages"), _with_keel),
    "panels/hull": PanelShot(hull_panels("hull", "check")),
    "panels/hull-of-mesh": PanelShot(hull_panels("hull", "made_of"), _of_a_mesh),
    "panels/surface": PanelShot(hull_panels("surface")),
    "panels/edges-and-points": PanelShot(
        hull_panels("tags", "select", "point_groups", "shown_tags"), in_edit_mode=True
    ),
    "panels/shape": PanelShot(hull_panels("shape"), in_edit_mode=True),
    "panels/pull": PanelShot(hull_panels("pull"), in_edit_mode=True),
    "panels/fit": PanelShot(hull_panels("fit"), _with_fit),
    "panels/targets": PanelShot(hull_panels("targets"), _with_targets),
    "panels/morph": PanelShot(hull_panels("morph", "morph_pairs"), _with_morph),
    "panels/morph-series": PanelShot(
        hull_panels("morph", "morph_local", "morph_targets", "morph_series"), _with_morph
    ),
    "panels/fields": PanelShot(hull_panels("fields"), _with_fields),
    "panels/networks": PanelShot(hull_panels(*network_scenes.PANELS), network_scenes.prepare_panel),
    "panels/variants": PanelShot(
        hull_panels("variants", "comparison", "differences", "distances"),
        _with_variants,
        analyses=("differences",),
    ),
    "panels/transform": PanelShot(
        hull_panels("transform", "area_curve"), _with_kept_bow, analyses=("sectional_areas",)
    ),
    "panels/fair": PanelShot(
        hull_panels("fair", "fair_rows", "control_curves"), _with_dent_faired, in_edit_mode=True
    ),
    "panels/plates": PanelShot(hull_panels("plates", "plate_drawings", "frames"), with_plates),
    "panels/sections": PanelShot(hull_panels("sections", "planes")),
    "panels/fairness": PanelShot(
        hull_panels("fairness", "combs", "marks", "knuckles", "reflections"), _with_combs
    ),
    "panels/hydrostatics": PanelShot(
        hull_panels(
            "hydrostatics",
            "hydrostatics_displacement",
            "hydrostatics_centres",
            "hydrostatics_stability",
        )
    ),
    "panels/stability": PanelShot(
        hull_panels("stability", "downflooding_points", "stability_remarks"),
        _with_opening,
        analyses=("righting_levers",),
    ),
    "panels/load-cases": PanelShot(
        hull_panels("stability", "load_cases"),
        _with_load_cases,
        analyses=("load_cases", "righting_levers"),
    ),
    "panels/weights": PanelShot(
        hull_panels("stability", "weights"),
        _with_weights,
        analyses=("weights", "righting_levers"),
    ),
    "panels/resistance": PanelShot(
        hull_panels("resistance", "resistance_inputs", "resistance_waves", "resistance_remarks"),
        _with_propeller,
        analyses=("resistance_curves",),
    ),
    "panels/plots": PanelShot(hull_panels("plots")),
    "panels/lines-plan": PanelShot(hull_panels("lines_plan")),
    "panels/model": PanelShot(hull_panels("model"), _with_model),
    "panels/panels": PanelShot(hull_panels("panel_mesh"), _with_panels),
    "panels/export": PanelShot(hull_panels("export", "patches", "cad_file")),
    "panels/studio": PanelShot(hull_panels("studio"), _with_studio),
}
