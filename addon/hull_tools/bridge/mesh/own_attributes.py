# SPDX-License-Identifier: GPL-3.0-or-later
"""Attributes of Blender's meshes that the add-on keeps things in, outside of edit mode."""


def found(mesh, name, kind, domain):
    """The mesh's attribute of a data type and domain as Blender names them; None too for one of
    another kind with this name."""
    attribute = mesh.attributes.get(name)
    if attribute is None or (attribute.data_type, attribute.domain) != (kind, domain):
        return None
    return attribute


def made(mesh, name, kind, domain):
    """The same, made where there is none; one of another kind is removed. ValueError where
    something else has its name: Blender's own operators turn attributes into vertex groups."""
    attribute = found(mesh, name, kind, domain)
    if attribute is not None:
        return attribute
    of_another_kind = mesh.attributes.get(name)
    if of_another_kind is not None:
        mesh.attributes.remove(of_another_kind)
    attribute = mesh.attributes.new(name, kind, domain)
    if attribute is None:
        raise ValueError(
            f'Something else of the mesh is named "{name}", where Hull Tools keeps its own: rename '
            "or remove the vertex group of that name"
        )
    return attribute
