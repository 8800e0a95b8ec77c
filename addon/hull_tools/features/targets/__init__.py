# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull changed so that numbers of its form are as wanted."""
