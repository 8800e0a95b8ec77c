# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads the add-on's io package under the name `hull_io`, with Blender or without.

The package can't be imported as `io` (a standard module) nor, without Blender, as part of the
add-on. In Blender the installed add-on's own package is taken where it is loaded.
"""

import importlib.util
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
SHARED = ROOT.parent / "shared"


def load_hull_io():
    if "hull_io" in sys.modules:
        return sys.modules["hull_io"]
    installed = [name for name in sys.modules if name.endswith("hull_tools.io")]
    folder = ROOT / "addon" / "hull_tools" / "io"
    if installed:
        folder = Path(sys.modules[installed[0]].__file__).parent
    spec = importlib.util.spec_from_file_location(
        "hull_io", folder / "__init__.py", submodule_search_locations=[str(folder)]
    )
    module = importlib.util.module_from_spec(spec)
    sys.modules["hull_io"] = module
    spec.loader.exec_module(module)
    return module
