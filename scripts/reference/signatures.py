# SPDX-License-Identifier: GPL-3.0-or-later
"""What a compiled module offers, as its docstrings tell it: classes, functions, properties."""

import inspect
import re
from dataclasses import dataclass

_SIGNATURE = re.compile(r"^(\w+)\((.*)\) -> (.+)$")
_OVERLOAD = re.compile(r"^\d+\. (?=\w+\()", re.MULTILINE)
_OPENING, _CLOSING = "([{<", ")]}>"


@dataclass(frozen=True)
class Argument:
    """kind: of Python's type as the docstring has it, "" for * and self. default: as the docstring
    has it, None without one."""

    name: str
    kind: str
    default: object


@dataclass(frozen=True)
class Function:
    """One way of calling a function or method, and what its docstring says of it."""

    name: str
    arguments: tuple
    returns: str
    text: str


@dataclass(frozen=True)
class Property:
    name: str
    kind: str
    is_writable: bool
    text: str


@dataclass(frozen=True)
class Class:
    """functions: a list of all ways of calling each method."""

    name: str
    bases: tuple
    text: str
    properties: tuple
    functions: tuple


def functions_of(name, doc):
    """The Functions of a docstring as pybind11 makes it; ValueError where it has no signature."""
    parts = _OVERLOAD.split(doc)[1:] if "Overloaded function." in doc else [doc]
    return tuple(_function(name, part) for part in parts)


def _function(name, text):
    first, _, rest = text.partition("\n")
    found = _SIGNATURE.match(first.strip())
    if not found:
        raise ValueError(f"{name}: its docstring does not begin with a signature: {first!r}")
    arguments = tuple(_argument(part) for part in split(found[2]))
    return Function(name, arguments, found[3].strip(), rest.strip())


def split(text, separator=","):
    """Parts of a text between commas that are outside brackets and quotes, stripped."""
    parts, depth, quote, last = [], 0, "", 0
    for k, character in enumerate(text):
        if quote:
            quote = "" if character == quote else quote
        elif character in "'\"":
            quote = character
        elif character in _OPENING:
            depth += 1
        elif character in _CLOSING and text[k - 1 : k + 1] != "->":
            depth -= 1
        elif character == separator and not depth:
            parts.append(text[last:k].strip())
            last = k + 1
    return [part for part in (*parts, text[last:].strip()) if part]


def _argument(text):
    head, *default = split(text, "=")
    name, _, kind = head.partition(":")
    return Argument(name.strip(), kind.strip(), default[0] if default else None)


def class_of(cls):
    """The Class of a class that pybind11 made."""
    properties, functions = [], []
    for name, value in vars(cls).items():
        if isinstance(value, property):
            properties.append(_property(name, value))
        elif isinstance(value, staticmethod):
            functions.append(functions_of(name, value.__func__.__doc__ or ""))
        elif callable(value) and (not name.startswith("_") or name == "__init__"):
            doc = value.__doc__ or ""
            if "->" in doc:
                functions.append(functions_of(name, doc))
    bases = tuple(base.__name__ for base in cls.__bases__ if not base.__name__.startswith("pybind"))
    text = inspect.cleandoc(cls.__doc__ or "")
    return Class(cls.__name__, bases, text, tuple(properties), tuple(functions))


def _property(name, value):
    # Some getters are told with their name, others without.
    told = (value.fget.__doc__ or "").strip()
    kind = told.rsplit(" -> ", 1)[1] if " -> " in told else "object"
    return Property(name, kind.strip(), value.fset is not None, (value.__doc__ or "").strip())


def members(module):
    """(classes, functions, other values by name) that a compiled module itself has."""
    classes, functions, values = [], [], {}
    for name, value in vars(module).items():
        if name.startswith("_"):
            continue
        if inspect.isclass(value):
            if value.__module__.startswith(module.__name__) or value.__bases__ != (object,):
                classes.append(class_of(value))
        elif callable(value):
            functions.append(functions_of(name, value.__doc__ or ""))
        else:
            values[name] = value
    return classes, functions, values
