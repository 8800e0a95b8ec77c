// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/stretched_plate.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace hull::production {

namespace {

// Cells over the shorter side of the chart, before they are halved; and how often they may be.
constexpr int kFirstCells = 5, kMostHalvings = 4;
// Finer ones have no more functions than this; where the error is large, than that.
constexpr int kMostFunctions = 6000, kMostWhereLarge = 24000;
// What is left after changes that become smaller at least like kSlowest is what a geometric series
// of them has, of second order at best: once the whole is resolved, the ends of an arc are not yet,
// and the change after next is larger than the last two foretell. Otherwise as much as the last.
constexpr double kSlowest = 0.5, kFastest = 0.25;
// An error of stretch that is small enough, alone or as a part of the stretch; and one with which
// the plate does not count as settled.
constexpr double kSmallError = 2e-5, kSmallPart = 0.01, kLargeError = 5e-4;

constexpr double kSixth = 1.0 / 6.0;
// Of a triangle: corners, middles of sides, and its own, which is the last.
const std::array<Eigen::Vector3d, 7> kSeen{Eigen::Vector3d(1.0, 0.0, 0.0),
                                           {0.0, 1.0, 0.0},
                                           {0.0, 0.0, 1.0},
                                           {0.5, 0.5, 0.0},
                                           {0.0, 0.5, 0.5},
                                           {0.5, 0.0, 0.5},
                                           {2.0 * kSixth, 2.0 * kSixth, 2.0 * kSixth}};

void measure_stretch(FlatPlate& flat) {
  flat.least_stretch = std::numeric_limits<double>::infinity();
  flat.largest_stretch = 0.0;
  flat.stretches.clear();
  for (const PlateMesh::Element& element : flat.mesh.elements) {
    flat.stretches.emplace_back(1.0, 1.0);
    for (const Eigen::Vector3d& b : kSeen) {
      const auto point = plate_point(flat.mesh.shell->surface, flat.mesh.triangle(element), b);
      if (!point) continue;
      const Vector2d values = flat.map->slopes(*point).jacobiSvd().singularValues();
      // Singular values fall, and are lengths on the plane over those on the hull.
      flat.stretches.back() = values.cwiseInverse();
      flat.least_stretch = std::min(flat.least_stretch, 1.0 / values[0]);
      flat.largest_stretch = std::max(flat.largest_stretch, 1.0 / values[1]);
    }
  }
}

void place_nodes(FlatPlate& flat) {
  const surface::LimitSurface& surface = flat.mesh.shell->surface;
  flat.nodes.resize(flat.mesh.node_count);
  for (const PlateMesh::Element& element : flat.mesh.elements) {
    const ShellTriangle& t = flat.mesh.triangle(element);
    for (int k = 0; k < 3; ++k) {
      const Vector2d middle = 0.5 * (t.uv[k] + t.uv[(k + 1) % 3]);
      flat.nodes[element.nodes[k]] =
          flat.map->place(surface.position(t.cell, t.uv[k].x(), t.uv[k].y()));
      flat.nodes[element.nodes[3 + k]] =
          flat.map->place(surface.position(t.cell, middle.x(), middle.y()));
    }
  }
}

PlateChart chart_of(const FlatPlate& flat, const Plate& plate) {
  // Six points a triangle are enough to see all directions to which the plate turns.
  const auto points =
      quadrature_points(flat.mesh, std::numeric_limits<double>::infinity(), plate.across);
  const auto chart = PlateChart::best(points, plate.across);
  if (!chart) {
    throw std::invalid_argument(
        "A plate bends so far round that it can't be laid out: divide it by seams or butts.");
  }
  return *chart;
}

Eigen::AlignedBox2d box_of(const FlatPlate& flat, const PlateChart& chart, bool across) {
  Eigen::AlignedBox2d box;
  // Sides may bulge over the box of the corners: the splines' last cells go on there.
  for (const int corner : flat.mesh.corners) {
    Vector3d p = flat.mesh.shell->mesh.points[corner];
    box.extend(chart.value(p).at);
    p.y() *= -1.0;
    if (across) box.extend(chart.value(p).at);
  }
  return box;
}

// The least energy on the map's grid; the points by which it is integrated are returned.
std::vector<PlatePoint> settle(FlatPlate& flat, const Plate& plate, double poisson,
                               const SheetMap* coarser) {
  SheetMap& map = *flat.map;
  std::vector<PlatePoint> points =
      quadrature_points(flat.mesh, 1.5 * map.splines.cell(), plate.across);
  for (const PlatePoint& p : points) map.splines.use(map.chart.value(p.at).at);
  map.coefficients = coarser ? coarser->splines.refined(map.splines, coarser->coefficients)
                             : map.splines.identity();
  const LeastEnergy found = make_energy_least(map, points, poisson, coarser != nullptr);
  flat.iterations += found.iterations;
  flat.converged = found.converged;
  return points;
}

double error_after(double before, double change) {
  if (change >= kSlowest * before) return change;  // none after none, too
  const double ratio = std::max(change / before, kFastest);
  // The sum of change ratio^k over k > 0.
  return change * ratio / (1.0 - ratio);
}

}  // namespace

void stretch(FlatPlate& flat, const Plate& plate, double poisson) {
  flat.expansion = Expansion::kStretched;
  const PlateChart chart = chart_of(flat, plate);
  flat.map = SheetMap{chart, SheetSplines(box_of(flat, chart, plate.across), kFirstCells), {}};
  std::vector<PlatePoint> points = settle(flat, plate, poisson, nullptr);
  measure_stretch(flat);
  double before = 0.0;  // the last change but one
  for (int k = 0; k < kMostHalvings; ++k) {
    const bool is_large = flat.stretch_error > kLargeError;
    const int most = is_large ? kMostWhereLarge : kMostFunctions;
    // Halving makes about four functions of one.
    if (k > 0 && 4 * flat.map->splines.count() > most) break;
    const SheetMap coarser = *flat.map;
    const double least = flat.least_stretch, largest = flat.largest_stretch;
    flat.map = SheetMap{chart, coarser.splines.halved(), {}};
    points = settle(flat, plate, poisson, &coarser);
    measure_stretch(flat);
    const double change =
        std::max(std::abs(flat.least_stretch - least), std::abs(flat.largest_stretch - largest));
    flat.stretch_error = error_after(before, change);
    before = change;
    // One change alone does not tell: what neither of two coarse grids sees changes nothing.
    if (k > 0 && flat.stretch_error <= kSmallError + kSmallPart * (largest - least)) break;
  }
  flat.converged = flat.converged && flat.stretch_error <= kLargeError;
  flat.area = 0.0;
  // The determinant is the area on the plane over that on the hull.
  for (const PlatePoint& p : points) flat.area += p.area * flat.map->slopes(p).determinant();
  place_nodes(flat);
}

}  // namespace hull::production
