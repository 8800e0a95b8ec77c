// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/flat_plate.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "production/plates/across_centre.h"
#include "production/plates/rolled_plate.h"
#include "production/plates/stretched_plate.h"

namespace hull::production {

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
  // There may be several minima: tries over a right angle, after which boxes repeat, then halved
  // steps from the best.
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
  flat.turn = Eigen::Rotation2Dd(-best);
  flat.shift = -extent(best).min();
  for (Vector2d& p : flat.nodes) p = flat.turn * p + flat.shift;
  for (PlaneFrame& frame : flat.frames) {
    frame.angle -= best;
    frame.at = flat.turn * frame.at + flat.shift;
  }
  if (flat.axis) {
    flat.axis->at = flat.turn * flat.axis->at + flat.shift;
    flat.axis->along = flat.turn * flat.axis->along;
  }
}

// How tangents of the surface lie on the plane, in the middle of a triangle.
Eigen::Matrix2d turn_at(const FlatPlate& flat, const PlateMesh::Element& element,
                        const PlatePoint& point) {
  if (flat.map) {
    // The rotation of the polar decomposition: what only stretches does not turn.
    const auto svd = flat.map->slopes(point).jacobiSvd(Eigen::ComputeFullU | Eigen::ComputeFullV);
    return flat.turn * (svd.matrixU() * svd.matrixV().transpose());
  }
  const ShellTriangle& t = flat.mesh.triangle(element);
  const Vector2d middle = (t.uv[0] + t.uv[1] + t.uv[2]) / 3.0;
  const PlaneFrame frame =
      rolled(flat.mesh.shell->surface, {t.cell, t.uv[0], middle}, flat.frames[element.nodes[0]]);
  const double seen =
      std::atan2(frame.along.dot(point.tangents.col(1)), frame.along.dot(point.tangents.col(0)));
  return Eigen::Rotation2Dd(frame.angle - seen).toRotationMatrix();
}

// The mean of the second fundamental form, laid on the plane with the plate.
void measure_bending(FlatPlate& flat) {
  Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
  double area = 0.0;
  for (const PlateMesh::Element& element : flat.mesh.elements) {
    const auto point =
        plate_point(flat.mesh.shell->surface, flat.mesh.triangle(element), kMiddle, true);
    if (!point) continue;
    const Eigen::Matrix2d turn = turn_at(flat, element, *point);
    sum += point->area * turn * point->bending * turn.transpose();
    area += point->area;
  }
  if (flat.axis) {
    const Vector2d& a = flat.axis->along;
    // The other half's sum is the mirror image of this one's.
    const Eigen::Matrix2d mirror = 2.0 * a * a.transpose() - Eigen::Matrix2d::Identity();
    sum += (mirror * sum * mirror).eval();
    area *= 2.0;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(sum / area);
  // Bends to either side count alike; rolls lie along the lesser one.
  const Vector2d values = solver.eigenvalues().cwiseAbs();
  const int most = values[0] > values[1] ? 0 : 1;
  const Vector2d axis = solver.eigenvectors().col(1 - most);
  const double size = std::sqrt(area);
  // A radius of 1e9 of the plate's size is a plane's.
  const bool is_plane = values[most] * size < 1e-9;
  flat.rolling_radius = is_plane ? std::numeric_limits<double>::infinity() : 1.0 / values[most];
  const double angle = is_plane ? 0.0 : std::atan(axis.y() / axis.x());
  flat.rolling_angle = angle == -M_PI / 2 ? M_PI / 2 : angle;  // the same line, told in one way
}

// The line on which the corners in the centre plane lie; and how far they are off it, at most, m.
FlatAxis axis_of(const FlatPlate& flat, double& off) {
  std::vector<Vector2d> central;
  for (std::size_t i = 0; i < flat.mesh.corners.size(); ++i) {
    const Vector3d& p = flat.mesh.shell->mesh.points[flat.mesh.corners[i]];
    if (is_central(flat.mesh.shell->surface, p)) central.push_back(flat.nodes[i]);
  }
  const Vector2d first = central.front();
  // Over the longest distance rounding turns the line the least.
  const Vector2d last = *std::max_element(
      central.begin(), central.end(), [&first](const Vector2d& a, const Vector2d& b) {
        return (a - first).squaredNorm() < (b - first).squaredNorm();
      });
  const FlatAxis axis{first, (last - first).normalized()};
  off = 0.0;
  for (const Vector2d& p : central) off = std::max(off, 0.5 * (axis.mirrored(p) - p).norm());
  return axis;
}

bool develop(FlatPlate& flat, const Plate& plate) {
  RolledPlate rolled = rolled_plate(flat.mesh, plate.centre);
  const double most = kDevelopable * std::sqrt(plate.area);
  if (rolled.gap > most || rolled.turn > kDevelopable) return false;
  flat.nodes = std::move(rolled.nodes);
  if (plate.across) {
    double off = 0.0;
    flat.axis = axis_of(flat, off);
    // Developable, but its middle line would be bent in the plane: the halves would not meet along
    // it.
    if (off > most) return false;
  }
  flat.expansion = Expansion::kDeveloped;
  flat.frames = std::move(rolled.frames);
  flat.area = plate.area;
  flat.least_stretch = flat.largest_stretch = 1.0;
  flat.stretches.assign(flat.mesh.elements.size(), Vector2d(1.0, 1.0));
  flat.converged = true;
  return true;
}

}  // namespace

FlatPlate flat_plate(const Plating& plating, const Plate& plate, double poisson) {
  if (!(poisson >= 0.0 && poisson <= 0.5)) {
    throw std::invalid_argument("Poisson's ratio must be in [0, 0.5], as 0.3 of steel.");
  }
  FlatPlate flat{};
  flat.mesh = plate_mesh(plating, plate);
  if (!develop(flat, plate)) {
    flat.axis.reset();
    stretch(flat, plate, poisson);
    double off = 0.0;
    // The least energy of a symmetric plate is symmetric: the line is straight to rounding.
    if (plate.across) flat.axis = axis_of(flat, off);
  }
  if (flat.axis) {
    const std::size_t own = flat.nodes.size();
    for (std::size_t i = 0; i < own; ++i) flat.nodes.push_back(flat.axis->mirrored(flat.nodes[i]));
  }
  straighten(flat);
  measure_bending(flat);
  return flat;
}

}  // namespace hull::production
