// SPDX-License-Identifier: GPL-3.0-or-later
// A smooth keel stays smooth whichever tool moves the control points: these heed the same limits.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "modelling/fit/fit.h"
#include "modelling/knuckle_setting.h"
#include "modelling/pull/pull.h"
#include "modelling/reshape/square_ties.h"
#include "test_meshes.h"

namespace hull::modelling {
namespace {

// Half of a bottom, square to its border in y = 0, with a knuckle along x at y = 2.
mesh::MeshArrays half_bottom() {
  const int length = 12;
  mesh::MeshArrays arrays = testing::grid(length, 8);
  for (Vector3d& p : arrays.points) p.z() = p.y() > 2.0 ? p.y() - 2.0 : 0.0;
  const int first = 2 * (length + 1);
  for (int i = 0; i < length; ++i) arrays.creases.push_back({first + i, first + i + 1});
  return arrays;
}

class TiedPoints : public ::testing::Test {
 protected:
  TiedPoints() : surface_(mesh::ControlMesh(half_bottom())) {
    limits_.tied = square_ties(surface_);
    for (std::size_t p = 0; p < points().size(); ++p) {
      if (points()[p].y() == 0.0) {
        limits_.limits.held.push_back({static_cast<int>(p), Vector3d::UnitY()});
      }
    }
  }

  const std::vector<Vector3d>& points() const { return surface_.mesh().points(); }

  // The largest difference of moves along what ties them, m.
  double torn(const std::vector<Vector3d>& moves) const {
    double most = 0.0;
    for (const TiedPoint& tie : limits_.tied) {
      most = std::max(most, std::abs(tie.direction.dot(moves[tie.point] - moves[tie.leader])));
    }
    return most;
  }

  template <class Moved>
  std::vector<Vector3d> moves_of(const Moved& moved) const {
    std::vector<Vector3d> moves(points().size(), Vector3d::Zero());
    for (std::size_t i = 0; i < moved.points.size(); ++i) moves[moved.points[i]] = moved.moves[i];
    return moves;
  }

  surface::LimitSurface surface_;
  ReshapeLimits limits_;
};

TEST_F(TiedPoints, ThereAreSome) {
  // In x and in z, of all points of the keel but its two ends.
  EXPECT_EQ(limits_.tied.size(), 2u * 11u);
}

TEST_F(TiedPoints, MoveTogetherInAPull) {
  PullTarget target{-1, 0.3, 0.6, {}};
  for (int cell = 0; cell < surface_.cell_count() && target.cell < 0; ++cell) {
    const Vector3d at = surface_.position(cell, target.u, target.v);
    if (at.y() < 1.0 && std::abs(at.x() - 6.0) < 1.0) target.cell = cell;
  }
  ASSERT_GE(target.cell, 0);
  target.point = surface_.position(target.cell, target.u, target.v) + Vector3d(0.2, 0.1, -0.5);
  for (const PullSpread& spread : {PullSpread{}, PullSpread{3.0, true}}) {
    EXPECT_GT(torn(moves_of(pull(surface_, {target}, {limits_.limits}, spread))), 1e-3);
    const Pull pulled = pull(surface_, {target}, limits_, spread);
    EXPECT_LT(torn(moves_of(pulled)), 1e-15);
    EXPECT_LT(pulled.miss, 1e-13);
    for (const HeldDirection& held : limits_.limits.held) {
      EXPECT_EQ(moves_of(pulled)[held.point].y(), 0.0);
    }
  }
}

TEST_F(TiedPoints, MoveTogetherInAFit) {
  FitTarget target;
  for (int cell = 0; cell < surface_.cell_count(); ++cell) {
    for (double u : {0.2, 0.5, 0.8}) {
      const Vector3d at = surface_.position(cell, u, 0.4);
      target.points.emplace_back(at + Vector3d(0.0, 0.0, 0.1 * at.y() + 0.05 * std::sin(at.x())));
    }
  }
  const auto moves = [&](const ReshapeLimits& limits) {
    FitOptions options;
    options.limits = limits;
    std::vector<Vector3d> result = fit(surface_, target, {}, options).points;
    for (std::size_t i = 0; i < result.size(); ++i) result[i] -= points()[i];
    return result;
  };
  EXPECT_GT(torn(moves({limits_.limits})), 1e-2);
  EXPECT_LT(torn(moves(limits_)), 1e-14);
}

TEST_F(TiedPoints, MoveTogetherAsAKnuckleIsSet) {
  const surface::CreaseCurve* knuckle = nullptr;
  const std::vector<surface::CreaseCurve> curves = surface::crease_curves(surface_);
  for (const surface::CreaseCurve& curve : curves) {
    const int end = curve.vertices().front();
    if (points()[end].y() == 2.0 && points()[curve.vertices()[1]].y() == 2.0) knuckle = &curve;
  }
  ASSERT_NE(knuckle, nullptr);
  // The only points beside the knuckle on the keel's side are those tied to the keel.
  const double angle = 50.0 / 180.0 * std::numbers::pi;
  const auto set = [&](const ReshapeLimits& limits) {
    return moves_of(set_knuckle_angle(surface_, *knuckle, angle, limits));
  };
  EXPECT_GT(torn(set({limits_.limits})), 1e-3);
  EXPECT_LT(torn(set(limits_)), 1e-14);
}

}  // namespace
}  // namespace hull::modelling
