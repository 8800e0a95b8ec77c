# SPDX-License-Identifier: GPL-3.0-or-later
"""Between Blender's data and the native module's arrays: the only code that knows both.

Everything here can be called from a script as well as from an operator. What a user can get wrong
raises ValueError with a message to show.

By subject; each uses itself and those above it, nothing else:
  native          the native module, which nothing else imports
  blender         Blender itself: its versions, units of the scene, what the user prefers
  background      work in threads, beside Blender's own
  mesh            Blender's meshes as arrays and back: points, creases, marks of edges, selection
  objects         Blender's objects: which is the hull, which shows its surface, what became of both
  constraints     what holds while points are moved: flats, the centre plane, locked points
  flotation       how the hull lies in the water, and its hydrostatics
  display         the surface as an object to look at: its mesh, exact normals, colours, materials
  lines           sections and other lines, their combs, reflection lines, places of the lines plan
  hull            a hull as a whole: made, brought up to date, its tags, saved
  analyses        tables and plots that are computed when they are looked at
  conversion      the surface as B-spline patches, and how far they are from it
  exchange        files for other programs: hull file, lines plan, tables, STEP, IGES, DXF
  fitting         control points moved so that the surface meets a given shape
  modelling       tools on points and faces: pulling, bilges, flats, halves, irregular points
  studio          a studio around the hull, for pictures of it
"""
