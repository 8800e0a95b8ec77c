# SPDX-License-Identifier: GPL-3.0-or-later
"""One hull beside another: differences of hydrostatics and sectional areas, and of surfaces."""
