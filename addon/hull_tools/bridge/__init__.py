# SPDX-License-Identifier: GPL-3.0-or-later
"""Between Blender's data and the native module's arrays: what knows both, and nothing of a feature.

What a user can get wrong raises ValueError with a message to show.

By subject; each uses itself and those above it, nothing else:
  limits          what settings may ask for at most
  counts          numbers of things in sentences
  native          the native module, which nothing else imports
  blender         Blender itself: its versions, units of the scene, what the user prefers
  background      work in threads and at pauses, beside Blender's own
  mesh            Blender's meshes as arrays and back: points, creases, marks of edges, selection
  objects         Blender's objects: which is the hull, which shows its surface, what became of both
"""
