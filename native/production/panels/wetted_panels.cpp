// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/panels/wetted_panels.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "production/panels/water_cut.h"

namespace hull::production {
namespace {

// Twice the mean of both ways to cut a quadrilateral in triangles, by a function of three corners:
// a warped panel is no plane, and neither of its diagonals is to be preferred.
template <class Value, class Function>
Value over_triangles(const std::array<Vector3d, 4>& q, const Function& of, Value sum) {
  const auto add = [&](int a, int b, int c) { sum += of(q[a], q[b], q[c]); };
  add(0, 1, 2);
  add(0, 2, 3);
  add(0, 1, 3);
  add(1, 2, 3);
  return sum;
}

std::array<Vector3d, 4> corners_of(const PanelMesh& mesh, const std::array<int, 4>& panel) {
  return {mesh.points[panel[0]], mesh.points[panel[1]], mesh.points[panel[2]],
          mesh.points[panel[3]]};
}

// Closing lines get as many parts as their longest needs that is wet.
int parts_across(const ClosingLines& lines, const PanelSizeField& field,
                 const analysis::Plane& water) {
  double most = 1.0;
  for (const auto& [from, to] : lines) {
    if (std::min(water.height(from), water.height(to)) > 0.0) continue;
    const double least = std::min(field.at(from), field.at(to));
    most = std::max(most, (to - from).norm() / least);
  }
  return static_cast<int>(std::ceil(std::min(most, kMostPanels) - 1e-9));
}

Eigen::Matrix3d water_axes(const analysis::FloatingPosition& position) {
  Eigen::Matrix3d axes;
  axes.row(0) = analysis::forward_direction(position.trim, position.heel);
  axes.row(1) = -analysis::starboard_direction(position.trim, position.heel);
  axes.row(2) = analysis::up_direction(position.trim, position.heel);
  // Exactly, where the product of the two has its rounding.
  if (position.heel == 0.0) axes.row(1) = Eigen::RowVector3d::UnitY();
  return axes;
}

void take_panels(const WaterCut& cut, PanelMesh& mesh) {
  std::vector<int> number(cut.points().size(), -1);
  for (const std::array<int, 4>& corners : cut.panels()) {
    std::array<int, 4> panel;
    for (int k = 0; k < 4; ++k) {
      const int corner = corners[k];
      if (number[corner] < 0) {
        number[corner] = static_cast<int>(mesh.points.size());
        mesh.points.push_back(mesh.axes * (cut.points()[corner] - mesh.origin));
        mesh.at_water.push_back(cut.in_water_plane(corner));
        if (mesh.at_water.back()) mesh.points.back().z() = 0.0;  // the rotation has its rounding
      }
      panel[k] = number[corner];
    }
    mesh.panels.push_back(panel);
  }
}

// Of what has panels: the hull's own surface, whatever is joined to it.
double volume_alone(const analysis::HullBody& body, const analysis::Plane& water) {
  if (!body.joined()) return body.immersion(water).volume;
  const analysis::HullBody alone(body.surface(), body.mirrored(), body.openings(),
                                 body.tolerance());
  return alone.immersion(water).volume;
}

}  // namespace

Vector3d PanelMesh::volumes() const {
  Vector3d sum = Vector3d::Zero();
  for (const std::array<int, 4>& panel : panels) {
    sum += over_triangles(
        corners_of(*this, panel),
        [](const Vector3d& a, const Vector3d& b, const Vector3d& c) -> Vector3d {
          // Flux of (x, 0, 0) through the plane triangle: the mean of x at its corners times the
          // vector area's x; y and z likewise.
          return (a + b + c).cwiseProduct((b - a).cross(c - a)) / 6.0;
        },
        Vector3d(Vector3d::Zero()));
  }
  // The sum has each panel twice, and half a hull counts twice.
  return (half ? 1.0 : 0.5) * sum;
}

double PanelMesh::area() const {
  double sum = 0.0;
  for (const std::array<int, 4>& panel : panels) {
    sum += over_triangles(
        corners_of(*this, panel),
        [](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
          return 0.5 * (b - a).cross(c - a).norm();
        },
        0.0);
  }
  return (half ? 1.0 : 0.5) * sum;
}

PanelMesh wetted_panels(const analysis::HullBody& body, const analysis::FloatingPosition& position,
                        const PanelSizes& sizes, double origin_x,
                        const surface::Progress& progress) {
  if (!std::isfinite(origin_x)) throw std::invalid_argument("origin_x must be a finite number.");
  const analysis::Plane water = analysis::water_plane(position);
  PanelMesh mesh;
  mesh.displaced_volume = volume_alone(body, water);
  // Without heel the water is symmetric about the centre plane, too.
  mesh.half = body.mirrored() && position.heel == 0.0;
  mesh.axes = water_axes(position);
  const Vector3d base(origin_x, 0.0, 0.0);
  mesh.origin = base - water.height(base) * water.normal;

  const bool both_sides = body.mirrored() && !mesh.half;
  const PanelSizeField field(body.surface(), water, both_sides, sizes);
  const SidePoints sides = panel_sides(body.surface(), field, sizes);
  GridOptions options;
  options.both_sides = both_sides;
  options.places = true;
  options.progress = surface::part_of(progress, 0.05, 0.3);
  options.parts_across = [&](const ClosingLines& lines) {
    return parts_across(lines, field, water);
  };
  const HullGrid grid = hull_grid(body, sides, options);
  const surface::Progress cutting = surface::part_of(progress, 0.3, 1.0);
  take_panels(WaterCut(body.surface(), grid, water, cutting), mesh);
  if (mesh.panels.empty()) {
    throw std::invalid_argument("Nothing of the hull is wet but points; raise the draft.");
  }
  return mesh;
}

}  // namespace hull::production
