# SPDX-License-Identifier: GPL-3.0-or-later
"""What came of bringing a hull to an area curve, in words."""

from ...bridge.blender import units


def percent(difference):
    """A target_curve.Difference as text."""
    return f"{100.0 * difference.largest:+.2f} %"


def summary(report, scene):
    """A matching.Report as a sentence."""
    volume = units.format_value(scene, report.volume, "m3")
    change = 100.0 * report.volume_change / (report.volume - report.volume_change)
    lcb = units.format_value(scene, report.lcb, "m")
    at = units.format_value(scene, report.after.at, "m")
    text = (
        f"Areas are off by {percent(report.after)} of the largest one at most, at x = {at}; before "
        f"by {percent(report.before)}. ∇ {volume} ({change:+.2f} %), LCB {lcb}"
    )
    if report.rms is not None:
        text += f"; the surface shifts by {units.format_mm(report.rms)} RMS"
    return text + _WHY[report.status]


_WHY = {
    "met": "",
    "unreachable": ". The control points come no nearer: unlock some, or let outlines move",
    "unsettled": ". The control points come no nearer so",
}
