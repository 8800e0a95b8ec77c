// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/quality/seam_measure.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

#include "conversion/blocks/block_places.h"
#include "conversion/quality/sample_line.h"

namespace hull::conversion {
namespace {

double angle_between(const Vector3d& one, const Vector3d& two) {
  return std::atan2(one.cross(two).norm(), one.dot(two));
}

// Of the normal section in a direction of the tangent plane, positive where the surface bulges
// towards its normal; none where there is no normal.
std::optional<double> section_curvature(const surface::SurfaceJet& jet, const Vector3d& normal,
                                        const Vector3d& direction) {
  Eigen::Matrix<double, 3, 2> slope;
  slope << jet.du, jet.dv;
  const Eigen::Matrix2d metric = slope.transpose() * slope;
  // The direction by du and dv (first fundamental form), of unit length in space.
  const Eigen::Vector2d step = metric.inverse() * slope.transpose() * direction;
  const Vector3d bend = step.x() * step.x() * jet.duu + 2.0 * step.x() * step.y() * jet.duv +
                        step.y() * step.y() * jet.dvv;
  const double curvature = -normal.dot(bend);
  return std::isfinite(curvature) ? std::optional(curvature) : std::nullopt;
}

// Of shares of sides, counted in cells.
constexpr double kSeamRounding = 1e-9;

// One patch along its part of a seam, with t from 0 to 1 in its own direction.
class Bank {
 public:
  Bank(const QualityGauge& gauge, const SeamSide& use)
      : cells_(gauge.surface.cells()),
        patch_(gauge.set.patches[use.patch]),
        block_(gauge.set.blocks[use.patch]),
        use_(use) {
    // A side within its block runs between cells or through them.
    if (!has_cells() || !is_on_side(block_, use.side)) return;
    half_edges_ = block_.half_edges(cells_, use.side);
    const auto [begin, end] = part_of_side(block_, use.side);
    const double count = static_cast<double>(half_edges_.size());
    begin_ = count * (begin + use.part.begin * (end - begin));
    end_ = count * (begin + use.part.end * (end - begin));
  }

  bool has_cells() const { return !block_.sides.empty(); }
  // Whether it runs along sides of cells, those of its block.
  bool is_along_cells() const { return !half_edges_.empty(); }
  int half_edge(double t) const {
    // Rounding must not lead into the cell before the seam or the one after it.
    const int first = static_cast<int>(std::floor(begin_ + kSeamRounding));
    const int last = static_cast<int>(std::ceil(end_ - kSeamRounding)) - 1;
    return half_edges_[std::clamp(static_cast<int>(begin_ + t * (end_ - begin_)), first, last)];
  }
  // Whether an irregular point is where the seam begins.
  bool begins_at_irregular_point(const QualityGauge& gauge) const {
    // Not within a side of a cell, whose half-edge begins elsewhere.
    return is_along_cells() && std::abs(begin_ - std::round(begin_)) < kSeamRounding &&
           gauge.irregular[cells_.origin(half_edge(0.0))] != 0;
  }
  CellPoint place(double t) const {
    if (!has_cells()) return {};
    const auto [u, v] = place_on_side(use_.side, on_side(t));
    return place_in_block(block_, u, v);
  }
  surface::SurfaceJet jet(double t) const {
    const auto [u, v] = place_on_side(use_.side, on_side(t));
    return patch_.evaluate(u, v);
  }
  Vector3d tangent(const surface::SurfaceJet& jet) const {
    const Vector3d along = use_.side % 2 == 0 ? jet.du : jet.dv;
    return use_.side < 2 ? along : Vector3d(-along);
  }
  // Knots and borders of cells within the seam, as t.
  void add_breaks(std::vector<double>& breaks, bool reversed) const {
    const auto add = [&](double s) {
      const double t = (s - use_.part.begin) / (use_.part.end - use_.part.begin);
      breaks.push_back(reversed ? 1.0 - t : t);
    };
    for (double knot : patch_.side_knots(use_.side)) add(knot);
    // Cells count along the block's side, which may be longer than the patch's.
    for (int i = static_cast<int>(std::ceil(begin_)); i < end_; ++i) {
      const double t = (i - begin_) / (end_ - begin_);
      breaks.push_back(reversed ? 1.0 - t : t);
    }
  }
  // Of a point to this side's curve, from t on: never more than that at t.
  double distance(const Vector3d& point, double t) const {
    double best = (point - jet(t).point).norm();
    for (int step = 0; step < 6; ++step) {
      const surface::SurfaceJet here = jet(t);
      // By t, which runs from 0 to 1 over the part.
      const Vector3d slope = (use_.part.end - use_.part.begin) * tangent(here);
      if (!(slope.squaredNorm() > 0.0)) break;
      t = std::clamp(t + slope.dot(point - here.point) / slope.squaredNorm(), 0.0, 1.0);
      const double next = (point - jet(t).point).norm();
      if (!(next < best)) break;
      best = next;
    }
    return best;
  }

 private:
  double on_side(double t) const { return use_.part.begin + t * (use_.part.end - use_.part.begin); }

  const mesh::Topology& cells_;
  const BSplinePatch& patch_;
  const Block& block_;
  const SeamSide& use_;
  std::vector<int> half_edges_;     // of the block's side
  double begin_ = 0.0, end_ = 0.0;  // along these, counted in cells
};

class SeamMeasure {
 public:
  SeamMeasure(const QualityGauge& gauge, const Seam& seam)
      : gauge_(gauge), one_(gauge, seam[0]), two_(gauge, seam[1]) {
    found_.edge = seam[0].part.edge;
    found_.patches = {seam[0].patch, seam[1].patch};
    find_irregular_ends();
  }

  SeamQuality measure() {
    std::vector<double> numbers;
    one_.add_breaks(numbers, false);
    two_.add_breaks(numbers, true);
    std::vector<double> breaks = breaks_between(std::move(numbers));
    refine_ends(breaks, is_irregular_[0], is_irregular_[1]);
    found_.is_smooth = one_.has_cells() && two_.has_cells();
    for (double t : sample_line(breaks, gauge_.rule).at) take_sample(t);
    if (!found_.is_smooth) {
      found_.angle = found_.angle_at_points = {};
      found_.curvature_jump = found_.curvature_jump_at_points = {};
    }
    return found_;
  }

 private:
  void find_irregular_ends() {
    // The other bank begins where this one ends.
    ends_ = {one_.jet(0.0).point, one_.jet(1.0).point};
    is_irregular_ = {one_.begins_at_irregular_point(gauge_),
                     two_.begins_at_irregular_point(gauge_)};
  }

  void take_sample(double t) {
    // Every bank counts along its own side, and the two run against each other.
    const surface::SurfaceJet here = one_.jet(t), there = two_.jet(1.0 - t);
    const Vector3d middle = 0.5 * (here.point + there.point);
    const CellPoint place = one_.has_cells() ? one_.place(t) : two_.place(1.0 - t);
    // At equal shares of the edge first: mostly nothing nearer need be looked for.
    double gap = (here.point - there.point).norm();
    if (gap > gauge_.negligible()) gap = two_.distance(here.point, 1.0 - t);
    found_.gap.take(gap, middle, place);
    // Smooth all along, or not at all: one sample on a crease drops what was taken before.
    found_.is_smooth = found_.is_smooth && is_smooth_at(t);
    if (!found_.is_smooth) return;
    const Vector3d normal = surface::unit_normal(here.du, here.dv),
                   other = surface::unit_normal(there.du, there.dv);
    if (normal.isZero(0.0) || other.isZero(0.0)) return;
    const bool at_point = is_at_irregular_point(middle);
    (at_point ? found_.angle_at_points : found_.angle)
        .take(angle_between(normal, other), middle, place);
    const Vector3d along = one_.tangent(here), back = two_.tangent(there);
    if (along.isZero(0.0) || back.isZero(0.0)) return;
    // The sign of the direction does not matter, so each bank may take its own.
    const auto across = section_curvature(here, normal, normal.cross(along).normalized());
    const auto beyond = section_curvature(there, other, other.cross(back).normalized());
    if (!across || !beyond) return;
    (at_point ? found_.curvature_jump_at_points : found_.curvature_jump)
        .take(std::abs(*across - *beyond), middle, place);
  }

  // Not on creases, nor where patches were joined across something left out.
  bool is_smooth_at(double t) const {
    if (!one_.is_along_cells() || !two_.is_along_cells()) return true;  // within a block
    const mesh::Topology& cells = gauge_.surface.cells();
    const int here = one_.half_edge(t), there = two_.half_edge(1.0 - t);
    return cells.twin(here) == there && !cells.is_crease(here);
  }

  bool is_at_irregular_point(const Vector3d& point) const {
    for (int k = 0; k < 2; ++k) {
      if (is_irregular_[k] && (point - ends_[k]).norm() <= gauge_.reach) return true;
    }
    return false;
  }

  const QualityGauge& gauge_;
  Bank one_, two_;
  std::array<Vector3d, 2> ends_;
  std::array<bool, 2> is_irregular_{};
  SeamQuality found_;
};

}  // namespace

std::vector<Seam> seams_of(const PatchSet& set) {
  std::vector<SeamSide> first(set.edge_count);
  std::vector<Seam> seams;
  for (int p = 0; p < static_cast<int>(set.patches.size()); ++p) {
    for (int k = 0; k < 4; ++k) {
      for (const SideEdge& part : set.sides[p][k]) {
        SeamSide& use = first[part.edge];
        if (use.patch >= 0) {
          seams.push_back({use, {p, k, part}});
        } else {
          use = {p, k, part};
        }
      }
    }
  }
  return seams;
}

SeamQuality measure_seam(const QualityGauge& gauge, const Seam& seam) {
  return SeamMeasure(gauge, seam).measure();
}

}  // namespace hull::conversion
