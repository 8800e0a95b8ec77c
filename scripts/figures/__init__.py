# SPDX-License-Identifier: GPL-3.0-or-later
"""What the scripts that make the docs' figures have in common."""
