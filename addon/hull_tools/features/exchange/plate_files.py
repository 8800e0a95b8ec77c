# SPDX-License-Identifier: GPL-3.0-or-later
"""The shell in plates, written beside Blender's own work: a task, as those of file_tasks are."""

from pathlib import Path

from ....hull_io.bytes_on_disk import write_bytes
from ...bridge import limits, native
from ...bridge.background import jobs
from ..conversion import conversions
from ..hull import hull_state


class PlateFile(jobs.JobTask):
    """The plates of a half hull's shell, by the name's ending .pdf (one page a plate), .dxf (all on
    one drawing at true size) or .csv (the list).

    strake, plate_length, frame_spacing, thickness: m; frame_spacing 0 draws no frames. result(): a
    text about the plates.
    """

    text = "Laying out plates"

    def __init__(self, obj, scene, path, *, strake, plate_length, thickness, frame_spacing):
        self.state = hull_state.up_to_date(obj, scene)
        source = self.state.ship.source
        hull_native = native.require()
        if not source.half:
            raise ValueError(
                "Plates are laid out of a half hull: use Make Half, and each counts twice"
            )

        def work(progress):
            surface = source.new_surface()
            curves, seams = hull_native.shell_seams(
                surface, strake=strake, plate_length=plate_length
            )
            progress(0.15)
            plates = hull_native.plates(
                surface, seams, progress=lambda share: progress(0.15 + 0.25 * share)
            )
            if len(plates) > limits.MOST_PLATES:
                raise ValueError(
                    f"The shell would have {len(plates)} plates, and at most {limits.MOST_PLATES} "
                    "are written; ask for larger ones"
                )
            listed = hull_native.plate_list(
                plates,
                thickness=thickness,
                mirrored=True,
                progress=lambda share: progress(0.4 + 0.5 * share),
            )
            progress(0.9)
            if Path(path).suffix.lower() == ".csv":
                text = hull_native.rows_csv(hull_native.plate_rows(listed))
                write_bytes(Path(path), text.encode())
            else:
                marks = _frames(hull_native, curves, plates, frame_spacing)
                hull_native.write_plates(
                    listed, path, marks=marks, progress=lambda share: progress(0.9 + 0.1 * share)
                )
            mass = 2.0 * sum(one.mass_t for one in listed)
            return f"{len(listed)} plates of each side, {mass:.2f} t of both"

        self._job = jobs.Job(work)
        conversions.watch(self)


def _frames(hull_native, curves, plates, spacing):
    """("FRAMES", curve) of frames that cross the plates."""
    if spacing <= 0.0:
        return []
    low = min(float(p.box[0][0]) for p in plates)
    high = max(float(p.box[1][0]) for p in plates)
    ranges = [(int(low / spacing) - 1, int(high / spacing) + 1, spacing)]
    if high / spacing - low / spacing > limits.MOST_PLATES:
        raise ValueError("There would be too many frames; space them wider")
    table = hull_native.frame_table(ranges)
    return [("FRAMES", curve) for curve in hull_native.frame_marks(curves, table, low, high)]
