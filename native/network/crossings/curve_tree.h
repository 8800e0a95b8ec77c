// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "network/curves/curve_pieces.h"

namespace hull::network {

// A curve's pieces, halved where they are asked for until they are straight: a tree of boxes. The
// parts keep what they are over queries.
class CurveTree {
 public:
  // `flat`, m: how far the control points of a part that counts as straight may be off its chord.
  // Throws std::invalid_argument where it is not above zero.
  CurveTree(const NurbsCurve& curve, double flat);

  struct Part {
    CurvePiece piece;
    Eigen::AlignedBox3d box;
    Vector3d start, end;
    bool is_straight;
    int first = -1;  // of its halves, the second follows; -1: not halved
  };

  const NurbsCurve& curve() const { return curve_; }
  double flat() const { return flat_; }
  const Eigen::AlignedBox3d& box() const { return box_; }
  // The parts between knots are the first ones.
  int root_count() const { return root_count_; }
  const Part& part(int number) const { return parts_[static_cast<std::size_t>(number)]; }
  // The number of its first half. REQUIRES: it is not straight.
  int halves_of(int number);

 private:
  Part part_of(CurvePiece piece) const;

  NurbsCurve curve_;
  double flat_;
  std::vector<Part> parts_;
  int root_count_;
  Eigen::AlignedBox3d box_;
};

}  // namespace hull::network
