# SPDX-License-Identifier: GPL-3.0-or-later
"""The add-on's Blender classes, registered in the order in which they need one another."""

from . import late_loading

late_loading.install(
    f"{__name__}.bridge", f"{__name__}.features", f"{__package__.rpartition('.')[0]}.hull_io"
)

from . import handlers, operators, overlays, panels, properties  # noqa: E402

_PARTS = (properties, operators, panels, overlays, handlers)


def register():
    for part in _PARTS:
        part.register()


def unregister():
    for part in reversed(_PARTS):
        part.unregister()
