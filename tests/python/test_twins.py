# SPDX-License-Identifier: GPL-3.0-or-later
"""Nothing is written twice: no two functions or long statements of Python that differ by the names
of their variables alone, and no two runs of lines in functions of C++."""

import ast
import re
from collections import defaultdict
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PYTHON = ("addon", "python", "native/bindings", "tests", "scripts", "samples", "docs")
CPP = ("native", "tests/native")
# Characters; what is shorter is an idiom.
LEAST_FUNCTION, LEAST_STATEMENT = 120, 160
# Lines of C++ with a word in them, and characters in one of these on the average.
RUN, LEAST_LINE = 7, 25

STATEMENTS = (
    ast.For, ast.If, ast.With, ast.While, ast.Try, ast.Assign, ast.Return, ast.Assert,
)  # fmt: skip
TOKEN = re.compile(r'"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\'|[A-Za-z_]\w*|\d[\w.\']*|::|->|\S')
BRACE = re.compile(r'"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|[{}]')
TYPE = re.compile(r"\b(?:namespace|class|struct|enum|union)\b")
WORDS = set(
    """if else for while do return switch case break continue const auto int double bool char void
    static constexpr unsigned long true false nullptr this throw new delete using typename template
    sizeof float default try catch std""".split()
)


class Numbers:
    """Of variables, in the order in which they appear; other names stay."""

    def __init__(self, names):
        self._names, self._numbers = names, {}

    def number(self, name):
        if name not in self._names:
            return name
        return self._numbers.setdefault(name, len(self._numbers))


def variables(nodes):
    """The names that are bound in these nodes."""
    for node in (inner for outer in nodes for inner in ast.walk(outer)):
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            yield node.id
        elif isinstance(node, ast.arg):
            yield node.arg
        elif isinstance(node, ast.FunctionDef):
            yield node.name


def tokens_of(node, names):
    """A syntax tree as a list of what it is made of; names: Numbers of its variables."""
    if isinstance(node, list):
        return ["["] + [token for each in node for token in tokens_of(each, names)] + ["]"]
    if not isinstance(node, ast.AST):
        return [repr(node)]
    found = [type(node).__name__]
    for field, value in ast.iter_fields(node):
        if field in ("ctx", "annotation", "type_comment"):
            continue
        if field in ("id", "arg") or field == "name" and isinstance(node, ast.FunctionDef):
            found.append(names.number(value))
        else:
            found += tokens_of(value, names)
    return found


def without_names(nodes, arguments=()):
    names = Numbers({*variables(nodes), *variables(arguments)})
    return tuple(tokens_of(nodes, names))


def characters(nodes, lines):
    """About how many the nodes have in the source, without its margin."""
    own = lines[nodes[0].lineno - 1 : nodes[-1].end_lineno]
    return sum(len(line.strip()) for line in own)


def parts_of_python(text):
    """(line, tokens without names of variables) of all functions and statements that are long."""
    lines = text.split("\n")
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.FunctionDef):
            body = node.body[ast.get_docstring(node) is not None :]
            if body and characters(body, lines) >= LEAST_FUNCTION:
                yield node.lineno, ("function", *without_names(body, [node.args]))
        elif isinstance(node, STATEMENTS) and characters([node], lines) >= LEAST_STATEMENT:
            yield node.lineno, without_names([node])


def bare(text):
    """C++ without comments and directives, its lines where they were."""
    text = re.sub(r"//[^\n]*", "", text)
    return re.sub(r"^[ \t]*#.*$", "", text, flags=re.MULTILINE)


def functions_of_cpp(text):
    """(begin, end) of what stands in braces that are no namespace's and no type's, the outermost
    ones."""
    opened = []
    for brace in BRACE.finditer(text):
        if brace[0] == "{":
            head = re.split(r"[;{}]", text[max(0, brace.start() - 300) : brace.start()])[-1]
            is_type = TYPE.search(head) and "(" not in head
            opened.append((brace.end(), not is_type and not any(own for _, own in opened)))
        elif brace[0] == "}" and opened:
            begin, is_function = opened.pop()
            if is_function:
                yield begin, brace.start()


def without_names_of_cpp(lines):
    """Their tokens; variables by numbers, but for members of others and what is called."""
    tokens, numbers, found = TOKEN.findall("\n".join(lines)), {}, []
    for before, token, after in zip([""] + tokens, tokens, tokens[1:] + [""]):
        is_name = re.match(r"[a-z_]", token) and token not in WORDS
        if is_name and before not in (".", "->", "::") and after not in ("(", "::", "<"):
            token = numbers.setdefault(token, f"v{len(numbers)}")
        found.append(token)
    return " ".join(found)


def runs_of_cpp(text):
    """(line, tokens without names of variables) of all runs of lines within functions."""
    text = bare(text)
    for begin, end in functions_of_cpp(text):
        first = text.count("\n", 0, begin) + 1
        lines = [
            (first + number, line.strip())
            for number, line in enumerate(text[begin:end].split("\n"))
            if re.search(r"\w", line)
        ]
        for k in range(len(lines) - RUN + 1):
            run = [line for _, line in lines[k : k + RUN]]
            if sum(map(len, run)) >= RUN * LEAST_LINE:
                yield lines[k][0], without_names_of_cpp(run)


def twins(sources, parts):
    """Places of parts that are the same: lists of two or more; of what is in several files, the
    first of each set of files."""
    homes = defaultdict(list)
    for name, text in sources:
        for line, part in parts(text):
            homes[part].append((name, line))
    found = {}
    for places in homes.values():
        if len(places) > 1:
            found.setdefault(tuple(name for name, _ in places), places)
    return [[f"{name}:{line}" for name, line in places] for places in found.values()]


def sources_of(folders, endings):
    for folder in folders:
        for path in sorted((ROOT / folder).rglob("*")):
            if path.suffix in endings:
                yield str(path.relative_to(ROOT)), path.read_text(encoding="utf-8")


FUNCTION = '''
def {name}({given}):
    """{words}"""
    {found} = [{given}.mesh.points[k] for k in range(len({given}.mesh.points)) if k % 2 == 0]
    return sorted({found}, key=lambda {one}: {one}[0] + {one}[1] + {number})
'''
CODE = """
namespace hull {{
double {name}(const Mesh& mesh) {{
  double {sum} = 0.0;  // {words}
  for (const Face& {face} : mesh.faces()) {{
    const Vector3d normal = {face}.normal().normalized();
    const double height = normal.dot({face}.centroid());
    if (height > mesh.size() * kTolerance) continue;
    {sum} += height * {face}.area() / {number};
  }}
  return std::abs({sum}) + mesh.volume_of_closings();
}}
}}
"""


@pytest.mark.parametrize(
    "parts, pattern, own, other",
    [
        (
            parts_of_python,
            FUNCTION,
            {"name": "even", "given": "surface", "found": "points", "one": "p", "words": "Even"},
            {"name": "second", "given": "hull", "found": "them", "one": "q", "words": "Others"},
        ),
        (
            runs_of_cpp,
            CODE,
            {"name": "volume", "sum": "sum", "face": "face", "words": "m³"},
            {"name": "content", "sum": "total", "face": "each", "words": "of all"},
        ),
    ],
    ids=["Python", "C++"],
)
def test_twins_are_found(parts, pattern, own, other):
    first = pattern.format(number=3, **own)
    same, different = pattern.format(number=3, **other), pattern.format(number=4, **other)
    assert twins([("a", first), ("b", same)], parts)
    assert not twins([("a", first), ("b", different)], parts)


def test_python_has_no_twins():
    assert twins(sources_of(PYTHON, (".py",)), parts_of_python) == []


def test_cpp_has_no_twins():
    assert twins(sources_of(CPP, (".h", ".cpp")), runs_of_cpp) == []
