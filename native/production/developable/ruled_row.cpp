// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/developable/ruled_row.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "mesh/tolerances.h"
#include "surface/eigenbasis/neighbourhood.h"
#include "surface/pieces/point_weights.h"

namespace hull::production {

namespace {

using mesh::Topology;

// Bézier points from the values of a cubic at 0, 1/3, 2/3 and 1.
Eigen::Matrix4d bezier_of_values() {
  Eigen::Matrix4d bernstein;
  for (int i = 0; i < 4; ++i) {
    const double t = i / 3.0, s = 1.0 - t;
    bernstein.row(i) << s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t;
  }
  return bernstein.inverse();
}

// The surface's point on a half-edge of the control mesh, s of the way along.
std::vector<surface::PointWeight> on_edge(surface::PointWeights& weights, const Topology& control,
                                          int h, double s) {
  // An edge is the side of two cells: along u of that at its origin, backwards along v of the next
  // corner's.
  if (s <= 0.5) return weights.at(h, 2.0 * s, 0.0);
  return weights.at(control.next(h), 0.0, 2.0 * (1.0 - s));
}

using Rows = std::array<std::map<int, double>, 4>;  // of Bézier points, by control point

Rows bezier_rows(surface::PointWeights& weights, const Topology& control, int h, bool backwards) {
  // The curve along an edge is one cubic unless a dart is at its end: four of its points tell it.
  static const Eigen::Matrix4d from_values = bezier_of_values();
  Rows rows;
  for (int j = 0; j < 4; ++j) {
    const double s = backwards ? 1.0 - j / 3.0 : j / 3.0;
    // All is linear in the control points: Bezier points are sums of the curve's points, and these
    // of control points.
    for (const auto& [point, weight] : on_edge(weights, control, h, s)) {
      for (int i = 0; i < 4; ++i) rows[i][point] += from_values(i, j) * weight;
    }
  }
  return rows;
}

std::string named(int face) { return "Face " + std::to_string(face); }

// Whether all control points that a face's surface is made of lie in one plane: the surface is that
// plane then, whatever the rules.
bool is_flat(const surface::LimitSurface& surface, surface::PointWeights& weights, int face) {
  const mesh::ControlMesh& mesh = surface.mesh();
  const int first = mesh.topology().first_half_edge(face);
  const auto corner = [&](int i) { return mesh.points()[mesh.topology().origin(first + i)]; };
  const Vector3d normal = (corner(2) - corner(0)).cross(corner(3) - corner(1)).normalized();
  if (normal.norm() == 0.0) return false;
  // A cell for each corner; in its middle all of its points count.
  for (int i = 0; i < 4; ++i) {
    for (const surface::PointWeight& one : weights.at(first + i, 0.5, 0.5)) {
      const double off = normal.dot(mesh.points()[one.point] - corner(0));
      if (std::abs(off) > kInPlane * mesh.size()) return false;
    }
  }
  return true;
}

// Refuses a face whose surface is more than the rulings between its sides' curves. At each step of
// the subdivision the point of a side across must be the mean of its ends' new points: so it is
// where these have no face but the row's two beside them, or, at the row's end, are corners, and
// where the face beyond has its middle, too, halfway between its creases.
void check_ruled(const surface::LimitSurface& surface, surface::PointWeights& weights, int face,
                 int side) {
  const Topology& control = surface.mesh().topology();
  const int first = control.first_half_edge(face);
  for (int i = 0; i < 4; ++i) {
    if (surface::is_regular_corner(control, first + i) || is_flat(surface, weights, face)) continue;
    throw std::invalid_argument(named(face) + " is not of straight lines at its point " +
                                std::to_string(control.origin(first + i)) +
                                ", where knuckles bend or meet beside the row: leave the face out, "
                                "or, at the row's end, make the point a corner.");
  }
  for (const int across : {first + (side + 1) % 4, first + (side + 3) % 4}) {
    const int beyond = control.is_crease(across) ? -1 : control.twin(across);
    if (beyond < 0 || control.face_size(control.face(beyond)) == 4) continue;
    if (is_flat(surface, weights, face)) continue;
    throw std::invalid_argument(named(face) + " is not of straight lines beside face " +
                                std::to_string(control.face(beyond)) +
                                ", which has not four points: leave the face out, too.");
  }
}

// Which of the sides 0 and 1 of a face runs along the chains; -1 if neither can.
class Sides {
 public:
  Sides(const surface::LimitSurface& surface, const std::vector<int>& faces)
      : surface_(surface),
        control_(surface.mesh().topology()),
        faces_(faces.begin(), faces.end()) {}

  int along(int face) const {
    const int h = control_.first_half_edge(face);
    const bool first = may(h), second = may(h + 1);
    if (first != second) return first ? 0 : 1;
    if (!first) return -1;
    // The row goes on across sides that are no creases; here all are.
    // Where the chains run along side 0 the row goes on across sides 1 and 3.
    const auto goes_on = [&](int side) { return is_inside(h + side) || is_inside(h + side + 2); };
    if (goes_on(0) != goes_on(1)) return goes_on(1) ? 0 : 1;
    return length(h) + length(h + 2) >= length(h + 1) + length(h + 3) ? 0 : 1;
  }

 private:
  bool may(int h) const { return control_.is_crease(h) && control_.is_crease(h + 2); }
  bool is_inside(int h) const {
    return control_.twin(h) >= 0 && faces_.contains(control_.face(control_.twin(h)));
  }
  double length(int h) const {
    const auto& points = surface_.mesh().points();
    return (points[control_.origin(control_.next(h))] - points[control_.origin(h)]).norm();
  }

  const surface::LimitSurface& surface_;
  const Topology& control_;
  std::set<int> faces_;
};

}  // namespace

RuledRow::RuledRow(const surface::LimitSurface& surface, const std::vector<int>& faces) {
  if (faces.empty()) {
    throw std::invalid_argument("A developable region needs faces between two knuckles.");
  }
  const Topology& control = surface.mesh().topology();
  const Sides sides(surface, faces);
  surface::PointWeights weights(surface);
  std::vector<std::array<Rows, 2>> rows;
  std::set<int> own, all;
  for (const int face : faces) {
    if (face < 0 || face >= control.face_count()) {
      throw std::invalid_argument(named(face) + " is none of the mesh.");
    }
    if (control.face_size(face) != 4) {
      throw std::invalid_argument(named(face) +
                                  " has not four points: a developable region is a row of "
                                  "quadrilaterals between two knuckles.");
    }
    const int side = sides.along(face);
    if (side < 0) {
      throw std::invalid_argument(
          named(face) +
          " does not lie between two knuckles: make the edges along two opposite "
          "sides of the row knuckles, with one row of faces between.");
    }
    const int h = control.first_half_edge(face) + side;
    const int other = control.first_half_edge(face) + (side + 2) % 4;
    for (const int corner : {h, control.next(h), other, control.next(other)}) {
      if (control.kind_at(corner) == mesh::VertexKind::kDart) {
        throw std::invalid_argument(named(face) +
                                    " lies where a knuckle fades out: let the "
                                    "knuckle go on, or leave the face out.");
      }
      own.insert(control.origin(corner));
    }
    check_ruled(surface, weights, face, side);
    // The opposite side runs against this one: backwards, so that rulings join equal parameters.
    rows.push_back(
        {bezier_rows(weights, control, h, false), bezier_rows(weights, control, other, true)});
    for (const Rows& curve : rows.back()) {
      for (const auto& row : curve) {
        for (const auto& entry : row) all.insert(entry.first);
      }
    }
  }
  all.insert(own.begin(), own.end());
  points_.assign(all.begin(), all.end());
  for (const int p : points_) is_own_.push_back(own.contains(p));
  // Few points count for a face's curves: matrices over these alone, not over all of the row's.
  for (std::size_t k = 0; k < rows.size(); ++k) {
    Span span{faces[k], {}, {}, {}};
    std::set<int> used;
    for (const Rows& curve : rows[k]) {
      for (const auto& row : curve) {
        for (const auto& [point, weight] : row) {
          used.insert(static_cast<int>(std::lower_bound(points_.begin(), points_.end(), point) -
                                       points_.begin()));
        }
      }
    }
    span.points.assign(used.begin(), used.end());
    for (const bool second : {false, true}) {
      Eigen::MatrixXd& m = second ? span.b : span.a;
      m.setZero(4, static_cast<int>(span.points.size()));
      for (int i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < span.points.size(); ++j) {
          const auto& row = rows[k][second ? 1 : 0][i];
          const auto found = row.find(points_[span.points[j]]);
          if (found != row.end()) m(i, static_cast<int>(j)) = found->second;
        }
      }
    }
    spans_.push_back(std::move(span));
  }
}

BezierSpan RuledRow::curve(int k, bool second, const std::vector<Vector3d>& control) const {
  const Span& span = spans_[k];
  const Eigen::MatrixXd& m = second ? span.b : span.a;
  BezierSpan curve;
  for (int i = 0; i < 4; ++i) {
    curve[i].setZero();
    for (std::size_t j = 0; j < span.points.size(); ++j) {
      curve[i] += m(i, static_cast<int>(j)) * control[points_[span.points[j]]];
    }
  }
  return curve;
}

}  // namespace hull::production
