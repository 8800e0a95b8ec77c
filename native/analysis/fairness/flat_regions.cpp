// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/fairness/flat_regions.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "analysis/arithmetic/gauss.h"
#include "analysis/fairness/plane_fit.h"

namespace hull::analysis {
namespace {

constexpr int kMostFits = 4;
constexpr int kAreaNodes = 5;
constexpr double kSmallestPart = 0x1p-10;
constexpr double kEigenvalueError = 1e-12;  // of the greatest, by far

using Points = std::vector<Vector3d>;

// The points in whose convex hull a cell lies.
Points control_points(const surface::LimitSurface& surface, int cell) {
  Points points;
  surface::for_each_piece(
      surface, cell,
      [&](const surface::CornerSquare& square) {
        points.insert(points.end(), square.points().begin(), square.points().end());
        // The square's points hold all of its rings.
        return false;
      },
      [&](const surface::SurfacePiece& piece) {
        points.insert(points.end(), piece.points.begin(), piece.points.end());
      });
  return points;
}

bool lies_in(const Points& points, const Plane& plane, double tolerance) {
  return std::all_of(points.begin(), points.end(),
                     [&](const Vector3d& p) { return std::abs(plane.height(p)) <= tolerance; });
}

// False where no plane is as near to all points: the squares of their distances from the plane of
// least squares add up to the least eigenvalue, which is known to within rounding.
bool may_lie_in_a_plane(const Points& points, double tolerance) {
  Vector3d centre = Vector3d::Zero();
  for (const Vector3d& p : points) centre += p;
  const auto count = static_cast<double>(points.size());
  centre /= count;
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  for (const Vector3d& p : points) squares += (p - centre) * (p - centre).transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(squares, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[0] <=
         2.0 * count * tolerance * tolerance + kEigenvalueError * squares.trace();
}

double area_of(const surface::LimitSurface& surface, int cell) {
  static const GaussRule rule = gauss_rule(kAreaNodes);
  double area = 0.0;
  for (int i = 0; i < kAreaNodes; ++i) {
    for (int j = 0; j < kAreaNodes; ++j) {
      const surface::SurfaceJet jet = surface.evaluate(cell, rule.nodes[i], rule.nodes[j], 1);
      area += rule.weights[i] * rule.weights[j] * jet.du.cross(jet.dv).norm();
    }
  }
  return area;
}

// The side of a half-edge of cells(), cubic by cubic along it.
class SideCubics {
 public:
  SideCubics(const surface::LimitSurface& surface, int half_edge)
      : surface_(surface), cell_(half_edge / 4), side_(half_edge % 4) {}

  void add_to(std::vector<std::array<Vector3d, 4>>& cubics) {
    surface::for_each_piece(
        surface_, cell_,
        [&](const surface::CornerSquare& square) {
          if (!touches(square.u, square.v, square.size)) return false;
          if (square.size > kSmallestPart) return true;
          take(square.u, square.v, square.size);
          return false;
        },
        [&](const surface::SurfacePiece& piece) {
          if (touches(piece.u, piece.v, piece.size)) take(piece.u, piece.v, piece.size);
        });
    // Rings come from the outside in, not along the side.
    std::sort(parts_.begin(), parts_.end());
    for (const auto& [from, to] : parts_) cubics.push_back(cubic(from, to));
  }

 private:
  bool touches(double u, double v, double size) const {
    // Squares are dyadic, so that sums of place and size are exact.
    switch (side_) {
      case 0:
        return v == 0.0;
      case 1:
        return u + size == 1.0;
      case 2:
        return v + size == 1.0;
      default:
        return u == 0.0;
    }
  }
  void take(double u, double v, double size) {
    const double from = side_ % 2 == 0 ? u : v;
    // Along the half-edge, which runs with falling u or v on sides 2 and 3.
    parts_.push_back(side_ < 2 ? std::array<double, 2>{from, from + size}
                               : std::array<double, 2>{1.0 - from - size, 1.0 - from});
  }
  surface::SurfaceJet at(double t) const {
    const double s = side_ < 2 ? t : 1.0 - t;
    if (side_ % 2 == 0) return surface_.evaluate(cell_, s, side_ == 0 ? 0.0 : 1.0, 1);
    return surface_.evaluate(cell_, side_ == 1 ? 1.0 : 0.0, s, 1);
  }
  std::array<Vector3d, 4> cubic(double from, double to) const {
    const surface::SurfaceJet a = at(from), b = at(to);
    // A side's part is a cubic: its ends and derivatives tell all of it.
    const double third = (side_ < 2 ? 1.0 : -1.0) * (to - from) / 3.0;
    const auto step = [&](const surface::SurfaceJet& jet) -> Vector3d {
      const Vector3d d = side_ % 2 == 0 ? jet.du : jet.dv;
      // At an irregular knot there is no derivative.
      if (d.isZero(0.0)) return (b.point - a.point) / 3.0;
      return third * d;
    };
    return {a.point, a.point + step(a), b.point - step(b), b.point};
  }

  const surface::LimitSurface& surface_;
  int cell_, side_;
  std::vector<std::array<double, 2>> parts_;
};

class RegionFinder {
 public:
  RegionFinder(const surface::LimitSurface& surface, double tolerance)
      : surface_(surface),
        tolerance_(tolerance),
        areas_(surface.cell_count(), -1.0),
        used_(surface.cell_count(), 0),
        seen_(surface.cell_count(), 0),
        passed_(4 * surface.cell_count(), 0) {
    points_.reserve(surface.cell_count());
    for (int cell = 0; cell < surface.cell_count(); ++cell) {
      points_.push_back(control_points(surface, cell));
    }
  }

  std::vector<FlatRegion> in_plane(const Plane& plane) {
    std::vector<FlatRegion> regions;
    for (int cell = 0; cell < surface_.cell_count(); ++cell) {
      if (used_[cell] || !lies_in(points_[cell], plane, tolerance_)) continue;
      regions.push_back(finished(plane, grown(cell, plane)));
    }
    return regions;
  }

  std::vector<FlatRegion> anywhere() {
    struct Seed {
      int cell;
      Plane plane;
    };
    std::vector<Seed> seeds;
    for (int cell = 0; cell < surface_.cell_count(); ++cell) {
      // Three eigenvalues in closed form spare most cells the fit by singular values.
      if (!may_lie_in_a_plane(points_[cell], tolerance_)) continue;
      const Plane plane = fit_plane(points_[cell]).plane;
      if (lies_in(points_[cell], plane, tolerance_)) seeds.push_back({cell, plane});
    }
    // A large cell tells its plane better than a small one, and takes in those around it.
    std::stable_sort(seeds.begin(), seeds.end(),
                     [&](const Seed& a, const Seed& b) { return area(a.cell) > area(b.cell); });
    std::vector<FlatRegion> regions;
    for (const auto& [seed, own_plane] : seeds) {
      if (used_[seed]) continue;
      Plane plane = own_plane;
      std::vector<int> cells = grown(seed, plane);
      // The plane of a small cell is too tilted for a large region: fit it again to all of it.
      for (int fit = 0; fit < kMostFits; ++fit) {
        Points all;
        for (const int cell : cells) {
          all.insert(all.end(), points_[cell].begin(), points_[cell].end());
        }
        const Plane better = fit_plane(all).plane;
        if (!lies_in(points_[seed], better, tolerance_)) break;
        std::vector<int> more = grown(seed, better);
        // What fits all of them may leave out some at the rim.
        if (more.size() < cells.size()) break;
        const bool same = more.size() == cells.size();
        plane = better;
        cells = std::move(more);
        if (same) break;
      }
      regions.push_back(finished(plane, std::move(cells)));
    }
    return regions;
  }

 private:
  // Found when it is asked for: most cells are not flat.
  double area(int cell) {
    if (areas_[cell] < 0.0) areas_[cell] = area_of(surface_, cell);
    return areas_[cell];
  }

  std::vector<int> grown(int seed, const Plane& plane) {
    std::vector<int> cells{seed};
    seen_[seed] = ++mark_;
    // What was found is also the queue of what is to be looked around.
    for (std::size_t i = 0; i < cells.size(); ++i) {
      for (int side = 0; side < 4; ++side) {
        const int twin = surface_.cells().twin(4 * cells[i] + side);
        if (twin < 0) continue;
        const int next = twin / 4;
        if (seen_[next] == mark_ || used_[next]) continue;
        seen_[next] = mark_;
        if (lies_in(points_[next], plane, tolerance_)) cells.push_back(next);
      }
    }
    return cells;
  }

  FlatRegion finished(Plane plane, std::vector<int> cells) {
    std::sort(cells.begin(), cells.end());
    FlatRegion region{plane, std::move(cells), 0.0, {}};
    double outward = 0.0;
    for (const int cell : region.cells) {
      used_[cell] = 1;
      region.area += area(cell);
      // By area: normals of small cells may be turned by as much as the tolerance.
      outward += area(cell) * plane.normal.dot(surface_.normal(cell, 0.5, 0.5));
    }
    if (outward < 0.0) region.plane = {-plane.normal, -plane.offset};
    region.borders = borders(region.cells);
    return region;
  }

  std::vector<FlatBorder> borders(const std::vector<int>& cells) {
    const mesh::Topology& topology = surface_.cells();
    ++mark_;
    for (const int cell : cells) seen_[cell] = mark_;
    const auto is_border = [&](int h) {
      const int twin = topology.twin(h);
      return twin < 0 || seen_[twin / 4] != mark_;
    };
    std::vector<FlatBorder> result;
    for (const int cell : cells) {
      for (int h = 4 * cell; h < 4 * cell + 4; ++h) {
        if (passed_[h] || !is_border(h)) continue;
        FlatBorder& border = result.emplace_back();
        for (int at = h; !passed_[at];) {
          passed_[at] = 1;
          SideCubics(surface_, at).add_to(border.cubics);
          at = topology.next(at);
          // Around the side's end, across cells of the region.
          while (!is_border(at)) at = topology.next(topology.twin(at));
        }
      }
    }
    return result;
  }

  const surface::LimitSurface& surface_;
  double tolerance_;
  std::vector<Points> points_;
  std::vector<double> areas_;
  std::vector<char> used_;
  // Cells that the search under way has seen have its number: nothing is cleared for the next one,
  // so that many small regions cost no more than a large one.
  std::vector<int> seen_;
  int mark_ = 0;
  std::vector<char> passed_;  // half-edges on borders of regions, of which each cell has one
};

}  // namespace

std::vector<FlatRegion> flat_regions(const surface::LimitSurface& surface,
                                     const std::optional<Plane>& plane, double tolerance,
                                     double smallest_area) {
  if (!(tolerance > 0.0) || !std::isfinite(tolerance)) {
    throw std::invalid_argument("The tolerance of flat regions must be a positive length, not " +
                                std::to_string(tolerance) + " m.");
  }
  RegionFinder finder(surface, tolerance);
  std::vector<FlatRegion> regions = plane ? finder.in_plane(*plane) : finder.anywhere();
  std::erase_if(regions, [&](const FlatRegion& r) { return r.area < smallest_area; });
  std::stable_sort(regions.begin(), regions.end(),
                   [](const FlatRegion& a, const FlatRegion& b) { return a.area > b.area; });
  return regions;
}

}  // namespace hull::analysis
