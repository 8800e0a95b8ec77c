# SPDX-License-Identifier: GPL-3.0-or-later
"""How fair a hull's lines look, measured on the exact surface: NumPy and hull_native.

  lights          the lights that a hull mirrors in its reflection pictures, and the eyes on it
  inflections     inflections and flat spots of a plane curve that an eye sees
  reflections     the lines of light on the surface, and how they turn
  kinks           kinks and waves of lines of light that an eye sees
  native          the native module
  lines           all lines of a hull judged: what is found on them, and what its design calls for
  changes         marks of a changed hull: which are new
  levers          how marks' depths change with control points
  fair_ways       ways in which new marks are made less deep
  fair_changes    new marks taken out, while numbers of the form stay
  kept_numbers    numbers of the form that stay
  fewest_marks    of several ways to what is wanted the one with the fewest new marks
"""
