// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/immersion/piece_moments.h"

#include <cassert>
#include <cmath>

#include "analysis/arithmetic/four.h"
#include "analysis/immersion/line_rule.h"

namespace hull::analysis {
namespace {

constexpr int kDeepestArea = 6;

// From one row's beginning to the next's. Rules of up to four nodes keep their padding.
int row_stride(int nodes) { return nodes <= 4 ? 4 : nodes; }

// Nodes of a span at the tensor product of two lines, those of equal v in a row, of which columns
// [4 quad, 4 quad + 4) are taken. Padding has no weight; the next row may overwrite it.
inline __attribute__((always_inline)) void take_columns(const SpanSquare& square, const LineRule& u,
                                                        const LineRule& v, int quad,
                                                        ShellNodes& nodes) {
  const double* point = square.points[0].data();
  // What is left after the sums along u: cubics along v, and those of the derivatives by u.
  Four cubic[4][3], cubic_u[4][3];
  Four value[4], slope[4];
  for (int a = 0; a < 4; ++a) {
    load(value[a], &u.values[a][4 * quad]);
    load(slope[a], &u.slopes[a][4 * quad]);
  }
  for (int b = 0; b < 4; ++b) {
    for (int c = 0; c < 3; ++c) {
      const double* p = point + 12 * b + c;
      cubic[b][c] = value[0] * p[0] + value[1] * p[3] + value[2] * p[6] + value[3] * p[9];
      cubic_u[b][c] = slope[0] * p[0] + slope[1] * p[3] + slope[2] * p[6] + slope[3] * p[9];
    }
  }
  Four weights;
  load(weights, &u.weights[4 * quad]);
  const int stride = row_stride(u.count);
  for (int j = 0; j < v.count; ++j) {
    const surface::Basis &at = v.value[j], &rise = v.slope[j];
    Four p[3], du[3], dv[3];
    for (int c = 0; c < 3; ++c) {
      p[c] = at[0] * cubic[0][c] + at[1] * cubic[1][c] + at[2] * cubic[2][c] + at[3] * cubic[3][c] -
             square.origin[c];
      du[c] = at[0] * cubic_u[0][c] + at[1] * cubic_u[1][c] + at[2] * cubic_u[2][c] +
              at[3] * cubic_u[3][c];
      dv[c] = rise[0] * cubic[0][c] + rise[1] * cubic[1][c] + rise[2] * cubic[2][c] +
              rise[3] * cubic[3][c];
    }
    const Four w = v.weights[j] * weights;
    const int first = j * stride + 4 * quad;
    store(p[0], &nodes.x[first]);
    store(p[1], &nodes.y[first]);
    store(p[2], &nodes.z[first]);
    store(w * (du[1] * dv[2] - du[2] * dv[1]), &nodes.nx[first]);
    store(w * (du[2] * dv[0] - du[0] * dv[2]), &nodes.ny[first]);
    store(w * (du[0] * dv[1] - du[1] * dv[0]), &nodes.nz[first]);
  }
}

HULL_WIDE void take_short_rows(const SpanSquare& square, const LineRule& u, const LineRule& v,
                               ShellNodes& nodes) {
  take_columns(square, u, v, 0, nodes);
}

// The right half first: what the left one writes beyond its four columns is nothing, but rows of
// five and six nodes overlap the padding of those before.
HULL_WIDE void take_long_rows(const SpanSquare& square, const LineRule& u, const LineRule& v,
                              ShellNodes& nodes) {
  take_columns(square, u, v, 1, nodes);
  take_columns(square, u, v, 0, nodes);
}

void take_nodes(const SpanSquare& square, const LineRule& u, const LineRule& v, ShellNodes& nodes) {
  (u.count <= 4 ? take_short_rows : take_long_rows)(square, u, v, nodes);
  // Up to a whole four: what is beyond the last node has no weight.
  nodes.count = (v.count * row_stride(u.count) + 3) / 4 * 4;
}

// Adds ∫ f n_c dS for f = 1, x, y, z and the six products: one component at a time, so that all ten
// sums stay in registers.
HULL_WIDE void sum_nodes(const ShellNodes& nodes, ShellMoments& sum) {
  const double* components[] = {nodes.nx.data(), nodes.ny.data(), nodes.nz.data()};
  for (int c = 0; c < 3; ++c) {
    Four s0{}, sx{}, sy{}, sz{}, sxx{}, syy{}, szz{}, sxy{}, syz{}, szx{};
    for (int k = 0; k < nodes.count; k += 4) {
      Four n, x, y, z;
      load(n, components[c] + k);
      load(x, &nodes.x[k]);
      load(y, &nodes.y[k]);
      load(z, &nodes.z[k]);
      const Four nx = n * x, ny = n * y, nz = n * z;
      s0 += n;
      sx += nx;
      sy += ny;
      sz += nz;
      sxx += nx * x;
      syy += ny * y;
      szz += nz * z;
      sxy += nx * y;
      syz += ny * z;
      szx += nz * x;
    }
    sum.normal[c] += total(s0);
    sum.first.col(c) += Vector3d(total(sx), total(sy), total(sz));
    const double products[] = {total(sxx), total(syy), total(szz),
                               total(sxy), total(syz), total(szx)};
    for (int k = 0; k < 6; ++k) sum.second(k, c) += products[k];
  }
}

// The area elements times weights.
using Elements = std::array<double, ShellNodes::kCapacity>;

HULL_WIDE double area_elements(const ShellNodes& nodes, Elements& elements) {
  double area[4] = {0.0, 0.0, 0.0, 0.0};
  for (int begin = 0; begin < nodes.count; begin += 4) {
    for (int k = 0; k < 4; ++k) {
      const int i = begin + k;
      elements[i] = std::sqrt(nodes.nx[i] * nodes.nx[i] + nodes.ny[i] * nodes.ny[i] +
                              nodes.nz[i] * nodes.nz[i]);
      area[k] += elements[i];
    }
  }
  return (area[0] + area[1]) + (area[2] + area[3]);
}

void take_square(const SpanSquare& square, SpanRule rule, ShellNodes& nodes) {
  // Of whole spans, by far the most, the basis functions are kept.
  if (square.size == 1.0) {
    take_nodes(square, LineRule::whole(rule), LineRule::whole(rule), nodes);
  } else {
    take_nodes(square, LineRule(gauss(rule), square.u, square.size),
               LineRule(gauss(rule), square.v, square.size), nodes);
  }
}

// The two Legendre polynomials of highest degree that a rule of n nodes resolves, n - 2 and n - 1,
// at its nodes on [0, 1], times the norms that make them coefficients of a series.
struct TopPolynomials {
  explicit TopPolynomials(SpanRule rule) : count(static_cast<int>(rule)) {
    for (int i = 0; i < count; ++i) {
      const double x = 2.0 * gauss(rule).nodes[i] - 1.0;
      high[i] = (2 * count - 3) * std::legendre(count - 2, x);
      highest[i] = (2 * count - 1) * std::legendre(count - 1, x);
    }
  }
  int count;
  std::array<double, LineRule::kMostNodes> high{}, highest{};
};

// Estimated error of the area: the coefficients of the area element's Legendre series fall
// geometrically, and the error is of the order of that of degree 2 n. So it is of the power
// 2 n / (n - 2) of the share that those of degree n - 2 have in the area, and of the power
// 2 n / (n - 1) of that of degree n - 1; rounded down to powers that are quick to compute.
double area_error(const Elements& elements, SpanRule rule, double area) {
  static const PerRule<TopPolynomials> rules([](SpanRule which) { return TopPolynomials(which); });
  const TopPolynomials& top = rules[rule];
  const int n = top.count, stride = row_stride(n);
  // Along rows and along columns, as a span may be rough in one direction alone.
  double high = 0.0, highest = 0.0;
  std::array<double, LineRule::kMostNodes> column_high{}, column_highest{};
  for (int j = 0; j < n; ++j) {
    const double* row = &elements[j * stride];
    double row_high = 0.0, row_highest = 0.0;
    for (int i = 0; i < n; ++i) {
      row_high += top.high[i] * row[i];
      row_highest += top.highest[i] * row[i];
      column_high[i] += top.high[j] * row[i];
      column_highest[i] += top.highest[j] * row[i];
    }
    high += std::abs(row_high);
    highest += std::abs(row_highest);
  }
  for (int i = 0; i < n; ++i) {
    high += std::abs(column_high[i]);
    highest += std::abs(column_highest[i]);
  }
  if (!(area > 0.0)) return 0.0;
  // Shares above one tell nothing: the error is the whole area then.
  const double a = std::min(1.0, high / area), b = std::min(1.0, highest / area);
  const double power_a = n == 4 ? a * a * a * a : a * a * a;            // of 4; 10/3, 3
  const double power_b = b * b * std::sqrt(n == 6 ? std::sqrt(b) : b);  // of 8/3, 10/4; 12/5
  return area * (power_a + power_b);
}

struct Estimate {
  double value, error;
};

Estimate area_of(const SpanSquare& square) {
  ShellNodes nodes;
  take_square(square, SpanRule::kExact, nodes);
  Elements elements;
  const double area = area_elements(nodes, elements);
  return {area, area_error(elements, SpanRule::kExact, area)};
}

Estimate refined_area(const SpanSquare& square, double tolerance, int depth) {
  Estimate total{0.0, 0.0};
  const double half = 0.5 * square.size;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const SpanSquare part{square.points, square.origin, square.u + half * (quarter & 1),
                          square.v + half * (quarter >> 1), half};
    Estimate area = area_of(part);
    if (area.error > 0.25 * tolerance && depth < kDeepestArea) {
      area = refined_area(part, 0.25 * tolerance, depth + 1);
    }
    total.value += area.value;
    total.error += area.error;
  }
  return total;
}

ShellMoments moments_alone(const SpanSquare& square, SpanRule rule) {
  ShellNodes nodes;
  take_square(square, rule, nodes);
  ShellMoments moments;
  sum_nodes(nodes, moments);
  return moments;
}

ShellMoments moments_and_elements(const SpanSquare& square, SpanRule rule, Elements& elements) {
  ShellNodes nodes;
  take_square(square, rule, nodes);
  ShellMoments moments;
  sum_nodes(nodes, moments);
  moments.area = area_elements(nodes, elements);
  return moments;
}

}  // namespace

void ShellNodes::add(const Vector3d& p, const Vector3d& n) {
  assert(count < kCapacity);
  x[count] = p.x();
  y[count] = p.y();
  z[count] = p.z();
  nx[count] = n.x();
  ny[count] = n.y();
  nz[count] = n.z();
  ++count;
}

void add_nodes(ShellNodes& nodes, ShellMoments& sum) {
  const int count = nodes.count;
  // Sums go by fours: nodes without weight fill up the last.
  while (nodes.count % 4 != 0) nodes.add(Vector3d::Zero(), Vector3d::Zero());
  Elements elements;
  sum.area += area_elements(nodes, elements);
  sum_nodes(nodes, sum);
  nodes.count = count;
}

ShellMoments span_moments(const SpanSquare& square, SpanRule rule) {
  Elements elements;
  return moments_and_elements(square, rule, elements);
}

ShellMoments span_moments(const SpanSquare& square, SpanRule rule, double area_tolerance) {
  assert(rule != SpanRule::kSmallest);
  if (std::isinf(area_tolerance)) return moments_alone(square, rule);
  Elements elements;
  ShellMoments moments = moments_and_elements(square, rule, elements);
  Estimate area{moments.area, area_error(elements, rule, moments.area)};
  // Six nodes each way before four quarters with six each.
  if (area.error > area_tolerance && rule != SpanRule::kExact) area = area_of(square);
  if (area.error > area_tolerance) area = refined_area(square, area_tolerance, 1);
  moments.area = area.value;
  moments.area_error = area.error;
  return moments;
}

}  // namespace hull::analysis
