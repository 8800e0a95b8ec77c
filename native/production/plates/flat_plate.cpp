// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/flat_plate.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "production/plates/rolled_plate.h"
#include "production/plates/strain_energy.h"

namespace hull::production {

using Eigen::Vector2d;

namespace {

constexpr double kDevelopable = 1e-9;  // of the plate's size; rad of a turn
const Eigen::Vector3d kMiddle = Eigen::Vector3d::Constant(1.0 / 3.0);

// Turned so that the box of least area around the outline lies along the axes, its longer side
// along x, and shifted to begin in (0, 0).
void straighten(FlatPlate& flat) {
  const auto extent = [&flat](double angle) {
    const Eigen::Rotation2Dd turn(-angle);
    Eigen::AlignedBox2d box;
    for (const Vector2d& p : flat.nodes) box.extend(turn * p);
    return box;
  };
  const auto area = [&](double angle) { return extent(angle).sizes().prod(); };
  double best = 0.0;
  constexpr int kTries = 90;
  for (int i = 1; i < kTries; ++i) {
    if (const double angle = M_PI / 2 * i / kTries; area(angle) < area(best)) best = angle;
  }
  for (double step = M_PI / 4 / kTries; step > 1e-7; step *= 0.5) {
    for (const double angle : {best - step, best + step}) {
      if (area(angle) < area(best)) best = angle;
    }
  }
  if (extent(best).sizes().x() < extent(best).sizes().y()) best += M_PI / 2;
  const Eigen::Rotation2Dd turn(-best);
  const Vector2d shift = -extent(best).min();
  for (Vector2d& p : flat.nodes) p = turn * p + shift;
  for (PlaneFrame& frame : flat.frames) {
    frame.angle -= best;
    frame.at = turn * frame.at + shift;
  }
}

void measure_stretch(FlatPlate& flat) {
  const surface::LimitSurface& surface = flat.mesh.shell->surface;
  flat.least_stretch = std::numeric_limits<double>::infinity();
  flat.largest_stretch = 0.0;
  const auto principal = [&](const PlateMesh::Element& element, const Eigen::Vector3d& b) {
    const auto point = element_point(surface, flat.mesh.triangle(element), b);
    if (!point) return Vector2d(1.0, 1.0);
    const Vector2d values = plane_slopes(*point, element, flat.nodes).jacobiSvd().singularValues();
    return Vector2d(1.0 / values[0], 1.0 / values[1]);
  };
  const Eigen::Matrix3d corners = Eigen::Matrix3d::Identity();
  const double least_height = thin_height(flat.mesh, std::abs(flat.area));
  for (const PlateMesh::Element& element : flat.mesh.elements) {
    flat.stretches.push_back(principal(element, kMiddle));
    if (height_of(flat.mesh, element) < least_height) {
      flat.stretches.back() = Vector2d(1.0, 1.0);
      continue;
    }
    // In sides' middles and the triangle's own the slopes of quadratic elements are best.
    for (int k = 0; k < 4; ++k) {
      const Eigen::Vector3d b =
          k == 3 ? kMiddle : Eigen::Vector3d(0.5 * (corners.col(k) + corners.col((k + 1) % 3)));
      const Vector2d stretch = principal(element, b);
      flat.least_stretch = std::min(flat.least_stretch, stretch[0]);
      flat.largest_stretch = std::max(flat.largest_stretch, stretch[1]);
    }
  }
}

// The mean of the second fundamental form, laid on the plane with the plate.
void measure_bending(FlatPlate& flat) {
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  double area = 0.0;
  for (const PlateMesh::Element& element : flat.mesh.elements) {
    const auto point =
        element_point(flat.mesh.shell->surface, flat.mesh.triangle(element), kMiddle, true);
    if (!point) continue;
    const auto svd = plane_slopes(*point, element, flat.nodes)
                         .jacobiSvd(Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Matrix2d turn = svd.matrixU() * svd.matrixV().transpose();
    sum += point->area * turn * point->bending * turn.transpose();
    area += point->area;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(sum / area);
  const Vector2d values = solver.eigenvalues().cwiseAbs();
  const int most = values[0] > values[1] ? 0 : 1;
  const Vector2d axis = solver.eigenvectors().col(1 - most);
  const double size = std::sqrt(area);
  const bool is_plane = values[most] * size < 1e-9;
  flat.rolling_radius = is_plane ? std::numeric_limits<double>::infinity() : 1.0 / values[most];
  flat.rolling_angle = is_plane ? 0.0 : std::atan(axis.y() / axis.x());
}

// ∫ |det F| dA, exact for the map of elements where that is of quadratic elements.
double mapped_area(const FlatPlate& flat) {
  double sum = 0.0;
  for (const PlateMesh::Element& element : flat.mesh.elements) {
    // In barycentric coordinates det is a polynomial of degree 2: three points are exact.
    for (const Eigen::Vector3d& b : {Eigen::Vector3d(0.5, 0.5, 0.0), Eigen::Vector3d(0.0, 0.5, 0.5),
                                     Eigen::Vector3d(0.5, 0.0, 0.5)}) {
      const Eigen::Matrix<double, 6, 2> slopes = element_slopes(b);
      Eigen::Matrix2d f = Eigen::Matrix2d::Zero();
      for (int k = 0; k < 6; ++k) f += flat.nodes[element.nodes[k]] * slopes.row(k);
      sum += f.determinant() / 6.0;
    }
  }
  return sum;
}

}  // namespace

FlatPlate flat_plate(const Plating& plating, const Plate& plate, double poisson) {
  if (!(poisson >= 0.0 && poisson <= 0.5)) {
    throw std::invalid_argument("Poisson's ratio must be in [0, 0.5], as 0.3 of steel.");
  }
  FlatPlate flat{};
  flat.mesh = plate_mesh(plating, plate);
  RolledPlate rolled = rolled_plate(flat.mesh, plate.centre);
  const double size = std::sqrt(plate.area);
  if (rolled.gap <= kDevelopable * size && rolled.turn <= kDevelopable) {
    flat.expansion = Expansion::kDeveloped;
    flat.nodes = std::move(rolled.nodes);
    flat.frames = std::move(rolled.frames);
    flat.converged = true;
  } else {
    flat.expansion = Expansion::kStretched;
    LeastEnergy found = least_energy(flat.mesh, evened(flat.mesh, rolled), poisson);
    flat.nodes = std::move(found.nodes);
    flat.iterations = found.iterations;
    flat.converged = found.converged;
  }
  straighten(flat);
  flat.area = flat.expansion == Expansion::kDeveloped ? plate.area : mapped_area(flat);
  if (flat.expansion == Expansion::kDeveloped) {
    flat.least_stretch = flat.largest_stretch = 1.0;
    flat.stretches.assign(flat.mesh.elements.size(), Vector2d(1.0, 1.0));
  } else {
    measure_stretch(flat);
  }
  measure_bending(flat);
  return flat;
}

}  // namespace hull::production
