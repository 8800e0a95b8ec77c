// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/panels/panel_sizes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "surface/place_in_cell.h"

namespace hull::production {
namespace {

constexpr int kIntervals = 32;  // of a side, in which sizes and speeds are taken for constant

void check(const PanelSizes& sizes) {
  std::ostringstream words;
  if (!(sizes.size > 0.0) || !std::isfinite(sizes.size)) {
    words << "The size of panels must be a positive length, not " << sizes.size << " m.";
    throw std::invalid_argument(words.str());
  }
  if (!(sizes.grading > 0.0 && sizes.grading <= 1.0)) {
    words << "The grading of panels, the part of their size that they have at the ends and at the "
             "water's surface, is above 0 and at most 1, not "
          << sizes.grading << ".";
    throw std::invalid_argument(words.str());
  }
}

Vector3d on_side(const surface::LimitSurface& surface, int h, double t) {
  const Eigen::Vector2d uv = surface::on_square_side(h % 4, t);
  return surface.position(h / 4, uv.x(), uv.y());
}

// How many panels fit along a side, up to each of kIntervals + 1 points of it.
std::vector<double> panels_along(const surface::LimitSurface& surface, int h,
                                 const PanelSizeField& field) {
  std::vector<double> sums{0.0};
  Vector3d last = on_side(surface, h, 0.0);
  for (int k = 1; k <= kIntervals; ++k) {
    const Vector3d next = on_side(surface, h, static_cast<double>(k) / kIntervals);
    sums.push_back(sums.back() + (next - last).norm() / field.at(0.5 * (last + next)));
    last = next;
  }
  return sums;
}

// The parameters at which equal shares of the sums are reached, linear within the intervals.
std::vector<double> equal_shares(const std::vector<double>& sums, int parts) {
  std::vector<double> parameters{0.0};
  int k = 0;
  for (int i = 1; i < parts; ++i) {
    const double wanted = sums.back() * i / parts;
    while (k + 1 < kIntervals && sums[k + 1] < wanted) ++k;
    parameters.push_back((k + (wanted - sums[k]) / (sums[k + 1] - sums[k])) / kIntervals);
  }
  parameters.push_back(1.0);
  return parameters;
}

}  // namespace

PanelSizeField::PanelSizeField(const surface::LimitSurface& surface, const analysis::Plane& water,
                               bool both_sides, const PanelSizes& sizes)
    : water_(water), both_sides_(both_sides), sizes_(sizes), wet_(surface.cell_count(), 0) {
  check(sizes);
  const Vector3d& up = water.normal;
  // Level and ahead: the ship's own x laid into the water.
  along_ = (Vector3d::UnitX() - up.x() * up).normalized();
  aft_ = std::numeric_limits<double>::infinity();
  forward_ = -aft_;
  constexpr int kSamples = 8;
  for (int cell = 0; cell < surface.cell_count(); ++cell) {
    for (int j = 0; j <= kSamples; ++j) {
      for (int i = 0; i <= kSamples; ++i) {
        Vector3d p = surface.position(cell, static_cast<double>(i) / kSamples,
                                      static_cast<double>(j) / kSamples);
        // The point, then its mirror image.
        for (int side = 0; side < (both_sides ? 2 : 1); ++side, p.y() = -p.y()) {
          if (water.height(p) > 0.0) continue;
          wet_[cell] = 1;
          aft_ = std::min(aft_, along_.dot(p));
          forward_ = std::max(forward_, along_.dot(p));
        }
      }
    }
  }
  if (!(aft_ <= forward_)) {
    throw std::invalid_argument("The hull is out of the water; raise the draft.");
  }
}

double PanelSizeField::height(const Vector3d& p) const {
  const double own = std::abs(water_.height(p));
  if (!both_sides_) return own;
  // Both sides are divided alike: the one nearer to the water decides.
  return std::min(own, std::abs(water_.height({p.x(), -p.y(), p.z()})));
}

double PanelSizeField::at(const Vector3d& p) const {
  const double x = along_.dot(p);
  const double from_ends = std::min(std::abs(x - aft_), std::abs(forward_ - x));
  const double distance = std::min(height(p), from_ends);
  return std::min(sizes_.size, sizes_.grading * sizes_.size + kPanelGrowth * distance);
}

SidePoints panel_sides(const surface::LimitSurface& surface, const PanelSizeField& field,
                       const PanelSizes& sizes) {
  const mesh::Topology& cells = surface.cells();
  surface::CellDivisions divisions(cells, 1);
  std::vector<std::vector<double>> sums(cells.edge_count());
  double most = 0.0;
  for (int h = 0; h < cells.half_edge_count(); ++h) {
    std::vector<double>& own = sums[cells.edge(h)];
    if (!cells.is_edge_front(h)) continue;
    own = panels_along(surface, h, field);
  }
  // A strip of cells is divided alike from end to end: its longest wet side decides; dry strips
  // stay undivided.
  std::vector<double> wanted(divisions.strip_count(), 1.0);
  for (int h = 0; h < cells.half_edge_count(); ++h) {
    if (!field.is_wet(h / 4)) continue;
    double& strip = wanted[divisions.strip(h)];
    // Rounding is no reason for one more part.
    strip = std::max(strip, std::ceil(sums[cells.edge(h)].back() - 1e-9));
  }
  for (int cell = 0; cell < cells.face_count(); ++cell) {
    most += wanted[divisions.strip(4 * cell)] * wanted[divisions.strip(4 * cell + 1)];
  }
  if (most > kMostPanels) {
    // Their number goes with the square of the size; 5 % are left for parts that are rounded up.
    const double enough = sizes.size * std::sqrt(most / kMostPanels) * 1.05;
    std::ostringstream words;
    words.precision(2);
    words << "Panels of " << sizes.size << " m are more than 2^20. " << enough << " m would do.";
    throw std::invalid_argument(words.str());
  }
  for (int strip = 0; strip < divisions.strip_count(); ++strip) {
    divisions.set(strip, static_cast<int>(wanted[strip]));
  }
  SidePoints sides(cells, divisions);
  for (int h = 0; h < cells.half_edge_count(); ++h) {
    if (!cells.is_edge_front(h)) continue;
    const std::vector<double>& own = sums[cells.edge(h)];
    // A side without length, at a pole, is divided evenly.
    if (own.back() > 0.0) sides.set(cells.edge(h), equal_shares(own, divisions.side(h)));
  }
  return sides;
}

}  // namespace hull::production
