# SPDX-License-Identifier: GPL-3.0-or-later
"""A variant of a hull set made: change by change, each of the form that the last one left.

A Maker keeps the surface and its body, which are placed anew for each variant, and what depends on
topology alone. What it makes depends on nothing but what is asked for: not on what it made before.
"""

from dataclasses import dataclass, field, replace

import hull_native as hn
import numpy as np
from hull_io import scaling

from .changes import SCALES, target_names
from .fields import shape_fields

DIMENSIONS = ("length_pp", "beam", "draft", "depth")


@dataclass(frozen=True, eq=False)
class Form:
    """points (n, 3): of the control mesh; main dimensions of the project, 0 where unknown; the
    draft of the water; all in m. weights (p,): of the member that it is, if it is one."""

    points: np.ndarray
    length_pp: float
    beam: float
    draft: float
    depth: float
    water_draft: float
    weights: object = None

    def moved(self, moves):
        return replace(self, points=self.points + moves, weights=None)


@dataclass
class Making:
    """What making a variant told: numbers {column: float or None}, and in misses the sentences on
    what was wanted and is not met."""

    numbers: dict = field(default_factory=dict)
    misses: list = field(default_factory=list)


class Maker:
    """Makes variants of a HullSet in one thread. trim in rad, water_density in t/m³ (None: as the
    hull's particulars have it), openings: as hull_native.HullBody has them."""

    def __init__(self, hulls, openings="closed"):
        self.hulls = hulls
        mesh = hn.ControlMesh(
            hulls.parents[0], hulls.face_sizes, hulls.face_vertices, hulls.creases, hulls.corners
        )
        self.surface = hn.LimitSurface(mesh, hulls.scheme)
        self.body = hn.HullBody(self.surface, mirrored=hulls.mirrored, openings=openings)
        self.openings = openings
        self._places = hn.SurfacePlaces(self.surface)
        self._family = self._family_of(mesh) if len(hulls.parents) > 1 else None
        self._last = {}

    def _family_of(self, mesh):
        parents = [
            hn.LimitSurface(mesh.with_points(points), self.hulls.scheme)
            for points in self.hulls.parents
        ]
        return hn.HullFamily(parents)

    def start(self, draft=None):
        """The Form of the first hull. draft: of the water; None: the design draft."""
        return self._form(self.hulls.parents[0], self.hulls.dimensions[0], draft)

    @staticmethod
    def _form(points, dimensions, draft, weights=None):
        length_pp, beam, own, depth = map(float, dimensions)
        at = own if draft is None else draft
        return Form(points, length_pp, beam, own, depth, at, weights)

    def made(self, changes, names, water):
        """(the Form of a variant, the Making). changes: without variables; names: of their
        columns; water: of the study, without variables. ValueError, in a sentence, where one of
        them can't be made."""
        form, told = self.start(water["draft"]), Making()
        for change, name in zip(changes, names):
            form = getattr(self, "_" + change["change"])(form, change, name, water, told)
        return form, told

    def placed(self, form):
        """The body as the form has it."""
        self.surface.set_points(form.points)
        self.body.update()
        return self.body

    def afloat(self, form, water):
        """How it floats, as keyword arguments of hydrostatics()."""
        return {
            "draft": form.water_draft,
            "trim": water["trim"] or 0.0,
            "length_pp": form.length_pp,
            "beam": form.beam,
            "design_draft": form.draft,
            "water_density": water["water_density"] or self.hulls.water_density,
        }

    # --- changes ---

    def _weights(self, form, change, name, water, told):
        weights = [1.0 - sum(change["weights"]), *change["weights"]]
        points = self._family.points(weights)
        fold = self._family.first_fold(points)
        if fold is not None:
            raise ValueError(f"The member is folded{_at(fold)}: take weights nearer to 0 and 1.")
        # What all have alike stays so to the last bit.
        first = self.hulls.dimensions[0]
        dimensions = first + np.array(change["weights"]) @ (self.hulls.dimensions[1:] - first)
        return self._form(points, dimensions, water["draft"], weights)

    def _dimensions(self, form, change, name, water, told):
        given = {key: change.get(key) for key in DIMENSIONS}
        wanted = {**given, "length": given["length_pp"]}
        del wanted["length_pp"]
        scale = scaling.Scale(scaling.factors(form, **wanted))
        for key in ("draft", "depth"):
            if given[key] is None:
                given[key] = scale.length(2, getattr(form, key))
        for axis, key in enumerate(("length_pp", "beam")):
            if given[key] is None:
                given[key] = scale.length(axis, getattr(form, key))
        at = water["draft"]
        points = scale.points(form.points)
        return Form(points, *given.values(), given["draft"] if at is None else at)

    def _fields(self, form, change, name, water, told):
        self.placed(form)
        places = hn.SurfacePlaces(self.surface, places=self._places)
        fields = shape_fields(self.surface, change["fields"], change["blend"], self.hulls.mirrored)
        shifts, gradients = fields.at(places.positions)
        limits = self._limits()
        limits["locked"] = np.union1d(limits["locked"], places.points_beyond(shifts))
        if len(limits["locked"]) == len(form.points):
            told.numbers.update({f"{name}.residual_rms": 0.0, f"{name}.residual_largest": 0.0})
            return form
        key = (self.surface.mesh.points.tobytes(), limits["locked"].tobytes())
        reshape = self._same(
            "reshape", key, lambda: hn.Reshape(self.surface, places=self._places, **limits)
        )
        found = reshape.solve(shifts, gradients=gradients)
        if found.folded_place is not None:
            raise ValueError(
                f"The fields turn the surface over{_at(found.folded_place)}: shift less, or let "
                "them reach further."
            )
        self._tell_residual(told, name, found)
        return form.moved(found.moves)

    def _sections(self, form, change, name, water, told):
        body = self.placed(form)
        limits = self._limits()
        rigid = [*hn.plane_ends(self.surface), *self.hulls.flats_across]
        shift = hn.SectionShift(
            body,
            part=change["part"],
            limits=hn.TransformLimits(rigid=rigid, **limits),
            **self.afloat(form, water),
        )
        wanted = {key: held for key, held in change.items() if key not in ("change", "part")}
        if "lcb_percent" in wanted:
            wanted["lcb"] = (0.5 + wanted.pop("lcb_percent") / 100.0) * form.length_pp
        found = shift.solve(**wanted)
        self._tell_residual(told, name, found)
        if not found.converged:
            told.misses.append(
                f"{name}: displacement and LCB are met nearly only, {found.volume:.6g} m³ and "
                f"{found.lcb:.6g} m."
            )
        return form.moved(found.moves)

    @staticmethod
    def _tell_residual(told, name, found):
        told.numbers[f"{name}.residual_rms"] = found.rms
        told.numbers[f"{name}.residual_largest"] = found.largest

    def _targets(self, form, change, name, water, told):
        names = target_names(change["targets"])
        wanted = [
            hn.FormTarget(
                one["number"],
                one["value"],
                tolerance=one["tolerance"],
                sense=one["sense"],
                station=one.get("station"),
                weight=one["weight"],
            )
            for one in change["targets"]
        ]
        settings = {
            "mirrored": self.hulls.mirrored,
            "openings": self.openings,
            "stiffness": change["stiffness"],
            "places": self._places,
            **{key: tuple(change[key]) for key in SCALES},
            **self.afloat(form, water),
        }
        weights = None
        if change["moves"] == "weights":
            weights, found = self._family.wanted_weights(form.weights, wanted, **settings)
        else:
            self.placed(form)
            found = hn.reach_targets(self.surface, wanted, **settings, **self._limits())
        self._tell_targets(told, name, names, change, found, weights)
        return self._scaled(form.moved(found.moves), found.scale)

    @staticmethod
    def _scaled(form, scale):
        x, y, z = map(float, scale)
        return replace(
            form,
            length_pp=form.length_pp * x,
            beam=form.beam * y,
            draft=form.draft * z,
            depth=form.depth * z,
            water_draft=form.water_draft * z,
        )

    @staticmethod
    def _tell_targets(told, name, names, change, found, weights):
        told.numbers[f"{name}.shift_rms"] = found.rms
        for key, scale in zip(SCALES, found.scale):
            told.numbers[f"{name}.{key}"] = scale
        for k, weight in enumerate([] if weights is None else weights):
            told.numbers[f"{name}.weight {k + 1}"] = weight
        for one, reached, miss in zip(names, found.reached, found.misses):
            told.numbers[f"{name}.{one}"] = reached
            told.numbers[f"{name}.{one}.miss"] = miss
        if found.status == "met":
            return
        parts = [
            f"{one} is {reached:.6g}, {abs(miss):.3g} too {'great' if miss > 0 else 'small'}"
            for one, reached, miss in zip(names, found.reached, found.misses)
            if miss
        ]
        text = "; ".join(parts) or "all are met, but not at the least change"
        if found.status == "folded":
            text += f"; beyond that the surface would fold{_at(found.folded_place)}"
        told.misses.append(f"{name}: {text}.")

    # --- what holds ---

    def _limits(self):
        """Limits of moves of the surface as it is placed, as keyword arguments."""
        key = self.surface.mesh.points.tobytes()
        return dict(self._same("limits", key, self._limits_of_surface))

    def _same(self, name, key, make):
        """What make() gives; of the same key as the last time what it gave then. Where variants
        differ in late changes alone, all that the first ones need is known already."""
        if name not in self._last or self._last[name][0] != key:
            self._last[name] = (key, make())
        return self._last[name][1]

    def _limits_of_surface(self):
        hulls = self.hulls
        limits = {
            "locked": hulls.locked,
            "held_points": hulls.held_points,
            "held_normals": hulls.held_normals,
        }
        if not hulls.mirrored:
            return limits
        tied, directions = hn.square_ties(self.surface)
        sums = hn.square_sums(self.surface)
        return {**limits, "tied": tied, "tied_directions": directions, "kept": sums}


def _at(place):
    return " at x {:.4g}, y {:.4g}, z {:.4g} m".format(*place)
