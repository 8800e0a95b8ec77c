// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/fairness/surface_field.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "surface/parallel_for.h"

namespace hull::analysis {
namespace {

constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kGrain = 512;  // a place takes about a third of a microsecond

// From the fundamental forms (do Carmo 1976, 3-3), without directions.
double curvature_value(const surface::SurfaceJet& jet, FieldKind kind) {
  const Vector3d cross = jet.du.cross(jet.dv);
  const double area2 = cross.squaredNorm();
  const double e = jet.du.squaredNorm(), f = jet.du.dot(jet.dv), g = jet.dv.squaredNorm();
  if (!(area2 > 1e-24 * e * g)) return kUndefined;
  // Positive where the surface bulges towards its normal. These are sqrt(area2) times as large.
  const double l = -cross.dot(jet.duu), m = -cross.dot(jet.duv), n = -cross.dot(jet.dvv);
  const double gaussian = (l * n - m * m) / (area2 * area2);
  if (kind == FieldKind::kGaussian) return gaussian;
  const double mean = 0.5 * (e * n - 2.0 * f * m + g * l) / (area2 * std::sqrt(area2));
  if (kind == FieldKind::kMean) return mean;
  // At umbilics rounding may leave less than zero.
  const double half = std::sqrt(std::max(mean * mean - gaussian, 0.0));
  return kind == FieldKind::kMaximum ? mean + half : mean - half;
}

double slope_of(const Vector3d& normal, const Vector3d& direction) {
  if (normal.isZero(0.0)) return kUndefined;
  // Exact near 0 and π, too.
  return std::atan2(normal.cross(direction).norm(), normal.dot(direction));
}

double value_at(const surface::LimitSurface& surface, int cell, const Eigen::Vector2d& uv,
                FieldKind kind, const Vector3d& direction) {
  if (kind == FieldKind::kSlope) {
    return slope_of(surface.normal(cell, uv.x(), uv.y()), direction);
  }
  if (surface.is_irregular_knot(cell, uv.x(), uv.y())) {
    const auto beside = [](double t) {
      return t > 0.5 ? 1.0 - surface::kKnotOffset : surface::kKnotOffset;
    };
    return curvature_value(surface.evaluate(cell, beside(uv.x()), beside(uv.y()), 2), kind);
  }
  return curvature_value(surface.evaluate(cell, uv.x(), uv.y(), 2), kind);
}

// Means of neighbours for the values that are not `known`; those without any wait for another
// round.
void fill_from_neighbours(const surface::Tessellation& tessellation, std::vector<char>& known,
                          std::vector<double>& values) {
  std::vector<double> sums(values.size());
  std::vector<int> counts(values.size());
  for (bool found = true; found;) {
    std::fill(sums.begin(), sums.end(), 0.0);
    std::fill(counts.begin(), counts.end(), 0);
    for (const auto& corners : tessellation.corner_normals) {
      for (int k = 0; k < 4; ++k) {
        if (known[corners[k]]) continue;
        for (const int other : {corners[(k + 1) % 4], corners[(k + 3) % 4]}) {
          if (!known[other]) continue;
          sums[corners[k]] += values[other];
          ++counts[corners[k]];
        }
      }
    }
    found = false;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (known[i] || counts[i] == 0) continue;
      values[i] = sums[i] / counts[i];
      known[i] = 1;
      found = true;
    }
  }
}

}  // namespace

std::vector<double> surface_field(const surface::LimitSurface& surface,
                                  const std::vector<int>& cells,
                                  const std::vector<Eigen::Vector2d>& uv, FieldKind kind,
                                  const Vector3d& direction) {
  std::vector<double> values(cells.size());
  surface::parallel_for(
      cells.size(), surface::kAllProcessors,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          values[i] = value_at(surface, cells[i], uv[i], kind, direction);
        }
      },
      kGrain);
  return values;
}

std::vector<double> surface_field(const surface::LimitSurface& surface,
                                  const surface::Tessellation& tessellation, FieldKind kind,
                                  const Vector3d& direction) {
  if (kind == FieldKind::kSlope) {
    return normal_field(tessellation, [&](const Vector3d&, const Vector3d& normal) {
      return slope_of(normal, direction);
    });
  }
  std::vector<double> values =
      surface_field(surface, tessellation.normal_cells, tessellation.normal_uv, kind, direction);
  std::vector<char> known(values.size());
  bool all_known = true;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Eigen::Vector2d& uv = tessellation.normal_uv[i];
    // Beside an irregular knot curvature depends on the way on which the knot is come near.
    known[i] = std::isfinite(values[i]) &&
               !surface.is_irregular_knot(tessellation.normal_cells[i], uv.x(), uv.y());
    all_known = all_known && known[i];
  }
  if (!all_known) fill_from_neighbours(tessellation, known, values);
  return values;
}

std::vector<double> normal_field(const surface::Tessellation& tessellation,
                                 const NormalFunction& function) {
  std::vector<const Vector3d*> points(tessellation.normals.size(), nullptr);
  for (std::size_t q = 0; q < tessellation.quads.size(); ++q) {
    for (int k = 0; k < 4; ++k) {
      // All corners that share a normal share a point.
      points[tessellation.corner_normals[q][k]] = &tessellation.points[tessellation.quads[q][k]];
    }
  }
  std::vector<double> values(points.size(), kUndefined);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Vector3d& normal = tessellation.normals[i];
    if (points[i] && !normal.isZero(0.0)) values[i] = function(*points[i], normal);
  }
  return values;
}

std::vector<double> field_weights(const surface::Tessellation& tessellation) {
  std::vector<double> weights(tessellation.normals.size(), 0.0);
  for (std::size_t q = 0; q < tessellation.quads.size(); ++q) {
    const auto& corners = tessellation.quads[q];
    const auto point = [&](int k) -> const Vector3d& { return tessellation.points[corners[k]]; };
    const Vector3d one = point(2) - point(0), other = point(3) - point(1);
    // A plane quadrilateral has half of the cross product of its diagonals.
    const double quarter = 0.125 * one.cross(other).norm();
    for (const int normal : tessellation.corner_normals[q]) weights[normal] += quarter;
  }
  return weights;
}

}  // namespace hull::analysis
