// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer harness: from bytes a mesh, from the mesh a surface under both schemes and everything
// that is computed from it. Besides what the sanitizers find, the properties below are required.
#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "analysis/sections/feature_curves.h"
#include "mesh_from_bytes.h"
#include "surface/creases/crease_curves.h"
#include "surface/curvature.h"
#include "surface/pieces/pieces.h"
#include "surface/queries/closest_point.h"
#include "surface/queries/ray_hits.h"
#include "surface/sampling/grid_samples.h"
#include "surface/sampling/tessellation.h"

namespace hull::fuzz {
namespace {

// Larger meshes are looked at here and there, so that a run takes milliseconds.
constexpr int kMostCells = 100;

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "surface_fuzz: this does not hold: %s\n", what);
  std::abort();
}

// The box of the control points, and the rounding error allowed.
struct Bounds {
  Eigen::AlignedBox3d box;
  double tolerance;

  explicit Bounds(const mesh::ControlMesh& mesh) {
    double largest = 0.0;
    const mesh::Topology& t = mesh.topology();
    for (int h = 0; h < t.half_edge_count(); ++h) {  // isolated points have no influence
      const Vector3d& p = mesh.points()[t.origin(h)];
      box.extend(p);
      largest = std::max(largest, p.cwiseAbs().maxCoeff());
    }
    tolerance = 1e-13 * box.diagonal().norm() + 1e-14 * largest;
  }
  bool holds(const Vector3d& p) const {
    return p.allFinite() && box.exteriorDistance(p) <= tolerance;
  }
};

bool unit_or_zero(const Vector3d& normal) {
  return normal.isZero(0.0) || std::abs(normal.norm() - 1.0) < 1e-12;
}

void check_place(const surface::LimitSurface& surface, const Bounds& bounds, int cell, double u,
                 double v) {
  const surface::SurfaceJet jet = surface.evaluate(cell, u, v, 2);
  require(bounds.holds(jet.point), "a point lies within the box of the control points");
  require(jet.point == surface.position(cell, u, v), "the order does not change the point");
  for (const Vector3d& d : {jet.du, jet.dv, jet.duu, jet.duv, jet.dvv}) {
    require(d.allFinite(), "derivatives are finite");
  }
  require(unit_or_zero(surface.normal(cell, u, v)), "normals are of length one or zero");
  const surface::Curvature k = surface::curvature(surface, cell, u, v);
  require(!(k.maximum < k.minimum), "principal curvatures are ordered");
  require(k.defined || k.maximum == 0.0, "undefined curvature is zero");
  if (k.defined) {
    require(std::abs(k.maximum_direction.norm() - 1.0) < 1e-9, "directions are of length one");
  }
}

void check_sides(const surface::LimitSurface& surface, const Bounds& bounds) {
  const mesh::Topology& cells = surface.cells();
  const auto on_side = [](int k, double t) {
    const Eigen::Vector2d places[] = {{t, 0.0}, {1.0, t}, {1.0 - t, 1.0}, {0.0, 1.0 - t}};
    return places[k];
  };
  const int step = 1 + cells.half_edge_count() / (4 * kMostCells);
  for (int h = 0; h < cells.half_edge_count(); h += step) {
    const int g = cells.twin(h);
    if (g < 0) continue;
    for (double t : {0.0, 0.03, 0.6}) {
      const Eigen::Vector2d a = on_side(h & 3, t), b = on_side(g & 3, 1.0 - t);
      const Vector3d gap =
          surface.position(h / 4, a.x(), a.y()) - surface.position(g / 4, b.x(), b.y());
      require(gap.norm() <= bounds.tolerance, "both cells of a side have the same points there");
    }
  }
}

void check_pieces(const surface::LimitSurface& surface, const Bounds& bounds) {
  constexpr double kSmallest = 1.0 / 64.0;
  const int step = 1 + surface.cell_count() / kMostCells;
  for (int cell = 0; cell < surface.cell_count(); cell += step) {
    double area = 0.0;
    surface::for_each_piece(
        surface, cell,
        [&](const surface::CornerSquare& square) {
          if (square.size > kSmallest) return true;
          for (const Vector3d& p : square.points()) {
            require(bounds.holds(p), "control points of squares lie within the box");
          }
          area += square.size * square.size;
          return false;
        },
        [&](const surface::SurfacePiece& piece) {
          area += piece.size * piece.size;
          const Vector3d ours = surface::evaluate_bicubic(piece.points, 0.4, 0.7, 0).point;
          const Vector3d same =
              surface.position(cell, piece.u + 0.4 * piece.size, piece.v + 0.7 * piece.size);
          require((ours - same).norm() <= bounds.tolerance, "pieces are the surface");
        });
    require(area == 1.0, "pieces cover the cell");
  }
}

void check_samples(const surface::LimitSurface& surface, const Bounds& bounds) {
  constexpr int kN = 3;
  const surface::GridSamples samples = surface::evaluate_grid(surface, kN, 2);
  for (int cell = 0; cell < surface.cell_count(); ++cell) {
    for (int i = 0; i <= kN; ++i) {
      for (int j = 0; j <= kN; ++j) {
        const Vector3d single =
            surface.position(cell, static_cast<double>(i) / kN, static_cast<double>(j) / kN);
        require((samples.points[samples.index(cell, i, j)] - single).norm() <= bounds.tolerance,
                "a grid's points are the single points");
      }
    }
  }
  const surface::Tessellation net = surface::tessellate(surface, 2);
  require(net.quads.size() == 4u * surface.cell_count(), "n x n quadrilaterals a cell");
  for (const auto& quad : net.quads) {
    for (int point : quad) require(bounds.holds(net.points.at(point)), "tessellations are bounded");
  }
  for (const Vector3d& normal : net.normals) require(unit_or_zero(normal), "normals of corners");
  for (const auto& corners : net.corner_normals) {
    for (int normal : corners) require(normal < static_cast<int>(net.normals.size()), "in range");
  }
  for (const analysis::FeatureCurve& curve : analysis::feature_curves(surface, 4)) {
    for (const Vector3d& p : curve.points) require(bounds.holds(p), "creases are bounded");
  }
}

void check_creases(const surface::LimitSurface& surface, const Bounds& bounds) {
  for (const surface::CreaseCurve& curve : surface::crease_curves(surface)) {
    for (double part : {0.0, 0.37, 1.0}) {
      const double t = part * curve.edge_count();
      const Vector3d p = curve.evaluate(t, 1).point;
      for (const surface::CellPlace& place : {curve.left(t), curve.right(t)}) {
        if (place.cell < 0) continue;
        const Vector3d of_surface = surface.position(place.cell, place.u, place.v);
        require((p - of_surface).norm() <= 10.0 * bounds.tolerance + curve.dart_error(),
                "creases lie on the surface");
      }
    }
  }
}

// A probe anywhere around, and a ray from it to a place of the surface.
void check_queries(const surface::LimitSurface& surface, const Bounds& bounds, ByteReader& bytes) {
  const surface::SurfaceTree tree(surface);
  const double size = bounds.box.diagonal().norm();
  Vector3d probe = bounds.box.center();
  for (double& x : probe) x += size * (bytes.byte() - 128) / 128.0;
  const surface::ClosestPoint foot = surface::closest_point(tree, probe);
  require(foot.cell >= 0, "there is a closest point");
  const Vector3d there = surface.position(foot.cell, foot.u, foot.v);
  const double tolerance = 10.0 * bounds.tolerance;
  require(std::abs((probe - foot.point).norm() - foot.distance) <= tolerance, "distance of a foot");
  require((there - foot.point).norm() <= 1e-9 * size + tolerance, "a foot is on the surface");
  const int cell = bytes.below(surface.cell_count());
  const double u = bytes.byte() / 255.0, v = bytes.byte() / 255.0;
  const Vector3d target = surface.position(cell, u, v);
  const double reach = (target - probe).norm();
  require(foot.distance <= reach + foot.gap + tolerance, "no point is nearer than the closest");
  if (reach < 1e-3 * size || size == 0.0) return;
  const Vector3d direction = (target - probe) / reach;
  const auto hit = surface::first_ray_hit(tree, {probe, direction});
  const double slope = std::abs(surface.normal(cell, u, v).dot(direction));
  // Crossings closer together than this may be told as one (ray_hits.h: 2e-7 of the size).
  const double nearly_touching = 1e-6 * tree.error_size();
  if (slope > 0.1) require(hit && hit->t <= reach + nearly_touching, "a ray hits what it aims at");
  if (hit) require(bounds.box.exteriorDistance(hit->point) <= 1e-9 * size, "hits are bounded");
}

void check_surface(const mesh::ControlMesh& mesh, surface::Scheme scheme, ByteReader& bytes) {
  // The bases are shared as they are in the Python module, but not for ever.
  static std::shared_ptr<surface::BasisCache> cache;
  static int uses = 0;
  if (uses++ % 200 == 0) cache = std::make_shared<surface::BasisCache>();
  surface::LimitSurface surface(mesh, scheme, cache);
  const Bounds bounds(mesh);
  constexpr double kPlaces[] = {0.0, 1e-300, 1e-30, 1e-5, 0.24, 0.5, 0.75, 1.0 - 1e-16, 1.0};
  const int step = 1 + surface.cell_count() / kMostCells;
  for (int cell = 0; cell < surface.cell_count(); cell += step) {
    check_place(surface, bounds, cell, 0.0, 0.0);
    const double known_u = kPlaces[bytes.byte() % 9], known_v = kPlaces[bytes.byte() % 9];
    check_place(surface, bounds, cell, known_u, known_v);
    const double any_u = bytes.byte() / 255.0, any_v = bytes.byte() / 255.0;
    check_place(surface, bounds, cell, any_u, any_v);
  }
  check_sides(surface, bounds);
  check_pieces(surface, bounds);
  check_samples(surface, bounds);
  check_creases(surface, bounds);
  check_queries(surface, bounds, bytes);

  std::vector<Vector3d> moved = mesh.points();
  for (Vector3d& p : moved) p *= 0.5;
  const Vector3d before = surface.position(0, 0.3, 0.2);
  surface.set_points(moved);
  require((surface.position(0, 0.3, 0.2) - 0.5 * before).norm() <= bounds.tolerance,
          "a mesh half as large has a surface half as large");
}

void check_bytes(ByteReader& bytes) {
  const mesh::MeshArrays arrays = mesh_from_bytes(bytes);
  const std::vector<mesh::MeshProblem> problems = mesh::check_mesh(arrays);
  const bool sound = problems.empty() || problems.front().severity == mesh::Severity::kWarning;
  try {
    const mesh::ControlMesh mesh(arrays);
    require(sound, "meshes with errors are refused");
    for (surface::Scheme scheme : {surface::Scheme::kBiermann, surface::Scheme::kCatmullClark}) {
      check_surface(mesh, scheme, bytes);
    }
  } catch (const std::invalid_argument& refused) {
    require(!sound, refused.what());
    require(refused.what() == problems.front().message, "the first error is thrown");
  }
}

}  // namespace
}  // namespace hull::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  hull::fuzz::ByteReader bytes(data, size);
  hull::fuzz::check_bytes(bytes);
  return 0;
}
