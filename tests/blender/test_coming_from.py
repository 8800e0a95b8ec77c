# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/coming-from.md: every command of FREE!ship's menus is on it, and what it says that it covers
of DELFTship and Rhino; what it sends one to stands in
the panels and in the mode that it says, and can be called there; and Blender's own tools that it
names leave a hull that follows."""

import re
from types import SimpleNamespace

import bmesh
import bpy
import pytest
from addon_under_test import add_hull, make_active, part, sample, state_of
from commands_elsewhere import DELFTSHIP, RHINO
from edited_hulls import edit
from freeship_commands import COMMANDS
from test_docs import DOCS, LabelNotebook, page_of
from test_panels import Drawn, context

PAGE = DOCS / "coming-from.md"
SLANTED = re.compile(r"(?<![\w*])\*([^*\n]+?)\*(?![\w*])")
EDIT, OBJECT = "EDIT", "OBJECT"
# Half a minute; test_plate_files has it.
TAKE_LONG = {"export_plates"}
HALF_LENGTH = 42.0  # of the coaster


class ButtonNotebook(LabelNotebook):
    """Notes pairs (label, operator's name or "")."""

    def _part(self, *unused, **more_unused):
        return ButtonNotebook(self.noted)

    row = column = split = box = grid_flow = _part

    def prop(self, data, name, text=None, **unused):
        if text != "":
            self.noted.append((text or data.bl_rna.properties[name].name, ""))

    def operator(self, idname, text=None, **unused):
        if idname.startswith("hull."):
            name = getattr(bpy.ops.hull, idname.split(".")[1]).get_rna_type().name
            self.noted.append((text or name, idname.split(".")[1]))
        return SimpleNamespace()


def rows():
    """(what is there, what is here) of each row of the page's tables."""
    cells = [
        line.strip("|").split(" | ") for line in PAGE.read_text().splitlines() if line[:1] == "|"
    ]
    return [tuple(cell) for cell in cells if len(cell) == 2 and cell[0].strip() != "there"]


def labels_of(cell):
    return [label.lower() for label in SLANTED.findall(cell.replace("**", "§"))]


def buttons():
    """What the panels have now: {page: {label: operator's name or ""}}."""
    found = {}
    for cls in part("panels")._CLASSES:
        if getattr(cls, "bl_category", "") != "Hull":
            continue
        is_elsewhere = getattr(cls, "bl_context", "") == "mesh_edit" and mode_now() != EDIT
        if is_elsewhere or hasattr(cls, "poll") and not cls.poll(context()):
            continue
        drawn = Drawn(cls)
        drawn.layout = ButtonNotebook()
        drawn.draw(context())
        noted = found.setdefault(page_of(cls), {})
        noted.update({label.lower(): name for label, name in drawn.layout.noted})
    return found


def mode_now():
    return bpy.context.object.mode


def mode_of(cell):
    return EDIT if ", edit" in cell or "(edit" in cell else OBJECT


def in_both_modes():
    """{mode: buttons()} of a sample hull with points, edges and faces selected in edit mode."""
    hull = sample("coaster")
    found = {OBJECT: buttons()}
    edit(hull)
    bpy.ops.mesh.select_all(action="SELECT")
    found[EDIT] = buttons()
    bpy.ops.object.mode_set(mode="OBJECT")
    return found


def named_commands():
    """What the left column lists, in small letters; with a menu before it also by both."""
    found = set()
    for there, _ in rows():
        text = there.replace("|", "").strip().lower()
        listed = [name.strip() for name in re.split("[,;:]", text)]
        menu = listed[0].partition(" › ")[0]
        for whole in listed:
            name = whole.rpartition(" › ")[2]
            found |= {whole, name, f"{menu} › {name}"}
    return found


def test_every_command_of_freeship_is_on_the_page():
    found = named_commands()
    missing = [
        caption
        for captions in COMMANDS.values()
        for caption in captions
        if caption.lower() not in found
    ]
    assert not missing
    assert sum(map(len, COMMANDS.values())) > 120


def rows_below(heading):
    """The left cells of the tables below a heading of the page, up to the next."""
    text = PAGE.read_text().partition(f"\n{heading}\n")[2]
    lines = re.split(r"\n#+ ", text)[0].splitlines()
    cells = [line.strip("|").split(" | ")[0].strip() for line in lines if line[:1] == "|"]
    return [cell for cell in cells if cell not in ("there", "---|---")]


def test_what_delftship_has_beyond_freeship_is_on_the_page():
    """That, and nothing else."""
    found = [name for cell in rows_below("### Of DELFTship alone") for name in cell.split(", ")]
    assert sorted(found) == sorted(DELFTSHIP)
    known = {caption.lower() for captions in COMMANDS.values() for caption in captions}
    assert not known & {name.lower() for name in DELFTSHIP}


def test_rhinos_commands_for_hulls_are_on_the_page():
    """Those of the list, and nothing else; Rhino's are in bold."""
    cells = rows_below("## Rhino (and Orca3D)")
    found = [name for cell in cells for name in re.findall(r"\*\*(\w+)\*\*", cell)]
    assert sorted(found) == sorted(name for names in RHINO.values() for name in names)
    assert len(found) > 80


def is_on(label, said):
    """Whether a page names a label, as such or as the heading of what is told of a panel."""
    heading = rf"^#+ (panel )?{re.escape(label)}$"
    return f"*{label}*" in said or re.search(heading, said, flags=re.M)


def test_what_rows_name_is_on_the_pages_that_they_lead_to():
    faults = []
    for there, here in rows():
        pages = re.findall(r"\]\((?:panels/)?([\w-]+\.md)", here)
        texts = [DOCS / "panels" / name for name in pages] + [DOCS / name for name in pages]
        said = "\n".join(path.read_text() for path in texts if path.exists()).lower()
        lost = [label for label in labels_of(here) if pages and not is_on(label, said)]
        faults += [f"{there}: {label} not in {pages}" for label in lost]
    assert not faults, "\n".join(faults)


def test_buttons_stand_in_the_panels_and_the_mode_that_rows_tell():
    found, faults, called = in_both_modes(), [], 0
    for there, here in rows():
        mode = mode_of(here)
        pages = re.findall(r"\(panels/([\w-]+)\.md", here)
        for label in labels_of(here):
            has = {m: [p for p in pages if label in found[m].get(p, {})] for m in found}
            if any(has.values()):
                called += 1
                if not has[mode]:
                    faults.append(f"{there}: {label} is not there in {mode}")
    assert not faults, "\n".join(faults)
    assert called > 60


def named_operators(mode):
    """Names of the operators whose buttons rows send one to, in a mode; a sample hull is active."""
    known = in_both_modes()[mode]
    labels = {label for _, here in rows() if mode_of(here) == mode for label in labels_of(here)}
    found = {name for page in known.values() for label, name in page.items() if label in labels}
    return sorted(found - {""})


def in_mode(hull, mode):
    if mode == EDIT:
        edit(hull)
        bpy.ops.mesh.select_all(action="SELECT")


@pytest.mark.parametrize("mode", [OBJECT, EDIT])
def test_buttons_that_rows_name_can_be_pressed(mode):
    pressed = named_operators(mode)
    in_mode(bpy.context.object, mode)
    assert len(pressed) > 20
    refused = {name for name in pressed if not getattr(bpy.ops.hull, name).poll()}
    # These need curves, and targets.
    assert refused <= {"curves_to_network", "solve_targets"}


def arguments(operator, folder):
    """A name for what writes or reads a file."""
    properties = operator.get_rna_type().properties
    if "filepath" not in properties:
        return {}
    ending = properties["filter_glob"].default.partition(";")[0].lstrip("*")
    return {"filepath": str(folder / f"file{ending}")}


@pytest.mark.parametrize("mode", [OBJECT, EDIT])
def test_what_rows_name_does_its_work_or_says_in_a_sentence_why_not(mode, tmp_path):
    """With all of a hull selected; the hull is followed afterwards in either case."""
    done, told = set(), {}
    for name in set(named_operators(mode)) - TAKE_LONG:
        bpy.ops.wm.read_homefile(use_empty=True)
        hull, operator = sample("coaster"), getattr(bpy.ops.hull, name)
        in_mode(hull, mode)
        if not operator.poll():
            continue
        try:
            assert operator(**arguments(operator, tmp_path)) == {"FINISHED"}, name
            done.add(name)
        except RuntimeError as error:
            told[name] = str(error)
        bpy.context.view_layer.update()
        assert not state_of(hull).status, name
    assert len(done) > 15
    assert all("Traceback" not in text and len(text.split()) > 3 for text in told.values())


def middle_edge(hull):
    """(BMesh, the edge between smooth points of four edges that is nearest to amidships)."""
    bm = bmesh.from_edit_mesh(hull.data)
    inner = [edge for edge in bm.edges if all(len(point.link_edges) == 4 for point in edge.verts)]
    return bm, min(inner, key=lambda edge: sum(abs(p.co.x - HALF_LENGTH) for p in edge.verts))


def collapsed(hull):
    bm, edge = middle_edge(hull)
    edge.select_set(True)
    bpy.ops.mesh.dissolve_edges(use_verts=False)


def coincided(hull):
    bm, edge = middle_edge(hull)
    for vertex in edge.verts:
        vertex.select_set(True)
        bm.select_history.add(vertex)
    bpy.ops.mesh.merge(type="FIRST")


def split(hull):
    bm, edge = middle_edge(hull)
    edge.select_set(True)
    bpy.ops.mesh.subdivide(number_cuts=1)


def bisected(hull):
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.bisect(plane_co=(HALF_LENGTH + 1.0, 0.0, 0.0), plane_no=(1.0, 0.0, 0.0))


def extruded(hull):
    """A bulwark: the borders beside the centre plane upwards."""
    bm = bmesh.from_edit_mesh(hull.data)
    for edge in bm.edges:
        if edge.is_boundary and max(point.co.y for point in edge.verts) > 0.1:
            edge.select_set(True)
    bpy.ops.mesh.extrude_region_move(TRANSFORM_OT_translate={"value": (0.0, 0.0, 1.0)})


def cleaned(hull):
    bm = bmesh.from_edit_mesh(hull.data)
    before = len(bm.verts)
    bm.verts.new((1.0, 1.0, 1.0))
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.delete_loose()
    assert len(bmesh.from_edit_mesh(hull.data).verts) == before


def linked(hull):
    """Faces within knuckles that are marked as seams, as Auto group has them."""
    bpy.ops.mesh.select_mode(type="EDGE")
    bpy.ops.hull.select_creases(kind="KNUCKLE")
    bpy.ops.mesh.mark_seam()
    bpy.ops.mesh.select_mode(type="FACE")
    bpy.ops.mesh.select_all(action="DESELECT")
    faces = bmesh.from_edit_mesh(hull.data).faces
    faces.ensure_lookup_table()
    faces[0].select_set(True)
    bpy.ops.mesh.select_linked(delimit={"SEAM"})
    bpy.ops.hull.new_layer(name="Group")


OF_BLENDER = (collapsed, coincided, split, bisected, extruded, cleaned, linked)


@pytest.mark.parametrize("tool", OF_BLENDER, ids=lambda tool: tool.__name__)
def test_tools_of_blender_that_are_named_leave_a_hull(tool):
    hull = sample("coaster")
    edit(hull)
    tool(hull)
    bpy.context.view_layer.update()
    bpy.ops.object.mode_set(mode="OBJECT")
    bpy.context.view_layer.update()
    state = state_of(hull)
    assert not state.status and not state.ship.check.errors
    assert state.hydrostatics.values.displaced_volume > 0.0


def test_two_control_meshes_are_joined():
    one, other = add_hull("one"), add_hull("other")
    other.location.x = 20.0
    make_active(one)
    other.select_set(True)
    assert bpy.ops.object.join() == {"FINISHED"}
    bpy.context.view_layer.update()
    assert state_of(one).ship.check.face_count == 8


def test_the_control_points_are_written_as_coordinates(tmp_path):
    hull = sample("coaster")
    path = tmp_path / "points.obj"
    export = bpy.ops.wm.obj_export
    export(filepath=str(path), export_selected_objects=True, apply_modifiers=False,
           export_materials=False)  # fmt: skip
    text = path.read_text().splitlines()
    assert sum(line.startswith("v ") for line in text) >= len(hull.data.vertices)
