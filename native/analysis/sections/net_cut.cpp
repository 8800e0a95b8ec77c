// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/net_cut.h"

#include <cmath>

#include "analysis/arithmetic/bezier.h"
#include "surface/wide_code.h"

namespace hull::analysis {
namespace {

// Slopes that vary by more than this factor along v make zeros a badly behaved function of u.
constexpr double kSteadyNet = 0.1;
// Tangled squares are halved until they are simple, so small or so many.
constexpr int kDeepestSquare = 20;
constexpr std::size_t kMostTangled = 1024;

// How steadily a net rises or falls: 0 if not monotonic, 1 if linear.
double steadiness(const SlopeRange& slope) {
  if (slope.low > 0.0) return slope.low / slope.high;
  if (slope.high < 0.0) return slope.high / slope.low;
  return 0.0;
}

bool has_zero(const BezierNet& net) { return lowest(net) < 0.0 && highest(net) >= 0.0; }

// Adds the square to the parts, if it is simple.
bool take_simple(const NetSquare& square, std::vector<NetCut::Part>& parts) {
  const double along_v = steadiness(slope_range_v(square.net));
  const double along_u = steadiness(slope_range_u(square.net));
  if (std::max(along_u, along_v) < kSteadyNet) return false;
  parts.push_back({square, NetCut::Shape::kSimple});
  if (along_u > along_v) {
    parts.back().square.net = transposed(square.net);
    parts.back().shape = NetCut::Shape::kSimpleSwapped;
  }
  return true;
}

double value_at(const BezierNet& net, double u, double v) {
  const BernsteinBasis at_u(u), at_v(v);
  return NetJet(Column(net, at_u), at_v).value;
}

}  // namespace

void NetCut::divide(const BezierNet& net) {
  parts.clear();
  level_.clear();
  if (!has_zero(net)) return;
  const NetSquare whole{net, 0.0, 0.0, 1.0};
  if (!take_simple(whole, parts)) level_.push_back(whole);
  // Level by level, so that their number is seen where squares multiply instead of becoming simple,
  // as along a line of contact.
  for (int depth = 1; !level_.empty(); ++depth) {
    next_.clear();
    for (const NetSquare& square : level_) {
      const double half = 0.5 * square.size;
      std::array<BezierNet, 2> sides;
      halve_v(square.net, sides[0], sides[1]);
      for (int j = 0; j < 2; ++j) {
        std::array<BezierNet, 2> quarters;
        halve_u(sides[j], quarters[0], quarters[1]);
        for (int i = 0; i < 2; ++i) {
          if (!has_zero(quarters[i])) continue;
          const NetSquare quarter{quarters[i], square.u + i * half, square.v + j * half, half};
          if (!take_simple(quarter, parts)) next_.push_back(quarter);
        }
      }
    }
    std::swap(level_, next_);
    if (depth == kDeepestSquare || level_.size() > kMostTangled) {
      for (const NetSquare& square : level_) parts.push_back({square, Shape::kTangled});
      return;
    }
  }
}

SideCrossings side_crossings(const BezierNet& net) {
  SideCrossings crossings;
  const BezierCubic sides[] = {{net[0], net[1], net[2], net[3]},
                               {net[3], net[7], net[11], net[15]},
                               {net[15], net[14], net[13], net[12]},
                               {net[12], net[8], net[4], net[0]}};
  for (int side = 0; side < 4; ++side) {
    bool above = sides[side][0] >= 0.0;
    for (const double t : sign_changes(sides[side])) {
      const double u = side == 0 ? t : side == 1 ? 1.0 : side == 2 ? 1.0 - t : 0.0;
      const double v = side == 0 ? 0.0 : side == 1 ? t : side == 2 ? 1.0 : 1.0 - t;
      // From above to below along the border, what is above is on the left of the way in.
      crossings.push_back({u, v, above});
      above = !above;
    }
  }
  return crossings;
}

CrossingPairs pair_crossings(const BezierNet& net, const SideCrossings& crossings) {
  CrossingPairs pairs;
  const int count = static_cast<int>(crossings.size());
  // Two curves that run side by side through the part have their fellows at the same rank on the
  // opposite side.
  if (count == 4) {
    for (int k = 0; k < 2; ++k) {
      const int a = k, b = k + 1, c = k + 2, d = (k + 3) % 4;
      const auto on_one_side = [&](int i, int j) {
        return (crossings[i].u == crossings[j].u &&
                (crossings[i].u == 0.0 || crossings[i].u == 1.0)) ||
               (crossings[i].v == crossings[j].v &&
                (crossings[i].v == 0.0 || crossings[i].v == 1.0));
      };
      if (!on_one_side(a, b) || !on_one_side(c, d)) continue;
      for (const auto& [i, j] : {std::array<int, 2>{b, c}, std::array<int, 2>{d, a}}) {
        pairs.push_back(crossings[i].enters ? std::array<int, 2>{i, j} : std::array<int, 2>{j, i});
      }
      return pairs;
    }
  }
  // Otherwise what lies at the centre hangs together.
  // A crossing that enters begins a stretch of the border that is below: with the centre above,
  // each such stretch is cut off by itself, otherwise each that is above.
  const int step = value_at(net, 0.5, 0.5) >= 0.0 ? 1 : count - 1;
  for (int i = 0; i < count; ++i) {
    const int to = (i + step) % count;
    if (crossings[i].enters && !crossings[to].enters) pairs.push_back({i, to});
  }
  return pairs;
}

}  // namespace hull::analysis
