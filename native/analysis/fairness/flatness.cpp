// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/fairness/flatness.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "analysis/fairness/plane_fit.h"

namespace hull::analysis {
namespace {

constexpr int kFits = 50;
constexpr double kSmallDistance = 1e-9;  // of the size: below it distances weigh alike
// Of the size: by how much the furthest distance may be missed, a thousandth of kInPlane, which it
// is compared with.
constexpr double kExact = 1e-9;
constexpr int kDeepestSquare = 24;
constexpr double kSmallestSquare = 0x1p-30;

void sort_unique(std::vector<int>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

void check_indices(const std::vector<int>& indices, int count, const std::string& what) {
  if (indices.empty()) {
    throw std::invalid_argument("A part that is meant to be flat needs " + what +
                                "s: select some.");
  }
  for (const int index : indices) {
    if (index >= 0 && index < count) continue;
    throw std::invalid_argument("The mesh has no " + what + " " + std::to_string(index) + ".");
  }
}

// Iteratively reweighted least squares (Weiszfeld 1937) for the least sum of distances.
Plane plane_of_most(const std::vector<Vector3d>& points, double size, double tolerance) {
  std::vector<double> weights(points.size(), 1.0);
  PlaneFit fit = fit_plane(points, weights);
  for (int i = 0; i < kFits; ++i) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      // A square over its distance is a distance.
      weights[k] = 1.0 / std::max(std::abs(fit.plane.height(points[k])), kSmallDistance * size);
    }
    fit = fit_plane(points, weights);
  }
  std::vector<Vector3d> near;
  for (const Vector3d& p : points) {
    if (std::abs(fit.plane.height(p)) <= tolerance) near.push_back(p);
  }
  const auto spread_across = [size](const std::vector<Vector3d>& of, const PlaneFit& within) {
    double spread = 0.0;
    for (const Vector3d& p : of) {
      spread = std::max(spread, std::abs(within.across.dot(p - of.front())));
    }
    return spread > kSmallDistance * size;
  };
  // What is at fault has no say in the plane in the end, though it had a little in the sum of
  // distances.
  if (near.size() >= 3) {
    const PlaneFit finer = fit_plane(near);
    if (spread_across(near, finer)) return finer.plane;
  }
  if (!spread_across(points, fit)) {
    throw std::invalid_argument(
        "The control points lie in a line, which has no one plane: select more of them, or give a "
        "plane.");
  }
  return fit.plane;
}

// Looks for the point furthest from a plane.
class Furthest {
 public:
  Furthest(const surface::LimitSurface& surface, const Plane& plane)
      : surface_(surface), plane_(plane), exact_(kExact * surface.mesh().size()) {}

  void look_at(int cell) {
    surface::for_each_piece(
        surface_, cell,
        [&](const surface::CornerSquare& square) {
          double bound = 0.0;
          for (const Vector3d& p : square.points()) {
            bound = std::max(bound, std::abs(plane_.height(p)));
          }
          if (found_ && bound <= distance_ + exact_) return false;
          // What is left at the knot is no more than its own point.
          if (square.size <= kSmallestSquare) {
            take(cell, square.u > 0.0 ? 1.0 : 0.0, square.v > 0.0 ? 1.0 : 0.0);
            return false;
          }
          return true;
        },
        [&](const surface::SurfacePiece& piece) {
          look_at(piece, heights(piece.points, plane_, 0.0), {0.0, 0.0, 1.0}, 0);
        });
  }

  double distance() const { return distance_; }
  const Vector3d& point() const { return point_; }

 private:
  void take(int cell, double u, double v) {
    const Vector3d p = surface_.position(cell, u, v);
    const double distance = std::abs(plane_.height(p));
    // The first of equals stays; of distances of zero one has to be taken, too.
    if (distance < distance_ || (distance == distance_ && found_)) return;
    distance_ = distance;
    point_ = p;
    found_ = true;
  }

  void look_at(const surface::SurfacePiece& piece, const BezierBicubic& height,
               const surface::DomainSquare& square, int depth) {
    // Branch and bound: coefficients bound the height over a square, places known are reached.
    if (found_ && std::max(-height.lowest(), height.highest()) <= distance_ + exact_) return;
    const double u = square.u + 0.5 * square.size, v = square.v + 0.5 * square.size;
    for (const auto& at : {std::array{square.u, square.v}, std::array{u, v},
                           std::array{square.u + square.size, square.v},
                           std::array{square.u, square.v + square.size},
                           std::array{square.u + square.size, square.v + square.size}}) {
      take(piece.cell, std::min(piece.u + piece.size * at[0], 1.0),
           std::min(piece.v + piece.size * at[1], 1.0));
    }
    if (depth == kDeepestSquare) return;
    for (int i = 0; i < 4; ++i) {
      const surface::DomainSquare quarter{square.u + 0.5 * square.size * (i & 1),
                                          square.v + 0.5 * square.size * (i >> 1),
                                          0.5 * square.size};
      look_at(piece, height.quarter(i & 1, i >> 1), quarter, depth + 1);
    }
  }

  const surface::LimitSurface& surface_;
  const Plane& plane_;
  double exact_;
  double distance_ = 0.0;
  Vector3d point_ = Vector3d::Zero();
  bool found_ = false;
};

// The control points of the faces around those of the part, as far as creases let them through.
std::vector<int> points_around(const mesh::Topology& topology, const std::vector<int>& faces) {
  std::vector<int> around;
  const auto add_face = [&](int h) {
    const int face = topology.face(h), first = topology.first_half_edge(face);
    for (int k = first; k < first + topology.face_size(face); ++k) {
      around.push_back(topology.origin(k));
    }
  };
  for (const int face : faces) {
    const int first = topology.first_half_edge(face);
    for (int h = first; h < first + topology.face_size(face); ++h) {
      int at = mesh::turn_left(topology, h);
      for (; at >= 0 && at != h; at = mesh::turn_left(topology, at)) add_face(at);
      if (at == h) continue;
      // A crease ended the turn: the rest lies the other way round.
      for (at = mesh::turn_right(topology, h); at >= 0; at = mesh::turn_right(topology, at)) {
        add_face(at);
      }
    }
  }
  sort_unique(around);
  return around;
}

}  // namespace

FlatPart flat_part_of_faces(const surface::LimitSurface& surface, std::vector<int> faces) {
  const mesh::Topology& topology = surface.mesh().topology();
  check_indices(faces, topology.face_count(), "face");
  sort_unique(faces);
  FlatPart part{std::move(faces), {}};
  for (const int face : part.faces) {
    const int first = topology.first_half_edge(face);
    for (int h = first; h < first + topology.face_size(face); ++h) {
      part.vertices.push_back(topology.origin(h));
    }
  }
  sort_unique(part.vertices);
  return part;
}

FlatPart flat_part_of_vertices(const surface::LimitSurface& surface, std::vector<int> vertices) {
  const mesh::Topology& topology = surface.mesh().topology();
  check_indices(vertices, topology.vertex_count(), "control point");
  sort_unique(vertices);
  FlatPart part{{}, std::move(vertices)};
  for (int face = 0; face < topology.face_count(); ++face) {
    const int first = topology.first_half_edge(face);
    bool all = true;
    for (int h = first; h < first + topology.face_size(face) && all; ++h) {
      all = std::binary_search(part.vertices.begin(), part.vertices.end(), topology.origin(h));
    }
    if (all) part.faces.push_back(face);
  }
  return part;
}

Flatness flatness(const surface::LimitSurface& surface, const FlatPart& part,
                  const std::optional<Plane>& plane, double tolerance) {
  if (!(tolerance > 0.0) || !std::isfinite(tolerance)) {
    throw std::invalid_argument("The tolerance of flat parts must be a positive length, not " +
                                std::to_string(tolerance) + " m.");
  }
  const mesh::ControlMesh& mesh = surface.mesh();
  const mesh::Topology& topology = mesh.topology();
  std::vector<Vector3d> points;
  for (const int v : part.vertices) points.push_back(mesh.points()[v]);
  if (!plane && points.size() < 3) {
    throw std::invalid_argument(
        "Fewer than three control points have no one plane: select more of them, or give a plane.");
  }
  Flatness result;
  result.plane = plane ? *plane : plane_of_most(points, mesh.size(), tolerance);
  result.vertices = part.vertices;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double height = result.plane.height(points[i]);
    result.distances.push_back(height);
    result.control_distance = std::max(result.control_distance, std::abs(height));
    if (std::abs(height) > tolerance) result.at_fault.push_back(part.vertices[i]);
  }
  for (const int v : points_around(topology, part.faces)) {
    if (std::binary_search(part.vertices.begin(), part.vertices.end(), v)) continue;
    if (std::abs(result.plane.height(mesh.points()[v])) > tolerance) {
      result.neighbours_at_fault.push_back(v);
    }
  }
  Furthest furthest(surface, result.plane);
  for (const int face : part.faces) {
    const int first = topology.first_half_edge(face);
    // Cells are numbered as the half-edges of the control mesh.
    for (int cell = first; cell < first + topology.face_size(face); ++cell) furthest.look_at(cell);
  }
  result.surface_distance = furthest.distance();
  result.surface_point = furthest.point();
  return result;
}

}  // namespace hull::analysis
