// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/segments/segment_search.h"

#include <algorithm>
#include <cmath>

namespace hull::production {
namespace {

// Of penalties and sums of roots: cuts as good as one another differ by it, according to the order
// in which their parts were summed. The next measure, and at last the order of the search, decides.
constexpr double kRounding = 1e-9;

}  // namespace

SegmentSearch::SegmentSearch(const SegmentGrid& grid, const surface::Progress& progress)
    : grid_(grid) {
  double boxes = 1.0, numbers = 1.0;
  for (int a = 0; a < 3; ++a) {
    layers_[a] = static_cast<int>(grid.planes()[a].size()) - 1;
    boxes *= 0.5 * layers_[a] * (layers_[a] + 1.0);
    numbers *= (layers_[a] + 1.0) * (layers_[a] + 1.0);
  }
  found_.resize(static_cast<std::size_t>(numbers));
  double done = 0.0;
  // By rising sizes along each axis: both parts of a box, smaller along one and equal along the
  // others, are known before it.
  SegmentBox box;
  for (int x = 1; x <= layers_[0]; ++x) {
    for (int y = 1; y <= layers_[1]; ++y) {
      for (int z = 1; z <= layers_[2]; ++z) {
        surface::tell(progress, done, boxes);
        for (int i = 0; i + x <= layers_[0]; ++i) {
          for (int j = 0; j + y <= layers_[1]; ++j) {
            for (int k = 0; k + z <= layers_[2]; ++k) {
              box = {{i, j, k}, {i + x, j + y, k + z}};
              found_[number(box)] = searched(box);
              done += 1.0;
            }
          }
        }
      }
    }
  }
}

SegmentBox SegmentSearch::whole() const { return {{0, 0, 0}, layers_}; }

std::size_t SegmentSearch::number(const SegmentBox& box) const {
  std::size_t result = 0;
  for (int a = 0; a < 3; ++a) {
    const std::size_t planes = layers_[a] + 1;
    // Two digits for each axis, of as many values as it has planes: pairs that are no boxes have
    // numbers, too.
    result = (result * planes + box.low[a]) * planes + box.high[a];
  }
  return result;
}

bool SegmentSearch::is_better(const Best& a, const Best& b) const {
  const double slack = kRounding * (1.0 + a.penalty);
  if (a.penalty < b.penalty - slack) return true;
  if (a.penalty > b.penalty + slack) return false;
  if (a.count != b.count) return a.count < b.count;
  return a.roots > b.roots * (1.0 + kRounding);
}

SegmentSearch::Best SegmentSearch::searched(const SegmentBox& box) const {
  const SegmentVerdict verdict = grid_.judged(box);
  // An empty box is no segment and costs nothing.
  if (verdict.direction < 0) return {};
  Best best{verdict.penalty, std::sqrt(std::max(0.0, grid_.volume(box))), 1, {}};
  // What can be made is not cut further: no cut can do better than no penalty.
  if (verdict.penalty == 0.0) return best;
  for (int a = 0; a < 3; ++a) {
    SegmentBox below = box, above = box;
    for (int plane = box.low[a] + 1; plane < box.high[a]; ++plane) {
      below.high[a] = above.low[a] = plane;
      const Best &p = found_[number(below)], &q = found_[number(above)];
      const Best both{p.penalty + q.penalty,
                      p.roots + q.roots,
                      p.count + q.count,
                      {static_cast<signed char>(a), static_cast<short>(plane)}};
      if (is_better(both, best)) best = both;
    }
  }
  return best;
}

}  // namespace hull::production
