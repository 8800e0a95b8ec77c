# SPDX-License-Identifier: GPL-3.0-or-later
"""What the fairness of a hull is judged by, which follows its edits."""

from dataclasses import dataclass, field

from . import combs, level_lines, row_combs


@dataclass
class LiveFairness:
    """combs: combs.CombGroup by kind, and a row_combs.RowGroup; level_lines: level_lines.LevelGroup
    by kind; status: why they are not up to date, or ""."""

    combs: dict = field(default_factory=dict)
    level_lines: dict = field(default_factory=dict)
    status: str = ""

    def follow(self, obj, ship, line_groups, scale):
        """Brings all up to date with a hull, its flotation.live_ship.LiveShip, and the groups
        of its lines.live_lines.LiveLines, of which those of now are not cut again."""
        settings, surface, moved = obj.hull, ship.surface, ship.moved
        rows = self.combs.get(row_combs.KIND)
        try:
            shown = [group for group in line_groups.values() if group.key[0] == moved.after]
            self.combs = combs.combs(self.combs, surface, settings, moved, scale, shown)
            rows = row_combs.follow(rows, obj, ship, settings)
            if rows is not None:
                self.combs[row_combs.KIND] = rows
            self.level_lines = level_lines.level_lines(
                self.level_lines, surface, settings, moved.after
            )
            self.status = ""
        except ValueError as error:
            self.status = str(error)
