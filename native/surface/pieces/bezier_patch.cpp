// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/pieces/bezier_patch.h"

#include <algorithm>
#include <cmath>

#include "surface/wide_code.h"

namespace hull::surface {
namespace {

// Bernstein's cubic polynomials and their derivatives.
struct Weights {
  double value[4], first[4], second[4];

  explicit Weights(double t) {
    const double s = 1.0 - t;
    const double ss = s * s, st = s * t, tt = t * t;
    value[0] = ss * s, value[1] = 3.0 * ss * t, value[2] = 3.0 * st * t, value[3] = tt * t;
    first[0] = -3.0 * ss, first[1] = 3.0 * (ss - 2.0 * st);
    first[2] = 3.0 * (2.0 * st - tt), first[3] = 3.0 * tt;
    second[0] = 6.0 * s, second[1] = 6.0 * (t - 2.0 * s);
    second[2] = 6.0 * (s - 2.0 * t), second[3] = 6.0 * t;
  }
};

inline double dot4(const double* a, const double* b) {
  return (a[0] * b[0] + a[1] * b[1]) + (a[2] * b[2] + a[3] * b[3]);
}

inline void sum_rows(const double* x, const double* w, double* sum) {
  for (int i = 0; i < 4; ++i) {
    sum[i] = (w[0] * x[i] + w[1] * x[4 + i]) + (w[2] * x[8 + i] + w[3] * x[12 + i]);
  }
}

// Four numbers of a row or column of control points, `step` apart, to those of its halves.
// De Casteljau at 1/2.
inline void halve(const double* x, int step, double* low, double* high) {
  const double a = x[0], b = x[step], c = x[2 * step], d = x[3 * step];
  const double ab = 0.5 * (a + b), bc = 0.5 * (b + c), cd = 0.5 * (c + d);
  const double abc = 0.5 * (ab + bc), bcd = 0.5 * (bc + cd), middle = 0.5 * (abc + bcd);
  low[0] = a, low[step] = ab, low[2 * step] = abc, low[3 * step] = middle;
  high[0] = middle, high[step] = bcd, high[2 * step] = cd, high[3 * step] = d;
}

// Uniform B-spline to Bézier, in place, for four numbers `step` apart.
inline void to_bezier(double* x, int step) {
  const double a = x[0], b = x[step], c = x[2 * step], d = x[3 * step];
  x[0] = (a + 4.0 * b + c) / 6.0;
  x[step] = (2.0 * b + c) / 3.0;
  x[2 * step] = (b + 2.0 * c) / 3.0;
  x[3 * step] = (b + 4.0 * c + d) / 6.0;
}

// Second differences of a grid of numbers.
// As control points of the second derivatives: by 3 · 2 for pure ones, by 3 · 3 for the mixed one.
inline double second_uu(const double* x, int i, int j) {
  const double* at = x + 4 * j + i;
  return 6.0 * (at[2] - 2.0 * at[1] + at[0]);
}
inline double second_vv(const double* x, int i, int j) {
  const double* at = x + 4 * j + i;
  return 6.0 * (at[8] - 2.0 * at[4] + at[0]);
}
inline double second_uv(const double* x, int i, int j) {
  const double* at = x + 4 * j + i;
  return 9.0 * ((at[5] - at[4]) - (at[1] - at[0]));
}

template <class Component>
double largest_norm(int columns, int rows, const Component& component) {
  double largest = 0.0;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      double square = 0.0;
      for (int k = 0; k < 3; ++k) {
        const double value = component(k, i, j);
        square += value * value;
      }
      largest = std::max(largest, square);
    }
  }
  return std::sqrt(largest);
}

// The form [[a, b], [b, c]]: its least eigenvalue.
inline double least_eigenvalue(double a, double b, double c) {
  const double half = 0.5 * (a - c);
  return 0.5 * (a + c) - std::sqrt(half * half + b * b);
}

inline void project(const BezierPatch& patch, const Vector3d& on, double* numbers) {
  for (int i = 0; i < 16; ++i) {
    numbers[i] = on[0] * patch.x[0][i] + on[1] * patch.x[1][i] + on[2] * patch.x[2][i];
  }
}

struct Bounds {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void take(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  double magnitude() const { return std::max(-low, high); }
};

// Bounds of a first derivative of a grid of numbers, by its control points.
inline Bounds slopes(const double* x, int columns, int rows, int step) {
  Bounds bounds;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      bounds.take(3.0 * (x[4 * j + i + step] - x[4 * j + i]));
    }
  }
  return bounds;
}

}  // namespace

HULL_WIDE BezierPatch BezierPatch::from_bspline(const BicubicPoints& points) {
  BezierPatch patch;
  for (int k = 0; k < 3; ++k) {
    double* x = patch.x[k];
    for (int i = 0; i < 16; ++i) x[i] = points[i][k];
    // Columns, then rows: the rule for curves, as a tensor product.
    for (int i = 0; i < 4; ++i) to_bezier(x + i, 4);
    for (int j = 0; j < 4; ++j) to_bezier(x + 4 * j, 1);
  }
  return patch;
}

Eigen::AlignedBox3d BezierPatch::box() const {
  Eigen::AlignedBox3d box;
  for (int k = 0; k < 3; ++k) {
    const auto [low, high] = std::minmax_element(x[k], x[k] + 16);
    box.min()[k] = *low;
    box.max()[k] = *high;
  }
  return box;
}

HULL_WIDE void BezierPatch::split(int axis, BezierPatch& low, BezierPatch& high) const {
  for (int k = 0; k < 3; ++k) {
    if (axis == 0) {
      for (int j = 0; j < 4; ++j) halve(x[k] + 4 * j, 1, low.x[k] + 4 * j, high.x[k] + 4 * j);
    } else {
      for (int i = 0; i < 4; ++i) halve(x[k] + i, 4, low.x[k] + i, high.x[k] + i);
    }
  }
}

HULL_WIDE SurfaceJet evaluate(const BezierPatch& patch, double u, double v) {
  const Weights wu(u), wv(v);
  SurfaceJet jet;
  for (int k = 0; k < 3; ++k) {
    // Along v first, which leaves cubics in u.
    double c[4], cv[4], cvv[4];
    sum_rows(patch.x[k], wv.value, c);
    sum_rows(patch.x[k], wv.first, cv);
    sum_rows(patch.x[k], wv.second, cvv);
    jet.point[k] = dot4(c, wu.value);
    jet.du[k] = dot4(c, wu.first);
    jet.dv[k] = dot4(cv, wu.value);
    jet.duu[k] = dot4(c, wu.second);
    jet.duv[k] = dot4(cv, wu.first);
    jet.dvv[k] = dot4(cvv, wu.value);
  }
  return jet;
}

HULL_WIDE void evaluate_first(const BezierPatch& patch, double u, double v, SurfaceJet& jet) {
  const Weights wu(u), wv(v);
  for (int k = 0; k < 3; ++k) {
    double c[4], cv[4];
    sum_rows(patch.x[k], wv.value, c);
    sum_rows(patch.x[k], wv.first, cv);
    jet.point[k] = dot4(c, wu.value);
    jet.du[k] = dot4(c, wu.first);
    jet.dv[k] = dot4(cv, wu.value);
  }
}

HULL_WIDE PatchShape shape_of(const BezierPatch& patch) {
  PatchShape shape;
  const auto& x = patch.x;
  Vector3d mean_u, mean_v;
  for (int k = 0; k < 3; ++k) {
    const double* p = x[k];
    double sum = 0.0;
    for (int i = 0; i < 16; ++i) sum += p[i];
    shape.centre[k] = sum / 16.0;
    // The mean over the square: Bernstein's four polynomials have the integral 1/4 each.
    mean_u[k] = 0.25 * ((p[3] - p[0]) + (p[7] - p[4]) + (p[11] - p[8]) + (p[15] - p[12]));
    mean_v[k] = 0.25 * ((p[12] - p[0]) + (p[13] - p[1]) + (p[14] - p[2]) + (p[15] - p[3]));
  }
  shape.su = mean_u.norm();
  shape.sv = mean_v.norm();
  if (!(shape.su > 0.0 && shape.sv > 0.0)) return shape;
  const double per_u = 1.0 / shape.su, per_v = 1.0 / shape.sv;
  const double uu = per_u * per_u *
                    largest_norm(2, 4, [&](int k, int i, int j) { return second_uu(x[k], i, j); });
  const double uv = per_u * per_v *
                    largest_norm(3, 3, [&](int k, int i, int j) { return second_uv(x[k], i, j); });
  const double vv = per_v * per_v *
                    largest_norm(4, 2, [&](int k, int i, int j) { return second_vv(x[k], i, j); });
  // The largest eigenvalue of [[uu, uv], [uv, vv]]: for a unit direction (a, b) the second
  // derivative is no longer than uu a² + 2 uv |a b| + vv b².
  shape.bend = -least_eigenvalue(-uu, uv, -vv);

  // W maps the mean derivatives to the unit vectors of the plane. Along a straight line of (U, V)
  // W S advances by a mean of W (S_U, S_V), whose entries keep within the bounds below, and S by
  // 1 / |W| of that at least.
  const Vector3d a = mean_u * per_u, b = mean_v * per_v;
  const double cosine = a.dot(b), sine2 = 1.0 - cosine * cosine;
  // Parameter lines that are parallel in the mean have no W.
  if (!(sine2 > 1e-9)) return shape;
  alignas(32) double on_a[16], on_b[16];
  // The rows of W: the basis dual to a and b.
  project(patch, (a - cosine * b) / sine2, on_a);
  project(patch, (b - cosine * a) / sine2, on_b);
  const double across =
      slopes(on_a, 4, 3, 4).magnitude() * per_v + slopes(on_b, 3, 4, 1).magnitude() * per_u;
  // For any matrix M within the bounds |M x| is at least x · M x for a unit x, and that at least
  // the least eigenvalue of its symmetric part; what is taken off outweighs rounding.
  const double least = least_eigenvalue(slopes(on_a, 3, 4, 1).low * per_u, 0.5 * across,
                                        slopes(on_b, 4, 3, 4).low * per_v) -
                       1e-9;
  // 1 / |W| is the least singular value of (a b), the square root of 1 - |a · b|.
  if (least > 0.0) shape.stretch = (1.0 - std::abs(cosine)) * least * least;
  return shape;
}

HULL_WIDE bool is_least(const BezierPatch& patch, const PatchShape& shape, const Vector3d& r) {
  if (!(shape.stretch > 0.0)) return false;
  // The cheap test first: r in the worst direction.
  if (r.norm() * shape.bend <= shape.stretch) return true;
  alignas(32) double along[16];
  project(patch, r, along);
  // The second derivatives of r · S alone, with their sign: where the surface bends away from p
  // they help, however far p is.
  Bounds uu, uv, vv;
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 2; ++i) uu.take(second_uu(along, i, j));
  }
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) uv.take(second_uv(along, i, j));
  }
  for (int j = 0; j < 2; ++j) {
    for (int i = 0; i < 4; ++i) vv.take(second_vv(along, i, j));
  }
  const double per_u = 1.0 / shape.su, per_v = 1.0 / shape.sv;
  // In (U, V): stretch times the unit matrix less the Hessian of r · S has to be positive.
  return least_eigenvalue(shape.stretch - uu.high * per_u * per_u, uv.magnitude() * per_u * per_v,
                          shape.stretch - vv.high * per_v * per_v) >= 0.0;
}

}  // namespace hull::surface
