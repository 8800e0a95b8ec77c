// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/planes/edge_normals.h"

#include <algorithm>
#include <cmath>

namespace hull::network {
namespace {

constexpr double kMostRatio = 8.0;    // of neighbouring edges that tell each other's slopes
constexpr double kSameNormal = 1e-9;  // of unit normals of one plane

class NormalFields {
 public:
  NormalFields(const JoinedCurves& joined, const std::vector<EdgeShape>& shapes,
               const NodeOrder& order, const RegionFaces& faces)
      : joined_(joined), shapes_(shapes), order_(order), faces_(faces) {}

  EdgeNormals run(const std::vector<bool>& is_knuckle, double limit) {
    for (std::size_t node = 0; node < joined_.nodes.size(); ++node) {
      normals_.planes.push_back(tangent_planes(star_of(node, is_knuckle), limit));
    }
    const std::size_t count = joined_.edges.size();
    normals_.left.resize(count);
    normals_.right.resize(count);
    for (std::size_t node = 0; node < joined_.nodes.size(); ++node) set_ends(node);
    for (std::size_t edge = 0; edge < count; ++edge) set_crease(edge);
    for (auto* side : {&normals_.left, &normals_.right}) set_slopes(*side);
    for (std::size_t edge = 0; edge < count; ++edge) share_slopes(edge);
    return std::move(normals_);
  }

 private:
  int region(std::size_t edge, bool is_left) const {
    return faces_.region_of_side[2 * edge + (is_left ? 0 : 1)];
  }

  NodeStar star_of(std::size_t node, const std::vector<bool>& is_knuckle) const {
    NodeStar star;
    star.outwards = order_.normals[node];
    for (const EdgeEnd& end : order_.around[node]) {
      const auto edge = static_cast<std::size_t>(end.edge);
      const int curve = joined_.edges[edge].curve;
      star.directions.push_back(shapes_[edge].tangent_from(end.is_start));
      star.curves.push_back(curve);
      star.is_crease.push_back(is_knuckle[static_cast<std::size_t>(curve)]);
      // Counterclockwise of an end is what the edge has to its left, seen from its node.
      star.is_beyond.push_back(region(edge, end.is_start) < 0);
    }
    return star;
  }

  void set_ends(std::size_t node) {
    const auto& around = order_.around[node];
    const auto& sectors = normals_.planes[node].normals;
    for (std::size_t i = 0; i < around.size(); ++i) {
      const auto edge = static_cast<std::size_t>(around[i].edge);
      const Vector3d& after = sectors[i];
      const Vector3d& before = sectors[(i + around.size() - 1) % around.size()];
      NormalField &left = normals_.left[edge], &right = normals_.right[edge];
      if (around[i].is_start) {
        left.start = after;
        right.start = before;
      } else {
        left.end = before;
        right.end = after;
      }
    }
  }

  // Beyond the border the surface goes on as it is.
  void set_crease(std::size_t edge) {
    NormalField &left = normals_.left[edge], &right = normals_.right[edge];
    if (region(edge, true) < 0) left = right;
    if (region(edge, false) < 0) right = left;
    normals_.is_crease.push_back((left.start - right.start).norm() > kSameNormal ||
                                 (left.end - right.end).norm() > kSameNormal);
  }

  bool follow(std::size_t edge) const {
    if (edge + 1 >= joined_.edges.size()) return false;
    const CurveEdge &a = joined_.edges[edge], &b = joined_.edges[edge + 1];
    return a.curve == b.curve && a.piece == b.piece && a.to == b.from && a.high == b.low;
  }

  // The edges of a piece of a curve are one after the other; a crease across it parts them.
  void set_slopes(std::vector<NormalField>& side) {
    const std::size_t count = side.size();
    std::vector<Vector3d> rise(count);
    const auto width = [&](std::size_t e) { return joined_.edges[e].high - joined_.edges[e].low; };
    for (std::size_t e = 0; e < count; ++e) rise[e] = (side[e].end - side[e].start) / width(e);
    // What normals of nodes differ by, over a short edge, tells nothing of a long one.
    const auto goes_on = [&](std::size_t e) {
      return follow(e) && (side[e].end - side[e + 1].start).norm() <= kSameNormal &&
             width(e) < kMostRatio * width(e + 1) && width(e + 1) < kMostRatio * width(e);
    };
    for (std::size_t e = 0; e < count; ++e) {
      const bool has_before = e > 0 && goes_on(e - 1), has_after = goes_on(e);
      const auto at_joint = [&](std::size_t a) {
        return Vector3d((width(a + 1) * rise[a] + width(a) * rise[a + 1]) /
                        (width(a) + width(a + 1)));
      };
      Vector3d start = rise[e], end = rise[e];
      if (has_before) start = at_joint(e - 1);
      if (has_after) end = at_joint(e);
      // A parabola's slope rises evenly.
      if (!has_before && has_after) start = 2.0 * rise[e] - end;
      if (has_before && !has_after) end = 2.0 * rise[e] - start;
      side[e].start_slope = width(e) * start;
      side[e].end_slope = width(e) * end;
    }
  }

  void share_slopes(std::size_t edge) {
    if (normals_.is_crease[edge]) return;
    NormalField &left = normals_.left[edge], &right = normals_.right[edge];
    left.start_slope = 0.5 * (left.start_slope + right.start_slope);
    left.end_slope = 0.5 * (left.end_slope + right.end_slope);
    right = left;
  }

  const JoinedCurves& joined_;
  const std::vector<EdgeShape>& shapes_;
  const NodeOrder& order_;
  const RegionFaces& faces_;
  EdgeNormals normals_;
};

}  // namespace

NormalJet NormalField::at(double u) const {
  const double w = 1.0 - u;
  const double h0 = w * w * (1.0 + 2.0 * u), h1 = u * u * (3.0 - 2.0 * u);
  const double h2 = u * w * w, h3 = -u * u * w;
  return {h0 * start + h1 * end + h2 * start_slope + h3 * end_slope,
          6.0 * u * w * (end - start) + w * (1.0 - 3.0 * u) * start_slope +
              u * (3.0 * u - 2.0) * end_slope};
}

EdgeNormals edge_normals(const JoinedCurves& joined, const std::vector<EdgeShape>& shapes,
                         const NodeOrder& order, const RegionFaces& faces,
                         const std::vector<bool>& is_knuckle, double limit) {
  return NormalFields(joined, shapes, order, faces).run(is_knuckle, limit);
}

}  // namespace hull::network
