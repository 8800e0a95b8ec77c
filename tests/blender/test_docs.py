# SPDX-License-Identifier: GPL-3.0-or-later
"""The docs keep in step with the program: what they name exists, and what panels show is named."""

import ast
import re
from pathlib import Path
from types import SimpleNamespace

import bpy
import pytest
from addon_under_test import ROOT, add_hull, compute, part
from expect_morph import boxes, morph_of
from networks import grid_network
from test_panels import Drawn, Notebook, context

DOCS = ROOT / "docs"
PAGES = sorted(DOCS.rglob("*.md"))
PANEL_PAGES = sorted((DOCS / "panels").glob("*.md"))
# Pages where what is slanted is what the add-on has on its buttons and fields.
LABELLED = [*PANEL_PAGES, DOCS / "first-hull.md", DOCS / "coming-from.md"]
# Pages of panels whose file has another name than the panel.
PAGE_OF = {"check": "hull", "tags": "edges-and-points", "lines_plan": "lines-plan",
           "panel_mesh": "panels"}  # fmt: skip
# Named as part of the ship or of a list, not as a label; and the slanted word of the legend.
NOT_LABELS = {"slanted", "surface", "kept flat"}


def page_id(path):
    return str(path.relative_to(DOCS))


def prose(path):
    """A page without its blocks of code."""
    return re.sub(r"```.*?```", "", path.read_text(), flags=re.S)


def properties_of(rna):
    """All properties of a group and of the groups in it."""
    for prop in rna.properties:
        if prop.identifier in ("rna_type", "name"):
            continue
        yield prop
        if prop.type in ("POINTER", "COLLECTION") and is_group(prop.fixed_type):
            yield from properties_of(prop.fixed_type)


def is_group(rna):
    return rna.base is not None and rna.base.identifier == "PropertyGroup"


def hull_rna():
    return bpy.types.Object.bl_rna.properties["hull"].fixed_type


def operator_rnas():
    return [getattr(bpy.ops.hull, name).get_rna_type() for name in dir(bpy.ops.hull)]


def labels():
    """All that the add-on writes on buttons, fields, panels and menus."""
    found = set()
    for rna in operator_rnas():
        found.add(rna.name)
        for prop in rna.properties:
            found |= names_of(prop)
    network = bpy.types.Collection.bl_rna.properties["hull_network"].fixed_type
    for prop in (*properties_of(hull_rna()), *properties_of(network)):
        found |= names_of(prop)
    for name in ("panels", "features"):
        for path in Path(part(name).__file__).parent.rglob("*.py"):
            for node in ast.walk(ast.parse(path.read_text())):
                if isinstance(node, ast.Constant) and isinstance(node.value, str):
                    found.add(node.value)
    return found


def names_of(prop):
    names = {prop.name}
    if prop.type == "ENUM":
        names |= {item.name for item in prop.enum_items}
    return names


@pytest.mark.parametrize("path", PAGES, ids=page_id)
def test_operators_and_properties_named_exist(path):
    text = path.read_text()
    for name in re.findall(r"bpy\.ops\.hull\.(\w+)", text):
        assert name in dir(bpy.ops.hull), f"there is no operator hull.{name}"
    for chain in re.findall(r"\b(?:Object|hull)\.hull\.([a-z_]\w*(?:\.[a-z_]\w*)*)", text):
        group = hull_rna()
        for name in chain.split("."):
            assert name in group.properties, f"there is no Object.hull.{chain}"
            prop = group.properties[name]
            group = getattr(prop, "fixed_type", None)
    for call in re.finditer(r"bpy\.ops\.hull\.(\w+)\(([^)]*)\)", text):
        known = getattr(bpy.ops.hull, call[1]).get_rna_type().properties
        for name in re.findall(r"(\w+)=", call[2]):
            assert name in known or name in ("name", "co"), f"hull.{call[1]} has no {name}"


@pytest.mark.parametrize("path", LABELLED, ids=page_id)
def test_labels_named_exist(path):
    known = {label.lower() for label in labels()} | NOT_LABELS
    slanted = re.findall(r"(?<![\w*])\*([^*\n]+?)\*(?![\w*])", prose(path).replace("**", "§"))
    assert slanted
    unknown = [label for label in slanted if label.lower() not in known]
    assert not unknown


class LabelNotebook(Notebook):
    """Notes what fields and buttons are called in the window."""

    def _part(self, *unused, **more_unused):
        return LabelNotebook(self.noted)

    row = column = split = box = grid_flow = _part

    def label(self, text="", icon="NONE"):
        pass

    def template_list(self, *unused, **more_unused):
        pass

    def prop(self, data, name, text=None, **unused):
        rna = data.bl_rna.properties[name]
        is_own = is_group(data.bl_rna)
        # Lists show names that users give; fields without a name show what is chosen.
        if is_own and name not in ("name", "progress") and text != "":
            self.noted.append(text or rna.name)

    def prop_search(self, data, name, *where, **more):
        self.prop(data, name, **more)

    def operator(self, idname, text=None, **unused):
        if idname.startswith("hull."):
            name = getattr(bpy.ops.hull, idname.split(".")[1]).get_rna_type().name
            self.noted.append(text or name)
        return SimpleNamespace()

    def operator_menu_enum(self, idname, name, text=None, **unused):
        self.operator(idname, text)

    def menu(self, name, text=None, **unused):
        pass


def drawn_labels():
    """Pairs (page, label) of all fields and buttons of the tab."""
    found = set()
    for cls in part("panels")._CLASSES:
        if getattr(cls, "bl_category", "") != "Hull":
            continue
        if hasattr(cls, "poll") and not cls.poll(context()):
            continue
        drawn = Drawn(cls)
        drawn.layout = LabelNotebook()
        drawn.draw(context())
        found |= {(page_of(cls), label) for label in drawn.layout.noted}
    return found


def drawn_labels_of_a_family():
    bpy.ops.object.mode_set(mode="OBJECT")
    made = morph_of(*boxes((1.0, 1.0, 1.0), (2.0, 1.0, 1.0)))
    made.hull.morph.active_parent, made.hull.morph.has_other_pairs = 1, True
    found = drawn_labels()
    bpy.ops.hull.add_field()
    bpy.ops.hull.add_local_parent()
    found |= drawn_labels()
    made.data.vertices[0].co.z -= 1.0
    part("features.morphing.members").follow(made, bpy.context.scene)
    found |= drawn_labels()
    return {pair for pair in found if pair[0] == "morph"}


def drawn_labels_of_a_network():
    bpy.ops.object.mode_set(mode="OBJECT")
    grid_network()
    curve = bpy.context.object.hull.curve
    found = drawn_labels()
    for name, value in (("plane", "OWN"), ("shape", "CONIC"), ("start", "TANGENT"),
                        ("end", "SLAVE_TANGENT"), ("show_comb", True)):  # fmt: skip
        setattr(curve, name, value)
    bpy.context.view_layer.update()
    found |= drawn_labels()
    curve.start = "SLAVE_CURVATURE"
    return {pair for pair in found | drawn_labels() if pair[0] == "networks"}


def page_of(cls):
    while getattr(cls, "bl_parent_id", ""):
        cls = getattr(bpy.types, cls.bl_parent_id)
    name = cls.__name__.removeprefix("HULL_PT_")
    return PAGE_OF.get(name, name)


def test_what_panels_show_is_on_their_pages():
    found = drawn_labels()
    hull = add_hull()
    hull.hull.fairness.show_reflections = hull.hull.fairness.show_isophotes = True
    hull.hull.fairness.colours = "MEAN"
    hull.hull.loading.use_displacement = hull.hull.loading.use_lcb = False
    hull.hull.plan.paper = "OWN"
    hull.hull.lines.stations = "1 2"
    bpy.ops.hull.add_plane()
    bpy.ops.hull.make_studio()
    for name in ("add_load_case", "add_downflooding_point"):
        getattr(bpy.ops.hull, name)()
    bpy.context.view_layer.update()
    compute([(hull.name, name) for name in part("features.analyses").ANALYSES])
    found |= drawn_labels()
    bpy.ops.object.mode_set(mode="EDIT")
    found |= drawn_labels()
    found |= drawn_labels_of_a_family()
    found |= drawn_labels_of_a_network()
    assert len(found) > 100
    missing = []
    for page, label in sorted(found):
        text = (DOCS / "panels" / f"{page}.md").read_text()
        if f"*{label}*".lower() not in text.lower():
            missing.append(f"panels/{page}.md: {label}")
    assert not missing, "\n".join(missing)


@pytest.mark.parametrize("path", [ROOT / "README.md", *PAGES], ids=lambda path: path.name)
def test_links_lead_somewhere(path):
    for target in re.findall(r"\]\(([^)#\s]+)[^)]*\)", prose(path)):
        if not target.startswith(("http:", "https:")):
            assert (path.parent / target).exists(), f"{path.name} links to {target}"


def test_the_index_has_every_page():
    index = (DOCS / "README.md").read_text()
    missing = [page_id(path) for path in PAGES if page_id(path) not in index]
    assert not missing


def test_the_index_has_the_panels_in_the_order_of_the_sidebar():
    section = (DOCS / "README.md").read_text().split("## The panels, from top to bottom")[1]
    rows = re.findall(r"^\| \[([^\]]+)\]\(panels/([\w-]+)\.md\)", section, flags=re.M)
    told = [label for labels, _ in rows for label in labels.split(", ")]
    panels = [
        cls
        for cls in part("panels")._CLASSES
        if getattr(cls, "bl_category", "") == "Hull" and not getattr(cls, "bl_parent_id", "")
    ]
    assert told == [cls.bl_label for cls in panels] and len(told) > 25
    pages = dict.fromkeys(page_of(cls) for cls in panels)
    assert [page for _, page in rows] == list(pages)


def test_every_picture_is_on_a_page():
    shown = {
        (path.parent / target).resolve()
        for path in [ROOT / "README.md", *PAGES]
        for target in re.findall(r"!\[[^\]]*\]\(([^)\s]+)\)", path.read_text())
    }
    pictures = {path.resolve() for path in (DOCS / "images").rglob("*") if path.is_file()}
    assert pictures - shown == set()


def test_the_glossary_tells_each_word_once():
    words = re.findall(r"^\| ([^|]+?) \|", (DOCS / "glossary.md").read_text(), flags=re.M)
    words = [word for word in words if word != "Word"]
    assert len(words) > 60 and len(set(words)) == len(words)


def test_the_key_of_the_pie_menu_is_the_one_named():
    key = part("bridge.blender.pie_key").KEY
    named = " ".join([*(["Shift"] if key.get("shift") else []), key["type"]])
    for page in ("first-hull.md", "tags.md", "panels/edges-and-points.md"):
        assert f"**{named}**" in (DOCS / page).read_text()
