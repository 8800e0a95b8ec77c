# SPDX-License-Identifier: GPL-3.0-or-later
"""Work in threads, beside Blender's own."""
