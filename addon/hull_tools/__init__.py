# SPDX-License-Identifier: GPL-3.0-or-later
"""The add-on's Blender classes, registered in the order in which they need one another."""

from . import late_loading

# Of the overlays what makes arrays: nothing is drawn before there is a hull.
_ARRAYS = ("field", "legend", "line", "mark", "network", "plot", "tag")

late_loading.install(
    f"{__name__}.bridge",
    f"{__name__}.features",
    f"{__package__.rpartition('.')[0]}.hull_io",
    f"{__package__.rpartition('.')[0]}.hull_fairness",
    f"{__package__.rpartition('.')[0]}.hull_fitting",
    *(f"{__name__}.overlays.{name}_arrays" for name in _ARRAYS),
    f"{__name__}.overlays.buffers",
    f"{__name__}.overlays.label_places",
    f"{__name__}.overlays.plot_cards",
    f"{__name__}.overlays.shapes",
    f"{__name__}.overlays.tag_drawing",
)

from . import handlers, operators, overlays, panels, properties  # noqa: E402

_PARTS = (properties, operators, panels, overlays, handlers)


def register():
    for part in _PARTS:
        part.register()


def unregister():
    for part in reversed(_PARTS):
        part.unregister()
