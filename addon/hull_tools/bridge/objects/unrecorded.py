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
        self._obj.data = self._before

    def put_again(self):
        if self._given.name and self._obj.data == self._before:
            self._obj.data = self._given


class _Surface:
    """A surface object that a hull was given in place of one that is not its own."""

    def __init__(self, hull, before):
        self._hull, self._before, self._given = hull, before, hull.hull.surface_object

    def is_there(self):
        return self._hull.hull.surface_object == self._given and bool(self._before.name)

    def put_back(self):
        self._hull.hull.surface_object = self._before
        self._is_hidden = self._given.name in _view_objects() and self._given.hide_get()
        for collection in self._given.users_collection:
            collection.objects.unlink(self._given)

    def put_again(self):
        if self._given.name and self._hull.hull.surface_object == self._before:
            self._hull.hull.surface_object = self._given
            for collection in self._hull.users_collection:
                if self._given.name not in collection.objects:
                    collection.objects.link(self._given)
            if self._is_hidden:
                _to_hide.append(self._given)


_made = []  # the last one last
_put_back = []
_to_hide = []


def give_mesh(obj, mesh):
    """obj.data = mesh, within a handler."""
    _remember(_Mesh(obj, mesh))
    obj.data = mesh


def has_new_surface(hull, before):
    """Within a handler a hull was given a surface object; before: what it pointed to."""
    _remember(_Surface(hull, before))


def before_undo():
    """Before an undo or redo."""
    for one in reversed(_made):
        if _in_file(one.is_there):
            one.put_back()
            _put_back.append(one)
    _made.clear()


def after_undo():
    """First of all that is done after an undo or redo."""
    for one in reversed(_put_back):
        _in_file(one.put_again)
    _put_back.clear()


def after_update():
    """What was hidden is hidden again: after an undo a view layer has nothing of what it got."""
    for obj in _to_hide:
        _in_file(lambda obj=obj: obj.name in _view_objects() and obj.hide_set(True))
    _to_hide.clear()


def forget():
    """Before another file is read."""
    _made.clear()
    _put_back.clear()
    _to_hide.clear()


def _view_objects():
    return bpy.context.view_layer.objects


def _remember(one):
    _made[:] = [other for other in _made if _in_file(other.is_there)]
    _made.append(one)


def _in_file(do):
    """What do() returns; False where something it is about is not in the file any longer."""
    try:
        return do()
    except ReferenceError:
        return False
