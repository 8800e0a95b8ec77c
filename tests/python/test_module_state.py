# SPDX-License-Identifier: GPL-3.0-or-later
"""What bridge and features of the add-on keep in modules, beside what belongs to a hull: few
things, each with its reason."""

import ast
from pathlib import Path

ADDON = Path(__file__).resolve().parents[2] / "addon" / "hull_tools"

# Names of modules that functions change, and why they are there. What is of a hull belongs into its
# state instead: hull_state.state_of(hull).of(Class).
KEPT = {
    "bridge/background/jobs.py: _unfinished": "the thread's pieces of work, of no hull",
    "bridge/background/worker.py: _jobs": "the thread's pieces of work, of no hull",
    "bridge/objects/curve_lines.py: _read": "curves read once, for as long as one function runs",
    "bridge/objects/surface_upkeep.py: _seen": "hulls that were there, to find what is gone",
    "bridge/objects/surface_upkeep.py: _scales": "units of scenes as they were, to see a change",
    "bridge/objects/unrecorded.py: _made": "data that undo is not to know of, of the session",
    "bridge/objects/unrecorded.py: _to_give": "what is done once an undo is through",
    "bridge/objects/unrecorded.py: _to_hide": "what is done once an undo is through",
    "bridge/objects/unrecorded.py: _is_undoing": "between two handlers of one undo",
    "features/analyses/live_analyses.py: _plots": "what all 3D views show now",
    "features/conversion/conversions.py: _recent": "for undo: of any hull with this surface",
    "features/conversion/conversions.py: _tasks": "work that goes on when its hull is deleted",
    "features/hull/curve_entries.py: _known": "of hulls that are gone, joined to others",
    "features/hull/hull_state.py: _states": "the states themselves",
    "features/hull/tags.py: _known": "made of a surface, and gone with it",
    "features/modelling/developable_making.py: _known": "made of a surface, and gone with it",
    "features/morphing/weights.py: _is_writing": "setting a property calls its update",
    "features/networks/drawing.py: _pen": "the one tool that draws now, for its overlay",
    "features/networks/following.py: _is_following": "writing to curves makes Blender tell of them",
    "features/networks/following.py: _has_followed": "writing to curves makes Blender tell of them",
    "features/networks/network_state.py: _states": "the states of networks themselves",
    "features/studio/following.py: _is_at_rest": "a thread that renders waits for it",
    "features/surface/colour_views.py: _before": "what views are set back to, of no hull",
    "features/variants/following.py: _after": "what comes after ghosts, told once at registration",
}

CHANGES = {"add", "append", "clear", "discard", "extend", "insert", "move_to_end", "pop", "popitem",
           "remove", "set", "setdefault", "update"}  # fmt: skip


def bound_names(tree):
    """Names that a module binds at its top."""
    for node in tree.body:
        targets = node.targets if isinstance(node, ast.Assign) else []
        if isinstance(node, ast.AnnAssign):
            targets = [node.target]
        yield from (target.id for target in targets if isinstance(target, ast.Name))


def changed_names(tree):
    """Names of a module that functions bind anew (`global`), or change the value of."""
    names = set(bound_names(tree))
    functions = [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]
    for node in {node for function in functions for node in ast.walk(function)}:
        if isinstance(node, ast.Global):
            yield from node.names
            continue
        values = []
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            values = [node.func.value] if node.func.attr in CHANGES else []
        elif isinstance(node, (ast.Assign, ast.AugAssign, ast.Delete)):
            targets = [node.target] if isinstance(node, ast.AugAssign) else node.targets
            values = [t.value for t in targets if isinstance(t, (ast.Subscript, ast.Attribute))]
        yield from (v.id for v in values if isinstance(v, ast.Name) and v.id in names)


def test_modules_keep_little_and_say_why():
    found = {
        f"{path.relative_to(ADDON).as_posix()}: {name}"
        for part in ("bridge", "features")
        for path in (ADDON / part).rglob("*.py")
        for name in changed_names(ast.parse(path.read_text(encoding="utf-8")))
    }
    assert found == set(KEPT)
    assert all(KEPT.values())


def test_what_is_changed_is_found():
    text = """
_a, _b = [], {}
_known = {}
_list: list = []
_flag = False
_event = Event()
_never = {}
def change(one):
    global _flag
    _known[one] = 1
    _list.append(one)
    _event.set()
    own = []
    own.append(_never[one])
"""
    assert set(changed_names(ast.parse(text))) == {"_known", "_list", "_flag", "_event"}
