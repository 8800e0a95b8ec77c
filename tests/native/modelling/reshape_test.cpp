// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/reshape/reshape.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>
#include <stdexcept>

#include "modelling/reshape/move_energy.h"
#include "modelling/reshape/square_ties.h"
#include "modelling/thin_plate.h"
#include "random_values.h"
#include "surface/refined_mesh.h"
#include "test_meshes.h"

namespace hull::modelling {
namespace {

constexpr unsigned kReshapeSeed = 23112026;

template <class Field>
std::vector<Vector3d> shifts_at(const SurfacePlaces& places, const Field& field) {
  std::vector<Vector3d> shifts;
  for (int k = 0; k < places.count(); ++k) shifts.push_back(field(places.position(k)));
  return shifts;
}

surface::LimitSurface random_surface(std::mt19937& random, int trial) {
  static const auto cache = std::make_shared<surface::BasisCache>();
  return surface::LimitSurface(
      mesh::ControlMesh(testing::random_mesh(random, 12)),
      trial % 2 ? surface::Scheme::kBiermann : surface::Scheme::kCatmullClark, cache);
}

// A sheet of quadrilaterals that is neither plane nor even.
surface::LimitSurface wavy_sheet(int n) {
  mesh::MeshArrays mesh = testing::grid(n, n);
  for (auto& p : mesh.points) {
    p /= n;
    p.z() = 0.2 * std::sin(3.0 * p.x()) * std::cos(2.0 * p.y());
  }
  return surface::LimitSurface(mesh::ControlMesh(mesh));
}

Vector3d smooth_field(const Vector3d& p) {
  return 0.05 * Vector3d(std::sin(2.0 * p.y()), p.x() * std::exp(-p.y()),
                         std::cos(3.0 * p.x()) * std::sin(2.0 * p.y()));
}

struct CellPlace {
  int cell;
  double u, v;
};

std::vector<Vector3d> moved_points(const surface::LimitSurface& surface, const Reshaped& reshaped) {
  std::vector<Vector3d> points = surface.mesh().points();
  for (std::size_t i = 0; i < points.size(); ++i) points[i] += reshaped.moves[i];
  return points;
}

// The places' areas sum up to the surface's area, irregular points included.
TEST(SurfacePlaces, CoverTheSurface) {
  // Plane, so that the area is known by its border.
  for (int n : {3, 4, 5, 7, 12}) {
    mesh::MeshArrays mesh = testing::fan(n);
    for (auto& p : mesh.points) p.z() = 0.0;
    const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
    const SurfacePlaces places(surface);
    double area = 0.0;
    const mesh::Topology& cells = surface.cells();
    for (int h = 0; h < cells.half_edge_count(); ++h) {
      if (cells.twin(h) >= 0) continue;
      const int steps = 400;
      const auto at = [&](int i) {
        const double t = static_cast<double>(i) / steps;
        const double u[] = {t, 1.0, 1.0 - t, 0.0}, v[] = {0.0, t, 1.0, 1.0 - t};
        return surface.position(h / 4, u[h % 4], v[h % 4]);
      };
      for (int i = 0; i < steps; ++i) {
        const Vector3d a = at(i), b = at(i + 1);
        area += 0.5 * (a.x() * b.y() - a.y() * b.x());
      }
    }
    EXPECT_NEAR(places.total_area(), std::abs(area), 2e-4 * std::abs(area)) << n;
  }
}

// An affine shift of the surface is that of its control points.
TEST(Reshape, MeetsAffineShiftsExactly) {
  SCOPED_TRACE(::testing::Message() << "seed " << kReshapeSeed);
  std::mt19937 random(kReshapeSeed);
  for (int trial = 0; trial < 60; ++trial) {
    surface::LimitSurface surface = random_surface(random, trial);
    const double size = surface.mesh().size();
    const Reshape reshape(surface, {});
    Eigen::Matrix3d matrix;
    for (int k = 0; k < 3; ++k) matrix.col(k) = 0.2 * testing::random_vector(random);
    const Vector3d constant = size * testing::random_vector(random);
    const auto field = [&](const Vector3d& p) { return Vector3d(matrix * p + constant); };
    const Reshaped result = reshape.solve(shifts_at(reshape.places(), field));
    EXPECT_LT(result.largest, 1e-13 * size) << "trial " << trial;
    // Control points need not come to lie on the affine image: those of a cube, for one, may move
    // up and down in turns without moving the surface.
    std::vector<CellPlace> places;
    std::vector<Vector3d> before;
    for (int k = 0; k < 100; ++k) {
      places.push_back(
          {static_cast<int>(testing::uniform(random, 0.0, surface.cell_count() - 1e-9)),
           testing::uniform(random, 0.0, 1.0), testing::uniform(random, 0.0, 1.0)});
      before.push_back(surface.position(places[k].cell, places[k].u, places[k].v));
    }
    surface.set_points(moved_points(surface, result));
    for (int k = 0; k < 100; ++k) {
      const Vector3d now = surface.position(places[k].cell, places[k].u, places[k].v);
      ASSERT_LT((now - before[k] - field(before[k])).norm(), 1e-13 * size) << "trial " << trial;
    }
  }
}

Eigen::MatrixXd dense_rows(const PlaceWeights& weights) {
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(weights.count(), weights.point_count());
  for (int square = 0; square < weights.forms().squares().count(); ++square) {
    const PlaceWeights::SquareRows own = weights.rows(square);
    for (std::size_t i = 0; i < own.points.size(); ++i) {
      rows.col(own.points[i]).segment(own.first, own.rows.rows()) =
          own.rows.col(static_cast<Eigen::Index>(i));
    }
  }
  return rows;
}

// Products that go through squares and kinds are those with the matrix written out.
TEST(PlaceWeights, ProductsAreThoseOfTheMatrix) {
  SCOPED_TRACE(::testing::Message() << "seed " << kReshapeSeed);
  std::mt19937 random(kReshapeSeed);
  for (int trial = 0; trial < 40; ++trial) {
    const surface::LimitSurface surface = random_surface(random, trial);
    const PlaceWeights weights(surface, 2 + trial % 2);
    const Eigen::MatrixXd rows = dense_rows(weights);
    const VectorRows control = VectorRows::Random(weights.point_count(), 3),
                     by_places = VectorRows::Random(weights.count(), 3);
    EXPECT_LT((weights.at(control) - rows * control).cwiseAbs().maxCoeff(), 1e-14) << trial;
    EXPECT_LT((weights.back(by_places) - rows.transpose() * by_places).cwiseAbs().maxCoeff(), 1e-12)
        << trial;
    const Eigen::VectorXd diagonal = Eigen::VectorXd::Random(weights.count());
    const Eigen::MatrixXd form = rows.transpose() * diagonal.asDiagonal() * rows;
    EXPECT_LT((Eigen::MatrixXd(weights.form(diagonal)) - form).cwiseAbs().maxCoeff(), 1e-12)
        << trial;
    EXPECT_LT((rows.rowwise().sum().array() - 1.0).abs().maxCoeff(), 1e-14) << trial;
  }
}

// Bending summed by squares is that summed by pieces.
TEST(MoveEnergy, ThinPlateIsThatOfPieces) {
  SCOPED_TRACE(::testing::Message() << "seed " << kReshapeSeed);
  std::mt19937 random(kReshapeSeed + 1);
  for (int trial = 0; trial < 20; ++trial) {
    const surface::LimitSurface surface = random_surface(random, trial);
    const Eigen::MatrixXd form(thin_plate_form(surface, surface::SquareForms(surface), 1.0));
    std::vector<Vector3d> values;
    double by_form = 0.0;
    for (std::size_t i = 0; i < surface.mesh().points().size(); ++i) {
      values.push_back(testing::random_vector(random));
    }
    const VectorRows rows = rows_of(values);
    for (int axis = 0; axis < 3; ++axis) by_form += rows.col(axis).dot(form * rows.col(axis));
    const double by_pieces = thin_plate_energy(surface, surface::PieceWeights(surface), values);
    EXPECT_NEAR(by_form, by_pieces, 1e-11 * by_pieces) << trial;
  }
}

// The least by a dense matrix of everything: minimum, limits and conditions at once.
Eigen::VectorXd dense_optimum(const surface::LimitSurface& surface, const SurfacePlaces& places,
                              const std::vector<Vector3d>& shifts, const Eigen::MatrixXd& held,
                              const Eigen::VectorXd& values, double stiffness) {
  const auto n = static_cast<Eigen::Index>(surface.mesh().points().size());
  const Eigen::MatrixXd rows = dense_rows(*places.weights());
  Eigen::VectorXd shares(places.count());
  for (int k = 0; k < places.count(); ++k) shares[k] = places.area(k) / places.total_area();
  Eigen::MatrixXd form = rows.transpose() * shares.asDiagonal() * rows;
  visit_thin_plate_forms(surface, surface::PieceWeights(surface),
                         std::pow(stiffness * surface.mesh().size(), 2),
                         [&](const std::vector<int>& points, const Eigen::MatrixXd& piece) {
                           for (Eigen::Index i = 0; i < piece.rows(); ++i) {
                             for (Eigen::Index j = 0; j < piece.cols(); ++j)
                               form(points[i], points[j]) += piece(i, j);
                           }
                         });
  Eigen::MatrixXd kkt = Eigen::MatrixXd::Zero(3 * n + held.rows(), 3 * n + held.rows());
  Eigen::VectorXd right = Eigen::VectorXd::Zero(kkt.rows());
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      for (int axis = 0; axis < 3; ++axis) kkt(3 * i + axis, 3 * j + axis) = form(i, j);
    }
  }
  for (int k = 0; k < places.count(); ++k) {
    for (Eigen::Index i = 0; i < n; ++i) {
      right.segment<3>(3 * i) += shares[k] * rows(k, i) * shifts[k];
    }
  }
  kkt.bottomLeftCorner(held.rows(), 3 * n) = held;
  kkt.topRightCorner(3 * n, held.rows()) = held.transpose();
  right.tail(held.rows()) = values;
  return kkt.fullPivLu().solve(right).head(3 * n);
}

struct Rows {
  std::vector<Eigen::RowVectorXd> rows;
  std::vector<double> values;
  Eigen::Index size;

  void add(std::initializer_list<std::pair<int, Vector3d>> terms, double value) {
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(size);
    for (const auto& [point, vector] : terms) row.segment<3>(3 * point) += vector.transpose();
    rows.push_back(row);
    values.push_back(value);
  }
  Eigen::MatrixXd matrix() const {
    Eigen::MatrixXd result(static_cast<Eigen::Index>(rows.size()), size);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      result.row(static_cast<Eigen::Index>(i)) = rows[i];
    }
    return result;
  }
  Eigen::VectorXd right() const {
    return Eigen::VectorXd::Map(values.data(), static_cast<Eigen::Index>(values.size()));
  }
};

// Locked, held, tied and prescribed points and conditions together, with and without stiffness.
TEST(Reshape, IsTheOptimumWithinLimits) {
  SCOPED_TRACE(::testing::Message() << "seed " << kReshapeSeed);
  std::mt19937 random(kReshapeSeed);
  for (int trial = 0; trial < 24; ++trial) {
    mesh::MeshArrays mesh = testing::grid(5, 4);
    testing::randomise(mesh, random, 0.2, 0.1, 0.2);
    const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
    const int n = static_cast<int>(surface.mesh().points().size());
    const double size = surface.mesh().size();
    ReshapeOptions options;
    options.stiffness = trial % 2 ? 1e-2 : 0.0;
    Rows held{{}, {}, 3 * static_cast<Eigen::Index>(n)};
    const Vector3d normal = testing::random_vector(random), tie = testing::random_vector(random);
    const Vector3d told = 0.1 * size * testing::random_vector(random);
    options.limits.limits = {{0}, {{1, normal}, {2, Vector3d::UnitY()}}};
    options.limits.tied = {{3, 4, tie}, {4, 5, Vector3d::UnitX()}, {5, 6, Vector3d::UnitZ()}};
    options.limits.prescribed = {6, 7};
    options.conditions = {{{8, 9, 3}, {}}, {{10, 2}, {}}};
    for (MoveCondition& c : options.conditions) {
      for (std::size_t k = 0; k < c.points.size(); ++k)
        c.slopes.push_back(testing::random_vector(random));
    }
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d unit = Vector3d::Unit(axis);
      held.add({{0, unit}}, 0.0);
      held.add({{6, unit}}, told[axis]);
      held.add({{7, unit}}, -told[axis]);
    }
    held.add({{1, normal}}, 0.0);
    held.add({{2, Vector3d::UnitY()}}, 0.0);
    held.add({{3, tie}, {4, -tie}}, 0.0);
    held.add({{4, Vector3d::UnitX()}, {5, -Vector3d::UnitX()}}, 0.0);
    held.add({{5, Vector3d::UnitZ()}, {6, -Vector3d::UnitZ()}}, 0.0);
    const std::vector<double> values{0.1 * size, -0.2 * size};
    const MoveCondition &one = options.conditions[0], &two = options.conditions[1];
    held.add({{8, one.slopes[0]}, {9, one.slopes[1]}, {3, one.slopes[2]}}, values[0]);
    held.add({{10, two.slopes[0]}, {2, two.slopes[1]}}, values[1]);

    const Reshape reshape(surface, options);
    std::vector<Vector3d> shifts;
    for (int k = 0; k < reshape.places().count(); ++k) {
      shifts.push_back(0.1 * size * testing::random_vector(random));
    }
    const Reshaped result = reshape.solve(shifts, {told, -told}, values);
    EXPECT_EQ(reshape.moves(shifts, {told, -told}, values), result.moves);
    const Eigen::VectorXd moves = dense_optimum(surface, reshape.places(), shifts, held.matrix(),
                                                held.right(), options.stiffness);
    Eigen::VectorXd ours(3 * n);
    for (int i = 0; i < n; ++i) ours.segment<3>(3 * i) = result.moves[i];
    EXPECT_LT((held.matrix() * ours - held.right()).cwiseAbs().maxCoeff(), 1e-12 * size);
    EXPECT_LT((ours - moves).cwiseAbs().maxCoeff(), 1e-9 * size) << "trial " << trial;
    // Bit by bit.
    EXPECT_EQ(result.moves[0], Vector3d(0.0, 0.0, 0.0));
    EXPECT_EQ(result.moves[6], told);
    EXPECT_EQ(result.moves[2].y(), 0.0);
  }
}

// What is outside a field's extent is locked, and stays bit by bit; the field is met within.
TEST(Reshape, LeavesLockedPointsAlone) {
  const surface::LimitSurface surface = wavy_sheet(12);
  const std::vector<Vector3d>& points = surface.mesh().points();
  ReshapeOptions options;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].x() > 0.6) options.limits.limits.locked.push_back(static_cast<int>(i));
  }
  const Reshape reshape(surface, options);
  const auto field = [](const Vector3d& p) {
    const double d = std::max(0.0, 1.0 - p.x() / 0.5);
    return Vector3d(0.0, 0.0, 0.1 * d * d * d);
  };
  const Reshaped result = reshape.solve(shifts_at(reshape.places(), field));
  for (int i : options.limits.limits.locked) {
    const Vector3d moved = points[i] + result.moves[i];
    EXPECT_TRUE(moved == points[i]);
  }
  EXPECT_LT(result.largest, 1e-3);
  EXPECT_EQ(result.folded_place, -1);
}

template <class Field>
double residual_of(const surface::LimitSurface& surface, const Field& field) {
  const Reshape reshape(surface, {});
  return reshape.solve(shifts_at(reshape.places(), field)).rms;
}

// Nothing beyond 0.4 from the sheet's middle.
Vector3d bump(const Vector3d& p) {
  const double x = (p.x() - 0.5) / 0.4, y = (p.y() - 0.5) / 0.4;
  const double inside = std::max(0.0, 1.0 - x * x - y * y);
  return Vector3d(0.02, -0.01, 0.1) * std::pow(inside, 5);
}

// Exact subdivision brings more points on the same surface, and what is left of a smooth shift
// falls: with the fourth power of their distance where all is regular; with less at irregular
// points, and at borders, where second derivatives across them are none.
TEST(Reshape, ResidualFallsWithSubdivision) {
  const auto refined = [](const surface::LimitSurface& surface) {
    return surface::LimitSurface(mesh::ControlMesh(surface::refined_mesh(surface)));
  };
  surface::LimitSurface sheet = wavy_sheet(12);
  double before = residual_of(sheet, bump);
  for (int step = 0; step < 2; ++step) {
    sheet = refined(sheet);
    const double now = residual_of(sheet, bump);
    EXPECT_GT(before, 8.0 * now);
    before = now;
  }
  surface::LimitSurface ball{mesh::ControlMesh(testing::cube())};
  ball = refined(ball);
  before = residual_of(ball, smooth_field);
  for (int step = 0; step < 2; ++step) {
    ball = refined(ball);
    const double now = residual_of(ball, smooth_field);
    EXPECT_GT(before, 3.0 * now);
    before = now;
  }
}

// Half an ellipsoid-like shell: square to y = 0 along its border there.
surface::LimitSurface half_shell() {
  mesh::MeshArrays mesh = testing::grid(10, 6);
  for (auto& p : mesh.points) {
    const double along = 0.3 + 0.24 * p.x(), around = 0.5 * p.y();
    // The row next to the border straight beside it.
    const double angle = std::max(0.0, around - 0.5);
    p = {-5.0 * std::cos(along), 2.0 * std::min(around, 0.5) + std::sin(angle),
         -std::sin(along) * std::cos(angle)};
  }
  return surface::LimitSurface(mesh::ControlMesh(mesh));
}

double largest_lean(const surface::LimitSurface& surface) {
  double largest = 0.0;
  const mesh::Topology& cells = surface.cells();
  for (int h = 0; h < cells.half_edge_count(); ++h) {
    if (cells.twin(h) >= 0) continue;
    const double u[] = {0.3, 1.0, 0.6, 0.0}, v[] = {0.0, 0.3, 1.0, 0.6};
    if (std::abs(surface.position(h / 4, u[h % 4], v[h % 4]).y()) > 1e-9) continue;
    largest = std::max(largest, std::abs(surface.normal(h / 4, u[h % 4], v[h % 4]).y()));
  }
  return largest;
}

TEST(Reshape, KeepsSurfacesSquareToTheCentrePlane) {
  surface::LimitSurface surface = half_shell();
  ASSERT_LT(largest_lean(surface), 1e-12);
  ReshapeOptions options;
  options.limits.tied = square_ties(surface);
  // Two for each of the nine border points between the ends.
  ASSERT_EQ(options.limits.tied.size(), 18u);
  const std::vector<Vector3d>& points = surface.mesh().points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].y() == 0.0) {
      options.limits.limits.held.push_back({static_cast<int>(i), Vector3d::UnitY()});
    }
  }
  const auto field = [](const Vector3d& p) {
    return Vector3d(0.2 * std::sin(p.x() + p.y()), 0.2 * std::cos(p.z()),
                    0.2 * std::sin(2.0 * p.y() - p.x()));
  };
  const auto lean_with = [&](const ReshapeOptions& with) {
    const Reshape reshape(surface, with);
    surface::LimitSurface shifted = surface;
    shifted.set_points(moved_points(surface, reshape.solve(shifts_at(reshape.places(), field))));
    return largest_lean(shifted);
  };
  // But for the ends, whose border turns off the plane: there the last half of the last edge is
  // ruled by the corner as well.
  ReshapeOptions with_ends = options;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::abs(points[i].x()) > 4.0)
      with_ends.limits.limits.locked.push_back(static_cast<int>(i));
  }
  EXPECT_LT(lean_with(with_ends), 1e-12);
  with_ends.limits.tied.clear();
  EXPECT_GT(lean_with(with_ends), 1e-2);
}

TEST(Reshape, TellsFolds) {
  const surface::LimitSurface surface = wavy_sheet(8);
  const Reshape reshape(surface, {});
  const auto turned = [](const Vector3d& p) {
    return Vector3d(p.x() > 0.5 ? -2.0 * (p.x() - 0.5) : 0.0, 0.0, 0.0);
  };
  const Reshaped result = reshape.solve(shifts_at(reshape.places(), turned));
  ASSERT_GE(result.folded_place, 0);
  EXPECT_GT(reshape.places().position(result.folded_place).x(), 0.45);
}

TEST(Reshape, RefusesWhatContradictsItself) {
  const surface::LimitSurface surface = wavy_sheet(3);
  ReshapeOptions options;
  options.limits.limits.locked = {0};
  options.limits.prescribed = {0};
  const Reshape reshape(surface, options);
  const std::vector<Vector3d> none(reshape.places().count(), Vector3d::Zero());
  EXPECT_THROW(reshape.solve(none, {Vector3d(1.0, 0.0, 0.0)}), std::invalid_argument);
  EXPECT_THROW(reshape.solve(none), std::invalid_argument);
  EXPECT_THROW(reshape.solve({}, {Vector3d::Zero()}), std::invalid_argument);
  ReshapeOptions twice;
  twice.conditions = {{{1, 2}, {Vector3d::UnitX(), Vector3d::UnitY()}},
                      {{1, 2}, {Vector3d(2.0, 0.0, 0.0), Vector3d(0.0, 2.0, 0.0)}}};
  EXPECT_THROW(Reshape(surface, twice), std::invalid_argument);
  ReshapeOptions held;
  held.limits.limits.locked = {1};
  held.conditions = {{{1}, {Vector3d::UnitX()}}};
  EXPECT_THROW(Reshape(surface, held), std::invalid_argument);
  ReshapeOptions wrong;
  wrong.limits.tied = {{0, 99, Vector3d::UnitX()}};
  EXPECT_THROW(Reshape(surface, wrong), std::invalid_argument);
}

}  // namespace
}  // namespace hull::modelling
