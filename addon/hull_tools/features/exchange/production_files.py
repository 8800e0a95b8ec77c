# SPDX-License-Identifier: GPL-3.0-or-later
"""Models of a hull and panels of its wetted part, written beside Blender's own work: tasks, as
those of file_tasks are."""

from pathlib import Path

from ....hull_io import (
    gdf_title,
    write_3mf,
    write_cli,
    write_gdf,
    write_nemoh,
    write_obj,
    write_stl,
)
from ...bridge import limits, native
from ...bridge.background import jobs
from ...bridge.blender import units
from ..conversion import conversions
from ..flotation import afloat
from ..hull import hull_state

_MILLIMETRES = 1000.0


class ModelFile(jobs.JobTask):
    """A closed model at 1 : `scale` in mm, by the name's ending .stl, .3mf, .obj; .cli: its layers.

    tolerance, layer: of the model, in mm. result(): a text about the model.
    """

    text = "Making the model"

    def __init__(self, obj, scene, path, *, scale, tolerance, layer):
        self.state = hull_state.up_to_date(obj, scene)
        source = self.state.ship.source
        hull_native, title = native.require(), obj.name
        factor = _MILLIMETRES / scale

        def work(progress):
            body = source.new_body(source.new_surface())
            progress(0.2)
            model = hull_native.closed_model(body, tolerance / factor).scaled(factor)
            count = len(model.triangles)
            if count > limits.MOST_MODEL_TRIANGLES:
                raise ValueError(
                    f"The model would have {count} triangles, and at most "
                    f"{limits.MOST_MODEL_TRIANGLES} are written; ask for a larger tolerance"
                )
            progress(0.6)
            told = f"{count} triangles, {model.volume / 1000.0:.1f} cm³"
            ending = Path(path).suffix.lower()
            if ending == ".cli":
                layers = model.layers(layer)
                progress(0.8)
                write_cli(path, layers)
                return f"{len(layers.slices)} layers of {told}"
            if ending == ".3mf":
                write_3mf(path, model.points, model.triangles, title=title)
            else:
                write = write_obj if ending == ".obj" else write_stl
                write(path, model.points, model.triangles)
            return told

        self._job = jobs.Job(work)
        conversions.watch(self)


class PanelFile(jobs.JobTask):
    """Panels of the hull as it floats, by the name's ending .gdf, .dat (Nemoh) or .obj, in metres.

    along: how many of the largest panels the length has; grading: how large they are at the water
    and at the ends, of that. The origin is amidships where Lpp is given, else at x = 0. result(): a
    text about the panels.
    """

    text = "Making panels"

    def __init__(self, obj, scene, path, *, along, grading):
        scale = units.metres_per_unit(scene)
        where = afloat.afloat(obj.hull, scale)
        self.state = hull_state.up_to_date(obj, scene)
        source = self.state.ship.source
        hull_native, title = native.require(), gdf_title(obj.name)

        def work(progress):
            surface = source.new_surface()
            body = source.new_body(surface)
            progress(0.2)
            x = surface.mesh.points[:, 0]
            size = (where.length_pp or float(x.max() - x.min())) / along
            mesh = hull_native.wetted_panels(
                body, size, grading=grading, origin_x=where.draft_at, **where.position()
            )
            progress(0.7)
            ending = Path(path).suffix.lower()
            if ending == ".dat":
                write_nemoh(path, mesh.points, mesh.panels, half=mesh.half)
            elif ending == ".obj":
                write_obj(path, mesh.points, mesh.panels)
            else:
                write_gdf(path, mesh.points, mesh.panels, half=mesh.half, title=title)
            off = mesh.volumes.mean() / mesh.displaced_volume - 1.0
            sides = "of the port half" if mesh.half else "of both sides"
            return f"{len(mesh.panels)} panels {sides}, volume {100.0 * off:+.2f} %"

        self._job = jobs.Job(work)
        conversions.watch(self)
