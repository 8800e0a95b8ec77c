// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/fit/fit_places.h"

#include <Eigen/Geometry>
#include <array>

#include "modelling/fit/even_ranges.h"
#include "surface/queries/closest_point.h"

namespace hull::modelling::fit_internal {
namespace {

constexpr std::array<double, 3> kThirds{1.0 / 6.0, 0.5, 5.0 / 6.0};
constexpr std::size_t kPerCell = kThirds.size() * kThirds.size();
// Of the shape's size: nearer places are on it, and place - foot has no direction.
constexpr double kOnShape = 1e-13;

struct SeenPlace {
  int cell;
  double u, v;
  Vector3d point;
  double area;  // m², of its third
};

std::vector<SeenPlace> places_of(const surface::LimitSurface& surface) {
  std::vector<SeenPlace> places;
  places.reserve(kPerCell * static_cast<std::size_t>(surface.cell_count()));
  for (int cell = 0; cell < surface.cell_count(); ++cell) {
    for (double u : kThirds) {
      for (double v : kThirds) {
        const surface::SurfaceJet jet = surface.evaluate(cell, u, v, 1);
        // The midpoint rule in each third: du and dv are those of the whole cell.
        places.push_back({cell, u, v, jet.point, jet.du.cross(jet.dv).norm() / kPerCell});
      }
    }
  }
  return places;
}

}  // namespace

PlacePulls find_place_pulls(const surface::LimitSurface& surface,
                            const surface::LimitSurface& shape, const surface::SurfaceTree& tree) {
  const std::vector<SeenPlace> places = places_of(surface);
  PlacePulls pulls;
  pulls.rows.resize(places.size());
  const auto pull = [&](std::size_t i, const surface::ClosestPoint& foot) {
    const SeenPlace& place = places[i];
    const Vector3d off = foot.point - place.point;
    FitRow row{place.cell, place.u, place.v, Vector3d::Zero(), 0.0, place.area};
    // Only across the shape, so that places may slide along it. On borders and creases there is no
    // one plane, and at a cone tip no normal.
    if (foot.kind == surface::FootKind::kSmooth) {
      row.direction = shape.normal(foot.cell, foot.u, foot.v);
    }
    if (row.direction.isZero(0.0) && foot.distance > kOnShape * tree.error_size()) {
      row.direction = off / foot.distance;
    }
    row.distance = row.direction.dot(off);
    // By the place's index: the order of rows, and so of sums, is not that of the threads.
    pulls.rows[i] = row;
  };
  for_even_ranges(places.size(), [&](std::size_t begin, std::size_t end) {
    std::vector<Vector3d> points;
    for (std::size_t i = begin; i < end; ++i) points.push_back(places[i].point);
    const std::vector<surface::ClosestPoint> feet = surface::closest_points(tree, points);
    for (std::size_t i = begin; i < end; ++i) pull(i, feet[i - begin]);
  });
  double area = 0.0;
  for (const FitRow& row : pulls.rows) area += row.weight;
  if (!(area > 0.0)) return {};
  for (FitRow& row : pulls.rows) {
    row.weight /= area;
    pulls.mean_square += row.weight * row.distance * row.distance;
  }
  return pulls;
}

}  // namespace hull::modelling::fit_internal
