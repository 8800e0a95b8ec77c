// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <vector>

namespace hull::production {

// Cubic B-splines on a uniform grid over a box: twice differentiable functions, of which only those
// count that are used somewhere. The border of a plate goes through the grid as it likes.
class SheetSplines {
 public:
  static constexpr int kOnPoint = 16;
  // Of the functions that are not zero at a point; derivatives by the box's coordinates.
  struct Values {
    std::array<int, kOnPoint> functions;  // -1: is not used
    Eigen::Matrix<double, kOnPoint, 1> values;
    Eigen::Matrix<double, kOnPoint, 2> slopes;
  };

  SheetSplines() = default;
  // About square cells, `across` of them over the shorter side.
  SheetSplines(const Eigen::AlignedBox2d& box, int across);
  // The grid with cells of half the size.
  SheetSplines halved() const;

  Values at(const Eigen::Vector2d& point) const;
  // Before use: the functions at a point, and at those up to kAround of a cell from it, count.
  static constexpr double kAround = 0.3;
  void use(const Eigen::Vector2d& point);
  int count() const { return static_cast<int>(used_.size()); }
  double cell() const { return step_.maxCoeff(); }

  // The coefficients with which the sum of functions is the point itself.
  std::vector<Eigen::Vector2d> identity() const;
  // Of the same map in the halved grid `finer`. Where a function of this one is missing, it is
  // taken to be the nearest affine map.
  std::vector<Eigen::Vector2d> refined(const SheetSplines& finer,
                                       const std::vector<Eigen::Vector2d>& coefficients) const;
  // Four functions that follow one another, along either direction.
  std::vector<std::array<int, 4>> runs() const;

 private:
  struct Where {
    Eigen::Vector2i cell;
    Eigen::Vector2d within;
  };
  Where where(const Eigen::Vector2d& point) const;
  int index(int i, int j) const { return j * (cells_.x() + 3) + i; }
  int number(int i, int j) const;

  Eigen::Vector2d origin_ = Eigen::Vector2d::Zero(), step_ = Eigen::Vector2d::Ones();
  Eigen::Vector2i cells_ = Eigen::Vector2i::Zero();
  std::vector<int> numbers_;  // by index()
  std::vector<Eigen::Vector2i> used_;
};

}  // namespace hull::production
