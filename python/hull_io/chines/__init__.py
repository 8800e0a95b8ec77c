# SPDX-License-Identifier: GPL-3.0-or-later
"""Boats that files give by their chines: Carlson's Hulls (`.hul`), Carene (`.xyz`) and the text in
which FREE!ship takes chines. `read_chines` reads any of them, `hull_of_chines` makes a hull."""

from .chine_files import Chines, looks_like_chines, read_chines
from .chine_hulls import hull_of_chines

__all__ = ["Chines", "hull_of_chines", "looks_like_chines", "read_chines"]
