# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes that handlers gave to objects, of which Blender's undo may know nothing.

Undo leaves an object as it is in memory where the two steps have the same record of it. A mesh that
a handler gave it after the step was recorded is in none of them: it goes with the undo, the object
points to what is no more, and Blender crashes. So objects get back what they had before, which the
records have, and the handlers that come after the undo do their work anew.
"""

_given = []  # (object, its mesh before, the mesh that it was given), the last one last


def give(obj, mesh):
    """obj.data = mesh, within a handler."""
    _given[:] = [entry for entry in _given if _has_still(entry)]
    _given.append((obj, obj.data, mesh))
    obj.data = mesh


def put_back():
    """Before an undo or redo."""
    for entry in reversed(_given):
        if _has_still(entry):
            obj, before, _ = entry
            obj.data = before
    _given.clear()


def forget():
    """Before another file is read."""
    _given.clear()


def _has_still(entry):
    """Whether the object has the mesh that it was given, and all three are in the file."""
    obj, before, given = entry
    try:
        return bool(before.name) and obj.data == given
    except ReferenceError:
        return False
