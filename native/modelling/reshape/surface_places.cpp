// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/reshape/surface_places.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "modelling/gauss_rule.h"
#include "surface/pieces/piece_weights.h"

namespace hull::modelling {
namespace {

// Of the sine of the angle between the sides of a piece: below, it has no area to speak of.
constexpr double kNoArea = 1e-9;
// Of the areas of neighbouring rings: more is no geometric series.
constexpr double kSlowestDecay = 0.8;

}  // namespace

// Walks through the pieces in the order in which PieceWeights has them.
class SurfacePlaces::Builder {
 public:
  Builder(SurfacePlaces& places, const surface::LimitSurface& surface)
      : places_(places), surface_(surface), pieces_(surface), deep_(surface) {}

  void build() {
    for (int cell = 0; cell < surface_.cell_count(); ++cell) {
      cell_ = cell;
      add_node(surface_.layout().root(cell), {0.0, 0.0}, 1.0);
    }
    const auto columns = static_cast<Eigen::Index>(surface_.mesh().points().size());
    const std::array<std::pair<Rows*, const Entries*>, 3> all{
        {{&places_.rows_, &at_}, {&places_.along_s_, &along_s_}, {&places_.along_t_, &along_t_}}};
    for (const auto& [rows, entries] : all) {
      rows->resize(places_.count(), columns);
      rows->setFromTriplets(entries->begin(), entries->end());
    }
    for (double area : places_.areas_) places_.total_area_ += area;
  }

 private:
  using Entries = std::vector<Eigen::Triplet<double>>;

  void add_node(const surface::SurfaceNode& node, const Eigen::Vector2d& begin, double size) {
    switch (node.kind) {
      case surface::SurfaceNode::Kind::kLeaf:
        add_piece(kThreePoints);
        return;
      case surface::SurfaceNode::Kind::kCorner:
        add_corner(node, begin, size);
        return;
      case surface::SurfaceNode::Kind::kSplit:
        break;
    }
    const auto& children = surface_.layout().split(node.index);
    for (int k = 0; k < 4; ++k) {
      const Eigen::Vector2d step(0.5 * size * (k % 2), 0.5 * size * (k / 2));
      add_node(children[k], begin + step, 0.5 * size);
    }
  }

  void add_corner(const surface::SurfaceNode& node, const Eigen::Vector2d& begin, double size) {
    const int segments = surface_.layout().basis(node.index).segment_count();
    double before = 0.0, area = 0.0;
    for (int ring = 0; ring < surface::kPlainRings; ++ring) {
      before = std::exchange(area, 0.0);
      for (int k = 0; k < segments; ++k) area += add_piece(kTwoPoints);
    }
    const double decay = before > 0.0 ? std::min(area / before, kSlowestDecay) : 0.0;
    const bool right = node.turn == 1 || node.turn == 2, above = node.turn >= 2;
    add_knot(begin + size * Eigen::Vector2d(right, above), area * decay / (1.0 - decay));
  }

  // The next piece's places; its area, m².
  double add_piece(const GaussRule& rule) {
    double sum = 0.0;
    for (int i = 0; i < rule.count; ++i) {
      for (int j = 0; j < rule.count; ++j) {
        sum +=
            add_place({piece_, rule.points[i], rule.points[j]}, rule.weights[i] * rule.weights[j]);
      }
    }
    ++piece_;
    return sum;
  }

  double add_place(const surface::PieceWeights::Place& place, double share) {
    const std::vector<int>& points = pieces_.piece(place.piece).points;
    const surface::PieceWeights::Jet jet = pieces_.jet(place);
    const Vector3d s = sum(points, jet.ds), t = sum(points, jet.dt), across = s.cross(t);
    const double area = share * across.norm();
    add_entries(at_, points, jet.at);
    const bool has_normal = across.norm() > kNoArea * s.norm() * t.norm();
    if (has_normal) {
      add_entries(along_s_, points, jet.ds);
      add_entries(along_t_, points, jet.dt);
    }
    add(sum(points, jet.at), has_normal ? Vector3d(across.normalized()) : Vector3d::Zero(), area);
    return area;
  }

  void add_knot(const Eigen::Vector2d& uv, double area) {
    for (const surface::PointWeight& w : deep_.at(cell_, uv.x(), uv.y())) {
      at_.emplace_back(places_.count(), w.point, w.weight);
    }
    add(surface_.position(cell_, uv.x(), uv.y()), Vector3d::Zero(), area);
  }

  void add(const Vector3d& position, const Vector3d& normal, double area) {
    places_.cells_.push_back(cell_);
    places_.positions_.push_back(position);
    places_.normals_.push_back(normal);
    places_.areas_.push_back(area);
  }

  void add_entries(Entries& entries, const std::vector<int>& points,
                   const Eigen::VectorXd& weights) const {
    for (std::size_t k = 0; k < points.size(); ++k) {
      entries.emplace_back(places_.count(), points[k], weights[static_cast<Eigen::Index>(k)]);
    }
  }

  Vector3d sum(const std::vector<int>& points, const Eigen::VectorXd& weights) const {
    Vector3d result = Vector3d::Zero();
    for (std::size_t k = 0; k < points.size(); ++k) {
      result += weights[static_cast<Eigen::Index>(k)] * surface_.mesh().points()[points[k]];
    }
    return result;
  }

  SurfacePlaces& places_;
  const surface::LimitSurface& surface_;
  const surface::PieceWeights pieces_;
  surface::PointWeights deep_;
  Entries at_, along_s_, along_t_;
  int cell_ = 0, piece_ = 0;
};

SurfacePlaces::SurfacePlaces(const surface::LimitSurface& surface) {
  Builder(*this, surface).build();
}

int SurfacePlaces::first_fold(const std::vector<Vector3d>& control_points) const {
  Eigen::MatrixX3d points(static_cast<Eigen::Index>(control_points.size()), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i) points.row(i) = control_points[i].transpose();
  const Eigen::MatrixX3d s = along_s_ * points, t = along_t_ * points;
  for (int k = 0; k < count(); ++k) {
    if (normals_[k].isZero(0.0)) continue;
    const Vector3d across = s.row(k).transpose().cross(Vector3d(t.row(k).transpose()));
    if (!(across.dot(normals_[k]) > 0.0)) return k;
  }
  return -1;
}

}  // namespace hull::modelling
