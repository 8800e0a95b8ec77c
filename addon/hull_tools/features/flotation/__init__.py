# SPDX-License-Identifier: GPL-3.0-or-later
"""How the hull lies in the water, and its hydrostatics."""
