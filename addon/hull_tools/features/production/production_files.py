# SPDX-License-Identifier: GPL-3.0-or-later
"""Models of a hull, panels of its wetted part and its surface in named parts, written beside
Blender's own work: tasks, as those of file_tasks are."""

import numpy as np

from ....hull_io import (
    gdf_title,
    write_3mf,
    write_cli,
    write_gdf,
    write_nemoh,
    write_obj,
    write_segments,
    write_stl,
    write_stl_parts,
)
from ....hull_io.part_files import part_name
from ...bridge import native
from ...bridge.background import jobs
from ...bridge.blender import units
from ...bridge.objects import hull_mesh, hull_objects
from ..conversion import conversions
from ..exchange.endings import checked_ending
from ..flotation import afloat
from ..hull import hull_state
from . import left_out
from .made_models import made_model, made_panels

MODEL_ENDINGS = (".stl", ".3mf", ".obj", ".cli")
PANEL_ENDINGS = (".gdf", ".dat", ".obj")


class ModelFile(jobs.JobTask):
    """A closed model by ModelOptions, by the name's ending .stl, .3mf, .obj; .cli: its layers of
    `layer` mm. Segments are a file each, named with -1, -2, …; 3MF has all in one.

    result(): (a text about the model, what is amiss with it or nothing).
    """

    text = "Making the model"

    def __init__(self, obj, scene, path, options, layer):
        ending = checked_ending(path, MODEL_ENDINGS, "a model")
        if ending == ".cli" and options.machine is not None:
            raise ValueError(
                "Layers are written of a whole model: turn In segments off, or take STL, 3MF or OBJ"
            )
        self.state = hull_state.up_to_date(obj, scene)
        source = self.state.ship.source
        hull_native, title, names = native.require(), obj.name, left_out.names_of(obj)

        def work(progress):
            made = made_model(
                hull_native, source, names, options, lambda share: progress(0.8 * share)
            )
            told = made.told()
            if ending == ".cli":
                layers = made.model.layers(
                    layer, progress=lambda share: progress(0.8 + 0.15 * share)
                )
                write_cli(path, layers)
                return f"{len(layers.slices)} layers of {told}", made.remark()
            pieces = [(one.points, one.triangles) for one in made.pieces()]
            progress(0.85)
            if made.parts is not None:
                files = write_segments(path, pieces, title=title)
                told += f" in {len(files)} files" if len(files) > 1 else ""
            elif ending == ".3mf":
                write_3mf(path, *pieces[0], title=title)
            else:
                (write_obj if ending == ".obj" else write_stl)(path, *pieces[0])
            return told, made.remark()

        self._job = jobs.Job(work)
        conversions.watch(self)


class PanelFile(jobs.JobTask):
    """Panels of the hull as it floats, by PanelOptions and the name's ending .gdf, .dat (Nemoh) or
    .obj, in metres. The origin is amidships where Lpp is given, else at x = 0. result(): (a text
    about the panels, what is amiss with them or nothing).
    """

    text = "Making panels"

    def __init__(self, obj, scene, path, options):
        ending = checked_ending(path, PANEL_ENDINGS, "a mesh of panels")
        where = afloat.afloat(obj.hull, units.metres_per_unit(scene))
        self.state = hull_state.up_to_date(obj, scene)
        source = self.state.ship.source
        hull_native, title = native.require(), gdf_title(obj.name)
        names = left_out.names_of(obj)

        def work(progress):
            made = made_panels(hull_native, source, names, where, options, progress)
            mesh = made.mesh
            if ending == ".dat":
                write_nemoh(path, mesh.points, mesh.panels, half=mesh.half)
            elif ending == ".obj":
                write_obj(path, mesh.points, mesh.panels)
            else:
                write_gdf(path, mesh.points, mesh.panels, half=mesh.half, title=title)
            return made.told(), made.remark

        self._job = jobs.Job(work)
        conversions.watch(self)


class PartsFile(jobs.JobTask):
    """The closed hull in named parts as one STL text in metres, for snappyHexMesh: layers of the
    hull by their names, the rest by hull_native.surface_parts. tolerance: m. result(): (a text,
    what is amiss or nothing)."""

    text = "Making parts"

    def __init__(self, obj, scene, path, tolerance):
        checked_ending(path, (".stl",), "a surface in parts")
        self.state = hull_state.up_to_date(obj, scene)
        source = self.state.ship.source
        hull_native, slots = native.require(), _named_slots(obj)
        names = left_out.names_of(obj)

        def work(progress):
            surface = source.new_surface()
            body = source.bare_body(surface)
            model = hull_native.closed_model(
                body, tolerance, progress=lambda share: progress(0.1 + 0.6 * share)
            )
            progress(0.75)
            parts = hull_native.surface_parts(model, _named_cells(slots, surface))
            write_stl_parts(path, model.points, parts)
            counts = ", ".join(f"{name} {len(own)}" for name, own in parts.items())
            text = f"{len(model.triangles)} triangles: {counts}"
            return text, left_out.remark(names, body)

        self._job = jobs.Job(work)
        conversions.watch(self)


def _named_slots(obj):
    """(slot of the material of each face of the shell (n,), {part's name: slots of a layer})."""
    names = {}
    for layer in obj.hull.layers:
        own = [k for k, slot in enumerate(obj.material_slots) if slot.material == layer.material]
        if own and layer.material is not None and layer.in_hydrostatics:
            names.setdefault(part_name(hull_objects.layer_name(layer)), []).extend(own)
    return hull_mesh.shell_slots(obj), names


def _named_cells(slots, surface):
    """{part's name: cells} of layers; nothing where one layer is all there is."""
    of_faces, names = slots
    sizes = surface.mesh.face_sizes
    if len(of_faces) != len(sizes):
        return {}
    of_cells = np.repeat(of_faces, sizes)
    found = {name: np.flatnonzero(np.isin(of_cells, own)) for name, own in names.items()}
    return {name: cells for name, cells in found.items() if 0 < len(cells) < len(of_cells)}
