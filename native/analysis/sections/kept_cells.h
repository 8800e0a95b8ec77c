// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

namespace hull::analysis {

// Calls visit(cell, entry, has_moved), in order, for cells that have moved and those of which
// something is kept; entry: what is, or null. Both lists are in order; cell_of(entry) is its cell.
template <class Entry, class CellOf, class Visit>
void for_each_moved_or_kept(const std::vector<int>& moved, const std::vector<Entry>& kept,
                            const CellOf& cell_of, const Visit& visit) {
  constexpr int kNone = std::numeric_limits<int>::max();
  auto next_moved = moved.begin();
  auto next_kept = kept.begin();
  while (true) {
    const int moved_cell = next_moved == moved.end() ? kNone : *next_moved;
    const int kept_cell = next_kept == kept.end() ? kNone : cell_of(*next_kept);
    const int cell = std::min(moved_cell, kept_cell);
    if (cell == kNone) return;
    visit(cell, cell == kept_cell ? &*next_kept : nullptr, cell == moved_cell);
    if (cell == moved_cell) ++next_moved;
    if (cell == kept_cell) ++next_kept;
  }
}

}  // namespace hull::analysis
