# SPDX-License-Identifier: GPL-3.0-or-later
"""The native module, found once. Nothing else imports it.

A packaged add-on carries it as its own subpackage; in a checkout it comes from the Python path.
Without it the add-on still registers, and `missing_reason` says what the user can do.
"""

hull_native = None
missing_reason = ""

try:
    from ... import hull_native
except ImportError as packaged_error:
    try:
        import hull_native
    except ModuleNotFoundError:
        missing_reason = f"The native part of Hull Tools cannot be loaded: {packaged_error}"
    except ImportError as path_error:
        missing_reason = f"The native part of Hull Tools cannot be loaded: {path_error}"


def require():
    """The native module; ValueError with the reason when it is not there."""
    if hull_native is None:
        raise ValueError(missing_reason)
    return hull_native
