# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls moved as they are, with all that belongs to them: up to another base line, or to the other
side of the centre plane."""

from dataclasses import dataclass

import numpy as np

from .scale import Scale


@dataclass(frozen=True)
class Lift(Scale):
    """A shift of all that lies in space, of factors 1. Coordinates that are given by themselves
    stay: heights of drafts, decks and centres were measured from the keel already."""

    def place(self, axis, value):
        return value


def upwards(height, heights_stay):
    """The Scale that moves a hull up so far; heights_stay: as Lift tells, else they go along."""
    return (Lift if heights_stay else Scale)((1.0, 1.0, 1.0), (0.0, 0.0, height))


@dataclass(frozen=True)
class OtherSide(Scale):
    """The mirror image on the centre plane of all that lies in space. Lengths, areas and what is
    given by itself are of the whole ship, and stay."""

    factors: tuple = (1.0, -1.0, 1.0)

    def __post_init__(self):
        """No factor is to be tried."""

    def plane(self, normal, offset):
        return self.normal(normal), offset

    def normal(self, normal):
        return np.multiply(self.factors, normal) + 0.0

    def length(self, axis, value):
        return value

    def place(self, axis, value):
        return value

    def diagonals(self, text):
        return text

    def sizes(self, appendage):
        return appendage.sizes

    def volume(self, value):
        return value

    profile = plan = surface = section = volume
