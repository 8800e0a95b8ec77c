// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/exact/grading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "conversion/blocks/block_places.h"
#include "conversion/exact/corner_grading.h"
#include "conversion/exact/exact_patches.h"
#include "mesh/groups.h"

namespace hull::conversion {
namespace {

constexpr int kFirstGrading = 2, kFirstWithInner = 3;
// CAD systems take knots closer together than 1e-9 for one; in files they are a thousand times
// farther apart.
constexpr double kClosestKnots = 1e-10;
constexpr double kReserve = 0.8;  // of the tolerances: measurements are at samples
// With more halvings rounding is seen: control points of neighbouring knots are close together.
constexpr int kManyHalvings = 12;
// Of an angle that is too large: knots within the corner squares make it as much smaller at best.
constexpr double kWithinReach = 20.0;
// Of the time: the search for gradings; the rest is for the patches.
constexpr double kSearchShare = 0.6;

CornerLimits limits_of(const surface::LimitSurface& surface, const ExactOptions& options) {
  const double in_proportion =
      0.02 * std::numbers::pi / 180.0 * std::sqrt(options.tolerance / 1e-6);
  return {kReserve * options.tolerance * surface.mesh().box().sizes().maxCoeff(),
          kReserve * (options.seam_angle > 0.0 ? options.seam_angle : in_proportion)};
}

class Grader {
 public:
  Grader(const surface::LimitSurface& surface, const BlockLayout& layout,
         const ExactOptions& options)
      : surface_(surface),
        cells_(surface.cells()),
        layout_(layout),
        options_(options),
        limits_(limits_of(surface, options)),
        groups_(cells_.vertex_count()),
        is_irregular_(cells_.vertex_count(), 0),
        fans_(cells_.vertex_count()) {
    find_groups();
  }

  std::vector<BSplinePatch> patches(const surface::Progress& progress) {
    search_ = surface::part_of(progress, 0.0, kSearchShare);
    find_gradings();
    Gradings gradings;
    for (int i = 0; i < cells_.vertex_count(); ++i) gradings.push_back(of_group_[groups_.find(i)]);
    const surface::Progress second = surface::part_of(progress, kSearchShare, 1.0);
    std::vector<BSplinePatch> result;
    for (const Block& block : layout_.blocks) {
      surface::tell(second, static_cast<double>(result.size()),
                    static_cast<double>(layout_.blocks.size()));
      result.push_back(exact_patch(surface_, block, gradings));
      for (int k = 0; k < 4; ++k) take_net(corner(block, k), k, result.back());
    }
    return result;
  }

 private:
  // The half-edge that leaves corner k of a block along its side k.
  int corner(const Block& block, int k) const { return block.half_edges(cells_, k).front(); }

  // Irregular points that sides of blocks join have one grading, for knots run through patches.
  void find_groups() {
    std::vector<double> most(cells_.vertex_count(), 1.0);  // cells along a block's side there
    for (const Block& block : layout_.blocks) {
      std::array<int, 4> corners{};
      for (int k = 0; k < 4; ++k) {
        const int h = corner(block, k);
        corners[k] = begins_at_irregular_knot(surface_, h) ? cells_.origin(h) : -1;
      }
      for (int k = 0; k < 4; ++k) {
        if (corners[k] < 0) continue;
        is_irregular_[corners[k]] = 1;
        const int next = corners[(k + 1) % 4];
        if (next >= 0) groups_.join(corners[k], next);
        double& longest = most[corners[k]];
        longest = std::max<double>(longest, std::max(block.count_u, block.count_v));
      }
    }
    last_.assign(most.size(), kMostGrading);
    for (std::size_t i = 0; i < most.size(); ++i) {
      int& last = last_[groups_.find(static_cast<int>(i))];
      // There are knots within the corner squares as well.
      // 2^-k of a cell is 2^-k / most of the patch.
      const int here = static_cast<int>(-std::log2(kClosestKnots * most[i])) - kMostInner;
      last = std::min(last, std::max(here, kFirstGrading));
    }
  }

  // Each group has the halvings that the worst of its points needs, and more knots within the
  // squares where halvings alone do not do.
  void find_gradings() {
    of_group_.assign(cells_.vertex_count(),
                     Grading{options_.grading > 0 ? options_.grading : kFirstGrading});
    std::vector<int> points;
    for (int i = 0; i < cells_.vertex_count(); ++i) {
      if (is_irregular_[i]) points.push_back(i);
    }
    for (std::size_t k = 0; k < points.size(); ++k) {
      searched_ = static_cast<double>(k) / static_cast<double>(points.size());
      raise(points[k]);
    }
    settle(points);
    if (options_.grading > 0) return;
    for (int inner = 2; inner <= kMostInner; ++inner) add_inner_knots(points, inner);
  }

  // Begins anew, with more knots within the squares, where limits are not kept yet and where they
  // are with very many halvings; these stay as they were if that misses the limits.
  void add_inner_knots(const std::vector<int>& points, int inner) {
    const auto misses = [](const GradedFan& fan) { return fan.excess() > 1.0; };
    const auto is_worth_it = [&](const GradedFan& fan) {
      return moved_points(fan.fan.count(), inner) <= kMostMoved &&
             (misses(fan) ? fan.outlook < kWithinReach : fan.grading.halvings > kManyHalvings);
    };
    const std::vector<char> missed = groups_with(points, misses);
    const std::vector<char> tried = groups_with(points, is_worth_it);
    if (std::ranges::count(tried, 1) == 0) return;
    const std::vector<Grading> gradings_before = of_group_;
    const std::vector<GradedFan> fans_before = fans_;
    for (std::size_t i = 0; i < tried.size(); ++i) {
      if (tried[i]) of_group_[i] = {kFirstWithInner, inner};
    }
    settle(points);
    const std::vector<char> still_missed = groups_with(points, misses);
    for (int point : points) {
      const int group = groups_.find(point);
      // A group that kept its limits before, with many halvings, goes back to that.
      if (missed[group] || !still_missed[group]) continue;
      of_group_[group] = gradings_before[group];
      fans_[point] = fans_before[point];
    }
  }

  // Per group, whether one of its fans is such.
  template <class Such>
  std::vector<char> groups_with(const std::vector<int>& points, const Such& such) {
    std::vector<char> found(of_group_.size(), 0);
    for (int point : points) {
      if (such(fans_[point])) found[groups_.find(point)] = 1;
    }
    return found;
  }

  // Fits those whose group has changed again, until none changes any more.
  void settle(const std::vector<int>& points) {
    // Gradings only rise, and not beyond the last one.
    for (bool changed = true; changed;) {
      changed = false;
      for (int point : points) {
        if (fans_[point].grading == of_group_[groups_.find(point)]) continue;
        raise(point);
        changed = true;
      }
    }
  }

  // Raises the group's halvings to what the point needs.
  void raise(int point) {
    surface::tell(search_, searched_, 1.0);
    Grading& grading = of_group_[groups_.find(point)];
    // With a grading given, first and last are the same: squares are fitted, nothing is searched
    // for.
    const int last = options_.grading > 0 ? grading.halvings : last_[groups_.find(point)];
    fans_[point] = least_graded_fan(surface_, point, limits_, grading, last);
    grading = fans_[point].grading;
  }

  // The points that may be chosen at corner k of a patch, where half-edge h leaves.
  void take_net(int h, int k, BSplinePatch& patch) const {
    const int vertex = cells_.origin(h);
    if (!is_irregular_[vertex]) return;
    const SquareFan& fan = fans_[vertex].fan;
    const auto found = std::ranges::find(fan.half_edges, h) - fan.half_edges.begin();
    // In this block the point may be regular, as beyond a crease.
    if (!fan.graded[found]) return;
    const CornerNet& net = fan.nets[found];
    for (int i = 0; i <= net.inner; ++i) {
      for (int j = 0; j <= net.inner; ++j) {
        patch.control_points[patch.corner_index(k, i, j)] = net.at(i, j);
      }
    }
  }

  const surface::LimitSurface& surface_;
  const mesh::Topology& cells_;
  const BlockLayout& layout_;
  const ExactOptions& options_;
  CornerLimits limits_;
  mesh::Groups groups_;  // of irregular vertices with one grading
  std::vector<char> is_irregular_;
  std::vector<int> last_;  // of groups, the most halvings
  std::vector<Grading> of_group_;
  std::vector<GradedFan> fans_;  // per vertex, of the irregular ones
  surface::Progress search_;
  double searched_ = 0.0;
};

}  // namespace

std::vector<BSplinePatch> graded_patches(const surface::LimitSurface& surface,
                                         const BlockLayout& layout, const ExactOptions& options,
                                         const surface::Progress& progress) {
  return Grader(surface, layout, options).patches(progress);
}

}  // namespace hull::conversion
