# SPDX-License-Identifier: GPL-3.0-or-later
"""Networks of curves: collections of curve objects that are joined, checked, and given a surface.

Where things are:
  curve_shapes   what the native module has of a curve, as Bézier handles and curvature
  definitions    curve objects as hull_native.NetworkCurves
  planes         the planes in which curves stay
  ties           what moves along when points move
  network_state  what is known of each network; follows its curves
  joining        curves joined to a hull_native.CurveNetwork, and their shapes
  following      which networks follow what Blender tells of
  live_surface   the object that shows the surface
  problems       what is wrong, and the way there
  surface_tasks  how good the surface is, what it is afloat; STEP and IGES files of it
  choosing_points, crossings, making, adding, drawing, sections, smoothing, from_hull: tools
  to_hull        a hull laid over a network
What makes something else of a network is one more file: it takes network_state.up_to_date(network),
which has the hull_native.CurveNetwork.
"""
