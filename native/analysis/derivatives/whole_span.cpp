// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/derivatives/whole_span.h"

#include <array>
#include <cmath>

#include "analysis/arithmetic/four.h"
#include "analysis/immersion/line_rule.h"

namespace hull::analysis {
namespace {

constexpr int kLanes = LineRule::kMostNodes;
constexpr int kColumns = 3 * immersed_number::kSubmerged;
// What is known of a shift at a node: n, and it times x, y and z; then what the wetted surface
// gains by the shift's derivatives along u and along v. x, y and z of each.
constexpr int kByShift = 12, kByU = 12, kByV = 15, kFactors = 18;

// Of the nodes in a row along u.
struct NodeRow {
  alignas(32) double factor[kFactors][kLanes];
};

// A span after the sums along u: cubics along v for each node, and those of the derivatives by u.
struct Cubics {
  alignas(32) double at[4][3][kLanes], by_u[4][3][kLanes];
};

// By the span's points, column by column as PointColumns has them: those of equal b in a row.
struct Sums {
  alignas(32) double column[kColumns][4][4] = {};
};

HULL_WIDE void sum_along_u(const surface::BicubicPoints& points, const LineRule& u, int lanes,
                           Cubics& cubics) {
  const double* point = points[0].data();
  for (int b = 0; b < 4; ++b) {
    for (int c = 0; c < 3; ++c) {
      // Point (a, b) begins at 12 b + 3 a.
      const double* p = point + 12 * b + c;
      for (int i = 0; i < lanes; ++i) {
        // Once for all rows of nodes: along v a place then takes four terms, not sixteen.
        cubics.at[b][c][i] = u.values[0][i] * p[0] + u.values[1][i] * p[3] + u.values[2][i] * p[6] +
                             u.values[3][i] * p[9];
        cubics.by_u[b][c][i] = u.slopes[0][i] * p[0] + u.slopes[1][i] * p[3] +
                               u.slopes[2][i] * p[6] + u.slopes[3][i] * p[9];
      }
    }
  }
}

HULL_WIDE void take_row(const Cubics& cubics, const LineRule& u, const surface::Basis& at,
                        const surface::Basis& rise, double weight, int lanes,
                        const Vector3d& centre, NodeRow& row) {
  alignas(32) double p[3][kLanes], du[3][kLanes], dv[3][kLanes], per_length[kLanes];
  for (int c = 0; c < 3; ++c) {
    for (int i = 0; i < lanes; ++i) {
      p[c][i] = at[0] * cubics.at[0][c][i] + at[1] * cubics.at[1][c][i] +
                at[2] * cubics.at[2][c][i] + at[3] * cubics.at[3][c][i] - centre[c];
      du[c][i] = at[0] * cubics.by_u[0][c][i] + at[1] * cubics.by_u[1][c][i] +
                 at[2] * cubics.by_u[2][c][i] + at[3] * cubics.by_u[3][c][i];
      dv[c][i] = rise[0] * cubics.at[0][c][i] + rise[1] * cubics.at[1][c][i] +
                 rise[2] * cubics.at[2][c][i] + rise[3] * cubics.at[3][c][i];
    }
  }
  double(&f)[kFactors][kLanes] = row.factor;
  for (int i = 0; i < lanes; ++i) {
    const double w = weight * u.weights[i];
    f[0][i] = w * (du[1][i] * dv[2][i] - du[2][i] * dv[1][i]);
    f[1][i] = w * (du[2][i] * dv[0][i] - du[0][i] * dv[2][i]);
    f[2][i] = w * (du[0][i] * dv[1][i] - du[1][i] * dv[0][i]);
  }
  for (int i = 0; i < lanes; ++i) {
    // f is w N here, and |f| is w |N|: f times w / |f| is w times the unit normal.
    const double length = std::sqrt(f[0][i] * f[0][i] + f[1][i] * f[1][i] + f[2][i] * f[2][i]);
    per_length[i] = length > 0.0 ? weight * u.weights[i] / length : 0.0;
  }
  for (int c = 0; c < 3; ++c) {
    for (int k = 0; k < 3; ++k) {
      for (int i = 0; i < lanes; ++i) f[3 + 3 * c + k][i] = p[c][i] * f[k][i];
    }
  }
  for (int k = 0; k < 3; ++k) {
    // The wetted surface's, as of a span that is cut (immersion_span.cpp): S_v x n, and n x S_u.
    const int l = (k + 1) % 3, m = (k + 2) % 3;
    for (int i = 0; i < lanes; ++i) {
      f[kByU + k][i] = per_length[i] * (dv[l][i] * f[m][i] - dv[m][i] * f[l][i]);
      f[kByV + k][i] = per_length[i] * (f[l][i] * du[m][i] - f[m][i] * du[l][i]);
    }
  }
}

// Σ basis[i] · factor[i] over the row's nodes, for the four functions along u.
inline __attribute__((always_inline)) void along_row(
    const std::array<surface::Basis, kLanes>& basis, const double* factor, int count, Four& sum) {
  sum = Four{};
  for (int i = 0; i < count; ++i) {
    Four functions;
    load(functions, basis[i].data());
    sum += functions * factor[i];
  }
}

inline __attribute__((always_inline)) void add_along_v(const surface::Basis& basis,
                                                       const Four& along, double (&column)[4][4]) {
  for (int b = 0; b < 4; ++b) {
    Four sum;
    load(sum, column[b]);
    sum += basis[b] * along;
    store(sum, column[b]);
  }
}

HULL_WIDE void add_row(const NodeRow& row, const LineRule& u, const surface::Basis& at,
                       const surface::Basis& rise, Sums& sums) {
  Four along;
  for (int k = 0; k < kByShift; ++k) {
    along_row(u.value, row.factor[k], u.count, along);
    add_along_v(at, along, sums.column[k]);
  }
  for (int k = 0; k < 3; ++k) {
    // A shift's derivative along u has the slopes of the functions of u, that along v those of v.
    along_row(u.slope, row.factor[kByU + k], u.count, along);
    add_along_v(at, along, sums.column[kByShift + k]);
    along_row(u.value, row.factor[kByV + k], u.count, along);
    add_along_v(rise, along, sums.column[kByShift + k]);
  }
}

}  // namespace

void add_whole_span(const surface::BicubicPoints& points, const ImmersionFrame& frame,
                    SpanRule rule, PointColumns& sum) {
  static_assert(immersed_number::kFirst == 1 && immersed_number::kWettedSurface == 4);
  const LineRule& line = LineRule::whole(rule);
  // Whole registers: lanes beyond the rule's nodes are computed along, and not summed.
  const int lanes = line.count <= 4 ? 4 : kLanes;
  Cubics cubics;
  sum_along_u(points, line, lanes, cubics);
  NodeRow row;
  Sums sums;
  for (int j = 0; j < line.count; ++j) {
    const surface::Basis &at = line.value[j], &rise = line.slope[j];
    take_row(cubics, line, at, rise, line.weights[j], lanes, frame.buoyancy, row);
    add_row(row, line, at, rise, sums);
  }
  using Columns = Eigen::Matrix<double, 16, kColumns>;
  sum.leftCols<kColumns>() += Eigen::Map<const Columns>(&sums.column[0][0][0]);
}

}  // namespace hull::analysis
