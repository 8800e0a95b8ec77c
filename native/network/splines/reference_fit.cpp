// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/splines/reference_fit.h"

#include <Eigen/Geometry>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>

#include "analysis/arithmetic/gauss.h"
#include "network/splines/quad_constraints.h"

namespace hull::network {
namespace {

using conversion::BSplinePatch;

constexpr int kMostReferenceSpans = 32;
constexpr int kLeastParts = 8, kPartsOfSpan = 2;  // of a curve, a point each
constexpr int kMeasuredOfPart = 3;
constexpr int kFootSteps = 8;       // of Newton's
constexpr double kSettled = 1e-13;  // of the parameters, 0 … 1: a shorter step is rounding
constexpr int kReach = 6;           // of functions that have an energy together
constexpr double kEnergy = 1e-10;   // against the mean square of distances

using Place = Eigen::Vector2d;

Place foot_from(const BSplinePatch& patch, Place at, const Vector3d& point) {
  for (int step = 0; step < kFootSteps; ++step) {
    const surface::SurfaceJet jet = patch.evaluate(at.x(), at.y());
    Eigen::Matrix<double, 3, 2> slopes;
    slopes << jet.du, jet.dv;
    const Place move =
        (slopes.transpose() * slopes).ldlt().solve(slopes.transpose() * (point - jet.point));
    // Where the patch has no tangent plane.
    if (!move.allFinite()) return at;
    at = (at + move).cwiseMax(0.0).cwiseMin(1.0);
    if (move.norm() < kSettled) break;
  }
  return at;
}

// ∫ B_i''' B_k''' and ∫ B_i B_k over a knot vector. To the former belongs what second and first
// derivatives jump by at multiple knots: else pieces of parabolas would cost nothing there.
struct Energies {
  Eigen::MatrixXd third, mass;

  explicit Energies(const std::vector<double>& knots)
      : count_(static_cast<Eigen::Index>(knots.size()) - 4) {
    third = mass = Eigen::MatrixXd::Zero(count_, count_);
    for (std::size_t s = 1; s < knots.size(); ++s) {
      if (knots[s] > knots[s - 1]) add_span(knots, knots[s - 1], knots[s] - knots[s - 1]);
    }
  }

 private:
  void add_span(const std::vector<double>& knots, double low, double width) {
    // Second derivatives are linear in a span, products of functions of the sixth degree.
    const auto at = [&](double share) {
      return conversion::basis_values(knots, 3, low + share * width);
    };
    // Within the span: at its end the polynomials of the next one would be asked for.
    const conversion::BasisValues a = at(0.25), b = at(0.75);
    const Eigen::RowVector4d bend = (b.rows.row(2) - a.rows.row(2)) / (0.5 * width);
    third.block<4, 4>(a.first, a.first) += width * bend.transpose() * bend;
    const auto& [count, nodes, weights] = analysis::kFourNodes;
    for (int g = 0; g < count; ++g) {
      const conversion::BasisValues values = at(nodes[g]);
      const Eigen::Vector4d row = values.rows.row(0).transpose();
      mass.block<4, 4>(values.first, values.first) += width * weights[g] * row * row.transpose();
    }
    const double quarter = 0.25 * width;
    // First and second ones at an end of the span, by Taylor from within.
    const auto derivatives = [&](const conversion::BasisValues& from, double step) {
      Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(2, count_);
      rows.block<1, 4>(0, from.first) =
          from.rows.row(1) + step * from.rows.row(2) + 0.5 * step * step * bend;
      rows.block<1, 4>(1, from.first) = from.rows.row(2) + step * bend;
      return rows;
    };
    if (low > 0.0) {
      // Zero at simple knots, but for rounding. Divided by the mean width to the powers that make
      // it an integral of squared third derivatives.
      const Eigen::MatrixXd jump = derivatives(a, -quarter) - at_end_;
      const double mean = 0.5 * (width + width_);
      third += jump.row(1).transpose() * jump.row(1) / mean;
      third += jump.row(0).transpose() * jump.row(0) / (mean * mean * mean);
    }
    at_end_ = derivatives(b, quarter);
    width_ = width;
  }

  Eigen::Index count_;
  // Of the span before: first and second derivatives at its end.
  Eigen::MatrixXd at_end_;
  double width_ = 0.0;
};

// A point of a curve, and where it is to be.
struct PlacedPoint {
  Vector3d point;
  Place place;
};

// Normal equations of all coordinates, with the constraints bordered to them.
class CurveFit {
 public:
  CurveFit(BSplinePatch& patch, const std::array<QuadSide, 4>& sides)
      : patch_(patch),
        along_u_(patch.knots_u),
        along_v_(patch.knots_v),
        constraints_(normal_constraints(patch, sides)) {}

  // False, and nothing done, where there is no solution.
  bool solve(const std::vector<PlacedPoint>& points) {
    const Eigen::Index inner = 3 * (patch_.count_u - 2) * (patch_.count_v - 2);
    // Three unknowns a point, then a multiplier for each constraint.
    const Eigen::Index size = inner + std::ssize(constraints_);
    right_ = Eigen::VectorXd::Zero(size);
    for (const PlacedPoint& one : points) add_point(one, 1.0 / static_cast<double>(points.size()));
    // So little that it decides only where no point of a curve is.
    add_energy(kEnergy);
    for (std::size_t q = 0; q < constraints_.size(); ++q) {
      add_constraint(constraints_[q], inner + static_cast<Eigen::Index>(q));
    }
    // Indefinite, as nothing stands where constraints meet constraints: no Cholesky.
    Eigen::SparseMatrix<double> form(size, size);
    form.setFromTriplets(entries_.begin(), entries_.end());
    Eigen::SparseLU<Eigen::SparseMatrix<double>> solver(form);
    if (solver.info() != Eigen::Success) return false;
    const Eigen::VectorXd found = solver.solve(right_);
    if (!found.allFinite()) return false;
    for (int point = 0; point < std::ssize(patch_.control_points); ++point) {
      const int number = inner_number(patch_, point);
      if (number < 0) continue;
      patch_.control_points[static_cast<std::size_t>(point)] = found.segment<3>(3 * number);
    }
    return true;
  }

 private:
  // Of two control points, of which the first is a row.
  void add(int row_point, int column_point, double weight) {
    const int row = inner_number(patch_, row_point), column = inner_number(patch_, column_point);
    if (row < 0) return;
    // Points of the border are known.
    if (column < 0) {
      right_.segment<3>(3 * row) -=
          weight * patch_.control_points[static_cast<std::size_t>(column_point)];
      return;
    }
    for (int a = 0; a < 3; ++a) entries_.emplace_back(3 * row + a, 3 * column + a, weight);
  }

  void add_point(const PlacedPoint& one, double weight) {
    const conversion::BasisValues u = conversion::basis_values(patch_.knots_u, 3, one.place.x());
    const conversion::BasisValues v = conversion::basis_values(patch_.knots_v, 3, one.place.y());
    std::array<int, 16> numbers;
    std::array<double, 16> shares;
    for (int a = 0; a < 16; ++a) {
      const auto at = static_cast<std::size_t>(a);
      // Four by four, those of v one after the other.
      numbers[at] = (u.first + a / 4) * patch_.count_v + v.first + a % 4;
      shares[at] = u.rows(0, a / 4) * v.rows(0, a % 4);
    }
    for (std::size_t a = 0; a < 16; ++a) {
      for (std::size_t b = 0; b < 16; ++b) {
        add(numbers[a], numbers[b], weight * shares[a] * shares[b]);
      }
      const int row = inner_number(patch_, numbers[a]);
      if (row >= 0) right_.segment<3>(3 * row) += weight * shares[a] * one.point;
    }
  }

  void add_energy(double share) {
    // A span has four functions; across a threefold knot it has seven with the next one.
    const auto near = [](int i, int count) {
      return std::pair{std::max(0, i - kReach), std::min(count - 1, i + kReach)};
    };
    for (int i = 1; i + 1 < patch_.count_u; ++i) {
      const auto [low_u, high_u] = near(i, patch_.count_u);
      for (int j = 1; j + 1 < patch_.count_v; ++j) {
        const auto [low_v, high_v] = near(j, patch_.count_v);
        for (int k = low_u; k <= high_u; ++k) {
          for (int l = low_v; l <= high_v; ++l) {
            // Integrals over the square of products of functions of u and of v are products of
            // integrals.
            const double energy = along_u_.third(i, k) * along_v_.mass(j, l) +
                                  along_u_.mass(i, k) * along_v_.third(j, l);
            add(i * patch_.count_v + j, k * patch_.count_v + l, share * energy);
          }
        }
      }
    }
  }

  void add_constraint(const NormalConstraint& constraint, Eigen::Index row) {
    for (const auto& [point, weight] : constraint.weights) {
      const int number = inner_number(patch_, point);
      const Vector3d part = weight * constraint.normal;
      if (number < 0) {
        right_[row] -= part.dot(patch_.control_points[static_cast<std::size_t>(point)]);
        continue;
      }
      for (int a = 0; a < 3; ++a) {
        entries_.emplace_back(row, 3 * number + a, part[a]);
        entries_.emplace_back(3 * number + a, row, part[a]);
      }
    }
  }

  BSplinePatch& patch_;
  Energies along_u_, along_v_;
  std::vector<NormalConstraint> constraints_;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::VectorXd right_;
};

// Of all curves, at the middles of equal parts.
std::vector<PlacedPoint> points_of(const std::vector<Reference>& curves, int parts) {
  std::vector<PlacedPoint> points;
  for (const Reference& curve : curves) {
    for (int i = 0; i < parts; ++i) {
      // At its end a curve may be on a side, where no inner point moves anything.
      const double t = (i + 0.5) / parts;
      points.push_back({curve.point(t), curve.place(t)});
    }
  }
  return points;
}

// Of a curve, at places between those that the patch was made of, too.
double furthest_point(const BSplinePatch& patch, const Reference& curve, int parts) {
  double worst = 0.0;
  for (int i = 0; i <= kMeasuredOfPart * parts; ++i) {
    const double t = static_cast<double>(i) / (kMeasuredOfPart * parts);
    const Vector3d point = curve.point(t);
    const Place foot = foot_from(patch, curve.place(t), point);
    worst = std::max(worst, (patch.position(foot.x(), foot.y()) - point).norm());
  }
  return worst;
}

ReferenceFit fit_with_spans(const std::array<QuadSide, 4>& sides, const QuadTarget& start,
                            const std::vector<Reference>& curves, int spans) {
  // With the borders, and what stays where there is no solution.
  ReferenceFit fit{fitted_quad(sides, start, spans), {}};
  BSplinePatch& patch = fit.quad.patch;
  // With the knots of its borders a patch has more spans than were asked for.
  const int most = std::max(patch.count_u, patch.count_v) - 3;
  const int parts = std::max(kLeastParts, kPartsOfSpan * most);
  if (!CurveFit(patch, sides).solve(points_of(curves, parts))) fit.quad.has_normals = false;
  for (const Reference& curve : curves) {
    fit.errors.push_back(furthest_point(patch, curve, parts));
  }
  return fit;
}

}  // namespace

double ReferenceFit::largest_error() const {
  return errors.empty() ? 0.0 : *std::ranges::max_element(errors);
}

ReferenceFit fitted_to_curves(const std::array<QuadSide, 4>& sides, const QuadTarget& start,
                              const std::vector<Reference>& curves,
                              const ReferenceOptions& options) {
  int spans = options.spans;
  ReferenceFit fit = fit_with_spans(sides, start, curves, spans);
  while (fit.largest_error() > options.tolerance && 2 * spans <= kMostReferenceSpans) {
    spans *= 2;
    fit = fit_with_spans(sides, start, curves, spans);
  }
  return fit;
}

}  // namespace hull::network
