// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/exact/exact_patches.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <string>

#include "conversion/blocks/block_spans.h"
#include "conversion/exact/blossom.h"

namespace hull::conversion {
namespace {

// Of the mesh's size: a smaller jump of third differences is none.
constexpr double kSmooth = 1e-13;
// In spans: farther from the span that control points are computed from, rounding grows with the
// cube of the distance.
constexpr double kLongestInterval = 2.0;

// The knots of one direction.
struct KnotLine {
  std::vector<double> lines;  // distinct knots
  std::vector<int> places;    // of BlockSpans, one in each interval

  int intervals() const { return static_cast<int>(places.size()); }
  int count() const { return intervals() + 3; }
  // Knot k of the clamped vector.
  double knot(int k) const { return lines[std::clamp(k - 3, 0, intervals())]; }
  int intervals_to_end(int k) const { return std::min(k, intervals() - 1 - k); }
  // The intervals on which function i lives, those around its middle first.
  std::array<int, 4> support(int i) const {
    const auto within = [this](int k) { return std::clamp(k, 0, intervals() - 1); };
    return {within(i - 2), within(i - 1), within(i - 3), within(i)};
  }
};

Vector3d third_difference(const BlockSpan& span, int row, bool along_u) {
  const auto point = [&](int k) -> const Vector3d& {
    return span.points[along_u ? 4 * row + k : 4 * k + row];
  };
  // The third derivative of the cubic: spans of one size, whose second ones agree at their common
  // line, are one polynomial if it is the same.
  return point(3) - 3.0 * (point(2) - point(1)) - point(0);
}

// Whether the surface is the same polynomial on both sides of two neighbouring spans' common side.
bool is_smooth(const BlockSpan& a, const BlockSpan& b, bool along_u, double tolerance) {
  if (a.is_in_corner || b.is_in_corner || a.size != b.size) return false;
  for (int row = 0; row < 4; ++row) {
    const Vector3d jump = third_difference(a, row, along_u) - third_difference(b, row, along_u);
    if (jump.cwiseAbs().maxCoeff() > tolerance) return false;
  }
  return true;
}

// The lines that the surface needs as knots.
KnotLine knot_line(const BlockSpans& spans, bool along_u, double tolerance) {
  const std::vector<double>& all = along_u ? spans.lines_u() : spans.lines_v();
  const int across = static_cast<int>((along_u ? spans.places_v() : spans.places_u()).size());
  const auto span_at = [&](int k, int l) { return along_u ? spans.at(k, l) : spans.at(l, k); };
  KnotLine knots{{all.front()}, {0}};
  for (int k = 1; k + 1 < static_cast<int>(all.size()); ++k) {
    bool removable = true;
    for (int l = 0; l < across && removable; ++l) {
      const BlockSpan *a = span_at(k - 1, l), *b = span_at(k, l);
      // None is the smallest square at an irregular corner, around which all knots stay.
      removable = a && b && (a == b || is_smooth(*a, *b, along_u, tolerance)) &&
                  all[k + 1] - knots.lines.back() <= kLongestInterval * b->size;
    }
    if (removable) continue;
    knots.lines.push_back(all[k]);
    knots.places.push_back(k);
  }
  knots.lines.push_back(all.back());
  return knots;
}

class PatchBuilder {
 public:
  PatchBuilder(const surface::LimitSurface& surface, const Block& block, const Gradings& gradings)
      : surface_(surface),
        block_(block),
        spans_(surface, block, gradings),
        u_(knot_line(spans_, true, kSmooth * surface.mesh().size())),
        v_(knot_line(spans_, false, kSmooth * surface.mesh().size())) {}

  BSplinePatch build() const {
    BSplinePatch patch;
    patch.count_u = u_.count();
    patch.count_v = v_.count();
    patch.knots_u = clamped_knots(u_);
    patch.knots_v = clamped_knots(v_);
    patch.cell = block_.sides.front() / 4;
    for (int i = 0; i < u_.count(); ++i) {
      for (int j = 0; j < v_.count(); ++j) patch.control_points.push_back(control_point(i, j));
    }
    return patch;
  }

 private:
  static std::vector<double> clamped_knots(const KnotLine& line) {
    std::vector<double> knots;
    for (int k = 0; k < line.count() + 4; ++k) knots.push_back(line.knot(k) / line.lines.back());
    return knots;
  }

  // From a span of the surface if the function lives on one outside the corner squares. Else it
  // lives within one of these: then it is the point at a corner, or from the span there that is
  // farthest from that.
  Vector3d control_point(int i, int j) const {
    const bool at_end_u = i == u_.count() - 1, at_end_v = j == v_.count() - 1;
    if ((i == 0 || at_end_u) && (j == 0 || at_end_v)) return corner_point(at_end_u, at_end_v);
    const BlockSpan* inner = nullptr;
    int farthest = -1;
    for (int a : u_.support(i)) {
      for (int b : v_.support(j)) {
        const BlockSpan* span = spans_.at(u_.places[a], v_.places[b]);
        if (span && !span->is_in_corner) return point_from(*span, i, j);
        const int far = u_.intervals_to_end(a) + v_.intervals_to_end(b);
        if (span && far > farthest) {
          inner = span;
          farthest = far;
        }
      }
    }
    assert(inner);
    return point_from(*inner, i, j);
  }

  Vector3d point_from(const BlockSpan& span, int i, int j) const {
    const auto weights = [&](const KnotLine& line, int k, double begin) {
      const auto local = [&](int m) { return (line.knot(m) - begin) / span.size; };
      // A control point is the blossom of its span at the three knots that its function has within.
      return blossom_weights(local(k + 1), local(k + 2), local(k + 3));
    };
    return blossom(span.points, weights(u_, i, span.u), weights(v_, j, span.v));
  }

  // The surface's point at a corner of the block, (1, 0) for the end of its side v = 0.
  Vector3d corner_point(bool at_end_u, bool at_end_v) const {
    const int side =
        block_.side(at_end_u ? block_.count_u - 1 : 0, at_end_v ? block_.count_v - 1 : 0);
    const int corner = (side + (at_end_v ? (at_end_u ? 2 : 3) : (at_end_u ? 1 : 0))) % 4;
    return surface_.position(side / 4, corner == 1 || corner == 2, corner >= 2);
  }

  const surface::LimitSurface& surface_;
  const Block& block_;
  BlockSpans spans_;
  KnotLine u_, v_;
};

}  // namespace

BSplinePatch exact_patch(const surface::LimitSurface& surface, const Block& block, int grading) {
  return exact_patch(surface, block, Gradings(surface.cells().vertex_count(), Grading{grading}));
}

BSplinePatch exact_patch(const surface::LimitSurface& surface, const Block& block,
                         const Gradings& gradings) {
  for (const Grading& grading : gradings) {
    if (grading.halvings >= kLeastGrading && grading.halvings <= kMostGrading) continue;
    throw std::invalid_argument(
        "The grading of patches must be between " + std::to_string(kLeastGrading) + " and " +
        std::to_string(kMostGrading) + ", not " + std::to_string(grading.halvings) + ".");
  }
  return PatchBuilder(surface, block, gradings).build();
}

}  // namespace hull::conversion
