# SPDX-License-Identifier: GPL-3.0-or-later
"""What handlers point hulls to, of which Blender's undo may know nothing.

Undo leaves an object as it is in memory where the two steps have the same record of it. What a
handler pointed it to after a step was recorded is in no record: it goes with the undo, the object
points to what is no more, and Blender crashes. So before an undo objects point again to what they
did, which the records have. Where the undo went not so far as that what was made is gone, they then
get it back.
"""

import bpy


class _Mesh:
    """A mesh that an object was given."""

    def __init__(self, obj, mesh):
        self._obj, self._before, self._given = obj, obj.data, mesh

    def is_there(self):
        return self._obj.data == self._given and bool(self._before.name)

    def put_back(self):
        """The function that gives it again."""
        names = self._obj.name, self._before.name, self._given.name
        self._obj.data = self._before
        return lambda: _give_again(*names)


def _give_again(name, before, given):
    obj, mesh = _local(bpy.data.objects, name), _local(bpy.data.meshes, given)
    if obj is not None and mesh is not None and obj.type == "MESH" and obj.data.name == before:
        obj.data = mesh


class _Surface:
    """A surface object that a hull was given in place of one that is not its own."""

    def __init__(self, hull, before):
        self._hull, self._before, self._given = hull, before, hull.hull.surface_object

    def is_there(self):
        return self._hull.hull.surface_object == self._given and bool(self._before.name)

    def put_back(self):
        """The function that gives it again."""
        names = self._hull.name, self._before.name, self._given.name
        is_hidden = names[2] in bpy.context.view_layer.objects and self._given.hide_get()
        self._hull.hull.surface_object = self._before
        for collection in self._given.users_collection:
            collection.objects.unlink(self._given)
        return lambda: _show_again(*names, is_hidden)


def _show_again(name, before, given, is_hidden):
    hull, shown = _local(bpy.data.objects, name), _local(bpy.data.objects, given)
    if hull is None or shown is None or shown.parent != hull:
        return
    pointed = hull.hull.surface_object
    if pointed is None or pointed.name != before:
        return
    hull.hull.surface_object = shown
    for collection in hull.users_collection:
        if given not in collection.objects:
            collection.objects.link(shown)
    if is_hidden:
        _to_hide.append(given)


def _local(all_of_a_kind, name):
    return all_of_a_kind.get((name, None))


_made = []  # the last one last
_to_give = []  # functions; what they are about is known by name, as undo makes all of it anew
_to_hide = []  # names of objects
_is_undoing = False


def is_undoing():
    """Whether an undo or redo is on its way: Blender may tell handlers of changes meanwhile, as
    where a mode ends, and what they pointed objects to then would go with the undo, too."""
    return _is_undoing


def give_mesh(obj, mesh):
    """obj.data = mesh, within a handler."""
    _remember(_Mesh(obj, mesh))
    obj.data = mesh


def has_new_surface(hull, before):
    """Within a handler a hull was given a surface object; before: what it pointed to."""
    _remember(_Surface(hull, before))


def before_undo():
    """Before an undo or redo."""
    global _is_undoing
    _is_undoing = True
    _to_give.clear()
    _to_give.extend(one.put_back() for one in reversed(_made) if _is_there(one))
    _made.clear()


def after_undo():
    """First of all that is done after an undo or redo."""
    global _is_undoing
    _is_undoing = False
    for give in reversed(_to_give):
        give()
    _to_give.clear()


def after_update():
    """What was hidden is hidden again: after an undo a view layer has nothing of what it got."""
    for name in _to_hide:
        obj = bpy.context.view_layer.objects.get(name)
        if obj is not None:
            obj.hide_set(True)
    _to_hide.clear()


def forget():
    """Before another file is read."""
    global _is_undoing
    _is_undoing = False
    for kept in (_made, _to_give, _to_hide):
        kept.clear()


def _remember(one):
    _made[:] = [other for other in _made if _is_there(other)]
    _made.append(one)


def _is_there(one):
    """Whether it is as it was made, and all that it is about is in the file."""
    try:
        return one.is_there()
    except ReferenceError:
        return False
