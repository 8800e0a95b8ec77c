# SPDX-License-Identifier: GPL-3.0-or-later
"""What has moved of a surface since its last change, so that what did not can stay."""

from dataclasses import dataclass, replace

import numpy as np

from .. import native

# Beyond the tolerance to which sections are cut, as a part of it: rounding.
_MARGIN = 2.0


@dataclass(frozen=True, eq=False)
class Moves:
    """before, after: keys of the surface, equal where surfaces are. watch: a hull_native.MoveWatch
    of what has moved between the two. cutter: a hull_native.KeptSections of the surface; judge: a
    hull_native.KeptFairness of it."""

    before: tuple
    after: tuple
    watch: object = None
    cutter: object = None
    judge: object = None

    @staticmethod
    def of(surface, key):
        """Of a new hull_native.LimitSurface with this key."""
        hull_native = native.require()
        kinds = hull_native.MoveWatch, hull_native.KeptSections, hull_native.KeptFairness
        return Moves(None, key, *(kind(surface) for kind in kinds))

    def kept(self, key, planes, tolerance):
        """(n,) which sections of a surface with this key, by planes (n, 4), are those of the
        surface as it is; tolerance: m, what lies in a plane when so near."""
        if key == self.after:
            return np.ones(len(planes), dtype=bool)
        if key is None or key != self.before or not len(planes):
            return np.zeros(len(planes), dtype=bool)
        return ~self.watch.comes_near(np.asarray(planes), margin=_MARGIN * tolerance)

    def further(self, before, after):
        """Of a surface whose points were just set."""
        self.watch.update()
        return replace(self, before=before, after=after)

    def sections(self, surface, planes, chord_tolerance, flat_tolerance):
        """hull_native.sections of the surface by planes (n, 4); of those of before only what has
        moved is cut anew."""
        if self.cutter is None:
            return native.require().sections(
                surface, planes, chord_tolerance, flat_tolerance=flat_tolerance
            )
        return self.cutter.sections(planes, chord_tolerance, flat_tolerance=flat_tolerance)

    def fairness(self, planes, sections, **options):
        """hull_native.section_fairness of what sections() gave for planes (n, 4); of what it was
        asked before only what has moved is judged anew."""
        return self.judge.section_fairness(planes, sections, **options)
