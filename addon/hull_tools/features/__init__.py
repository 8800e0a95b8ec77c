# SPDX-License-Identifier: GPL-3.0-or-later
"""What the add-on can do with a hull, one folder a subject: what it computes, keeps, and follows.

Everything here can be called from a script as well as from an operator. What a user can get wrong
raises ValueError with a message to show. Classes of Blender's (settings, operators, panels …) are
elsewhere, and Blender's data are read and written by the bridge.

Each subject uses itself, those above it and the bridge, nothing else:
  constraints     what holds while points are moved: flats, the centre plane, points held
  flotation       how the hull lies in the water, and its hydrostatics
  surface         the surface as an object to look at: its mesh, exact normals, colours, materials
  lines           sections and other lines, places of the lines plan, the table of offsets
  fairness        what fairness is judged by: combs of lines and rows, reflection and level lines
  hull            a hull as a whole: made, brought up to date, its tags, saved
  curves_of_form  tables and curves of upright hulls: drafts, sectional areas, Bonjean curves
  stability       righting levers, cross curves, load cases, criteria
  variants        hulls that were kept, and the hull beside another one: ghost, differences
  resistance      resistance and power over speeds, also of the hull beside; the waves behind
  analyses        all tables and plots of those above, computed when they are looked at
  conversion      the surface as B-spline patches, and how far they are from it
  exchange        hull files; files for other programs: lines plan, tables, STEP, IGES, DXF
  production      plates and frames to cut, models, parts and panels to compute with
  fitting         control points moved so that the surface meets a given shape
  geometry        hulls that exist as meshes or files, made control meshes
  fairing         chosen control points moved so that surface or rows are fair, within a deviation
  modelling       tools on points and faces: pulling, bilges, flats, halves, irregular points
  dimensions      hulls scaled to main dimensions, with all that belongs to them
  transformation  the whole form changed to given particulars: shifts of sections, lengthening
  fields          shape fields kept with the hull: regions shift, others are protected
  networks        networks of curves, and the surface between them
  targets         control points moved so that numbers of the form are as wanted
  area_curves     sectional area curves that are wanted, and hulls brought to them
  morphing        hulls between parents: members of a family, moved by weights
  studio          a studio around the hull, for pictures of it

A new subject gets a folder of its own, below what it uses; the studio stays last.
"""
