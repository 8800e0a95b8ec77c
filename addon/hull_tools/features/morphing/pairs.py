# SPDX-License-Identifier: GPL-3.0-or-later
"""Which lines of the layout and of a parent are one line in the family, as lists that are corrected
by hand: what is corrected counts from the next fit on."""

import colorsys

# From one pair's colour to the next: far from those before, however many there are.
_GOLDEN = 0.61803398875


def give_features(group, graph):
    """Stores the features of a hull_native.FeatureGraph, by number and name."""
    group.features.clear()
    for number in range(len(graph.features)):
        feature = group.features.add()
        feature.number, feature.name = number, _told(graph, number)


def _told(graph, number):
    """A feature by its number, from 1 on, with its place."""
    return f"{number + 1}: {graph.described(number).removeprefix('the ')}"


def give_pairs(entry, match, graph, other, apart):
    """Stores the pairs of a hull_native.FeatureMatch of the layout's FeatureGraph and a parent's,
    and those (first, second) that were held apart."""
    entry.pairs.clear()
    entry.apart.clear()
    for first, second, _, is_given in match.pairs:
        _add(entry.pairs, graph, other, first, second).is_given = is_given
    for first, second in apart:
        _add(entry.apart, graph, other, first, second)
    _give_colours(entry)


def _add(pairs, graph, other, first, second):
    roles = graph.features[first].role, other.features[second].role
    pair = pairs.add()
    pair.first, pair.second, pair.name = first, second, _pair_told(first, second, *roles)
    return pair


def _pair_told(first, second, role, other):
    """In few letters: a sidebar is narrow."""
    numbers = f"{first + 1}–{second + 1}"
    return f"{numbers} {role}" if role == other else f"{numbers} {role}, {other}"


def _give_colours(entry):
    for number, pair in enumerate(entry.pairs):
        pair.colour = colorsys.hsv_to_rgb((0.05 + _GOLDEN * number) % 1.0, 0.85, 0.85)


def chosen_parent(obj):
    """The parent that is chosen in the list, and has lines to be paired; ValueError without one."""
    morph = obj.hull.morph
    if not 0 <= morph.active_parent < len(morph.parents):
        raise ValueError("Choose a parent first")
    entry = morph.parents[morph.active_parent]
    if not entry.features:
        raise ValueError(f"{entry.name} gave the layout: choose another parent")
    return entry


def add(obj):
    """Pairs the chosen lines of the layout and of the chosen parent; pairs that either of them was
    in go. Returns the pair."""
    morph, entry = obj.hull.morph, chosen_parent(obj)
    first = _number(morph.features, morph.feature, "the layout")
    second = _number(entry.features, entry.feature, entry.name)
    _remove_from(entry.apart, lambda pair: (pair.first, pair.second) == (first, second))
    _remove_from(entry.pairs, lambda pair: pair.first == first or pair.second == second)
    roles = _role_of(morph.features[first]), _role_of(entry.features[second])
    pair = entry.pairs.add()
    pair.first, pair.second, pair.name = first, second, _pair_told(first, second, *roles)
    pair.is_given, morph.has_other_pairs = True, True
    entry.active_pair = len(entry.pairs) - 1
    _give_colours(entry)
    obj.update_tag(refresh={"DATA"})
    return entry.pairs[entry.active_pair]


def _number(features, name, whose):
    found = features.get(name)
    if found is None:
        raise ValueError(f"Choose a line of {whose} first")
    return found.number


def _short_of(feature):
    """Of "3: knuckle from (…) to (…)" the words before the place."""
    return f"{feature.number + 1} {_role_of(feature)}"


def _role_of(feature):
    return feature.name.split(" from ")[0].partition(": ")[2]


def _remove_from(pairs, is_one):
    for index in reversed(range(len(pairs))):
        if is_one(pairs[index]):
            pairs.remove(index)


def remove(obj):
    """Holds the two lines of the chosen pair apart."""
    entry = chosen_parent(obj)
    if not 0 <= entry.active_pair < len(entry.pairs):
        raise ValueError("Choose a pair first")
    pair = entry.pairs[entry.active_pair]
    held = entry.apart.add()
    held.first, held.second, held.name = pair.first, pair.second, pair.name
    entry.pairs.remove(entry.active_pair)
    entry.active_pair = max(min(entry.active_pair, len(entry.pairs) - 1), 0)
    obj.hull.morph.has_other_pairs = True
    obj.update_tag(refresh={"DATA"})


def forget_corrections(obj):
    """Lines are paired by role, order and place alone from the next fit on."""
    morph = obj.hull.morph
    for entry in morph.parents:
        entry.apart.clear()
        for pair in entry.pairs:
            pair.is_given = False
    morph.has_other_pairs = True
    obj.update_tag(refresh={"DATA"})


def corrections(morph):
    """(pairs, apart) as hull_native.common_layout takes them, by the number of the parent."""
    given, apart = {}, {}
    for number, entry in enumerate(morph.parents):
        given[number] = [(pair.first, pair.second) for pair in entry.pairs if pair.is_given]
        apart[number] = [(pair.first, pair.second) for pair in entry.apart]
    return given, apart


def alone(morph, entry):
    """(names of the layout's lines, names of a parent's) without counterpart, in short."""
    own = {pair.first for pair in entry.pairs}
    other = {pair.second for pair in entry.pairs}
    return (
        [_short_of(feature) for feature in morph.features if feature.number not in own],
        [_short_of(feature) for feature in entry.features if feature.number not in other],
    )
