# SPDX-License-Identifier: GPL-3.0-or-later
"""Objects whose class was never initialised, as those of a subclass that forgets its base, raise
TypeError wherever they are used: in every method, property and argument of every class."""

import re

import hull_native as hn
import pytest

WORDS = "before the __init__"
NAMES = [name for name in dir(hn) if not name.startswith("_")]
CLASSES = {
    value.__name__: value
    for value in (getattr(hn, name) for name in NAMES)
    if isinstance(value, type) and type(value).__name__ == "pybind11_type"
}


def unmade(cls):
    class Forgetful(cls):
        def __init__(self):
            pass

    return Forgetful.__new__(Forgetful)


def signatures(function):
    """Of each overload the (name, bound class or None) of its parameters; none of Python's own."""
    found = re.findall(r"^(?:\d+\. )?\w+\((.*)\) ->", function.__doc__ or "", re.MULTILINE)
    for parameters in found:
        named = re.findall(r"(\w+): ([\w.]+)", parameters)
        yield [(name, CLASSES.get(kind.rpartition(".")[2])) for name, kind in named]


def uses():
    """(what, function that uses unmade instances) for everything that takes a bound class."""
    for cls in CLASSES.values():
        for name, member in vars(cls).items():
            if isinstance(member, property):
                yield f"{cls.__name__}.{name}", lambda m=member, c=cls: m.fget(unmade(c))
    functions = [(name, getattr(hn, name)) for name in NAMES]
    functions += [
        (f"{cls.__name__}.{name}", getattr(cls, name))
        for cls in CLASSES.values()
        for name in vars(cls)
    ]
    for label, function in functions:
        for overload, taken in enumerate(signatures(function)):
            for index, (parameter, cls) in enumerate(taken):
                is_made_now = index == 0 and function.__name__ == "__init__"
                if cls is not None and not is_made_now:
                    use = f"{label}({parameter}) {overload}"
                    yield use, lambda f=function, t=taken: call(f, t)


def call(function, taken):
    """With None for what is of no bound class."""
    values = [(name, unmade(cls) if cls else None) for name, cls in taken]
    # Operators' arguments have no names of their own.
    by_place = [value for name, value in values if re.fullmatch(r"self|arg\d+", name)]
    return function(
        *by_place,
        **{name: value for name, value in values if not re.fullmatch(r"self|arg\d+", name)},
    )


USES = dict(uses())


def test_all_kinds_of_uses_are_tried():
    for use in (
        "LimitSurface.cell_count",
        "LimitSurface.positions(self)",
        "LimitSurface.__init__(mesh)",
        "HullBody.__init__(surface)",
        "SurfaceTree.refit(surface)",
        "hydrostatics(body)",
        "measure_quality(patches)",
        "Plot.add_curve(self)",
        "write_step(patches)",
    ):
        assert any(use in known for known in USES), use
    assert len(CLASSES) > 30


@pytest.mark.parametrize("use", USES)
def test_unmade_instances_are_refused(use):
    with pytest.raises(TypeError, match=WORDS):
        USES[use]()


@pytest.mark.parametrize("cls", CLASSES.values(), ids=CLASSES)
def test_subclasses_that_forget_their_base_are_refused(cls):
    class Forgetful(cls):
        def __init__(self):
            pass

    with pytest.raises(TypeError, match="must be called when overriding __init__"):
        Forgetful()


def test_subclasses_that_use_their_base_too_early_are_refused():
    class Early(hn.ControlMesh):
        def __init__(self, *arrays):
            self.seen = self.size
            super().__init__(*arrays)

    with pytest.raises(TypeError, match=WORDS):
        Early([[0, 0, 0], [1, 0, 0], [1, 1, 0]], [3], [0, 1, 2])


def test_subclasses_that_call_their_base_serve():
    class Named(hn.ControlMesh):
        def __init__(self, name, *arrays):
            super().__init__(*arrays)
            self.name = name

    mesh = Named("sheet", [[0, 0, 0], [1, 0, 0], [1, 1, 0]], [3], [0, 1, 2])
    assert mesh.name == "sheet"
    assert hn.LimitSurface(mesh).cell_count == 3
