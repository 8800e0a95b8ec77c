# SPDX-License-Identifier: GPL-3.0-or-later
"""The reference page and the type stubs say what the module's docstrings say."""

import inspect
import shutil
import subprocess
from pathlib import Path

import hull_native as hn
import page
import pytest
import signatures
import stubs

ROOT = Path(__file__).resolve().parents[2]

needs_mypy = pytest.mark.skipif(not shutil.which("mypy"), reason="mypy is not installed")


def test_the_page_is_that_of_the_module():
    found = (ROOT / "docs" / "module.md").read_text(encoding="utf-8")
    assert found == page.page(), "./hull reference makes it anew"


def test_all_that_is_public_is_on_the_page():
    headings = {line[4:] for line in page.page().splitlines() if line.startswith("### ")}
    public = {name for name in vars(hn._core) if not name.startswith("_")} | set(hn._LATER)
    values = {name for name in public if not callable(getattr(hn, name))}
    assert public - values <= headings
    assert len(headings) > 150


def test_signatures_are_read_with_their_defaults():
    doc = """f(a: List[float[3]], b: Tuple = (1, 'x, )'), *, c: Optional[H] = None) -> dict

    Text."""
    (found,) = signatures.functions_of("f", inspect.cleandoc(doc))
    assert [one.name for one in found.arguments] == ["a", "b", "*", "c"]
    assert [one.default for one in found.arguments] == [None, "(1, 'x, )')", None, "None"]
    assert (found.returns, found.text) == ("dict", "Text.")


def test_a_docstring_without_a_signature_is_named():
    with pytest.raises(ValueError, match="g: its docstring does not begin with a signature"):
        signatures.functions_of("g", "Text alone.")


def checked(folder, text):
    """What mypy says of a program beside the stubs."""
    stubs.write(folder / "hull_native")
    package = Path(hn.__file__).parent
    for path in package.rglob("*.py"):
        if path != package / "__init__.py":
            copy = folder / "hull_native" / path.relative_to(package)
            copy.parent.mkdir(exist_ok=True)
            shutil.copy(path, copy)
    program = folder / "program.py"
    program.write_text(text)
    done = subprocess.run(
        ["mypy", "--cache-dir", folder / "cache", "program.py", "hull_native"],
        cwd=folder, env={"PATH": "/usr/bin:/bin"}, capture_output=True, text=True, check=False,
    )  # fmt: skip
    return done.stdout


@needs_mypy
def test_stubs_are_sound_and_find_what_is_wrong(tmp_path):
    told = checked(tmp_path, """
import hull_native as hn
mesh = hn.ControlMesh([[0.0, 0.0, 0.0]], [4], [0, 1, 2, 3])
surface = hn.LimitSurface(mesh, "biermann")
first: float = surface.evaluate_grid(4)[0][0]
count: int = surface.cell_count
hn.write_step(surface, "hull.step", unit="mm")
hn.LimitSurface("no mesh")
wrong: str = surface.cell_count
surface.no_such_thing
""")  # fmt: skip
    faults = [line for line in told.splitlines() if "error:" in line]
    assert [line.split(":")[1] for line in faults] == ["8", "9", "10"], told
