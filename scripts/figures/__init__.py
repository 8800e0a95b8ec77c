# SPDX-License-Identifier: GPL-3.0-or-later
"""The five pictures of each vessel, for the scripts draw_vessels.py and picture_vessels.py."""
