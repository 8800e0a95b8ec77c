# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/architecture.md agrees with the tree: what it names is there, and what is there it names."""

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
TOPS = ("native", "python", "addon", "samples", "scripts", "tests", "docs", "cmake")
# What other programs leave in the tree.
LEFT = {"__pycache__", ".pytest_cache"}

NAMED = re.findall(r"`([\w./-]+)`", PAGE)
PATHS = sorted({name for name in NAMED if name.split("/")[0] in TOPS})
ROWS = re.findall(r"^\| (?:.*?; )?`([\w./-]+)` \|", PAGE, flags=re.M)


@pytest.mark.parametrize("path", PATHS)
def test_what_is_named_is_there(path):
    assert (ROOT / path).exists()


def test_short_names_of_features_are_there():
    for name in NAMED:
        if name.startswith("features/"):
            assert (ROOT / "addon" / "hull_tools" / name).is_dir(), name


def folders_below(path):
    """All folders with a file in them, below a folder; each as its path from the root."""
    for inner in sorted(path.iterdir()):
        if inner.is_dir() and inner.name not in LEFT:
            if any(one.is_file() and not LEFT & set(one.parts) for one in inner.rglob("*")):
                yield str(inner.relative_to(ROOT))
            yield from folders_below(inner)


def has_its_name(folder):
    """Whether a folder's name says what it is for: tests of a layer, pictures of a page."""
    path = Path(folder)
    return {
        "tests/native": (ROOT / "native" / path.name).is_dir(),
        "docs/images": path.name == "panels" or (ROOT / f"docs/{path.name}.md").is_file(),
    }.get(str(path.parent), False)


@pytest.mark.parametrize("top", TOPS)
def test_all_folders_are_named(top):
    folders = [one for one in folders_below(ROOT / top) if not has_its_name(one)]
    assert [one for one in folders if one not in PATHS] == []


def test_folders_at_any_depth_are_found():
    folders = set(folders_below(ROOT / "native"))
    assert {"native/production", "native/production/segments"} <= folders
    assert not any("__pycache__" in one for one in folders_below(ROOT / "tests"))


@pytest.mark.parametrize("folder", ["addon/hull_tools", "native/bindings/hull_native"])
def test_modules_beside_folders_are_named(folder):
    modules = {str(path.relative_to(ROOT)) for path in (ROOT / folder).glob("[!_]*.py")}
    assert modules
    assert modules - set(PATHS) == set()


def test_top_folders_are_named():
    there = {
        path.name
        for path in ROOT.iterdir()
        if path.is_dir() and path.name[0] != "." and path.name not in ("build", "out")
    }
    assert there == set(TOPS)
    assert set(TOPS) <= set(ROWS)


def test_classes_of_the_flow_are_in_their_folders():
    for name, folder in re.findall(r"`(\w+)(?:\.\w+)?` \(`(native/[\w/]+)`\)", PAGE):
        headers = (ROOT / folder).rglob("*.h")
        assert any(re.search(rf"^class {name}\b", path.read_text(), re.M) for path in headers), name


def test_layers_use_what_the_page_says():
    """The table of layers against the test that reads the includes."""
    from test_native_layers import USES

    rows = re.findall(r"^\| `native/(\w+)` \| .* \| ([\w, ]*?) ?\|$", PAGE, flags=re.M)
    told = {layer: {use for use in uses.split(", ") if use} for layer, uses in rows}
    assert {layer: told[layer] for layer in USES} == USES


def test_folders_of_hull_native_use_what_the_page_says():
    """The table of folders against the test that reads the imports."""
    from test_layers import FOLDERS

    pattern = r"^\| `native/bindings/hull_native/(\w+)` \| .* \| ([\w, ]*?) ?\|$"
    rows = re.findall(pattern, PAGE, flags=re.M)
    told = [(folder, {use for use in uses.split(", ") if use}) for folder, uses in rows]
    assert told == list(FOLDERS.items())


def test_public_names_of_hull_native_stay_in_one_table():
    """A folder gives no names of its own: its file says what is there."""
    folders = sorted((ROOT / "native" / "bindings" / "hull_native").glob("*/__init__.py"))
    assert folders
    for path in folders:
        tree = ast.parse(path.read_text(encoding="utf-8"))
        assert ast.get_docstring(tree) and len(tree.body) == 1, path


# Steps of the flow of data, by what the code calls them.
STEP = ("follow", "follow_edit", "keep", "placed", "refresh", "ask", "show_plots", "after_changes")
ADDON = ROOT / "addon" / "hull_tools"


def calls_of(file, function):
    """What a function of the add-on calls, in the order of the text: each as its last two names."""
    tree = ast.parse((ADDON / file).read_text(encoding="utf-8"))
    (found,) = (
        node
        for node in ast.walk(tree)
        if isinstance(node, ast.FunctionDef) and node.name == function
    )
    calls = [node.func for node in ast.walk(found) if isinstance(node, ast.Call)]
    calls.sort(key=lambda func: (func.end_lineno, func.end_col_offset))
    return [".".join(ast.unparse(func).split(".")[-2:]) for func in calls]


def flow():
    """The steps that follow an update of Blender's, one after the other, as the code has them."""
    state = "features/hull/hull_state.py"
    parts = {
        "_follow": ("handlers/follow.py", "_follow"),
        "_follow_one": ("handlers/follow.py", "_follow_one"),
        "later_subjects": ("handlers/follow.py", "later_subjects"),
        "_brought_up_to_date": (state, "_follow"),
    }
    handed_over = {"placed": "preview.placed"}  # as the handler does, see the test

    def expanded(file, function):
        for call in calls_of(file, function):
            call = handed_over.get(call, call)
            if call in parts:
                yield from expanded(*parts[call])
            elif call.split(".")[-1] in STEP:
                yield call
                if call == "hull_state.follow_edit":
                    yield from expanded(state, "follow_edit")

    return list(expanded("handlers/follow.py", "after_update"))


def test_the_flow_is_told_in_the_order_of_the_calls():
    text = (ADDON / "handlers" / "follow.py").read_text(encoding="utf-8")
    assert "preview.placed" in text.split("hull_state.follow_edit(")[1].split(")\n")[0]
    section = PAGE.split("## A dragged point")[1].split("\nDrawing starts nothing")[0]
    told = re.findall(rf"`(\w+\.(?:{'|'.join(STEP)}))`", section)
    assert told == flow()
    assert len(told) > 20 and told.index("preview.placed") < told.index("ship.follow")


def files_with(pattern):
    return {
        path.relative_to(ADDON).as_posix()
        for path in ADDON.rglob("*.py")
        if re.search(pattern, path.read_text(encoding="utf-8"))
    }


def test_timers_threads_and_drawing_have_one_place_each():
    assert files_with(r"app\.timers") == {"bridge/background/timers.py"}
    assert files_with(r"ThreadPoolExecutor|Thread\(") == {"bridge/background/work_queue.py"}
    assert files_with(r"WorkQueue\(") == {
        "bridge/background/jobs.py",
        "bridge/background/worker.py",
    }
    assert files_with(r"SpaceView3D\.draw_handler_(add|remove)") == {"overlays/view.py"}
    # All views, and the one that the mouse works in.
    assert files_with("tag_redraw") == {"bridge/blender/redraw.py", "operators/view_drag.py"}


def test_drawing_keeps_only_what_goes_with_its_source():
    """Nothing that overlays or panels keep for later is found by names or addresses, which another
    thing may have by then."""
    kept = files_with(r"(?m)^_\w+ = (\{\}|dict\(|set\(|\[\]|OrderedDict)")
    assert not {file for file in kept if file.startswith(("overlays/", "panels/"))}


# What begins work, or has it done later.
STARTERS = {"ask", "begin", "put_off", "start", "submit", "show_plots", "register_timer"}
BACKGROUND = {"background", "jobs", "timers", "worker", "work_queue", "threading", "concurrent"}


def starting(tree):
    """What of a module begins work or imports what does."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            if node.func.attr in STARTERS:
                yield ast.unparse(node.func)
        elif isinstance(node, (ast.Import, ast.ImportFrom)):
            module = getattr(node, "module", None) or ""
            names = [*module.split("."), *(p for a in node.names for p in a.name.split("."))]
            yield from sorted(BACKGROUND.intersection(names))


def draws(tree):
    """The functions of a module that Blender calls to draw: of panels, menus and dialogs."""
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef) and node.name.lstrip("_").startswith("draw"):
            yield node


def test_drawing_starts_nothing():
    found = {}
    for path in sorted(ADDON.rglob("*.py")):
        name = path.relative_to(ADDON).as_posix()
        tree = ast.parse(path.read_text(encoding="utf-8"))
        whole = name.startswith(("panels/", "overlays/"))
        found[name] = [one for part in ([tree] if whole else draws(tree)) for one in starting(part)]
    assert sum(name.startswith(("panels/", "overlays/")) for name in found) > 40
    assert {name: said for name, said in found.items() if said} == {}


def test_what_starts_is_found():
    text = "from ..bridge.background import timers\n\ndef draw(self, context):\n    looks.start()\n"
    assert list(starting(ast.parse(text))) == ["background", "timers", "looks.start"]
    assert [node.name for node in draws(ast.parse(text))] == ["draw"]


def test_both_pages_say_the_same_of_drawing():
    said = "Drawing starts nothing: it reads what was computed, and notes in the hull's state what"
    for page in (PAGE, (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")):
        assert said in " ".join(page.split())
