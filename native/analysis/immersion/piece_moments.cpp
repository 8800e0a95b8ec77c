// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/immersion/piece_moments.h"

#include <cassert>
#include <cmath>
#include <cstring>

#include "analysis/arithmetic/gauss.h"
#include "surface/wide_code.h"

namespace hull {
namespace {

constexpr int kMostNodes = 8;  // along a line, padded with nodes of no weight
constexpr int kDeepestArea = 6;

// Basis functions at the nodes of a Gauss rule on an interval, node by node, and for each function.
struct LineRule {
  int count = 0;
  std::array<Basis, kMostNodes> value{}, slope{};
  alignas(32) std::array<std::array<double, kMostNodes>, 4> values{}, slopes{};
  alignas(32) std::array<double, kMostNodes> weights{};

  LineRule(const GaussRule& rule, double begin, double size)
      : count(static_cast<int>(rule.nodes.size())) {
    for (int i = 0; i < count; ++i) {
      value[i] = cubic_basis(begin + size * rule.nodes[i]);
      slope[i] = cubic_basis_d1(begin + size * rule.nodes[i]);
      weights[i] = rule.weights[i] * size;
      for (int a = 0; a < 4; ++a) {
        values[a][i] = value[i][a];
        slopes[a][i] = slope[i][a];
      }
    }
  }
};

const GaussRule& gauss(SpanRule rule) {
  static const GaussRule exact = gauss_rule(static_cast<int>(SpanRule::kExact));
  static const GaussRule small = gauss_rule(static_cast<int>(SpanRule::kSmall));
  return rule == SpanRule::kExact ? exact : small;
}

const LineRule& whole_line(SpanRule rule) {
  static const LineRule exact(gauss(SpanRule::kExact), 0.0, 1.0);
  static const LineRule small(gauss(SpanRule::kSmall), 0.0, 1.0);
  return rule == SpanRule::kExact ? exact : small;
}

// Nodes of a span at the tensor product of two lines, those of equal v in a row. A row is computed
// with its padding, which the next row overwrites.
HULL_WIDE void take_nodes(const double* points, const Vector3d& origin, const LineRule& u,
                          const LineRule& v, ShellNodes& nodes) {
  for (int j = 0; j < v.count; ++j) {
    // What is left after the sums along v: a cubic along u, and its derivative by v.
    double row[12], row_v[12];
    for (int k = 0; k < 12; ++k) {
      row[k] = v.value[j][0] * points[k] + v.value[j][1] * points[12 + k] +
               v.value[j][2] * points[24 + k] + v.value[j][3] * points[36 + k];
      row_v[k] = v.slope[j][0] * points[k] + v.slope[j][1] * points[12 + k] +
                 v.slope[j][2] * points[24 + k] + v.slope[j][3] * points[36 + k];
    }
    double p[3][kMostNodes], du[3][kMostNodes], dv[3][kMostNodes];
    for (int c = 0; c < 3; ++c) {
      for (int i = 0; i < kMostNodes; ++i) {
        p[c][i] = u.values[0][i] * row[c] + u.values[1][i] * row[3 + c] +
                  u.values[2][i] * row[6 + c] + u.values[3][i] * row[9 + c] - origin[c];
        du[c][i] = u.slopes[0][i] * row[c] + u.slopes[1][i] * row[3 + c] +
                   u.slopes[2][i] * row[6 + c] + u.slopes[3][i] * row[9 + c];
        dv[c][i] = u.values[0][i] * row_v[c] + u.values[1][i] * row_v[3 + c] +
                   u.values[2][i] * row_v[6 + c] + u.values[3][i] * row_v[9 + c];
      }
    }
    const int first = j * u.count;
    double *x = &nodes.x[first], *y = &nodes.y[first], *z = &nodes.z[first];
    double *nx = &nodes.nx[first], *ny = &nodes.ny[first], *nz = &nodes.nz[first];
    for (int i = 0; i < kMostNodes; ++i) {
      const double w = v.weights[j] * u.weights[i];
      x[i] = p[0][i];
      y[i] = p[1][i];
      z[i] = p[2][i];
      nx[i] = w * (du[1][i] * dv[2][i] - du[2][i] * dv[1][i]);
      ny[i] = w * (du[2][i] * dv[0][i] - du[0][i] * dv[2][i]);
      nz[i] = w * (du[0][i] * dv[1][i] - du[1][i] * dv[0][i]);
    }
  }
  // The last row's padding has no weight.
  nodes.count = (v.count * u.count + 3) / 4 * 4;
}

// Four doubles that are added and multiplied at once, by whatever instructions there are.
using Four = double __attribute__((vector_size(32)));

inline double total(const Four& four) { return (four[0] + four[1]) + (four[2] + four[3]); }

// Adds ∫ f n_c dS for f = 1, x, y, z and the six products: one component at a time, so that all ten
// sums stay in registers.
HULL_WIDE void sum_nodes(const ShellNodes& nodes, ShellMoments& sum) {
  const double* components[] = {nodes.nx.data(), nodes.ny.data(), nodes.nz.data()};
  for (int c = 0; c < 3; ++c) {
    Four s0{}, sx{}, sy{}, sz{}, sxx{}, syy{}, szz{}, sxy{}, syz{}, szx{};
    for (int k = 0; k < nodes.count; k += 4) {
      Four n, x, y, z;
      std::memcpy(&n, components[c] + k, sizeof(Four));
      std::memcpy(&x, &nodes.x[k], sizeof(Four));
      std::memcpy(&y, &nodes.y[k], sizeof(Four));
      std::memcpy(&z, &nodes.z[k], sizeof(Four));
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
  const double* points = square.points[0].data();
  if (square.size == 1.0) {
    take_nodes(points, square.origin, whole_line(rule), whole_line(rule), nodes);
  } else {
    take_nodes(points, square.origin, LineRule(gauss(rule), square.u, square.size),
               LineRule(gauss(rule), square.v, square.size), nodes);
  }
}

// Values of the Legendre polynomials of degree 4 and 5 on [0, 1] at the six nodes.
struct TopPolynomials {
  std::array<double, kMostNodes> fourth{}, fifth{};
  TopPolynomials() {
    const GaussRule& rule = gauss(SpanRule::kExact);
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const double x = 2.0 * rule.nodes[i] - 1.0, x2 = x * x;
      fourth[i] = (35.0 * x2 * x2 - 30.0 * x2 + 3.0) / 8.0;
      fifth[i] = x * (63.0 * x2 * x2 - 70.0 * x2 + 15.0) / 8.0;
    }
  }
};

// Estimated error of the area by the six-point rule: the coefficients of the area element's
// Legendre series fall geometrically, and its error is of the order of the twelfth; so of the power
// 12/4 to 12/5 of the share that those of degree 4 and 5 have.
double area_error(const Elements& elements, double area) {
  static const TopPolynomials top;
  constexpr int kRows = static_cast<int>(SpanRule::kExact);
  double highest = 0.0;
  std::array<double, kMostNodes> column4{}, column5{};
  for (int j = 0; j < kRows; ++j) {
    const double* row = &elements[j * kRows];
    double row4 = 0.0, row5 = 0.0;
    for (int i = 0; i < kRows; ++i) {
      row4 += top.fourth[i] * row[i];
      row5 += top.fifth[i] * row[i];
      column4[i] += top.fourth[j] * row[i];
      column5[i] += top.fifth[j] * row[i];
    }
    highest += 9.0 * std::abs(row4) + 11.0 * std::abs(row5);
  }
  for (int i = 0; i < kRows; ++i) {
    highest += 9.0 * std::abs(column4[i]) + 11.0 * std::abs(column5[i]);
  }
  const double share = area > 0.0 ? std::min(1.0, highest / area) : 0.0;
  return area * share * share * std::sqrt(share);
}

struct Estimate {
  double value, error;
};

Estimate area_of(const SpanSquare& square) {
  ShellNodes nodes;
  take_square(square, SpanRule::kExact, nodes);
  Elements elements;
  const double area = area_elements(nodes, elements);
  return {area, area_error(elements, area)};
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
  while (nodes.count % 4 != 0) nodes.add(Vector3d::Zero(), Vector3d::Zero());
  Elements elements;
  sum.area += area_elements(nodes, elements);
  sum_nodes(nodes, sum);
  nodes.count = count;
}

ShellMoments span_moments(const SpanSquare& square, SpanRule rule, double area_tolerance) {
  ShellNodes nodes;
  take_square(square, rule, nodes);
  ShellMoments moments;
  sum_nodes(nodes, moments);
  Elements elements;
  moments.area = area_elements(nodes, elements);
  if (rule == SpanRule::kExact) {
    moments.area_error = area_error(elements, moments.area);
    if (moments.area_error > area_tolerance) {
      const Estimate area = refined_area(square, area_tolerance, 1);
      moments.area = area.value;
      moments.area_error = area.error;
    }
  }
  return moments;
}

}  // namespace hull
