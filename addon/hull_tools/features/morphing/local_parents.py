# SPDX-License-Identifier: GPL-3.0-or-later
"""Parents that count alone around the base of a shape field of the hull, and less and less in what
is around it: the bow of one, the stern of another. Fields are in the space of the first parent."""

import hashlib
from dataclasses import dataclass

from ...bridge import limits, native
from ..fields import bases, preview

_NO_FIELD = (
    'There is no field "{}" any longer (panel Fields): choose another one, or remove the row'
)
_NO_PARENT = 'There is no parent "{}": choose one of the list'


@dataclass(eq=False)
class _Ground:
    """The first parent as fields.bases finds it."""

    scale: float
    control: object
    surface: object
    is_half: bool

    def net(self):
        return native.require().GeodesicNet(self.surface, mirrored=self.is_half)


def of_hull(obj, family, scale):
    """[(hull_native.ShapeField, weights of the parents)] as hull_native.HullFamily.points takes
    them; family: the parents.Family without factors. ValueError for a row without meaning."""
    morph = obj.hull.morph
    if not len(morph.local):
        return []
    ground = _Ground(scale, family.control, family.surface, obj.hull.half)
    return [_local(row, obj, ground) for row in morph.local]


def _local(row, obj, ground):
    field = _field_of(row, obj)
    made = bases.shape_field(field, obj, ground)
    if field.role == "PROTECT":
        return made, None
    names = [entry.name for entry in obj.hull.morph.parents]
    if row.parent not in names:
        raise ValueError(_NO_PARENT.format(row.parent))
    number = names.index(row.parent)
    return made, [float(k == number) for k in range(len(names))]


def _field_of(row, obj):
    field = obj.hull.fields.fields.get(row.field)
    if field is None:
        raise ValueError(_NO_FIELD.format(row.field))
    return field


def key(obj):
    """Of all that decides on the local weights, as text; "" where there are none."""
    morph, told = obj.hull.morph, []
    if not len(morph.local):
        return ""
    for row in morph.local:
        field = obj.hull.fields.fields.get(row.field)
        values = None if field is None else preview.values_of(field, obj)
        told.append((row.field, row.parent, values))
    return hashlib.blake2b(repr(told).encode(), digest_size=16).hexdigest()


def add(obj):
    """A row more: the chosen field of the hull, and the parent that is chosen. ValueError without a
    field."""
    morph, fields = obj.hull.morph, obj.hull.fields
    limits.at_most(len(morph.local) + 1, "local parents", limits.MOST_FIELDS)
    if not 0 <= fields.active_field < len(fields.fields):
        raise ValueError("Add a field to this hull first (panel Fields)")
    row = morph.local.add()
    row.field = fields.fields[fields.active_field].name
    chosen = min(max(morph.active_parent, 0), len(morph.parents) - 1)
    row.parent = morph.parents[chosen].name
    morph.active_local = len(morph.local) - 1
    obj.update_tag(refresh={"DATA"})
    return row


def remove(obj):
    """Removes the row that is chosen."""
    morph = obj.hull.morph
    if not 0 <= morph.active_local < len(morph.local):
        raise ValueError("Choose a local parent first")
    morph.local.remove(morph.active_local)
    morph.active_local = max(min(morph.active_local, len(morph.local) - 1), 0)
    obj.update_tag(refresh={"DATA"})
