# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether two builds of hull_native give the same results for the samples, to the last bit.

export PYTHONPATH=build/release/python:python:samples
python3 scripts/compare_results.py --write FILE [SAMPLE ...]
python3 scripts/compare_results.py FILE [FILE]

Writes all results of results/ to FILE; or compares those of the module in the path, or of
a second file, with FILE's. Told is each result that is not bit-equal, with its largest difference,
that in relation to the greatest number of the result too. Ends with 1 where there is one.
--only SUBJECT: these subjects alone. FILE is JSON: of each result the number of values, a hash,
and the numbers packed.
"""

import argparse
import base64
import hashlib
import json
import re
import sys
import time
import zlib
from pathlib import Path

import numpy as np

_DECIMAL = re.compile(r"[-+]?\d*\.\d+(?:[eE][-+]?\d+)?|[-+]?\d+\.(?:[eE][-+]?\d+)?")


# --- results as rows of numbers ---


def leaves(value, path=""):
    """Pairs (path, array or text) of all that a result holds; items of a list share a path."""
    if value is None or isinstance(value, str):
        yield path, str(value)
    elif isinstance(value, (bool, int, float, complex, np.generic, np.ndarray)):
        yield path, np.asarray(value)
    elif isinstance(value, dict):
        for key, part in value.items():
            yield from leaves(part, f"{path}.{key}")
    elif isinstance(value, (list, tuple)):
        for part in value:
            yield from leaves(part, path + "[]")
    else:
        names = _properties(type(value))
        if not names:
            raise TypeError(f"{path}: {type(value).__name__} holds nothing to compare")
        for name in names:
            yield from leaves(getattr(value, name), f"{path}.{name}")


def _properties(kind):
    return [
        name
        for name in dir(kind)
        if not name.startswith("_") and isinstance(getattr(kind, name), property)
    ]


def records(result):
    """What is kept of a result: for each path within it a dict."""
    found = {}
    for path, leaf in leaves(result):
        words, numbers = found.setdefault(path, ([], []))
        if isinstance(leaf, str):
            words.append(_DECIMAL.sub("#", leaf))
            numbers.append(np.array(_DECIMAL.findall(leaf), dtype=float))
        else:
            words.append(f"{leaf.dtype.kind}{leaf.shape}")
            numbers.append(_as_doubles(leaf.ravel()))
    return {path: _record(words, numbers) for path, (words, numbers) in found.items()}


def _as_doubles(leaf):
    """All of a row's numbers as doubles: parts of complex ones, and of integers that are too large
    for one, what that rounds them to and what it leaves."""
    if leaf.dtype.kind == "c":
        return np.stack([leaf.real, leaf.imag], axis=-1).ravel()
    if leaf.dtype.kind in "iu" and (leaf.astype(float).astype(object) != leaf.astype(object)).any():
        exact = [int(value) for value in leaf]
        return np.array([part for n in exact for part in (float(n), float(n - int(float(n))))])
    return leaf


def _record(words, numbers):
    values = np.concatenate(numbers).astype("<f8")
    return {
        "count": len(values),
        "form": hashlib.sha256("\n".join(words).encode()).hexdigest(),
        "hash": hashlib.sha256(values.tobytes()).hexdigest(),
        "numbers": base64.b64encode(zlib.compress(values.tobytes(), 1)).decode("ascii"),
    }


def computed(samples, subjects):
    """Records by "sample: subject: result" of the module in the path."""
    import results
    import vessels

    found = {}
    for name in samples or vessels.names():
        vessel = vessels.vessel(name)
        for subject in subjects or results.SUBJECTS:
            start = time.process_time()
            for result, value in results.SUBJECTS[subject](vessel):
                for path, record in records(value).items():
                    found[f"{name}: {subject}: {result}{path}"] = record
            print(f"{name}: {subject}, {time.process_time() - start:.1f} s", file=sys.stderr)
    return found


# --- comparison ---


def numbers_of(record):
    return np.frombuffer(zlib.decompress(base64.b64decode(record["numbers"])), dtype="<f8")


def difference(before, after):
    """In words; None where both are bit-equal."""
    if (before["form"], before["count"]) != (after["form"], after["count"]):
        return f"other shape or words ({before['count']} numbers before, {after['count']} now)"
    if before["hash"] == after["hash"]:
        return None
    old, new = numbers_of(before), numbers_of(after)
    defined = np.isfinite(old) & np.isfinite(new)
    same = (old == new) | (np.isnan(old) & np.isnan(new))
    if (~same & ~defined).any():
        return f"{(~same & ~defined).sum()} of {len(old)} numbers are defined in one only"
    largest = np.abs(old - new)[defined].max(initial=0.0)
    if not largest:
        return f"{len(old)} numbers: only the sign of zeros differs"
    scale = np.abs(old[defined]).max()
    relative = f"{largest / scale:.1e} of the greatest" if scale else "all were 0"
    return f"{(~same).sum()} of {len(old)} numbers differ, by up to {largest:.3g} ({relative})"


def renamed(key, names):
    """A result's name with those parts renamed that have an earlier name."""
    for old, new in names.items():
        key = re.sub(rf"\.{new}\b", f".{old}", key)
    return key


def compare(before, after):
    """Tells all differences; how many there are."""
    found = equal = 0
    for key in [*before, *(key for key in after if key not in before)]:
        if key in before and key in after:
            told = difference(before[key], after[key])
        else:
            told = "before only" if key in before else "now only"
        if told:
            found += 1
            print(f"{key}: {told}")
        else:
            equal += 1
    print(f"{equal} of {len(before)} results are bit-equal, {found} differ")
    return found


def _check_known(parser, what, names, known):
    for name in names:
        if name not in known:
            parser.error(f"there is no {what} {name!r}; these are: {', '.join(known)}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--write", type=Path, metavar="FILE")
    parser.add_argument("--only", action="append", metavar="SUBJECT")
    parser.add_argument("rest", nargs="*", metavar="FILE or SAMPLE")
    given = parser.parse_args()
    from results import RENAMED, SUBJECTS

    _check_known(parser, "subject", given.only or [], SUBJECTS)
    if given.write:
        import vessels

        _check_known(parser, "sample", given.rest, vessels.names())
        given.write.write_text(json.dumps(computed(given.rest, given.only)), encoding="ascii")
        return
    if not 1 <= len(given.rest) <= 2:
        parser.error("give the file of the results before, or two files")
    before, *others = (json.loads(Path(path).read_text(encoding="ascii")) for path in given.rest)
    samples = list(dict.fromkeys(key.split(": ")[0] for key in before))
    after = others[0] if others else computed(samples, given.only)
    # Either may be from before a change of names or from after it.
    before, after = (
        {
            renamed(key, RENAMED): row
            for key, row in rows.items()
            if not given.only or key.split(": ")[1] in given.only
        }
        for rows in (before, after)
    )
    sys.exit(1 if compare(before, after) else 0)


if __name__ == "__main__":
    main()
