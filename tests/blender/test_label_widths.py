# SPDX-License-Identifier: GPL-3.0-or-later
"""No text of the sidebar is cut off at the width at which Blender opens it."""

from types import SimpleNamespace

import bpy
import pytest
from addon_under_test import compute, module_name, part
from expect_morph import boxes, morph_of
from layout_widths import SIDEBAR, Measuring
from networks import grid_network
from test_fields_in_feet import ship as everything
from test_panels import Drawn, compute_all, context

# Those whose length is the user's or the file's.
_NAMES = {"Coaster"}


def drawn_panels(dialog_of=None):
    """(class, Measuring) of each panel of the add-on that is there."""
    now = context(dialog_of)
    now.region.width = 220
    for cls in part("panels")._CLASSES:
        if not issubclass(cls, bpy.types.Panel) or cls.bl_space_type != "VIEW_3D":
            continue
        if hasattr(cls, "poll") and not cls.poll(now):
            continue
        drawn = Drawn(cls)
        drawn.layout = Measuring()
        drawn.draw(now)
        yield cls, drawn.layout


def faults():
    return [
        f"{cls.__name__}: {fault}"
        for cls, layout in drawn_panels()
        for fault in layout.faults(SIDEBAR)
        if not any(name in fault for name in _NAMES)
    ]


@pytest.fixture
def ship():
    """A ship of usual size, of which everything is shown."""
    assert bpy.ops.hull.load_sample(name="coaster") == {"FINISHED"}
    hull = bpy.context.object
    settings = hull.hull
    settings.beam, settings.draft, settings.trim_m, settings.heel = 13.625, 5.2375, -0.125, 0.21
    fairness = settings.fairness
    fairness.colours = "GAUSSIAN"
    for name in ("comb_stations", "comb_waterlines", "comb_features", "show_reflections",
                 "show_isophotes", "show_silhouette"):  # fmt: skip
        setattr(fairness, name, True)
    settings.lines.stations = "0:80:10"
    settings.lines.frame_spacing = 0.625
    settings.plan.paper = "OWN"
    settings.loading.use_displacement = settings.loading.use_lcb = False
    settings.loading.mass_t, settings.loading.kg, settings.loading.lcg = 3456.789, 4.625, 41.375
    for face, plane in enumerate(((1, 0, 0, -2.375), (0.6, 0, 0.8, 2), (0.48, 0.6, 0.64, 30))):
        part("features.constraints.flats").mark(hull, [20 * face], plane)
    bpy.ops.hull.add_load_case()
    bpy.ops.hull.add_downflooding_point()
    bpy.ops.hull.add_plane()
    for name in part("features.analyses").PLOTTED:
        setattr(settings.plots, name, True)
    bpy.context.view_layer.update()
    compute_all(hull)
    return hull


def test_the_measure_itself():
    layout = Measuring()
    layout.label(text="Displacement")
    assert not list(layout.faults(SIDEBAR))
    layout.row().label(text="A text that is far too long for a sidebar of that width")
    assert len(list(layout.faults(SIDEBAR))) == 1
    split = layout.split(factor=0.5)
    split.label(text="Displacement by volume")
    split.label(text="1 m")
    assert len(list(layout.faults(SIDEBAR))) == 2


def test_without_a_hull():
    assert faults() == []


def test_a_ship_with_all_of_it(ship):
    bpy.ops.hull.convert()
    assert len(list(drawn_panels())) > 15
    found = faults()
    assert not found, "\n".join(found)


def test_in_edit_mode_and_in_feet(ship):
    bpy.context.scene.unit_settings.system = "IMPERIAL"
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.context.view_layer.update()
    found = faults()
    assert not found, "\n".join(found)


def test_a_hull_that_is_scaled_has_a_button_to_apply_it(ship):
    def buttons():
        bpy.context.view_layer.update()
        layouts = {cls.__name__: layout for cls, layout in drawn_panels()}
        assert faults() == []
        return list(layouts["HULL_PT_hull"].texts())

    assert "Apply" not in buttons()
    ship.scale = (2.0, 1.0, 1.0)
    assert "Apply" in buttons()
    ship.scale = (1.0, 1.0, 1.0)
    assert "Apply" not in buttons()


def test_a_network_of_curves():
    grid_network(show_surface=True)
    curve = bpy.context.object.hull.curve
    curve.plane, curve.shape, curve.show_comb = "OWN", "CONIC", True
    curve.start, curve.end = "SLAVE_CURVATURE", "SLAVE_TANGENT"
    bpy.context.view_layer.update()
    layouts = {cls.__name__: layout for cls, layout in drawn_panels()}
    assert {"HULL_PT_network_curve", "HULL_PT_network_problems"} <= set(layouts)
    assert faults() == []


def test_a_linked_hull(ship, tmp_path):
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "library.blend"))
    bpy.ops.wm.read_homefile(use_empty=True)
    with bpy.data.libraries.load(str(tmp_path / "library.blend"), link=True) as (_, wanted):
        wanted.objects = ["Coaster"]
    linked = wanted.objects[0]
    bpy.context.collection.objects.link(linked)
    bpy.context.view_layer.objects.active = linked
    bpy.context.view_layer.update()
    assert linked.library is not None
    texts = " ".join(text for _, layout in drawn_panels() for text in layout.texts())
    assert "linked from another file" in texts
    assert faults() == []


def drawn_in_menus():
    """(name, drawing function) of the add-on's menus, and of what it adds to Blender's own."""
    for cls in bpy.types.Menu.__subclasses__():
        if cls.__module__.startswith(f"{module_name()}."):
            yield cls.__name__, cls.draw
    for name in dir(bpy.types):
        for draw in getattr(getattr(getattr(bpy.types, name), "draw", None), "_draw_funcs", ()):
            if draw.__module__.startswith(f"{module_name()}."):
                yield name, draw


def test_menus_have_what_blender_has(ship):
    bpy.ops.object.mode_set(mode="EDIT")
    found = dict(drawn_in_menus())
    assert {"HULL_MT_pie", "TOPBAR_MT_file_import", "VIEW3D_MT_mesh_add"} <= set(found)
    for name, draw in found.items():
        layout = Measuring()
        draw(SimpleNamespace(layout=layout), bpy.context)
        assert layout.needed() > 0.0, name


def test_a_hull_of_a_family():
    made = morph_of(*boxes((1.0, 1.0, 1.0), (2.0, 1.5, 1.0)))
    morph = made.hull.morph
    morph.active_parent, morph.factors[1] = 1, 1.05
    assert "HULL_PT_morph_series" in [cls.__name__ for cls, _ in drawn_panels()]
    assert not faults()


def test_all_fields_of_a_large_ship_in_feet():
    """No wider than in metres."""
    units, own = bpy.context.scene.unit_settings, everything().hull
    own.resistance.holtrop.displaced_volume = own.resistance.delft.volume = 98765.4
    own.resistance.holtrop.wetted_surface = own.resistance.delft.wetted_surface = 12345.6
    own.loading.mass_t, own.loading.least_t, own.loading.greatest_t = 101234.5, 50123.4, 151234.5
    own.lines.waterlines = "0:1:0.25 2:12.5:0.5 13.25 14.75 16 18 20 22 24 26 28 30"
    own.targets.rows[0].value, own.targets.rows[0].tolerance = 98765.4, 12.3
    for colours in ("GAUSSIAN", "MEAN", "DISTANCE"):
        own.fairness.colours, own.fairness.colour_limit = colours, 0.125
        bpy.context.view_layer.update()
        for method in ("HOLTROP", "SAVITSKY", "DELFT"):
            own.resistance.method = method
            compute([(own.id_data.name, "resistance_curves")])
            found = {}
            for system in ("METRIC", "IMPERIAL"):
                units.system = system
                found[system] = set(faults())
            assert found["IMPERIAL"] <= found["METRIC"]


@pytest.mark.parametrize("kind", ["RUDDER", "BULB_KEEL", "TUNNEL"])
def test_forms_of_appendages(ship, kind):
    assert bpy.ops.hull.add_appendage(kind=kind) == {"FINISHED"}
    bpy.context.view_layer.update()
    assert bpy.context.object.hull.appendage.shape
    found = faults()
    assert not found, "\n".join(found)
