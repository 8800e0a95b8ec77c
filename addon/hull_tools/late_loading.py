# SPDX-License-Identifier: GPL-3.0-or-later
"""Modules that run when something of them is first used, not when they are imported.

Blender waits while an add-on is enabled, and most of what this one can do is not asked for in most
sessions. `import` statements stay at the top of the files, as everywhere: what they bind is the
module itself, still empty, which runs its file when a name of it is first looked up.
"""

import importlib
import sys
import threading
from importlib.machinery import PathFinder
from types import ModuleType

# One for all modules, held again by what a running module uses: with one each, two threads could
# wait for one another.
_running = threading.RLock()


class _Late(ModuleType):
    """A module that has not run yet, or is about to."""

    def __getattr__(self, name):
        # Whoever looks through all modules, as Python's own warnings do, asks for such names.
        if name.startswith("__"):
            raise AttributeError(f"module {self.__name__!r} has no attribute {name!r}")
        with _running:
            if type(self) is not _Late:  # run by another thread meanwhile
                return getattr(self, name)
            module = self.__spec__.loader.module_below(self, name)
            if module is None:
                self.__spec__.loader.run(self)
                module = ModuleType.__getattribute__(self, name)
            return module


class _LateLoader:
    """Loads by Python's own loader, later."""

    def __init__(self, loader):
        self._loader = loader
        self._runs = False

    def create_module(self, spec):
        return _Late(spec.name)

    def exec_module(self, module):
        pass

    def run(self, module):
        """Runs a module's file, unless it is what uses the module."""
        if self._runs:
            return
        self._runs = True
        try:
            self._loader.exec_module(module)
            module.__class__ = ModuleType
        finally:
            self._runs = False

    def module_below(self, module, name):
        """The module of that name in a package; None where there is none."""
        if "__path__" not in vars(module):
            return None
        if PathFinder.find_spec(f"{module.__name__}.{name}", module.__path__) is None:
            return None
        return importlib.import_module(f"{module.__name__}.{name}")

    def __getattr__(self, name):
        return getattr(self._loader, name)


class _LateFinder:
    def __init__(self, packages):
        self.packages = packages

    def find_spec(self, name, path, target=None):
        if not any(name == one or name.startswith(one + ".") for one in self.packages):
            return None
        spec = PathFinder.find_spec(name, path, target)
        if spec is not None and spec.loader is not None:
            spec.loader = _LateLoader(spec.loader)
        return spec


def install(*packages):
    """From now on these packages and all modules in them are late."""
    # What is there already may be of this file as it was before the add-on was updated.
    others = [one for one in sys.meta_path if getattr(one, "packages", None) != packages]
    sys.meta_path[:] = [_LateFinder(packages), *others]
