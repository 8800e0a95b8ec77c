# SPDX-License-Identifier: GPL-3.0-or-later
"""What hulls are made of: mesh objects and files, as hull_io has geometry."""

from dataclasses import dataclass, replace

from ....hull_io import geometry
from ...bridge.blender import letters, units
from ...bridge.objects import hull_objects
from ..fitting import fit_targets

_FORMAT = "Blender"


@dataclass(frozen=True, eq=False)
class Source:
    """read: called with a function that is told the share done, returns a Geometry of hull_io; for
    any thread. name: of the hull that is made of it, None: as the geometry's. address: of the mesh
    object that it is, 0 of a file: it stays when the object is renamed."""

    read: object
    name: object = None
    address: int = 0

    def object_in(self, scene):
        """The mesh object that it is, None of a file, and where that is not in the scene."""
        return next((obj for obj in scene.objects if obj.as_pointer() == self.address), None)


def of_object(obj, scene):
    """The Source that a mesh object is, as the view shows it, where it stands. ValueError where it
    has no faces, has points without a place, or is a hull itself."""
    if obj is None or obj.type != "MESH":
        raise ValueError("Select a mesh object first")
    hull = hull_objects.hull_of(obj)
    if hull is not None:
        raise ValueError(f'"{hull.name}" is a hull already: select another mesh')
    points, triangles, _ = fit_targets.shape_arrays(obj, None, units.metres_per_unit(scene))
    if not len(triangles):
        raise ValueError(f'"{obj.name}" has no faces: select a mesh that has the hull\'s surface')
    mesh = geometry.GeometryMesh(points, triangles)
    found = geometry.Geometry(obj.name, _FORMAT, "m", meshes=(mesh,))
    return Source(lambda progress: found, f"{obj.name} hull", obj.as_pointer())


def of_file(path):
    """The Source that a file is."""

    def read(progress):
        found = geometry.read_geometry(path, progress=progress)
        return replace(found, name=letters.taken(found.name))

    return Source(read)


def understood(source, known):
    """Sentences on how a mesh object's Source is taken: its dimensions, and what is to be looked
    at. known: what hull_io.geometry.guess_hull takes. ValueError where it is no hull."""
    guess = geometry.guess_hull(source.read(None), **known)
    sides = "one side" if guess.is_half else "both sides"
    return [
        f"{guess.length:.4g} m long, {guess.beam:.4g} m broad, {guess.depth:.4g} m deep",
        f"Lpp {guess.length_pp:.4g} m, forward {guess.forward}, up {guess.up}, {sides}",
        *(sentence(guess.reasons, doubt) for doubt in guess.doubts),
    ]


def sentence(reasons, about):
    """What a Guess of hull_io tells about something, with its name."""
    return f"{about[0].upper()}{about[1:]}: {reasons[about]}"
