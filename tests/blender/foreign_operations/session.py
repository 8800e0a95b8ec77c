# SPDX-License-Identifier: GPL-3.0-or-later
"""A run of Blender's own operations on hulls, chosen by a random number generator."""

import random

import bmesh
import bpy
from addon_under_test import add_hull, make_active, part

from . import operators
from .own_work import OwnWork
from .view import in_view

MOST_FACES = 500
MOST_OBJECTS = 14
# Faces of children, times faces or points of the parents that they are shown on.
MOST_INSTANCED = 30000
FEWEST_HULLS, MOST_HULLS = 2, 5
MODES = ("OBJECT", "EDIT", "EDIT", "SCULPT", "VERTEX_PAINT", "WEIGHT_PAINT")


def _update():
    """Updates the active hull; what came of it. A mesh may have been left that is refused."""
    try:
        return sorted(bpy.ops.hull.update())
    except RuntimeError as error:
        assert "Traceback" not in str(error), error
        return f"refused: {error}"


def _is_half_done(name):
    """Whether Blender would take a selected object's parent away and then refuse, telling nobody:
    where it is asked to join an object to its parent, or to make it a parent of its own."""
    if name not in ("object.join", "object.parent_set", "object.parent_no_inverse_set"):
        return False
    parent = bpy.context.view_layer.objects.active.parent
    while parent is not None and not parent.select_get():
        parent = parent.parent
    return parent is not None


class Session:
    """step() does one thing and returns what, as text."""

    def __init__(self, seed, folder):
        self.random = random.Random(seed)
        self.path = str(folder / "session.blend")
        self.is_saved = False
        own = OwnWork(self)
        self._actions = {
            self.operator: 60,
            self.select: 10,
            self.select_elements: 6,
            self.change_mode: 7,
            self.undo: 5,
            self.redo: 3,
            self.give_data: 3,
            self.touch_surface_object: 4,
            own.own_operator: 12,
            own.change_setting: 8,
            own.shape_field: 10,
            self.edit_by_script: 3,
            self.save_and_load: 1,
        }
        self.populate()

    def populate(self):
        """Hulls of both kinds, with lines, one of them with faces that are kept flat."""
        add_hull("box")
        assert bpy.ops.hull.add_hull(kind="BARGE") == {"FINISHED"}
        assert bpy.ops.hull.add_hull(kind="ROUND_BILGE") == {"FINISHED"}
        for hull in self.hulls():
            hull.hull.samples = 2
            hull.hull.draft = hull.hull.draft or 1.0
            hull.hull.lines.show_stations = hull.hull.lines.show_waterlines = True
        self.finish("start")

    def finish(self, name):
        bpy.context.view_layer.update()
        self._show_fewer()
        bpy.ops.ed.undo_push(message=name)
        bpy.context.view_layer.update()

    def hulls(self):
        return part("bridge.objects.hull_objects").hulls(bpy.context.view_layer.objects)

    def step(self):
        done = self.tidy() if self.random.random() < 0.5 else None
        if done is None:
            action = self.random.choices(list(self._actions), list(self._actions.values()))[0]
            done = action() or ""
            done = f"{action.__name__} {done}"
        if not done.startswith(("undo", "redo", "save_and_load")):
            self.finish(done[:60])
        bpy.context.view_layer.update()
        return done

    @staticmethod
    def _show_fewer():
        """Children shown on each face of a large mesh take minutes to draw by the processor."""
        for obj in bpy.context.view_layer.objects:
            if obj.type != "MESH" or obj.instance_type not in ("FACES", "VERTS"):
                continue
            places = max(len(obj.data.polygons), len(obj.data.vertices))
            faces = sum(len(child.data.polygons) for child in obj.children if child.type == "MESH")
            if places * faces > MOST_INSTANCED:
                obj.instance_type = "NONE"

    # Each of these returns what was done.

    def operator(self):
        for name in operators.by_chance(self.mode(), self.random):
            self.tell(f"poll {name}")
            if operators.can_be_called(name) and not _is_half_done(name):
                break
        arguments = operators.arguments_by_chance(name, self.random)
        self.tell(f"{name} {arguments}")
        came = operators.call(name, arguments)
        if name in operators.TELL_NOBODY:
            for edited in bpy.context.objects_in_mode_unique_data:
                bmesh.update_edit_mesh(edited.data)
        return f"{name} {arguments}: {came}"

    def tell(self, text):
        """What is about to be done, for a log that outlives a crash."""

    @staticmethod
    def mode():
        active = bpy.context.view_layer.objects.active
        mode = "OBJECT" if active is None else active.mode
        return mode if mode in ("EDIT", "SCULPT") or mode.endswith("PAINT") else "OBJECT"

    def select(self):
        if self.mode() != "OBJECT":
            return None
        objects = list(bpy.context.view_layer.objects)
        if not objects:
            return None
        chosen = self.random.sample(objects, min(len(objects), self.random.choice((1, 1, 2, 3))))
        for obj in objects:
            obj.select_set(obj in chosen)
        bpy.context.view_layer.objects.active = chosen[0]
        return ", ".join(obj.name for obj in chosen)

    def select_elements(self):
        # What is edited may have become a curve.
        if self.mode() != "EDIT" or not bpy.ops.mesh.select_all.poll():
            return None
        kinds = [self.random.random() < 0.5 for _ in range(3)]
        kinds[self.random.randrange(3)] = True
        bpy.context.tool_settings.mesh_select_mode = kinds
        if self.random.random() < 0.4:
            return bpy.ops.mesh.select_all(action="SELECT") and "all"
        ratio, seed = self.random.uniform(0.05, 0.6), self.random.randrange(1000)
        bpy.ops.mesh.select_all(action="DESELECT")
        bpy.ops.mesh.select_random(ratio=ratio, seed=seed)
        return f"{ratio} {seed}"

    def change_mode(self):
        mode = "OBJECT" if self.mode() != "OBJECT" else self.random.choice(MODES)
        self.tell(f"mode {mode}")
        try:
            bpy.ops.object.mode_set(mode=mode)
        except (RuntimeError, TypeError) as error:
            return f"{mode}: {error}"
        return mode

    def undo(self):
        return self._through_history(bpy.ops.ed.undo)

    def redo(self):
        return self._through_history(bpy.ops.ed.redo)

    def _through_history(self, operator):
        times = self.random.choice((1, 1, 2, 4))
        for _ in range(times):
            if not operator.poll():
                return "at the end"
            self.tell(str(operator))
            try:
                operator()
            except RuntimeError:
                return "at the end"
        return str(times)

    def give_data(self):
        """Mesh data shared, made single again, exchanged, by script as by the tab of data."""
        if self.mode() != "OBJECT":
            return None
        meshes = [obj for obj in bpy.context.view_layer.objects if obj.type == "MESH"]
        if len(meshes) < 2:
            return None
        one, other = self.random.sample(meshes, 2)
        how = self.random.choice(("share", "copy", "exchange", "new"))
        self.tell(f"{how} {one.name} {other.name}")
        if how == "share":
            one.data = other.data
        elif how == "copy":
            one.data = one.data.copy()
        elif how == "exchange":
            one.data, other.data = other.data, one.data
        else:
            one.data = bpy.data.meshes.new("new")
        return f"{how} {one.name} {other.name}"

    def touch_surface_object(self):
        """Who makes a surface object selectable may do with it what he likes."""
        if self.mode() != "OBJECT" or not self.hulls():
            return None
        hull = self.random.choice(self.hulls())
        shown = hull.hull.surface_object
        if shown is None:
            make_active(hull)
            refusal = part("bridge.objects.hull_objects").refusal(hull)
            return None if refusal else f"update {hull.name} {_update()}"
        if shown.name not in bpy.context.view_layer.objects:
            return None
        shown.hide_select = False
        make_active(shown)
        if self.random.random() < 0.5:
            hull.select_set(True)
        return shown.name

    def edit_by_script(self):
        hulls = self.hulls()
        if not hulls:
            return None
        hull = self.random.choice(hulls)
        how = self.random.choice(("move", "clear", "remove object", "remove mesh", "purge"))
        self.tell(f"{how} {hull.name}")
        if how == "move":
            self._move_a_point(hull)
        elif how == "purge":
            bpy.data.orphans_purge()
        elif hull.mode == "OBJECT" and not hull.data.is_editmode:
            if how == "clear":
                hull.data.clear_geometry()
            elif len(hulls) > FEWEST_HULLS:
                name = hull.name
                (bpy.data.objects.remove if how == "remove object" else bpy.data.meshes.remove)(
                    hull if how == "remove object" else hull.data
                )
                return f"{how} {name}"
        return f"{how} {hull.name}"

    def _move_a_point(self, hull):
        by, axis = self.random.uniform(-1.0, 1.0), self.random.randrange(3)
        if hull.data.is_editmode:
            bm = bmesh.from_edit_mesh(hull.data)
            bm.verts.ensure_lookup_table()
            if len(bm.verts):
                bm.verts[self.random.randrange(len(bm.verts))].co[axis] += by
                bmesh.update_edit_mesh(hull.data)
        elif len(hull.data.vertices):
            hull.data.vertices[self.random.randrange(len(hull.data.vertices))].co[axis] += by
            hull.data.update()

    def save_and_load(self):
        if self.mode() != "OBJECT":
            return None
        self.tell("save and load")
        if not self.is_saved or self.random.random() < 0.7:
            bpy.ops.wm.save_as_mainfile(filepath=self.path)
            self.is_saved = True
        bpy.ops.wm.open_mainfile(filepath=self.path)
        with in_view():
            self.finish("loaded")
        return self.path

    def tidy(self):
        """Keeps the scene small, and some hulls in it; what was done, or None."""
        objects = bpy.context.view_layer.objects
        large = [
            o
            for o in objects
            if o.type == "MESH"
            and len(o.data.polygons) > MOST_FACES
            and not any(h.hull.surface_object == o for h in self.hulls())
        ]
        few = len(self.hulls()) < FEWEST_HULLS
        many = len(objects) > MOST_OBJECTS or len(self.hulls()) > MOST_HULLS
        if not (large or few or many):
            return None
        if self.mode() != "OBJECT":
            return f"tidy {self.change_mode()}"
        self.tell("tidy")
        others = [o for o in objects if not o.hull.is_hull and o.parent is None]
        many_of = (others or self.hulls()[FEWEST_HULLS:]) if many else []
        for obj in dict.fromkeys(large + many_of):
            bpy.data.objects.remove(obj)
        if len(self.hulls()) < FEWEST_HULLS:
            name = f"box {self.random.randrange(1000)}"
            add_hull(name)
            bpy.context.object.hull.samples = 2
        return f"tidy {len(large)} {few} {many}"
