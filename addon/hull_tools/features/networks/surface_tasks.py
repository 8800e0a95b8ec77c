# SPDX-License-Identifier: GPL-3.0-or-later
"""The surface of a network as patches: how good they are, what they are afloat, and CAD files of
them. Tasks of a thread, which take the network as it is when they are made."""

from dataclasses import dataclass

from ...bridge import native
from ...bridge.background import jobs
from ...bridge.blender import units
from ...bridge.objects import networks
from . import network_state

# Of the time that a file takes, that of its patches.
_SHARE_OF_PATCHES = 0.1


@dataclass(frozen=True)
class Measured:
    """lines: what is told of the surface; revision: NetworkState's, of the curves it is of."""

    lines: tuple
    revision: int


class Measuring(jobs.JobTask):
    """Measures the surface, and at a draft, Blender's units, unless that is 0, what it is
    afloat. ValueError where curves are not joined."""

    text = "Measuring the surface"

    def __init__(self, network, scene):
        state = network_state.up_to_date(network, scene)
        self._name, own, revision = network.name, state.network, state.revision
        draft = network.hull_network.draft * units.metres_per_unit(scene)

        def work(progress):
            module = native.require()
            made = module.network_patches(own)
            progress(0.5)
            lines = module.network_report(own, made).lines()
            if draft > 0.0:
                progress(0.7)
                afloat = module.network_immersion(own, made, draft)
                lines += [f"At a draft of {draft:.3f} m:", *module.immersion_lines(afloat)]
            return Measured(tuple(lines), revision)

        self._job = jobs.Job(work)

    def write(self):
        """Keeps what was measured with the network; returns its name and the first line of it.
        ValueError where the network was deleted meanwhile."""
        measured = self.result()
        network = networks.named(self._name)
        if network is None:
            raise ValueError(f'"{self._name}" was deleted meanwhile: nothing is told of it')
        network_state.state_of(network).measured = measured
        return self._name, measured.lines[0]


class Writing(jobs.JobTask):
    """Writes the surface as a STEP or IGES file, by what the path ends in, in metres of the ship.
    is_whole: with the mirror image. ValueError where curves are not joined. result(): (what was
    found in the file, sentences on regions and curves)."""

    def __init__(self, network, scene, path, is_whole):
        own = network_state.up_to_date(network, scene).network
        is_step = path.lower().endswith((".step", ".stp"))
        self.text = f"Writing {'STEP' if is_step else 'IGES'}"
        name = network.name

        def work(progress):
            module = native.require()
            made = module.network_patches(own)
            if not made.patches.patch_count:
                raise ValueError("The network has no regions: add curves that enclose some")
            progress(_SHARE_OF_PATCHES)
            rest = 1.0 - _SHARE_OF_PATCHES
            write = module.write_step if is_step else module.write_iges
            report = write(
                made.patches,
                path,
                name=name,
                mirrored=is_whole,
                progress=lambda share: progress(_SHARE_OF_PATCHES + rest * share),
            )
            return report, [problem.what for problem in made.problems]

        self._job = jobs.Job(work)
