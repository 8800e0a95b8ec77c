# SPDX-License-Identifier: GPL-3.0-or-later
"""Files for other programs: hull files, lines plan, tables, CAD."""
