// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/splines/reference_fit.h"

#include <Eigen/Geometry>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>

#include "network/splines/quad_constraints.h"

namespace hull::network {
namespace {

using conversion::BSplinePatch;

constexpr int kMostReferenceSpans = 32;
constexpr int kLeastParts = 8, kPartsOfSpan = 2;  // of a curve, a point each
constexpr int kMeasuredOfPart = 3;
constexpr int kFootSolutions = 20;    // with feet found anew, at most
constexpr double kSettled = 1e-13;    // of the size: feet that move no more
constexpr int kFootGrid = 12;         // places each way from which a first foot is taken
constexpr int kFootSteps = 8;         // of Newton's
constexpr double kSlideShare = 1e-6;  // of a foot's distance along the patch
// Of the energy against the mean square of distances: first much, so that the patch's parameters
// become even, then less and less with each solution, so that it does not keep it off curves.
constexpr double kFirstEnergy = 1e-3, kLastEnergy = 1e-10, kLessEnergy = 0.3;

using Place = Eigen::Vector2d;

Place nearest_of_grid(const BSplinePatch& patch, const Vector3d& point) {
  Place nearest = Place::Zero();
  double least = -1.0;
  for (int i = 0; i <= kFootGrid; ++i) {
    for (int k = 0; k <= kFootGrid; ++k) {
      const Place at(static_cast<double>(i) / kFootGrid, static_cast<double>(k) / kFootGrid);
      const double distance = (patch.position(at.x(), at.y()) - point).squaredNorm();
      if (least >= 0.0 && distance >= least) continue;
      least = distance;
      nearest = at;
    }
  }
  return nearest;
}

Place foot_from(const BSplinePatch& patch, Place at, const Vector3d& point) {
  for (int step = 0; step < kFootSteps; ++step) {
    const surface::SurfaceJet jet = patch.evaluate(at.x(), at.y());
    Eigen::Matrix<double, 3, 2> slopes;
    slopes << jet.du, jet.dv;
    const Place move =
        (slopes.transpose() * slopes).ldlt().solve(slopes.transpose() * (point - jet.point));
    if (!move.allFinite()) return at;
    at = (at + move).cwiseMax(0.0).cwiseMin(1.0);
    if (move.norm() < kSettled) break;
  }
  return at;
}

// ∫ B_i''' B_k''' and ∫ B_i B_k over a knot vector.
struct Energies {
  Eigen::MatrixXd third, mass;

  explicit Energies(const std::vector<double>& knots) {
    const auto count = static_cast<Eigen::Index>(knots.size()) - 4;
    third = mass = Eigen::MatrixXd::Zero(count, count);
    for (std::size_t s = 1; s < knots.size(); ++s) {
      const double low = knots[s - 1], width = knots[s] - low;
      if (!(width > 0.0)) continue;
      // Second derivatives are linear in a span, products of functions of the sixth degree.
      const auto at = [&](double share) {
        return conversion::basis_values(knots, 3, low + share * width);
      };
      const conversion::BasisValues a = at(0.25), b = at(0.75);
      const Eigen::Vector4d jump = (b.rows.row(2) - a.rows.row(2)).transpose() / (0.5 * width);
      third.block<4, 4>(a.first, a.first) += width * jump * jump.transpose();
      constexpr double kNodes[] = {0.06943184420297371, 0.33000947820757187, 0.66999052179242813,
                                   0.93056815579702629};
      constexpr double kWeights[] = {0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                     0.17392742256872693};
      for (int g = 0; g < 4; ++g) {
        const conversion::BasisValues values = at(kNodes[g]);
        const Eigen::Vector4d row = values.rows.row(0).transpose();
        mass.block<4, 4>(values.first, values.first) += width * kWeights[g] * row * row.transpose();
      }
    }
  }
};

// Normal equations of all coordinates, with the constraints bordered to them.
class CurveFit {
 public:
  CurveFit(BSplinePatch& patch, const std::vector<Vector3d>& points,
           const std::array<QuadSide, 4>& sides)
      : patch_(patch),
        points_(points),
        along_u_(patch.knots_u),
        along_v_(patch.knots_v),
        constraints_(normal_constraints(patch, sides)) {}

  // One solution over the feet; false, and nothing done, where there is none.
  bool solve(const std::vector<Place>& feet, double energy) {
    const Eigen::Index inner = 3 * (patch_.count_u - 2) * (patch_.count_v - 2);
    const Eigen::Index size = inner + std::ssize(constraints_);
    entries_.clear();
    right_ = Eigen::VectorXd::Zero(size);
    for (std::size_t i = 0; i < points_.size(); ++i) add_point(feet[i], points_[i]);
    add_energy(energy);
    for (std::size_t q = 0; q < constraints_.size(); ++q) {
      add_constraint(constraints_[q], inner + static_cast<Eigen::Index>(q));
    }
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
  void add(int row_point, int column_point, const Eigen::Matrix3d& weight) {
    const int row = inner_number(patch_, row_point), column = inner_number(patch_, column_point);
    if (row < 0) return;
    if (column < 0) {
      right_.segment<3>(3 * row) -=
          weight * patch_.control_points[static_cast<std::size_t>(column_point)];
      return;
    }
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        if (weight(a, b) != 0.0) entries_.emplace_back(3 * row + a, 3 * column + b, weight(a, b));
      }
    }
  }

  // The distance along the normal counts, and the rest a little: feet may slide.
  void add_point(const Place& foot, const Vector3d& point) {
    const surface::SurfaceJet jet = patch_.evaluate(foot.x(), foot.y());
    const Vector3d normal = jet.du.cross(jet.dv).normalized();
    const Eigen::Matrix3d weight =
        (kSlideShare * Eigen::Matrix3d::Identity() + normal * normal.transpose()) /
        static_cast<double>(points_.size());
    const conversion::BasisValues u = conversion::basis_values(patch_.knots_u, 3, foot.x());
    const conversion::BasisValues v = conversion::basis_values(patch_.knots_v, 3, foot.y());
    std::array<int, 16> numbers;
    std::array<double, 16> shares;
    for (int a = 0; a < 16; ++a) {
      const auto at = static_cast<std::size_t>(a);
      numbers[at] = (u.first + a / 4) * patch_.count_v + v.first + a % 4;
      shares[at] = u.rows(0, a / 4) * v.rows(0, a % 4);
    }
    for (std::size_t a = 0; a < 16; ++a) {
      for (std::size_t b = 0; b < 16; ++b) {
        add(numbers[a], numbers[b], shares[a] * shares[b] * weight);
      }
      const int row = inner_number(patch_, numbers[a]);
      if (row >= 0) right_.segment<3>(3 * row) += shares[a] * weight * point;
    }
  }

  void add_energy(double share) {
    const auto near = [](int i, int count) {
      return std::pair{std::max(0, i - 3), std::min(count - 1, i + 3)};
    };
    for (int i = 1; i + 1 < patch_.count_u; ++i) {
      const auto [low_u, high_u] = near(i, patch_.count_u);
      for (int j = 1; j + 1 < patch_.count_v; ++j) {
        const auto [low_v, high_v] = near(j, patch_.count_v);
        for (int k = low_u; k <= high_u; ++k) {
          for (int l = low_v; l <= high_v; ++l) {
            const double energy = along_u_.third(i, k) * along_v_.mass(j, l) +
                                  along_u_.mass(i, k) * along_v_.third(j, l);
            add(i * patch_.count_v + j, k * patch_.count_v + l,
                share * energy * Eigen::Matrix3d::Identity());
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
  const std::vector<Vector3d>& points_;
  Energies along_u_, along_v_;
  std::vector<NormalConstraint> constraints_;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::VectorXd right_;
};

// Points of all curves at the middles of equal parts.
std::vector<Vector3d> points_of(const std::vector<Reference>& curves, int parts) {
  std::vector<Vector3d> points;
  for (const Reference& curve : curves) {
    for (int i = 0; i < parts; ++i) points.push_back(curve((i + 0.5) / parts));
  }
  return points;
}

std::vector<Place> first_feet(const BSplinePatch& patch, const std::vector<Vector3d>& points) {
  std::vector<Place> feet;
  for (const Vector3d& point : points) {
    feet.push_back(foot_from(patch, nearest_of_grid(patch, point), point));
  }
  return feet;
}

// Of curves, at places between those that the patch was made of.
std::vector<double> furthest_points(const BSplinePatch& patch, const std::vector<Reference>& curves,
                                    int parts) {
  std::vector<double> errors;
  for (const Reference& curve : curves) {
    double worst = 0.0;
    Place foot = nearest_of_grid(patch, curve(0.0));
    for (int i = 0; i <= kMeasuredOfPart * parts; ++i) {
      const Vector3d point = curve(static_cast<double>(i) / (kMeasuredOfPart * parts));
      foot = foot_from(patch, foot, point);
      worst = std::max(worst, (patch.position(foot.x(), foot.y()) - point).norm());
    }
    errors.push_back(worst);
  }
  return errors;
}

ReferenceFit fit_with_spans(const std::array<QuadSide, 4>& sides, const QuadTarget& start,
                            const std::vector<Reference>& references, int spans) {
  ReferenceFit fit{fitted_quad(sides, start, spans), {}};
  BSplinePatch& patch = fit.quad.patch;
  const int parts =
      std::max(kLeastParts, kPartsOfSpan * (std::max(patch.count_u, patch.count_v) - 3));
  const std::vector<Vector3d> points = points_of(references, parts);
  std::vector<Place> feet = first_feet(patch, points);
  CurveFit curves(patch, points, sides);
  double energy = kFirstEnergy;
  for (int solution = 0; solution < kFootSolutions; ++solution) {
    const bool is_solved = curves.solve(feet, energy);
    energy = std::max(kLastEnergy, kLessEnergy * energy);
    if (!is_solved) {
      fit.quad.has_normals = false;
      break;
    }
    double moved = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Place foot = foot_from(patch, feet[i], points[i]);
      moved = std::max(moved, (foot - feet[i]).norm());
      feet[i] = foot;
    }
    if (moved < kSettled) break;
  }
  fit.errors = furthest_points(patch, references, parts);
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
