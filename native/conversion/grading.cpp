// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/grading.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "conversion/groups.h"
#include "conversion/near_point.h"

namespace hull {
namespace {

constexpr int kFirstGrading = 3;
// Beyond this knots lie closer together than the 1e-9 that CAD systems tell apart.
constexpr int kLastGrading = 16;
constexpr double kUseful = 0.97;  // a halving that leaves more of an error is the last one
// Of the corner square.
constexpr std::array<double, 7> kPlaces{0.0, 0.04, 0.12, 0.24, 0.4, 0.65, 0.9};

std::array<double, 2> corner_uv(int k) {
  return {k == 1 || k == 2 ? 1.0 : 0.0, k >= 2 ? 1.0 : 0.0};
}

// A place a along half-edge h and b away from it, both from its begin.
CellPoint place_beside(int h, double a, double b) {
  switch (h % 4) {
    case 0:
      return {h / 4, a, b};
    case 1:
      return {h / 4, 1.0 - b, a};
    case 2:
      return {h / 4, 1.0 - a, 1.0 - b};
    default:
      return {h / 4, b, 1.0 - a};
  }
}

// The same place of the block's patch, from the corner where side k begins.
std::array<double, 2> place_in_patch(const Block& block, int k, double a, double b) {
  const auto [u0, v0] = corner_uv(k);
  const auto [along, across] = k % 2 == 0 ? std::pair(a, b) : std::pair(b, a);
  const double u = along / block.count_u, v = across / block.count_v;
  return {u0 == 0.0 ? u : 1.0 - u, v0 == 0.0 ? v : 1.0 - v};
}

double angle_between(const Vector3d& one, const Vector3d& two) {
  return std::atan2(one.cross(two).norm(), one.dot(two));
}

double largest_extent(const ControlMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& point : mesh.points()) box.extend(point);
  return box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
}

class Grader {
 public:
  Grader(const LimitSurface& surface, const BlockLayout& layout, const ExactOptions& options)
      : surface_(surface),
        layout_(layout),
        distance_(options.tolerance * largest_extent(surface.mesh())),
        angle_(options.seam_angle),
        groups_(surface.cells().vertex_count()),
        gradings_(surface.cells().vertex_count(), kFirstGrading),
        before_(gradings_.size(), std::numeric_limits<double>::infinity()) {
    if (angle_ == 0.0) {
      angle_ = 0.02 * std::numbers::pi / 180.0 * std::sqrt(options.tolerance / 1e-6);
    }
    find_corners();
  }

  std::vector<BSplinePatch> patches() {
    const std::size_t count = layout_.blocks.size();
    std::vector<BSplinePatch> result(count);
    std::vector<char> is_old(count, 1);
    while (std::ranges::count(is_old, 1) > 0) {
      std::vector<double> found(gradings_.size(), 0.0);  // of groups, the largest excess
      for (std::size_t p = 0; p < count; ++p) {
        if (!is_old[p]) continue;
        result[p] = exact_patch(surface_, layout_.blocks[p], gradings_);
        for (int k = 0; k < 4; ++k) {
          if (corners_[p][k] < 0) continue;
          double& largest = found[groups_.find(corners_[p][k])];
          largest = std::max(largest, excess(layout_.blocks[p], result[p], k));
        }
      }
      refine(found, is_old);
    }
    return result;
  }

 private:
  void find_corners() {
    const Topology& cells = surface_.cells();
    for (const Block& block : layout_.blocks) {
      std::array<int, 4> corners{};
      for (int k = 0; k < 4; ++k) {
        const int h = block.half_edges(cells, k).front();
        const auto [u, v] = corner_uv(h % 4);
        corners[k] = surface_.is_irregular_knot(h / 4, u, v) ? cells.origin(h) : -1;
      }
      for (int k = 0; k < 4; ++k) {
        const int next = corners[(k + 1) % 4];
        if (corners[k] >= 0 && next >= 0) groups_.join(corners[k], next);
      }
      corners_.push_back(corners);
    }
  }

  // The larger of both errors as a share of what is allowed.
  double excess(const Block& block, const BSplinePatch& patch, int k) {
    const int grading =
        gradings_[surface_.cells().origin(block.half_edges(surface_.cells(), k).front())];
    const CornerError error = corner_error(surface_, block, patch, k, grading);
    // Normals on squares smaller than the tolerance are nobody's concern.
    if (error.extent < distance_) return error.distance / distance_;
    return std::max(error.distance / distance_, error.angle / (0.5 * angle_));
  }

  // Halves once more where that is wanted, and the last time was of use: where sides meet at 180
  // degrees, normals at the corner itself are lost in rounding.
  void refine(const std::vector<double>& found, std::vector<char>& is_old) {
    std::vector<char> changed(gradings_.size(), 0);
    for (std::size_t i = 0; i < gradings_.size(); ++i) {
      const double excess = found[groups_.find(static_cast<int>(i))];
      if (!(excess > 1.0) || excess > kUseful * before_[i] || gradings_[i] >= kMostGrading)
        continue;
      before_[i] = excess;
      ++gradings_[i];
      changed[i] = 1;
    }
    for (std::size_t p = 0; p < is_old.size(); ++p) {
      is_old[p] = std::ranges::any_of(corners_[p], [&](int c) { return c >= 0 && changed[c]; });
    }
  }

  const LimitSurface& surface_;
  const BlockLayout& layout_;
  double distance_, angle_;
  Groups groups_;  // of irregular vertices with one grading
  Gradings gradings_;
  std::vector<double> before_;               // the excess found at the grading before
  std::vector<std::array<int, 4>> corners_;  // per block, its irregular vertices or -1
};

}  // namespace

CornerError corner_error(const LimitSurface& surface, const Block& block, const BSplinePatch& patch,
                         int k, int grading) {
  const int h = block.half_edges(surface.cells(), k).front();
  const double size = std::exp2(-grading), enough = 1e-13 * surface.mesh().size();
  CornerError error;
  const auto at = [&](double share) {
    const auto [u, v] = place_in_patch(block, k, share * size, share * size);
    return patch.position(u, v);
  };
  error.extent = (at(1.0) - at(0.0)).norm();
  for (double a : kPlaces) {
    for (double b : kPlaces) {
      const auto [u, v] = place_in_patch(block, k, a * size, b * size);
      const bool on_side = a == 0.0 || b == 0.0;
      const SurfaceJet jet = patch.evaluate(u, v);
      const NearPoint near =
          near_point(surface, jet.point, place_beside(h, a * size, b * size), enough);
      error.distance = std::max(error.distance, near.distance);
      if (!on_side) continue;
      const Vector3d exact = surface.normal(near.place.cell, near.place.u, near.place.v);
      const Vector3d normal = jet.du.cross(jet.dv);
      // Cone tips and cusps have none.
      if (exact.isZero() || normal.isZero()) continue;
      error.angle = std::max(error.angle, angle_between(exact, normal));
    }
  }
  return error;
}

std::vector<BSplinePatch> graded_patches(const LimitSurface& surface, const BlockLayout& layout,
                                         const ExactOptions& options) {
  return Grader(surface, layout, options).patches();
}

}  // namespace hull
