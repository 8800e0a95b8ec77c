# SPDX-License-Identifier: GPL-3.0-or-later
"""The native module beside this package: on the Python path, or in the same packaged add-on."""

import importlib

_beside = __package__.rpartition(".")[0]
hull_native = importlib.import_module(f"{_beside}.hull_native" if _beside else "hull_native")
