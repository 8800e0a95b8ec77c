# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables and curves of upright hulls: drafts, sectional areas, Bonjean curves."""
