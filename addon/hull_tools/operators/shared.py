# SPDX-License-Identifier: GPL-3.0-or-later
"""What the operators have in common: what they work on, and how they say no."""

import functools

from ..bridge import hull_objects, native


def reporting_errors(execute):
    """Makes an `execute` that reports what a user can get wrong, and then is cancelled."""

    @functools.wraps(execute)
    def reporting_execute(self, context):
        try:
            return execute(self, context)
        except (ValueError, OSError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}

    return reporting_execute


def native_is_there(cls):
    if native.hull_native is None:
        cls.poll_message_set(native.missing_reason)
        return False
    return True


def has_hull(cls, context):
    """Whether the active object is a hull, or shows one, that can be worked on."""
    hull = hull_objects.hull_of(context.object)
    if hull is None:
        cls.poll_message_set("Select a hull first, or make this mesh one")
        return False
    reason = hull_objects.refusal(hull)
    if reason:
        cls.poll_message_set(reason)
        return False
    return True


def in_mesh_edit_mode(cls, context):
    if context.mode != "EDIT_MESH":
        cls.poll_message_set("Enter edit mode first (Tab)")
        return False
    return True


def in_object_mode(cls, context):
    if context.mode != "OBJECT":
        cls.poll_message_set("Leave edit mode first (Tab)")
        return False
    return True
