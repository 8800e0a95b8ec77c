# SPDX-License-Identifier: GPL-3.0-or-later
"""What the panels say, read from a layout that writes down texts; the background has no window."""

from types import FunctionType, MethodType, SimpleNamespace

import bpy
import pytest
from addon_under_test import add_hull, compute, part


class Notebook:
    """Stands for a layout and its parts; texts, properties and operators are noted in order."""

    def __init__(self, noted=None):
        self.noted = [] if noted is None else noted

    def _part(self, *unused, **more_unused):
        return Notebook(self.noted)

    row = column = split = box = grid_flow = _part

    def separator(self):
        pass

    def label(self, text="", icon="NONE"):
        self.noted.append(text)

    def prop(self, data, name, **unused):
        assert name in data.bl_rna.properties
        self.noted.append(f"property {name}")

    def prop_search(self, data, name, *where, **unused):
        self.prop(data, name)

    def prop_enum(self, data, name, value, **unused):
        assert value in data.bl_rna.properties[name].enum_items
        self.prop(data, name)

    def operator(self, idname, **unused):
        self.noted.append(f"operator {idname}")
        return SimpleNamespace()

    def operator_menu_enum(self, idname, name, **unused):
        self.noted.append(f"operator {idname}")

    def menu(self, name, **unused):
        assert hasattr(bpy.types, name)
        self.noted.append(f"menu {name}")

    def template_list(self, list_type, identifier, data, name, active_data, active, **unused):
        assert hasattr(bpy.types, list_type)
        self.noted.append(f"list of {len(getattr(data, name))} at {getattr(active_data, active)}")


class Drawn:
    """Stands for an instance of a panel's class, which only Blender can make."""

    def __init__(self, cls):
        self._cls = cls
        self.layout = Notebook()

    def __getattr__(self, name):
        value = getattr(self._cls, name)
        return MethodType(value, self) if isinstance(value, FunctionType) else value


def context(dialog_of=None):
    """dialog_of: the name of the class of the operator whose file dialog is open."""
    operator = dialog_of and SimpleNamespace(bl_idname=dialog_of)
    return SimpleNamespace(
        object=bpy.context.object,
        selected_objects=bpy.context.selected_objects,
        scene=bpy.context.scene,
        region=SimpleNamespace(width=4000),
        space_data=SimpleNamespace(active_operator=operator),
        # Without a window Blender's own scale is 0.
        preferences=SimpleNamespace(system=SimpleNamespace(ui_scale=1.0)),
    )


def texts(dialog_of=None):
    """All that the panels that are there say, by the name of the panel's class."""
    panels, now = part("panels")._CLASSES, context(dialog_of)
    said = {}
    for cls in panels:
        if issubclass(cls, bpy.types.Panel) and (not hasattr(cls, "poll") or cls.poll(now)):
            drawn = Drawn(cls)
            drawn.draw(now)
            said[cls.__name__] = drawn.layout.noted
    return said


def compute_all(hull):
    analyses = part("features.analyses").ANALYSES
    compute([(hull.name, name) for name in analyses])


@pytest.fixture
def hull():
    hull = add_hull()
    hull.hull.draft = 1.0
    hull.hull.loading.kg = 1.2
    bpy.context.view_layer.update()
    return hull


def value_after(noted, name):
    return noted[noted.index(name) + 1]


def test_hydrostatics_with_units(hull):
    said = texts()
    assert value_after(said["HULL_PT_hydrostatics_displacement"], "Volume ∇") == "40.000 m³"
    assert value_after(said["HULL_PT_hydrostatics_stability"], "KMt") == "1.833 m"
    assert value_after(said["HULL_PT_hydrostatics_coefficients_project"], "Cb") == "1.0000"
    assert value_after(said["HULL_PT_hydrostatics_waterplane"], "Entrance ½") == "90.00°"


def test_stability_says_dashes_before_it_was_computed(hull):
    before = texts()["HULL_PT_stability"]
    assert "Righting levers: computing …" in before
    assert value_after(before, "GM") == value_after(before, "Area 0–40°") == "–"
    compute_all(hull)
    said = texts()
    assert value_after(said["HULL_PT_stability"], "GM") == "0.633 m"
    assert any(text.startswith("2.2.4 met") for text in said["HULL_PT_criteria"])


def test_criteria_say_which_are_met_and_what_they_rest_on(hull):
    compute_all(hull)
    said = texts()["HULL_PT_criteria"]
    assert any(text.startswith("2.2 GZ and GM: ") for text in said)
    assert "2.3 Severe wind and rolling: not evaluated" in said
    assert any("wind areas are not known" in text for text in said)
    assert any("No downflooding point" in text for text in said)
    assert not any("guess" in text or "deck edge" in text for text in said)
    # The VCG that a hull begins with is a guess until somebody gives it.
    hull.hull.loading.kg_is_guess = True
    bpy.context.view_layer.update()
    compute_all(hull)
    for name in ("HULL_PT_criteria", "HULL_PT_stability_remarks"):
        assert any(text.startswith("VCG 1.2 m is a guess") for text in texts()[name])


def mirrored(hull):
    """Now it lies to starboard, or is back again."""
    for vertex in hull.data.vertices:
        vertex.co.y = -vertex.co.y
    hull.data.update()
    part("features.hull.hull_state").refresh(hull, bpy.context.scene)


def test_numbers_of_before_are_none_of_a_hull_with_errors(hull):
    compute_all(hull)
    good = texts()
    mirrored(hull)
    said = texts()
    assert any("lies to starboard" in text for text in said["HULL_PT_hydrostatics"])
    groups = [name for name in said if name.startswith("HULL_PT_hydrostatics_")]
    assert groups == [name for name in good if name.startswith("HULL_PT_hydrostatics_")]
    assert value_after(said["HULL_PT_hydrostatics_displacement"], "Volume ∇") == "–"
    for name in groups:
        assert not any(" m" in text and "." in text for text in said[name]), said[name]
    assert "Righting levers: hull has errors" in said["HULL_PT_stability"]
    assert "IS Code, Part A: hull has errors" in said["HULL_PT_criteria"]
    assert "computing" not in str(said)
    live = part("features.analyses.live_analyses")
    assert live.latest(hull, bpy.context.scene, "righting_levers")[1] is False
    hull.hull.plots.righting_levers = hull.hull.plots.sectional_areas = True
    live.show_plots(hull, bpy.context.scene)
    assert [plot.is_current for plot in live.plots().shown] == [False, False]
    hull.hull.plots.righting_levers = hull.hull.plots.sectional_areas = False
    mirrored(hull)
    assert texts() == good


def places(said):
    """By field and button at which line of its panel it stands."""
    marks = ("property ", "operator ", "list ")
    return [(line, text) for line, text in enumerate(said) if text.startswith(marks)]


def test_no_field_or_button_of_stability_moves_with_results(hull):
    """Not within its panel; panels that grow and shrink stand below those of fields."""
    found = [places(texts()["HULL_PT_stability"])]
    compute_all(hull)
    found.append(places(texts()["HULL_PT_stability"]))
    assert "No downflooding point is given" in texts()["HULL_PT_stability_remarks"][0]
    with bpy.context.temp_override(object=hull):
        bpy.ops.hull.add_downflooding_point()
    hull.hull.loading.kg = 2.5
    bpy.context.view_layer.update()
    found.append(places(texts()["HULL_PT_stability"]))
    compute_all(hull)
    found.append(places(texts()["HULL_PT_stability"]))
    assert texts()["HULL_PT_stability_remarks"] == ["None"]
    assert found[0] and all(one == found[0] for one in found)
    parts = [cls for cls in part("panels")._CLASSES if
             getattr(cls, "bl_parent_id", "") == "HULL_PT_stability"]  # fmt: skip
    parts.sort(key=lambda cls: cls.bl_order)
    assert [cls.bl_label for cls in parts[-2:]] == ["IS Code Criteria", "Remarks"]
    assert len({cls.bl_order for cls in parts}) == len(parts)


def test_a_criterion_that_is_not_met_in_spite_of_its_number_says_why(hull):
    """Where the ship floods before 30°, though there is area enough up to there."""
    criterion = SimpleNamespace(paragraph="2.2.1", outcome="fail", name="Area", value=0.06,
                                unit="m·rad", bound="at least", limit=0.055,
                                note="The ship floods at 18.0°.")  # fmt: skip
    drawn = Drawn(part("panels.criteria").HULL_PT_criteria)
    drawn._draw_criterion(drawn.layout, context(), criterion)
    assert drawn.layout.noted == [
        "2.2.1 not met: Area", "0.060 m·rad", "≥ 0.055 m·rad", "The ship floods at 18.0°."
    ]  # fmt: skip
    criterion.value, drawn.layout.noted[:] = 0.05, []
    drawn._draw_criterion(drawn.layout, context(), criterion)
    assert len(drawn.layout.noted) == 3


def test_the_vcg_is_a_guess_until_it_is_given():
    hull = add_hull()
    loading = hull.hull.loading
    assert loading.kg == pytest.approx(1.8) and loading.kg_is_guess
    loading.kg = 1.8
    assert not loading.kg_is_guess


def test_wind_and_rolling(hull):
    said = texts()["HULL_PT_wind"]
    assert said == ["Wind area", "property source"]
    hull.hull.wind.source = "HULL"
    assert bpy.ops.hull.add_wind_area() == {"FINISHED"}
    area = hull.hull.wind.areas[0]
    area.area, area.z = 12.0, 4.0
    bpy.context.view_layer.update()
    compute_all(hull)
    said = texts()
    assert "list of 1 at 0" in said["HULL_PT_wind"]
    # 10 m by 2 m of side above the draft, and the house.
    assert value_after(said["HULL_PT_wind"], "Wind area A") == "32.000 m²"
    lever = (20.0 * 2.0 + 12.0 * 4.0) / 32.0 - 0.5
    assert value_after(said["HULL_PT_wind"], "Lever Z") == f"{lever:.3f} m"
    assert any(
        text.startswith("2.3 Severe wind and rolling: ") for text in said["HULL_PT_criteria"]
    )
    assert any(text.startswith("2.3.1.2 ") for text in said["HULL_PT_criteria"])
    assert any("B/d is 4" in text for text in said["HULL_PT_criteria"])
    assert bpy.ops.hull.remove_wind_area() == {"FINISHED"}
    hull.hull.wind.source = "GIVEN"
    bpy.context.view_layer.update()
    compute_all(hull)
    # Without areas there is no criterion, and the others stay.
    said = texts()["HULL_PT_criteria"]
    assert any("no wind area" in text for text in said)
    assert any(text.startswith("2.2.4 met") for text in said)


def test_load_cases(hull):
    bpy.ops.hull.add_load_case()
    compute_all(hull)
    said = texts()["HULL_PT_load_cases"]
    assert "list of 1 at 0" in said and "Floats, stable" in said
    assert value_after(said, "Mean draft") == "1.000 m"


def test_a_load_case_tells_that_its_vcg_is_a_guess_until_it_is_given(hull):
    hull.hull.loading.kg_is_guess = True
    bpy.ops.hull.add_load_case()
    compute_all(hull)
    said = texts()
    assert value_after(said["HULL_PT_load_cases"], "VCG") == "1.200 m, a guess"
    remarks = said["HULL_PT_stability_remarks"]
    of_case = remarks[remarks.index("Load case 1:") + 1 :]
    assert any(text.startswith("VCG 1.2 m is a guess") for text in of_case)
    assert any("wind areas are not known" in text for text in of_case)
    # The same for the load case that is loaded.
    hull.hull.loading.loaded, hull.hull.loading.loaded_case = "CASE", "Load case 1"
    bpy.context.view_layer.update()
    compute_all(hull)
    for name in ("HULL_PT_criteria", "HULL_PT_stability_remarks"):
        assert any(text.startswith("VCG 1.2 m is a guess") for text in texts()[name])
    case = hull.hull.loading.load_cases[0]
    case.vcg = 1.2
    assert not case.vcg_is_guess
    bpy.context.view_layer.update()
    compute_all(hull)
    said = texts()
    assert value_after(said["HULL_PT_load_cases"], "VCG") == "1.200 m"
    assert "guess" not in str(said)
    hull.hull.loading.kg = 1.3
    bpy.ops.hull.add_load_case()
    assert not hull.hull.loading.load_cases[1].vcg_is_guess


def test_a_flooded_hull_is_a_quiet_line(hull):
    hull.hull.deck_closed = False
    hull.hull.heel = 1.2
    bpy.context.view_layer.update()
    compute_all(hull)
    said = texts()
    assert "floods at" in " ".join(said["HULL_PT_hydrostatics"])
    assert "HULL_PT_hydrostatics_centres" not in said


def test_a_load_that_sinks_is_a_quiet_line(hull):
    hull.hull.loading.use_displacement = False
    hull.hull.loading.mass_t = 1e4
    bpy.context.view_layer.update()
    compute_all(hull)
    said = texts()
    for name in ("HULL_PT_stability", "HULL_PT_levers", "HULL_PT_criteria"):
        assert "inks" in " ".join(said[name])


def test_panels_of_a_hull_of_which_nothing_is_known(hull):
    part("features.hull.hull_state").forget_all()
    assert "HULL_PT_hydrostatics" in texts()


def test_without_a_hull_there_are_only_beginnings():
    assert "HULL_PT_stability" not in texts()
    assert "menu HULL_MT_add" in texts()["HULL_PT_hull"]


def test_conversion_and_its_report(hull):
    said = texts()["HULL_PT_patches"]
    assert "operator hull.convert" in said and "operator hull.copy_report" not in said
    bpy.ops.hull.convert()
    said = texts()["HULL_PT_patches"]
    assert value_after(said, "Exact") == "100 %" and value_after(said, "Gaps") == "none"
    assert value_after(said, "Patches") == "4, least 4"
    assert "operator hull.copy_report" in said and "operator hull.show_worst_spot" in said
    assert "Out of date" not in " ".join(said)
    hull.hull.export.bezier = True
    assert "Out of date" in " ".join(texts()["HULL_PT_patches"])


def test_file_dialogs_say_how_far_the_patches_are(hull):
    assert not any("dialog" in name for name in texts())
    assert not any("dialog" in name for name in texts("HULL_OT_export_lines"))
    bpy.ops.hull.convert()
    step, iges = texts("HULL_OT_export_step"), texts("HULL_OT_export_iges")
    for said in (step, iges):
        assert value_after(said["HULL_PT_dialog_report"], "Gaps") == "none"
        assert "property extent" in said["HULL_PT_dialog_file"]
    assert "property schema" in step["HULL_PT_dialog_file"]
    assert "property schema" not in iges["HULL_PT_dialog_file"]


def test_panels_stand_in_the_order_of_the_work():
    tops = [
        cls.bl_label
        for cls in part("panels")._CLASSES
        if issubclass(cls, bpy.types.Panel)
        and not hasattr(cls, "bl_parent_id")
        and getattr(cls, "bl_category", "") == "Hull"
    ]
    wanted = ["Hull", "Surface", "Sections", "Shape", "Fairness", "Hydrostatics", "Stability",
              "Lines Plan", "Export", "Studio"]  # fmt: skip
    assert [label for label in tops if label in wanted] == wanted


def test_coefficients_are_at_the_top_of_the_numbers(hull):
    said = texts()["HULL_PT_hydrostatics"]
    assert [name for name in said if name in ("Cb", "Cp", "Cm", "Cwp", "LCF")] == [
        "Cb", "Cp", "Cm", "Cwp", "LCF",
    ]  # fmt: skip
    assert value_after(said, "Cb") == "1.0000" and value_after(said, "LCF") == "5.000 m"


def test_one_word_of_draft_and_no_it(hull):
    said = [text for noted in texts().values() for text in noted]
    assert not [text for text in said if "draught" in text.lower() or text.startswith("Its ")]


def test_other_hulls_are_at_hand_beside_a_hull(hull):
    said = texts()["HULL_PT_hull"]
    assert {"menu HULL_MT_add", "operator hull.import_hull", "operator hull.load_sample"} <= {*said}


def test_fields_have_labels_and_zeros_say_what_they_mean(hull):
    hull.hull.plan.scale = 0.0
    said = texts()
    assert "0: the largest that fits" in said["HULL_PT_lines_plan"]
    hull.hull.plan.scale = 100.0
    assert "0: the largest that fits" not in texts()["HULL_PT_lines_plan"]
    assert said["HULL_PT_fit"].index("Target") < said["HULL_PT_fit"].index("property target")
    for name, label in (("ground", "Ground"), ("light", "Light"), ("engine", "Renderer")):
        place = said["HULL_PT_studio"].index(f"property {name}")
        assert said["HULL_PT_studio"][place - 1] == label
    assert value_after(said["HULL_PT_plots"], "Corner") == "property corner"


def test_layers_are_named_in_the_tab(monkeypatch):
    bpy.ops.hull.load_sample(name="coaster")
    bpy.ops.hull.load_sample(name="coaster")
    hull = bpy.context.object
    edited = []
    note = Notebook.prop
    monkeypatch.setattr(
        Notebook, "prop", lambda self, data, name, **rest: (
            edited.append((data, name)), note(self, data, name, **rest)
        ),
    )  # fmt: skip
    texts()
    fields = [data for data, name in edited if name == "name"]
    assert fields == list(hull.hull.layers) and fields[0].name == "Shell"


def test_angles_of_knuckles(hull):
    compute_all(hull)
    said = texts()["HULL_PT_knuckles"]
    assert any("90.0°" in text for text in said)
