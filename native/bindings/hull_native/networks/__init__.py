# SPDX-License-Identifier: GPL-3.0-or-later
"""Networks of curves: taken of a hull, judged, and laid out as a control mesh. `network_hull` goes
that way: outline, girth lines, grid of rows and columns, mesh, fit, more rows and columns."""
