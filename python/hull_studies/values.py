# SPDX-License-Identifier: GPL-3.0-or-later
"""Values of a description that may be a variable of the study: "$name" stands for its value.

All checks take the CheckedJson of the study, the value, the key that an error names, and the
names of the variables; they raise HullFileError.
"""

MARK = "$"
_FARTHEST = 1e9


def is_variable(value):
    return isinstance(value, str) and value.startswith(MARK)


def number(check, value, where, variables, lowest=-_FARTHEST, highest=_FARTHEST):
    """A float, or "$name" of a variable."""
    if not is_variable(value):
        return check.number(value, where, lowest, highest)
    if value[len(MARK) :] not in variables:
        known = ", ".join(MARK + name for name in variables) or "there are none"
        raise check.error(where, f'"{value[:40]}" is no variable', f"variables: {known}")
    return value


def numbers(check, value, where, variables, length=None, most=10_000):
    """A list of such."""
    value = check.list(value, where, length, most)
    return [number(check, one, f"{where}[{k}]", variables) for k, one in enumerate(value)]


def resolved(value, values):
    """A description with the values {name: float} in the variables' places."""
    if is_variable(value):
        return values[value[len(MARK) :]]
    if isinstance(value, dict):
        return {key: resolved(one, values) for key, one in value.items()}
    if isinstance(value, list):
        return [resolved(one, values) for one in value]
    return value


def used_variables(value):
    """Names of the variables that a description has somewhere."""
    if is_variable(value):
        return {value[len(MARK) :]}
    if isinstance(value, dict):
        value = list(value.values())
    return set().union(*map(used_variables, value)) if isinstance(value, list) else set()
