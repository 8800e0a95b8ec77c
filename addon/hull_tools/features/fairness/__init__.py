# SPDX-License-Identifier: GPL-3.0-or-later
"""What fairness is judged by: curvature combs, reflection lines and other level lines."""
