// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/height_net.h"

#include <cmath>

namespace hull::analysis {
namespace {

// Coefficient k of a side's own row, and of the rows j = 0 … 3 from it inwards.
int row_index(int side, int k, int j) {
  switch (side) {
    case 0:
      return 4 * j + k;
    case 1:
      return 4 * k + 3 - j;
    case 2:
      return 4 * (3 - j) + k;
    default:
      return 4 * k + j;
  }
}

bool vanishes(const BezierNet& net, int side, double tolerance) {
  for (int k = 0; k < 4; ++k) {
    if (std::abs(net[row_index(side, k, 0)]) > tolerance) return false;
  }
  return true;
}

// Divides by the distance from the side: of degree two across, and raised to three again.
void divide_out(BezierNet& net, int side) {
  for (int k = 0; k < 4; ++k) {
    // B_k, of degree three, divided by the distance is 3, 3/2 or 1 times B_k-1 of degree two.
    const double g0 = 3.0 * net[row_index(side, k, 1)], g1 = 1.5 * net[row_index(side, k, 2)];
    const double g2 = net[row_index(side, k, 3)];
    net[row_index(side, k, 0)] = g0;
    net[row_index(side, k, 1)] = (g0 + 2.0 * g1) / 3.0;
    net[row_index(side, k, 2)] = (2.0 * g1 + g2) / 3.0;
    net[row_index(side, k, 3)] = g2;
  }
}

}  // namespace

BezierCubic HeightNet::along(int side) const {
  BezierCubic cubic;
  for (int k = 0; k < 4; ++k) cubic[k] = net[row_index(side, k, 0)];
  return cubic;
}

HeightNet height_net(const surface::BicubicPoints& points, const Plane& plane,
                     const HeightTolerances& tolerances, const SideFlags& may_lie) {
  HeightNet result{bezier_net(points, plane.normal, plane.offset), {}, false, false};
  BezierNet& net = result.net;
  double low = net[0], high = net[0];
  for (const double h : net) {
    low = std::min(low, h);
    high = std::max(high, h);
  }
  result.flat = low >= -tolerances.flat && high <= tolerances.flat && may_lie == kAllSides;
  if (result.flat || low > tolerances.flat || high < -tolerances.flat) return result;
  // Corners tell of most sides that they are not in the plane.
  const std::array<bool, 4> near{
      std::abs(net[0]) <= tolerances.flat, std::abs(net[3]) <= tolerances.flat,
      std::abs(net[15]) <= tolerances.flat, std::abs(net[12]) <= tolerances.flat};
  for (int side = 0; side < 4; ++side) {
    if (!may_lie[side] || !near[side] || !near[(side + 1) % 4]) continue;
    // All of them before any is divided out, which changes coefficients of the sides beside it.
    result.in_plane[side] = vanishes(net, side, tolerances.flat);
    result.divided = result.divided || result.in_plane[side];
  }
  for (int side = 0; side < 4; ++side) {
    // A cubic that is not zero vanishes three times at most.
    for (int i = 0; i < 3 && result.in_plane[side]; ++i) {
      if (!vanishes(net, side, tolerances.flat)) break;
      divide_out(net, side);
    }
  }
  flush_to_zero(net, tolerances.zero);
  return result;
}

HeightJet height_jet(const BezierNet& net, double u, double v) {
  struct Basis3 {
    BernsteinBasis first;
    std::array<double, 4> second;
    explicit Basis3(double t)
        : first(t),
          second{6.0 * (1.0 - t), 6.0 * (3.0 * t - 2.0), 6.0 * (1.0 - 3.0 * t), 6.0 * t} {}
  };
  const Basis3 at_u(u), at_v(v);
  HeightJet jet{};
  for (int j = 0; j < 4; ++j) {
    double c = 0.0, du = 0.0, duu = 0.0;
    for (int i = 0; i < 4; ++i) {
      const double value = net[4 * j + i];
      c += at_u.first.b[i] * value;
      du += at_u.first.d[i] * value;
      duu += at_u.second[i] * value;
    }
    jet.u += at_v.first.b[j] * du;
    jet.v += at_v.first.d[j] * c;
    jet.uu += at_v.first.b[j] * duu;
    jet.uv += at_v.first.d[j] * du;
    jet.vv += at_v.second[j] * c;
  }
  return jet;
}

}  // namespace hull::analysis
