# SPDX-License-Identifier: GPL-3.0-or-later
"""What the menus of edit mode offer, and where they are found; the background has no window."""

from types import SimpleNamespace

import bpy
import pytest
from addon_under_test import add_box, add_hull, part
from edited_hulls import BORDERS, KNUCKLES, edit
from test_panels import Drawn, Notebook

OF_MODES = {
    (True, False, False): {"hull.tag_corner", "hull.tag_automatic", "hull.put_in_plane"},
    (False, True, False): {"hull.tag_crease", "hull.mark_deck_edge", "hull.select_chains"},
    (False, False, True): {"hull.make_flat", "hull.release_flat", "hull.check_flat"},
}


class MenuNotebook(Notebook):
    def _part(self, *unused, **more_unused):
        return MenuNotebook(self.noted)

    menu_pie = _part

    def menu(self, name, **unused):
        assert hasattr(bpy.types, name)
        self.noted.append(f"menu {name}")


def drawn(draw):
    """Operators that a draw function offers; each of them exists."""
    menu = SimpleNamespace(layout=MenuNotebook())
    draw(menu, bpy.context)
    return check(menu.layout.noted)


def check(noted):
    operators = [text.split()[1] for text in noted if text.startswith("operator ")]
    for name in operators:
        getattr(bpy.ops.hull, name.split(".")[1]).get_rna_type()
    return operators


def pie_items():
    pie = Drawn(part("panels.tag_menus").HULL_MT_pie)
    pie.layout = MenuNotebook()
    pie.draw(bpy.context)
    check(pie.layout.noted)
    return pie.layout.noted


def test_the_pie_has_no_more_items_than_directions():
    edit(add_hull())
    assert len(pie_items()) == 8
    other = add_box("no hull")
    bpy.ops.object.mode_set(mode="OBJECT")
    edit(other)
    assert pie_items() == [
        f"operator hull.tag_{name}" for name in ("crease", "smooth", "corner", "automatic")
    ]


@pytest.mark.parametrize("mode", OF_MODES)
def test_the_context_menu_is_of_the_select_mode(mode):
    menus = part("panels.tag_menus")
    edit(add_hull(), mode)
    offered = set(drawn(menus.DRAWN_IN["VIEW3D_MT_edit_mesh_context_menu"]))
    assert offered >= OF_MODES[mode]
    for other, operators in OF_MODES.items():
        assert other == mode or not offered & operators


def test_menus_of_other_meshes_are_left_alone():
    edit(add_box())
    for draw in part("panels.tag_menus").DRAWN_IN.values():
        assert drawn(draw) == []


def test_all_menus_are_blenders_and_have_the_hull_once():
    edit(add_hull())
    for name, draw in part("panels.tag_menus").DRAWN_IN.items():
        functions = getattr(bpy.types, name)._dyn_ui_initialize()
        assert functions.count(draw) == 1
        drawn(draw)


def test_the_select_menu_offers_all_ways():
    menu = Drawn(part("panels.tag_menus").HULL_MT_select)
    menu.layout = MenuNotebook()
    edit(add_hull())
    menu.draw(bpy.context)
    assert set(check(menu.layout.noted)) == {
        "hull.select_creases", "hull.select_chains", "hull.select_points", "hull.select_odd_faces",
        "hull.select_flat", "hull.select_locked", "hull.select_problems", "hull.select_kept",
        "hull.select_tied",
    }  # fmt: skip


def test_the_panel_counts_what_it_shows():
    hull = add_hull()
    edit(hull)
    panel = Drawn(part("panels.tags").HULL_PT_shown_tags)
    panel.layout = MenuNotebook()
    panel.draw(bpy.context)
    noted = panel.layout.noted
    counts = {name: text for name, text in zip(noted, noted[1:]) if name.startswith("property")}
    assert counts["property show_knuckle"] == str(KNUCKLES)
    assert counts["property show_border"] == str(BORDERS)
    assert counts["property show_corners"] == "8" and counts["property show_darts"] == "0"
    assert counts["property show_odd_faces"] == counts["property show_problems"] == "0"
