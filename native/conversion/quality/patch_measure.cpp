// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/quality/patch_measure.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "conversion/blocks/block_places.h"
#include "conversion/blocks/near_surface.h"
#include "conversion/quality/sample_line.h"
#include "surface/queries/closest_point.h"

namespace hull::conversion {
namespace {

// Of a largest distance: what a longer search for it may gain.
constexpr double kAlmost = 0.999;

// Knots of one direction, and the borders of cells.
// `begin`, `end`: the part of so many cells that is meant.
std::vector<double> breaks_of(const std::vector<double>& knots, int cells, double begin,
                              double end) {
  std::vector<double> numbers = knots;
  for (int i = 1; i < cells; ++i) {
    // By the patch's parameter; those beyond its part are left out by breaks_between().
    numbers.push_back((static_cast<double>(i) / cells - begin) / (end - begin));
  }
  return breaks_between(std::move(numbers));
}

int distinct_count(const std::vector<double>& knots) {
  return static_cast<int>(breaks_between(knots).size());
}

// The functions of one direction at all samples.
std::vector<BasisValues> basis_at(const std::vector<double>& knots, int degree,
                                  const SampleLine& line) {
  std::vector<BasisValues> result;
  for (double at : line.at) result.push_back(basis_values(knots, degree, at));
  return result;
}

// A sample that stands for some area.
struct Candidate {
  Worst found;
  double area;  // m2
};

class PatchMeasure {
 public:
  PatchMeasure(const QualityGauge& gauge, int patch)
      : gauge_(gauge), patch_(gauge.set.patches[patch]), block_(gauge.set.blocks[patch]) {
    const std::array<bool, 4> fine = irregular_corners();
    std::vector<double> u = breaks_of(patch_.knots_u, block_.count_u, block_.begin_u, block_.end_u);
    std::vector<double> v = breaks_of(patch_.knots_v, block_.count_v, block_.begin_v, block_.end_v);
    // Corners 0 and 3 are where u begins, 0 and 1 where v does.
    refine_ends(u, fine[0] || fine[3], fine[1] || fine[2]);
    refine_ends(v, fine[0] || fine[1], fine[2] || fine[3]);
    u_ = sample_line(u, gauge.rule);
    v_ = sample_line(v, gauge.rule);
    along_v_ = basis_at(patch_.knots_v, patch_.degree_v, v_);
    const std::size_t intervals = static_cast<std::size_t>(u_.interval_count) * v_.interval_count;
    areas_.assign(intervals, 0.0);
    largest_.assign(intervals, 0.0);
  }

  PatchQuality measure(const surface::Progress& progress) {
    const std::vector<BasisValues> along_u = basis_at(patch_.knots_u, patch_.degree_u, u_);
    for (std::size_t i = 0; i < along_u.size(); ++i) {
      surface::tell(progress, static_cast<double>(i), static_cast<double>(along_u.size()));
      contract(along_u[i]);
      for (std::size_t j = 0; j < along_v_.size(); ++j) take_sample(i, j);
    }
    take_largest();
    const double exact = QualityReport::kExactDistance * gauge_.length;
    for (std::size_t k = 0; k < areas_.size(); ++k) {
      found_.area += areas_[k];
      if (largest_[k] <= exact) found_.exact_area += areas_[k];
    }
    if (found_.area > 0.0) {
      found_.rms_distance = std::sqrt(std::max(squares_, 0.0) / found_.area);
    }
    return found_;
  }

 private:
  std::array<bool, 4> irregular_corners() const {
    const mesh::Topology& cells = gauge_.surface.cells();
    std::array<bool, 4> result{};
    for (int k = 0; k < 4; ++k) {
      // A part of a block has the block's corner only where both sides that meet there are the
      // block's.
      if (!is_on_side(block_, k) || !is_on_side(block_, (k + 3) % 4)) continue;
      result[k] = gauge_.irregular[cells.origin(block_.half_edges(cells, k).front())] != 0;
    }
    return result;
  }

  // The curve along v at one u: its control points, and those of its change along u.
  void contract(const BasisValues& u) {
    points_.assign(patch_.count_v, Vector3d::Zero());
    slopes_.assign(patch_.count_v, Vector3d::Zero());
    for (int a = 0; a <= patch_.degree_u; ++a) {
      for (int j = 0; j < patch_.count_v; ++j) {
        const Vector3d& point = patch_.control_point(u.first + a, j);
        points_[j] += u.rows(0, a) * point;
        slopes_[j] += u.rows(1, a) * point;
      }
    }
  }

  void take_sample(std::size_t i, std::size_t j) {
    const BasisValues& v = along_v_[j];
    Vector3d point = Vector3d::Zero(), du = Vector3d::Zero(), dv = Vector3d::Zero();
    for (int b = 0; b <= patch_.degree_v; ++b) {
      point += v.rows(0, b) * points_[v.first + b];
      dv += v.rows(1, b) * points_[v.first + b];
      du += v.rows(0, b) * slopes_[v.first + b];
    }
    NearPoint near{place_in_block(block_, u_.at[i], v_.at[j]), 0.0};
    const auto [cell, cell_u, cell_v] = near.place;
    // At its own place first: where the patch is exact no descent is needed.
    near.distance = (point - gauge_.ringed.position(cell, cell_u, cell_v)).norm();
    if (near.distance > gauge_.negligible()) {
      near = near_surface(gauge_.ringed, point, near.place, gauge_.negligible());
    }
    // Nothing at the sides, whose samples have no weight: they count for the largest distances
    // only.
    const double area = u_.weights[i] * v_.weights[j] * du.cross(dv).norm();
    const int interval = u_.intervals[i] * v_.interval_count + v_.intervals[j];
    areas_[interval] += area;
    largest_[interval] = std::max(largest_[interval], near.distance);
    squares_ += area * near.distance * near.distance;
    if (near.distance > gauge_.negligible()) {
      candidates_.push_back({{near.distance, point, near.place}, area});
    } else {
      // What is rounding needs no second look.
      found_.distance.take(near.distance, point, near.place);
    }
  }

  // No descent can be trusted with the largest distances: the surface may be nearer elsewhere.
  void take_largest() {
    std::sort(candidates_.begin(), candidates_.end(),
              [](const Candidate& a, const Candidate& b) { return a.found.value > b.found.value; });
    for (const auto& [found, area] : candidates_) {
      // The others are smaller still.
      if (kAlmost * found.value <= found_.distance.value) return;
      // A little farther, so that the foot that is known is found: without one all that is as near
      // would be cut to parts.
      const surface::ClosestPoint closest =
          surface::closest_point(gauge_.tree, found.point, found.value + gauge_.negligible());
      if (closest.cell >= 0 && closest.distance < found.value) {
        const CellPoint place{closest.cell, closest.u, closest.v};
        found_.distance.take(closest.distance, found.point, place);
        // In place of what the descent had found.
        squares_ += area * (closest.distance * closest.distance - found.value * found.value);
      } else {
        found_.distance.take(found);
      }
    }
  }

  const QualityGauge& gauge_;
  const BSplinePatch& patch_;
  const Block& block_;
  SampleLine u_, v_;
  std::vector<BasisValues> along_v_;
  std::vector<Vector3d> points_, slopes_;
  std::vector<double> areas_, largest_;  // per pair of intervals
  std::vector<Candidate> candidates_;    // what a descent has found, above what is negligible
  double squares_ = 0.0;
  PatchQuality found_;
};

}  // namespace

std::vector<char> irregular_vertices(const surface::LimitSurface& surface) {
  const mesh::Topology& cells = surface.cells();
  std::vector<char> result(cells.vertex_count(), 0);
  for (int h = 0; h < cells.half_edge_count(); ++h) {
    const CellPoint corner = place_beside_half_edge(h, 0.0, 0.0);
    if (surface.is_irregular_knot(corner.cell, corner.u, corner.v)) result[cells.origin(h)] = 1;
  }
  return result;
}

PatchQuality measure_patch(const QualityGauge& gauge, int patch,
                           const surface::Progress& progress) {
  const BSplinePatch& measured = gauge.set.patches[patch];
  const Block& block = gauge.set.blocks[patch];
  PatchQuality found;
  if (!block.sides.empty()) found = PatchMeasure(gauge, patch).measure(progress);
  found.cells = static_cast<int>(block.sides.size());
  found.knot_count = distinct_count(measured.knots_u) + distinct_count(measured.knots_v);
  found.control_point_count = static_cast<int>(measured.control_points.size());
  return found;
}

}  // namespace hull::conversion
