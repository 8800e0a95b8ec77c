# SPDX-License-Identifier: GPL-3.0-or-later
"""A hull as a whole: made, brought up to date, its tags, saved."""
