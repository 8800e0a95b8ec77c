# SPDX-License-Identifier: GPL-3.0-or-later
"""Shape fields kept with a hull: regions that shift, others that are protected."""
