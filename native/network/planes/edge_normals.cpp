// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/planes/edge_normals.h"

#include <algorithm>
#include <cmath>

namespace hull::network {
namespace {

constexpr double kMostRatio = 8.0;    // of neighbouring edges that tell each other's slopes
constexpr double kSameNormal = 1e-9;  // of unit normals of one plane

// Of all edges, and whether what is at their ends is told there.
struct Side {
  std::vector<NormalField> fields;
  std::vector<bool> starts_told, ends_told;
  std::vector<bool> is_known;  // of edges: whether fields follow from what is told anywhere
};

// From planes of nodes to fields along pieces of curves, for both sides of all edges at once: where
// there is no crease the two come out alike.
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
    for (Side* side : {&left_, &right_}) {
      side->fields.resize(count);
      side->starts_told.resize(count);
      side->ends_told.resize(count);
      side->is_known.resize(count);
    }
    for (std::size_t node = 0; node < joined_.nodes.size(); ++node) set_ends(node);
    for (std::size_t edge = 0; edge < count; ++edge) copy_beyond(edge);
    for (Side* side : {&left_, &right_}) set_slopes(*side);
    // What passes at a node is known by the field along its curve, and that by nodes that tell: so
    // fields are made once without what they lend, and once with it.
    bool is_more_told = false;
    for (std::size_t node = 0; node < joined_.nodes.size(); ++node) {
      is_more_told = take_from_passing(node) || is_more_told;
    }
    if (is_more_told) {
      for (Side* side : {&left_, &right_}) set_slopes(*side);
    }
    for (std::size_t edge = 0; edge < count; ++edge) share_slopes(edge);
    normals_.left = std::move(left_.fields);
    normals_.right = std::move(right_.fields);
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
    const auto& told = normals_.planes[node].is_told;
    for (std::size_t i = 0; i < around.size(); ++i) {
      const auto edge = static_cast<std::size_t>(around[i].edge);
      const std::size_t after = i, before = (i + around.size() - 1) % around.size();
      // What follows an end counterclockwise is to the left of an edge that begins there, and to
      // the right of one that ends there.
      if (around[i].is_start) {
        left_.fields[edge].start = sectors[after];
        right_.fields[edge].start = sectors[before];
        left_.starts_told[edge] = told[after];
        right_.starts_told[edge] = told[before];
      } else {
        left_.fields[edge].end = sectors[before];
        right_.fields[edge].end = sectors[after];
        left_.ends_told[edge] = told[before];
        right_.ends_told[edge] = told[after];
      }
    }
  }

  // What an end has in the sector that is counterclockwise of it, or clockwise.
  struct End {
    Side& side;
    std::size_t edge;
    bool is_start;

    Vector3d& normal() const {
      NormalField& field = side.fields[edge];
      return is_start ? field.start : field.end;
    }
    void set_told() const { (is_start ? side.starts_told : side.ends_told)[edge] = true; }
  };
  End end_of(const EdgeEnd& end, bool is_after) {
    return {end.is_start == is_after ? left_ : right_, static_cast<std::size_t>(end.edge),
            end.is_start};
  }

  // Where a curve only passes, and its plane is not told by the edges that end on it under small
  // angles, they have the plane that the curve has there by what its other nodes tell.
  bool take_from_passing(std::size_t node) {
    const auto& around = order_.around[node];
    const TangentPlanes& planes = normals_.planes[node];
    const std::size_t count = around.size();
    const auto is_open = [&](std::size_t sector) {
      return !planes.is_told[sector] && !planes.normals[sector].isZero(0.0);
    };
    bool is_taken = false;
    for (std::size_t first = 0; first < count; ++first) {
      // The end that begins what is not told, with the passing curve.
      const std::size_t before = (first + count - 1) % count;
      if (!is_open(first) || (is_open(before) && !planes.is_crease[first])) continue;
      const End passing = end_of(around[first], true);
      // What none of the passing curve's nodes tells is not told here, either.
      if (!passing.side.is_known[passing.edge]) continue;
      for (std::size_t i = 1; i < count; ++i) {
        const std::size_t at = (first + i) % count;
        // As far round as nothing is told, and no crease is crossed.
        if (!is_open(at) || planes.is_crease[at]) break;
        // On both of its sides, which are one surface.
        for (bool is_after : {false, true}) {
          const End inner = end_of(around[at], is_after);
          inner.normal() = passing.normal();
          inner.set_told();
        }
        is_taken = true;
      }
    }
    return is_taken;
  }

  // Beyond the border the surface goes on as it is.
  void copy_beyond(std::size_t edge) {
    const auto copy = [edge](Side& to, const Side& from) {
      to.fields[edge] = from.fields[edge];
      to.starts_told[edge] = from.starts_told[edge];
      to.ends_told[edge] = from.ends_told[edge];
    };
    if (region(edge, true) < 0) copy(left_, right_);
    if (region(edge, false) < 0) copy(right_, left_);
  }

  bool follow(std::size_t edge) const {
    if (edge + 1 >= joined_.edges.size()) return false;
    const CurveEdge &a = joined_.edges[edge], &b = joined_.edges[edge + 1];
    return a.curve == b.curve && a.piece == b.piece && a.to == b.from && a.high == b.low;
  }

  // Edges one after the other, between which no node tells of a plane: the field is one.
  struct Span {
    std::size_t first, last;
    double width;
    NormalField field;
    bool is_known;
  };

  std::vector<Span> spans_of(const Side& side) const {
    std::vector<Span> spans;
    for (std::size_t e = 0; e < side.fields.size(); ++e) {
      Span span{e, e, 0.0, side.fields[e], false};
      while (follow(e) && !side.ends_told[e] && !side.starts_told[e + 1]) ++e;
      span.last = e;
      // By the curve's own parameter, which runs on evenly from edge to edge.
      span.width = joined_.edges[e].high - joined_.edges[span.first].low;
      span.field.end = side.fields[e].end;
      const bool has_start = side.starts_told[span.first], has_end = side.ends_told[e];
      if (has_end && !has_start) span.field.start = carried(span.field.end, span.first, true);
      if (has_start && !has_end) span.field.end = carried(span.field.start, e, false);
      span.is_known = has_start || has_end;
      spans.push_back(span);
    }
    return spans;
  }

  // What is told at one end of a span, where nothing is at the other.
  Vector3d carried(const Vector3d& normal, std::size_t edge, bool is_start) const {
    const Vector3d tangent = shapes_[edge].tangent_from(is_start);
    return (normal - normal.dot(tangent) * tangent).normalized();
  }

  // The edges of a piece of a curve are one after the other; a crease across it parts them.
  void set_slopes(Side& side) {
    std::vector<Span> spans = spans_of(side);
    const std::size_t count = spans.size();
    std::vector<Vector3d> rise(count);
    for (std::size_t s = 0; s < count; ++s) {
      // Slopes by the curve's parameter, by which neighbours are compared; those of edges come
      // last.
      rise[s] = (spans[s].field.end - spans[s].field.start) / spans[s].width;
    }
    // What normals of nodes differ by, over a short edge, tells nothing of a long one.
    const auto goes_on = [&](std::size_t s) {
      return s + 1 < count && follow(spans[s].last) &&
             (spans[s].field.end - spans[s + 1].field.start).norm() <= kSameNormal &&
             spans[s].width < kMostRatio * spans[s + 1].width &&
             spans[s + 1].width < kMostRatio * spans[s].width;
    };
    for (std::size_t s = 0; s < count; ++s) {
      const bool has_before = s > 0 && goes_on(s - 1), has_after = goes_on(s);
      const auto at_joint = [&](std::size_t a) {
        // That of the parabola through the normals at three nodes, at the middle one (Bessel).
        const double one = spans[a].width, other = spans[a + 1].width;
        return Vector3d((other * rise[a] + one * rise[a + 1]) / (one + other));
      };
      Vector3d start = rise[s], end = rise[s];
      if (has_before) start = at_joint(s - 1);
      if (has_after) end = at_joint(s);
      // A parabola's slope rises evenly.
      if (!has_before && has_after) start = 2.0 * rise[s] - end;
      if (has_before && !has_after) end = 2.0 * rise[s] - start;
      spans[s].field.start_slope = spans[s].width * start;
      spans[s].field.end_slope = spans[s].width * end;
      divide(spans[s], side);
    }
  }

  // The span's field over each of its edges.
  void divide(const Span& span, Side& side) const {
    const double low = joined_.edges[span.first].low;
    for (std::size_t e = span.first; e <= span.last; ++e) {
      side.is_known[e] = span.is_known;
      const CurveEdge& edge = joined_.edges[e];
      const NormalJet start = span.field.at((edge.low - low) / span.width);
      const NormalJet end = span.field.at((edge.high - low) / span.width);
      // A part of a cubic is a cubic: dividing it loses nothing.
      const double part = (edge.high - edge.low) / span.width;
      NormalField& field = side.fields[e];
      field.start = start.normal;
      field.end = end.normal;
      field.start_slope = part * start.slope;
      field.end_slope = part * end.slope;
    }
  }

  void share_slopes(std::size_t edge) {
    NormalField &left = left_.fields[edge], &right = right_.fields[edge];
    normals_.is_crease.push_back((left.start - right.start).norm() > kSameNormal ||
                                 (left.end - right.end).norm() > kSameNormal);
    if (normals_.is_crease[edge]) return;
    // Where the curve goes on as a crease its sides have slopes of their own; along this edge there
    // is one surface.
    left.start_slope = 0.5 * (left.start_slope + right.start_slope);
    left.end_slope = 0.5 * (left.end_slope + right.end_slope);
    right = left;
  }

  const JoinedCurves& joined_;
  const std::vector<EdgeShape>& shapes_;
  const NodeOrder& order_;
  const RegionFaces& faces_;
  Side left_, right_;
  EdgeNormals normals_;
};

}  // namespace

NormalJet NormalField::at(double u) const {
  // Hermite's cubic, which is of unit length at its ends alone.
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
