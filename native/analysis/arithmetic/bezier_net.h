// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

#include "analysis/arithmetic/bezier.h"
#include "surface/pieces/bicubic.h"

namespace hull::analysis {

// One coordinate of a bicubic on [0, 1]^2 by its Bézier coefficients, index 4 j + i, i along u:
// open to arithmetic, where BezierBicubic is for one question at a time.
using BezierNet = std::array<double, 16>;

// Of the coordinate `direction`·p - offset of a uniform B-spline span.
BezierNet bezier_net(const surface::BicubicPoints& points, const Vector3d& direction,
                     double offset);

// Coefficients of rounding size are zero, so that what lies in a plane does not cross it.
inline void flush_to_zero(BezierNet& net, double tolerance) {
  for (double& c : net) {
    if (c < tolerance && c > -tolerance) c = 0.0;
  }
}

inline double lowest(const BezierNet& net) { return *std::min_element(net.begin(), net.end()); }
inline double highest(const BezierNet& net) { return *std::max_element(net.begin(), net.end()); }

inline BezierNet transposed(const BezierNet& net) {
  BezierNet result;
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) result[4 * j + i] = net[4 * i + j];
  }
  return result;
}

// The halves [0, ½] and [½, 1] along u (stride 1 within a row) or v.
template <int kAlong, int kAcross>
inline void halve(const BezierNet& net, BezierNet& low, BezierNet& high) {
  for (int k = 0; k < 4; ++k) {
    const double* c = net.data() + kAcross * k;
    double* l = low.data() + kAcross * k;
    double* h = high.data() + kAcross * k;
    const double ab = 0.5 * (c[0] + c[kAlong]), bc = 0.5 * (c[kAlong] + c[2 * kAlong]);
    const double cd = 0.5 * (c[2 * kAlong] + c[3 * kAlong]);
    const double abc = 0.5 * (ab + bc), bcd = 0.5 * (bc + cd), middle = 0.5 * (abc + bcd);
    h[3 * kAlong] = c[3 * kAlong];
    l[0] = c[0];
    l[kAlong] = ab;
    l[2 * kAlong] = abc;
    l[3 * kAlong] = middle;
    h[0] = middle;
    h[kAlong] = bcd;
    h[2 * kAlong] = cd;
  }
}
inline void halve_u(const BezierNet& net, BezierNet& low, BezierNet& high) {
  halve<1, 4>(net, low, high);
}
inline void halve_v(const BezierNet& net, BezierNet& low, BezierNet& high) {
  halve<4, 1>(net, low, high);
}

// Restricted to [u, u + size] x [v, v + size], a dyadic square of [0, 1]^2.
inline BezierNet restricted(BezierNet net, double u, double v, double size) {
  for (double width = 1.0, left = 0.0, bottom = 0.0; width > size;) {
    width *= 0.5;
    BezierNet low, high;
    halve_u(net, low, high);
    const bool right = u >= left + width;
    net = right ? high : low;
    if (right) left += width;
    halve_v(net, low, high);
    const bool upper = v >= bottom + width;
    net = upper ? high : low;
    if (upper) bottom += width;
  }
  return net;
}

// Bounds of a third of the derivative along u and v: the coefficients' differences.
struct SlopeRange {
  double low, high;
};
inline SlopeRange slope_range_u(const BezierNet& net) {
  SlopeRange range{net[1] - net[0], net[1] - net[0]};
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 3; ++i) {
      const double d = net[4 * j + i + 1] - net[4 * j + i];
      range = {std::min(range.low, d), std::max(range.high, d)};
    }
  }
  return range;
}
inline SlopeRange slope_range_v(const BezierNet& net) {
  SlopeRange range{net[4] - net[0], net[4] - net[0]};
  for (int k = 0; k < 12; ++k) {
    const double d = net[k + 4] - net[k];
    range = {std::min(range.low, d), std::max(range.high, d)};
  }
  return range;
}

// Bernstein polynomials of degree three and their derivatives.
struct BernsteinBasis {
  double b[4], d[4];
  explicit BernsteinBasis(double t) {
    const double s = 1.0 - t;
    b[0] = s * s * s;
    b[1] = 3.0 * s * s * t;
    b[2] = 3.0 * s * t * t;
    b[3] = t * t * t;
    d[0] = -3.0 * s * s;
    d[1] = 3.0 * s * (s - 2.0 * t);
    d[2] = 3.0 * t * (2.0 * s - t);
    d[3] = 3.0 * t * t;
  }
};

// The cubic in v at one u, and its derivative with respect to u.
struct Column {
  double c[4], du[4];
  Column(const BezierNet& net, const BernsteinBasis& at) {
    for (int j = 0; j < 4; ++j) {
      const double* row = net.data() + 4 * j;
      c[j] = at.b[0] * row[0] + at.b[1] * row[1] + at.b[2] * row[2] + at.b[3] * row[3];
      du[j] = at.d[0] * row[0] + at.d[1] * row[1] + at.d[2] * row[2] + at.d[3] * row[3];
    }
  }
};

struct NetJet {
  double value, du, dv;
  NetJet(const Column& column, const BernsteinBasis& at) : value(0.0), du(0.0), dv(0.0) {
    for (int j = 0; j < 4; ++j) {
      value += at.b[j] * column.c[j];
      du += at.b[j] * column.du[j];
      dv += at.d[j] * column.c[j];
    }
  }
};

}  // namespace hull::analysis
