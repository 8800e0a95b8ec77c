# SPDX-License-Identifier: GPL-3.0-or-later
"""What is selected in edit mode, by Blender's indices.

Elements of a kind are as mesh_check lists them: "vertex" and "face" by index, "edge" by the pair of
its vertices. Hidden ones stay hidden and unselected, unless they are asked to be shown.
"""

import bmesh

# Of each kind: Blender's select mode, as the tool settings and as a BMesh have it.
_MODES = {
    "vertex": ((True, False, False), "VERT"),
    "edge": ((False, True, False), "EDGE"),
    "face": ((False, False, True), "FACE"),
}


def select(context, obj, kind, elements, *, extend=False, reveal=False):
    """Selects these elements, and only points, edges or faces; returns how many.

    Without `extend` exactly these of all meshes that are edited; with it, those of the kind that
    are selected stay so. `reveal` shows hidden ones.
    """
    if not extend:
        for edited in {obj, *context.objects_in_mode_unique_data}:
            deselect_all(edited)
    tool_mode, mode = _MODES[kind]
    context.tool_settings.mesh_select_mode = tool_mode
    bm = bmesh.from_edit_mesh(obj.data)
    bm.select_mode = {mode}
    bm.select_flush_mode()
    count = 0
    for element in found(bm, kind, elements):
        if reveal:
            element.hide_set(False)
        if not element.hide:
            element.select_set(True)
            count += 1
    bm.select_flush_mode()
    bmesh.update_edit_mesh(obj.data, loop_triangles=False, destructive=False)
    return count


def deselect_all(obj):
    bm = bmesh.from_edit_mesh(obj.data)
    for sequence in (bm.faces, bm.edges, bm.verts):
        for element in sequence:
            element.select_set(False)
    bmesh.update_edit_mesh(obj.data, loop_triangles=False, destructive=False)


def selected(obj, kind):
    """The elements of a kind that are selected."""
    bm = bmesh.from_edit_mesh(obj.data)
    bm.verts.index_update()
    if kind == "vertex":
        return [vertex.index for vertex in bm.verts if vertex.select]
    if kind == "face":
        bm.faces.index_update()
        return [face.index for face in bm.faces if face.select]
    return [tuple(vertex.index for vertex in edge.verts) for edge in bm.edges if edge.select]


def found(bm, kind, elements):
    """The elements of a BMesh; those that it has not are left out."""
    sequence = bm.faces if kind == "face" else bm.verts
    sequence.ensure_lookup_table()
    count = len(sequence)
    if kind != "edge":
        return [sequence[index] for index in map(int, elements) if index < count]
    pairs = [[int(index) for index in pair] for pair in elements]
    edges = (bm.edges.get([sequence[i] for i in pair]) for pair in pairs if max(pair) < count)
    return [edge for edge in edges if edge is not None]


def vertices_of(obj, groups):
    """The vertices, rising, of elements given as pairs (kind, elements); those of the kind "mesh"
    have none."""
    bm = bmesh.from_edit_mesh(obj.data)
    vertices = set()
    for kind, elements in groups:
        if kind == "vertex":
            vertices.update(map(int, elements))
        elif kind != "mesh":
            for element in found(bm, kind, elements):
                vertices.update(vertex.index for vertex in element.verts)
    return sorted(vertices)
