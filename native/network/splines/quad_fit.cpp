// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/splines/quad_fit.h"

#include "analysis/arithmetic/gauss.h"
#include "network/splines/quad_constraints.h"

namespace hull::network {
namespace {

using conversion::BSplinePatch;

// Samples along one direction, and the functions of its control points there, times the root of
// the samples' weights.
struct Samples {
  std::vector<double> places, roots;
  Eigen::MatrixXd basis;

  explicit Samples(const std::vector<double>& knots) {
    static const std::vector<double> nodes = analysis::gauss_rule(2).nodes;  // weights: a half each
    for (std::size_t i = 1; i < knots.size(); ++i) {
      const double width = knots[i] - knots[i - 1];
      if (!(width > 0.0)) continue;
      // Roots of the weights, as they come into squares.
      for (double share : nodes) {
        places.push_back(knots[i - 1] + share * width);
        roots.push_back(std::sqrt(0.5 * width));
      }
    }
    const auto count = static_cast<Eigen::Index>(knots.size()) - 4;
    basis = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(places.size()), count);
    for (std::size_t s = 0; s < places.size(); ++s) {
      const conversion::BasisValues values = conversion::basis_values(knots, 3, places[s]);
      basis.row(static_cast<Eigen::Index>(s)).segment(values.first, 4) =
          roots[s] * values.rows.row(0);
    }
  }

  // Without the first and the last one, which are the borders'.
  auto inner() const { return basis.middleCols(1, basis.cols() - 2); }
};

BSplinePatch with_borders(const std::array<QuadSide, 4>& sides, int spans) {
  BSplinePatch patch;
  const auto knots_of = [&](std::size_t k) {
    // Each of two opposite sides is met exactly over the knots of both.
    const std::vector<double> both =
        united_knots(sides[k].curve.knots, sides[k + 2].curve.reversed().knots);
    return united_knots(both, uniform_knots(spans));
  };
  patch.knots_u = knots_of(0);
  patch.knots_v = knots_of(1);
  patch.count_u = static_cast<int>(patch.knots_u.size()) - 4;
  patch.count_v = static_cast<int>(patch.knots_v.size()) - 4;
  patch.control_points.assign(static_cast<std::size_t>(patch.count_u * patch.count_v),
                              Vector3d::Zero());
  for (int k = 0; k < 4; ++k) {
    const BSplineCurve& curve = sides[static_cast<std::size_t>(k)].curve;
    const auto& knots = k % 2 == 0 ? patch.knots_u : patch.knots_v;
    // Sides 2 and 3 run against u and v, along which the knots are.
    const BSplineCurve fine =
        k < 2 ? with_knots(curve, knots) : with_knots(curve.reversed(), knots).reversed();
    for (int i = 0; i < patch.side_count(k); ++i) {
      patch.control_points[static_cast<std::size_t>(patch.side_index(k, i))] =
          fine.points[static_cast<std::size_t>(i)];
    }
  }
  return patch;
}

// The least squares without constraints: one for each coordinate.
class InnerFit {
 public:
  explicit InnerFit(const BSplinePatch& patch)
      : u_(patch.knots_u),
        v_(patch.knots_v),
        solve_u_(u_.inner().transpose() * u_.inner()),
        solve_v_(v_.inner().transpose() * v_.inner()) {}

  void fit(BSplinePatch& patch, const QuadTarget& target) const {
    const Eigen::Index rows = u_.basis.rows(), columns = v_.basis.rows();
    // A matrix for each coordinate, with a row for each sample of u and a column for each of v.
    std::array<Eigen::MatrixXd, 3> wanted;
    for (auto& part : wanted) part.resize(rows, columns);
    for (Eigen::Index i = 0; i < rows; ++i) {
      for (Eigen::Index k = 0; k < columns; ++k) {
        const auto at_u = static_cast<std::size_t>(i), at_v = static_cast<std::size_t>(k);
        const Vector3d point = target(u_.places[at_u], v_.places[at_v]);
        for (std::size_t d = 0; d < 3; ++d) {
          wanted[d](i, k) = u_.roots[at_u] * v_.roots[at_v] * point[static_cast<int>(d)];
        }
      }
    }
    for (int d = 0; d < 3; ++d) {
      Eigen::MatrixXd points(patch.count_u, patch.count_v);
      for (int i = 0; i < patch.count_u; ++i) {
        for (int j = 0; j < patch.count_v; ++j) points(i, j) = patch.control_point(i, j)[d];
      }
      // Inner points are zero yet: this is what the borders leave of the target.
      const Eigen::MatrixXd rest =
          wanted[static_cast<std::size_t>(d)] - u_.basis * points * v_.basis.transpose();
      // Normal equations of a tensor product, A'A X B'B = A' R B: two small solutions for one of
      // all points.
      const Eigen::MatrixXd inner = solved(u_.inner().transpose() * rest * v_.inner());
      for (int i = 1; i + 1 < patch.count_u; ++i) {
        for (int j = 1; j + 1 < patch.count_v; ++j) {
          patch.control_points[static_cast<std::size_t>(i * patch.count_v + j)][d] =
              inner(i - 1, j - 1);
        }
      }
    }
  }

  // The inverse of the normal equations, of a matrix over the inner control points.
  Eigen::MatrixXd solved(const Eigen::MatrixXd& right) const {
    // From the left by u, then from the right by v.
    const Eigen::MatrixXd half = solve_u_.solve(right);
    return solve_v_.solve(half.transpose()).transpose();
  }

 private:
  Samples u_, v_;
  Eigen::LLT<Eigen::MatrixXd> solve_u_, solve_v_;
};

}  // namespace

FittedQuad fitted_quad(const std::array<QuadSide, 4>& sides, const QuadTarget& target, int spans) {
  FittedQuad fitted{with_borders(sides, spans)};
  const InnerFit inner(fitted.patch);
  inner.fit(fitted.patch, target);
  fitted.has_normals = meet_normals(
      fitted.patch, sides, [&](const Eigen::MatrixXd& right) { return inner.solved(right); });
  return fitted;
}

}  // namespace hull::network
