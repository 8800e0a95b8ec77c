# SPDX-License-Identifier: GPL-3.0-or-later
"""What exports with numbers in their dialogs have in common."""

from .export_hull import ExportByTask, ExportDrawing


class ExportWithNumbers(ExportDrawing, ExportByTask):
    """Exports whose dialogs have numbers below the choice of `format`: NAMES, or those of them that
    numbers() says."""

    def numbers(self):
        return self.NAMES

    def draw(self, context):
        super().draw(context)
        column = self.layout.column()
        column.use_property_split = True
        for name in self.numbers():
            column.prop(self, name)
