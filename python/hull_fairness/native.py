# SPDX-License-Identifier: GPL-3.0-or-later
"""The native module: beside this package in the same packaged add-on, else on the Python path, as
the wheels of an extension are."""

import importlib

_above = __package__.rpartition(".")[0]
try:
    hull_native = importlib.import_module(f"{_above}.hull_native" if _above else "hull_native")
except ModuleNotFoundError:
    hull_native = importlib.import_module("hull_native")
