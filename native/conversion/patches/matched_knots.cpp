// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/patches/matched_knots.h"

#include <algorithm>
#include <array>
#include <vector>

#include "conversion/patches/edge_uses.h"
#include "conversion/patches/patch_rows.h"

namespace hull::conversion {
namespace {

// The distinct knots of a patch in one direction, rising, and those of them that are new.
struct KnotList {
  std::vector<double> all, added;

  explicit KnotList(const std::vector<double>& knots) : all(knots) {
    all.erase(std::unique(all.begin(), all.end()), all.end());
  }
  bool add(double t) {
    const auto next = std::lower_bound(all.begin(), all.end(), t - kSameKnot);
    if (next != all.end() && *next <= t + kSameKnot) return false;
    all.insert(next, t);
    added.push_back(t);
    return true;
  }
};

class KnotMatcher {
 public:
  explicit KnotMatcher(PatchSet& set) : set_(set) {
    for (const BSplinePatch& patch : set.patches) {
      lists_.push_back({KnotList(patch.knots_u), KnotList(patch.knots_v)});
    }
  }

  void match() {
    const EdgeUses uses(set_);
    // Comes to an end: a knot keeps its place between the sides of cells, so that a row of cells
    // takes it once, and once more turned round.
    for (bool changed = true; changed;) {
      changed = false;
      for (int edge = 0; edge < set_.edge_count; ++edge) {
        const auto& [one, two] = uses.of(edge);
        if (two.patch < 0) continue;
        if (carry(one, two)) changed = true;
        if (carry(two, one)) changed = true;
      }
    }
    // Once all are known: insertion goes through whole patches.
    for (std::size_t p = 0; p < lists_.size(); ++p) insert(p);
  }

 private:
  // Adds the knots within an edge to those on its other side. Whether any was new there.
  bool carry(const EdgeUse& from, const EdgeUse& to) {
    const SideEdge &a = part(from), &b = part(to);
    bool changed = false;
    // A copy: a patch may be on both sides of an edge.
    const std::vector<double> knots = list(from).all;
    for (double knot : knots) {
      const double s = from.side < 2 ? knot : 1.0 - knot;
      const double t = (s - a.begin) / (a.end - a.begin);
      if (!(t > kSameKnot && t < 1.0 - kSameKnot)) continue;
      // The two parts run against each other.
      const double other = b.end - t * (b.end - b.begin);
      if (list(to).add(to.side < 2 ? other : 1.0 - other)) changed = true;
    }
    return changed;
  }

  void insert(std::size_t p) {
    const auto with = [](const std::vector<double>& added) {
      return [&added](BSplineCurve curve) {
        for (double t : added) curve.insert_knot(t);
        return curve;
      };
    };
    BSplinePatch& patch = set_.patches[p];
    const auto& [u, v] = lists_[p];
    if (!u.added.empty()) patch = with_rows_along_u(patch, with(u.added));
    if (!v.added.empty()) patch = with_rows_along_v(patch, with(v.added));
  }

  const SideEdge& part(const EdgeUse& use) const {
    return set_.sides[use.patch][use.side][use.part];
  }
  KnotList& list(const EdgeUse& use) { return lists_[use.patch][use.side % 2]; }

  PatchSet& set_;
  std::vector<std::array<KnotList, 2>> lists_;  // of each patch, along u and v
};

}  // namespace

void match_knots(PatchSet& set) { KnotMatcher(set).match(); }

}  // namespace hull::conversion
