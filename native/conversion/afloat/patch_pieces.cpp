// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/afloat/patch_pieces.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "conversion/patches/divide.h"

namespace hull::conversion {
namespace {

PatchSet checked_pieces(const PatchSet& set) {
  set.check();
  for (std::size_t p = 0; p < set.patches.size(); ++p) {
    const BSplinePatch& patch = set.patches[p];
    if (patch.degree_u == 3 && patch.degree_v == 3) continue;
    throw std::invalid_argument(
        "Patch " + std::to_string(p) + " is of degree " + std::to_string(patch.degree_u) + " by " +
        std::to_string(patch.degree_v) + ": sections and volumes are of bicubic patches.");
  }
  return divided(set, cuts_at_knots(set));
}

std::vector<double> with_both_ends(const std::vector<double>& cuts) {
  std::vector<double> lines{0.0};
  lines.insert(lines.end(), cuts.begin(), cuts.end());
  lines.push_back(1.0);
  return lines;
}

}  // namespace

PatchPieces::PatchPieces(const PatchSet& set)
    : set_(checked_pieces(set)), uses_(set_), size_(set.size()) {
  const std::vector<PatchCuts> cuts = cuts_at_knots(set);
  pieces_.reserve(set_.patches.size());
  for (std::size_t p = 0; p < cuts.size(); ++p) {
    const std::vector<double> u = with_both_ends(cuts[p].u), v = with_both_ends(cuts[p].v);
    for (std::size_t i = 1; i < u.size(); ++i) {
      for (std::size_t j = 1; j < v.size(); ++j) {
        // divided() has its pieces in the same order.
        const BSplinePatch& bezier = set_.patches[pieces_.size()];
        std::array<Vector3d, 16> points;
        std::ranges::copy(bezier.control_points, points.begin());
        pieces_.push_back({static_cast<int>(p), u[i - 1], v[j - 1], u[i] - u[i - 1],
                           v[j] - v[j - 1], uniform_points(points)});
      }
    }
  }
}

std::array<Vector3d, 4> uniform_points(const std::array<Vector3d, 4>& b) {
  // The inverse of (a + 4 b + c) / 6, (2 b + c) / 3, (b + 2 c) / 3, (b + 4 c + d) / 6.
  return {6.0 * b[0] - 7.0 * b[1] + 2.0 * b[2], 2.0 * b[1] - b[2], 2.0 * b[2] - b[1],
          2.0 * b[1] - 7.0 * b[2] + 6.0 * b[3]};
}

// Bézier points have v running fastest, spans' points u.
surface::BicubicPoints uniform_points(const std::array<Vector3d, 16>& bezier) {
  std::array<std::array<Vector3d, 4>, 4> rows;  // of one u each
  for (std::size_t i = 0; i < 4; ++i) {
    rows[i] = uniform_points(std::array<Vector3d, 4>{bezier[4 * i], bezier[4 * i + 1],
                                                     bezier[4 * i + 2], bezier[4 * i + 3]});
  }
  surface::BicubicPoints points;
  for (std::size_t j = 0; j < 4; ++j) {
    const auto along_u =
        uniform_points(std::array<Vector3d, 4>{rows[0][j], rows[1][j], rows[2][j], rows[3][j]});
    std::ranges::copy(along_u, points.begin() + static_cast<std::ptrdiff_t>(4 * j));
  }
  return points;
}

}  // namespace hull::conversion
