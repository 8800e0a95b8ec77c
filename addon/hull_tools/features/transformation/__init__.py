# SPDX-License-Identifier: GPL-3.0-or-later
"""The whole form changed to given particulars: sections shifted to a displacement and a centre of
buoyancy, hulls lengthened, sections inflated, sectional area curves met."""
