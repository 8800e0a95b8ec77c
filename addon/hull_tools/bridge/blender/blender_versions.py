# SPDX-License-Identifier: GPL-3.0-or-later
"""What differs between the Blenders this add-on runs in: 3.4, 4.x and later.

Creases: up to 3.6 an edge has a property and vertices a layer of their own; from 4.0 on both are
attributes, `crease_edge` and `crease_vert`. Split normals: up to 4.0 a mesh must ask for them.
Ready-made shaders lost the "3D_" of their names in 4.0.
"""

import bmesh
import bpy
import gpu
import numpy as np

_CREASES_ARE_ATTRIBUTES = bpy.app.version >= (4, 0, 0)
_LOOP_TOTAL_IS_WRITABLE = bpy.app.version < (3, 6, 0)
_SHADERS_ARE_UNPREFIXED = bpy.app.version >= (4, 0, 0)
_SPLIT_NORMALS_NEED_AUTO_SMOOTH = bpy.app.version < (4, 1, 0)


def edge_creases(mesh):
    """Crease values of all edges, (edges,) float32; `mesh` is not in edit mode."""
    values = np.zeros(len(mesh.edges), dtype=np.float32)
    if not _CREASES_ARE_ATTRIBUTES:
        mesh.edges.foreach_get("crease", values)
    elif "crease_edge" in mesh.attributes:
        mesh.attributes["crease_edge"].data.foreach_get("value", values)
    return values


def vertex_creases(mesh):
    """Crease values of all vertices, (vertices,) float32; `mesh` is not in edit mode."""
    values = np.zeros(len(mesh.vertices), dtype=np.float32)
    if not _CREASES_ARE_ATTRIBUTES:
        if mesh.vertex_creases:
            mesh.vertex_creases[0].data.foreach_get("value", values)
    elif "crease_vert" in mesh.attributes:
        mesh.attributes["crease_vert"].data.foreach_get("value", values)
    return values


def find_crease_layers(bm):
    """(edge layer, vertex layer) of a BMesh; None for a layer that the mesh has not."""
    if _CREASES_ARE_ATTRIBUTES:
        return bm.edges.layers.float.get("crease_edge"), bm.verts.layers.float.get("crease_vert")
    return bm.edges.layers.crease.active, bm.verts.layers.crease.active


def ensure_crease_layers(bm):
    """(edge layer, vertex layer) of a BMesh, made where missing.

    Adding a layer invalidates every BMVert and BMEdge held by the caller.
    """
    if _CREASES_ARE_ATTRIBUTES:
        edges, vertices = bm.edges.layers.float, bm.verts.layers.float
        return (
            edges.get("crease_edge") or edges.new("crease_edge"),
            vertices.get("crease_vert") or vertices.new("crease_vert"),
        )
    return bm.edges.layers.crease.verify(), bm.verts.layers.crease.verify()


def set_creases(mesh, crease_edges, corner_vertices):
    """Gives value 1 to these edges and vertices (indices) of a mesh that has no creases yet."""
    bm = bmesh.new()
    try:
        bm.from_mesh(mesh)
        edge_layer, vertex_layer = ensure_crease_layers(bm)
        bm.edges.ensure_lookup_table()
        bm.verts.ensure_lookup_table()
        for index in crease_edges:
            bm.edges[index][edge_layer] = 1.0
        for index in corner_vertices:
            bm.verts[index][vertex_layer] = 1.0
        bm.to_mesh(mesh)
    finally:
        bm.free()


def set_face_ranges(mesh, sizes):
    """Says which loops belong to which face: `sizes` (faces,) corners each, in the loops' order."""
    starts = np.zeros(len(sizes), dtype=np.int32)
    np.cumsum(sizes[:-1], out=starts[1:])
    mesh.polygons.foreach_set("loop_start", starts)
    if _LOOP_TOTAL_IS_WRITABLE:
        mesh.polygons.foreach_set("loop_total", np.ascontiguousarray(sizes, dtype=np.int32))


def set_corner_normals(mesh, normals):
    """Shades with these unit normals, (loops, 3); a zero normal leaves Blender's own."""
    if _SPLIT_NORMALS_NEED_AUTO_SMOOTH:
        mesh.use_auto_smooth = True
    mesh.normals_split_custom_set(normals.tolist())


def corner_normals(mesh):
    """The normals, (loops, 3) float32, that a mesh is shaded with."""
    normals = np.empty((len(mesh.loops), 3), dtype=np.float32)
    if _SPLIT_NORMALS_NEED_AUTO_SMOOTH:
        mesh.calc_normals_split()
        mesh.loops.foreach_get("normal", normals.reshape(-1))
        mesh.free_normals_split()
    else:
        mesh.corner_normals.foreach_get("vector", normals.reshape(-1))
    return normals


def rest_corner_normals(mesh):
    """Spares Blender the work of corner normals until they are set again, where it can be."""
    if _SPLIT_NORMALS_NEED_AUTO_SMOOTH and mesh.use_auto_smooth:
        mesh.use_auto_smooth = False


def shader_input(node, *names):
    """The first of these input sockets that a shader node has (they were renamed in 4.0)."""
    return next(node.inputs[name] for name in names if name in node.inputs)


def builtin_shader(name):
    """One of the graphics card's ready-made shaders, by its present name ("SMOOTH_COLOR")."""
    return gpu.shader.from_builtin(name if _SHADERS_ARE_UNPREFIXED else f"3D_{name}")


def make_see_through(material):
    """Has EEVEE draw a material with transparent parts, which cast no shadow."""
    if hasattr(material, "surface_render_method"):
        material.surface_render_method = "BLENDED"
    else:
        material.blend_method = "BLEND"
        material.shadow_method = "NONE"


def eevee():
    """The name of the renderer EEVEE in this Blender."""
    return "BLENDER_EEVEE_NEXT" if (4, 2, 0) <= bpy.app.version < (5, 0, 0) else "BLENDER_EEVEE"
