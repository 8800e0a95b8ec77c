// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/patches/bspline_patch.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>
#include <string>

namespace hull::conversion {
namespace {

// The last span [knots[k], knots[k + 1]) of positive length that holds t; t = 1 is in the last one.
int find_span(const std::vector<double>& knots, int degree, double t) {
  const auto begin = knots.begin() + degree;
  const auto end = knots.end() - degree - 1;
  // At the end: the last knot below it begins the span, however often the end is repeated.
  if (t >= *end) return static_cast<int>(std::lower_bound(begin, end, *end) - knots.begin()) - 1;
  return static_cast<int>(std::upper_bound(begin, end, t) - knots.begin()) - 1;
}

// Cox-de Boor: the degree + 1 functions that do not vanish in the span, the first being number
// span - degree.
Eigen::VectorXd functions_of_span(const std::vector<double>& knots, int degree, int span,
                                  double t) {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(degree + 1);
  values(0) = 1.0;
  for (int p = 1; p <= degree; ++p) {
    double carried = 0.0;
    for (int r = 0; r < p; ++r) {
      // Both sums of the recursion at once: the left part of a function is carried to its
      // neighbour. No difference is zero, as the span has a width.
      const double right = knots[span + r + 1], left = knots[span + r + 1 - p];
      const double share = values(r) / (right - left);
      values(r) = carried + (right - t) * share;
      carried = (t - left) * share;
    }
    values(p) = carried;
  }
  return values;
}

// From coefficients of functions of degree p - 1 (those of the span) to the derivative of the
// functions of degree p: N'_i = p (N_i / (t_{i+p} - t_i) - N_{i+1} / (t_{i+p+1} - t_{i+1})).
Eigen::VectorXd differentiated(const std::vector<double>& knots, int degree, int span,
                               const Eigen::VectorXd& lower) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(degree + 1);
  for (int r = 0; r < degree; ++r) {
    const int i = span - degree + 1 + r;  // the lower function lower(r) has this number
    const double slope = degree * lower(r) / (knots[i + degree] - knots[i]);
    result(r) -= slope;
    result(r + 1) += slope;
  }
  return result;
}

void check_knots(const std::vector<double>& knots, int degree, int count, const std::string& name) {
  if (degree < 1 || count <= degree) {
    throw std::invalid_argument(name + ": " + std::to_string(count) +
                                " control points are too few for degree " + std::to_string(degree));
  }
  if (static_cast<int>(knots.size()) != count + degree + 1) {
    throw std::invalid_argument(name + ": " + std::to_string(knots.size()) + " knots given, " +
                                std::to_string(count + degree + 1) + " wanted");
  }
  // Written so that a NaN fails too.
  const bool ascending = std::ranges::is_sorted(knots) && knots.front() == 0.0 &&
                         knots[degree] == 0.0 && knots[count] == 1.0 && knots.back() == 1.0;
  bool inside = true;
  for (int i = degree + 1; i < count; ++i) inside = inside && knots[i] > 0.0 && knots[i] < 1.0;
  if (!ascending || !inside) {
    throw std::invalid_argument(name + ": the knots must ascend from 0 to 1, both repeated " +
                                std::to_string(degree + 1) + " times");
  }
}

}  // namespace

std::vector<double> open_uniform_knots(int degree, int count) {
  assert(degree >= 1 && count > degree);
  std::vector<double> knots(count + degree + 1, 0.0);
  const int spans = count - degree;
  for (int i = 1; i < spans; ++i) knots[degree + i] = static_cast<double>(i) / spans;
  std::fill(knots.end() - degree - 1, knots.end(), 1.0);
  return knots;
}

BasisValues basis_values(const std::vector<double>& knots, int degree, double t) {
  t = std::clamp(t, 0.0, 1.0);
  const int span = find_span(knots, degree, t);
  BasisValues basis;
  basis.first = span - degree;
  basis.rows.setZero(3, degree + 1);
  basis.rows.row(0) = functions_of_span(knots, degree, span, t).transpose();
  basis.rows.row(1) =
      differentiated(knots, degree, span, functions_of_span(knots, degree - 1, span, t))
          .transpose();
  if (degree >= 2) {
    // Twice the rule of first derivatives, from two degrees below.
    const auto lowest = functions_of_span(knots, degree - 2, span, t);
    const auto lower = differentiated(knots, degree - 1, span, lowest);
    basis.rows.row(2) = differentiated(knots, degree, span, lower).transpose();
  }
  return basis;
}

void BSplinePatch::check() const {
  const std::string name = "patch of cell " + std::to_string(cell);
  check_knots(knots_u, degree_u, count_u, name + ", direction u");
  check_knots(knots_v, degree_v, count_v, name + ", direction v");
  if (control_points.size() != static_cast<size_t>(count_u) * count_v) {
    throw std::invalid_argument(name + ": " + std::to_string(control_points.size()) +
                                " control points given, " + std::to_string(count_u * count_v) +
                                " wanted");
  }
  for (const Vector3d& point : control_points) {
    if (!point.allFinite()) {
      throw std::invalid_argument(name + " has a control point that is not finite");
    }
  }
}

Vector3d BSplinePatch::position(double u, double v) const { return evaluate(u, v).point; }

surface::SurfaceJet BSplinePatch::evaluate(double u, double v) const {
  const BasisValues along_u = basis_values(knots_u, degree_u, u);
  const BasisValues along_v = basis_values(knots_v, degree_v, v);
  surface::SurfaceJet result;
  for (int i = 0; i <= degree_u; ++i) {
    // Sums along v first, for all orders at once.
    Eigen::Matrix3d row = Eigen::Matrix3d::Zero();  // column d: d-th derivative along v
    for (int j = 0; j <= degree_v; ++j) {
      const Vector3d& point = control_point(along_u.first + i, along_v.first + j);
      row += point * along_v.rows.col(j).transpose();
    }
    const auto weight = along_u.rows.col(i);
    result.point += weight(0) * row.col(0);
    result.du += weight(1) * row.col(0);
    result.dv += weight(0) * row.col(1);
    result.duu += weight(2) * row.col(0);
    result.duv += weight(1) * row.col(1);
    result.dvv += weight(0) * row.col(2);
  }
  return result;
}

int BSplinePatch::side_index(int side, int i) const {
  assert(i >= 0 && i < side_count(side));
  return corner_index(side, i, 0);
}

int BSplinePatch::corner_index(int k, int i, int j) const {
  assert(k >= 0 && k < 4);
  switch (k) {
    case 0:
      return i * count_v + j;
    case 1:
      return (count_u - 1 - j) * count_v + i;
    case 2:
      return (count_u - 1 - i) * count_v + count_v - 1 - j;
    default:
      return j * count_v + count_v - 1 - i;
  }
}

std::vector<Vector3d> BSplinePatch::side_points(int side) const {
  std::vector<Vector3d> points;
  for (int i = 0; i < side_count(side); ++i) points.push_back(control_points[side_index(side, i)]);
  return points;
}

std::vector<double> BSplinePatch::side_knots(int side) const {
  std::vector<double> knots = side % 2 == 0 ? knots_u : knots_v;
  if (side >= 2) {
    std::ranges::reverse(knots);
    // Rounded: whoever compares these with a neighbour's knots has to allow for that.
    for (double& knot : knots) knot = 1.0 - knot;
  }
  return knots;
}

BSplineCurve BSplinePatch::side_curve(int side) const {
  return {side_degree(side), side_knots(side), side_points(side)};
}

double BSplinePatch::side_length(int side) const { return side_curve(side).polygon_length(); }

BSplinePatch BSplinePatch::turned() const {
  BSplinePatch result;
  // New u runs along the old v, new v against the old u.
  result.degree_u = degree_v;
  result.degree_v = degree_u;
  result.knots_u = knots_v;
  for (auto knot = knots_u.rbegin(); knot != knots_u.rend(); ++knot) {
    result.knots_v.push_back(1.0 - *knot);
  }
  result.count_u = count_v;
  result.count_v = count_u;
  result.cell = cell;
  for (int j = 0; j < count_v; ++j) {
    for (int i = count_u - 1; i >= 0; --i) {
      result.control_points.push_back(control_point(i, j));
    }
  }
  return result;
}

BSplinePatch BSplinePatch::transposed() const {
  BSplinePatch result{degree_v, degree_u, knots_v, knots_u, count_v, count_u, {}, cell};
  result.control_points.reserve(control_points.size());
  for (int j = 0; j < count_v; ++j) {
    for (int i = 0; i < count_u; ++i) result.control_points.push_back(control_point(i, j));
  }
  return result;
}

}  // namespace hull::conversion
