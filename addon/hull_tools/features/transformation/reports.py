# SPDX-License-Identifier: GPL-3.0-or-later
"""What came of a transformation, in words."""

from ...bridge.blender import units


def shifted(found, scene):
    """A section_shifts.Shifted as a sentence."""
    after, result = found.after, found.result
    both = dict.fromkeys(("whole", "fair"), ("A", "B"))
    names = {**both, "apart": ("A fore", "A aft")}.get(found.part, ("A",))
    shifts = ", ".join(f"{n} {c:.4f}" for n, c in zip(names, result.coefficients))
    halves = ""
    if found.prismatics is not None:
        halves = f"Cp fore {found.prismatics.fore:.4f}, aft {found.prismatics.aft:.4f}; "
    return f"{halves}{form_parameters(after, scene)}: {shifts}; {residual(result)}"


def changed(found, scene):
    """A least_change.Changed as a sentence."""
    rms = units.format_mm(found.rms)
    return f"{form_parameters(found.after, scene)}; the surface shifts by {rms} RMS"


def form_parameters(found, scene):
    """A form_parameters.FormParameters in words."""
    return (
        f"Cb {found.block:.4f}, Cp {found.prismatic:.4f}, "
        f"∇ {units.format_value(scene, found.volume, 'm3')}, "
        f"LCB {units.format_value(scene, found.lcb, 'm')} ({found.lcb_percent:+.2f} %)"
    )


def lengthened(found, scene):
    """A hull_native.Lengthened as a sentence."""
    text = f"∇ changed by {units.format_value(scene, found.volume_change, 'm3')}"
    if not found.is_parallel:
        return f"{text}; {residual(found)}"
    return f"{text}: the section of {units.format_value(scene, found.area, 'm2')} times the length"


def inflated(found, scene):
    """A hull_native.Inflated as a sentence."""
    return (
        f"Area {units.format_value(scene, found.area, 'm2')}: "
        f"{'inflated' if found.amount >= 0.0 else 'deflated'} by "
        f"{units.format_mm(abs(found.amount))}; {residual(found)}"
    )


def residual(result):
    """How far the surface is from the wanted shifts."""
    return (
        f"off the shift wanted by {units.format_mm(result.rms)} on average, "
        f"{units.format_mm(result.largest)} at most"
    )
