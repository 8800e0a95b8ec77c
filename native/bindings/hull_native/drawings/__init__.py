# SPDX-License-Identifier: GPL-3.0-or-later
"""What is drawn of a hull: the lines plan, the figures that present it, views without hidden lines,
and the diagrams of hydrostatics, stability and curvature."""
