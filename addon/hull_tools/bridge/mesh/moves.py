# SPDX-License-Identifier: GPL-3.0-or-later
"""What has moved of a surface since its last change, so that what did not can stay."""

from dataclasses import dataclass

import numpy as np

# Beyond the tolerance to which sections are cut, as a part of it: rounding.
_MARGIN = 2.0


@dataclass(frozen=True, eq=False)
class Moves:
    """before, after: keys of the surface, equal where surfaces are. watch: a hull_native.MoveWatch
    of what has moved between the two."""

    before: tuple
    after: tuple
    watch: object

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
        return Moves(before, after, self.watch)
