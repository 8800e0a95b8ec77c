// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/crossings/curve_tree.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hull::network {
namespace {

Vector3d place_of(const Eigen::RowVector4d& point) {
  return point.head<3>().transpose() / point[3];
}

double distance_from_chord(const Vector3d& place, const Vector3d& start, const Vector3d& end) {
  const Vector3d chord = end - start;
  const double length = chord.squaredNorm();
  // From the chord as a segment: a part that turns back has control points on its line, beyond it.
  const double share = length > 0.0 ? std::clamp(chord.dot(place - start) / length, 0.0, 1.0) : 0.0;
  return (place - start - share * chord).norm();
}

}  // namespace

CurveTree::CurveTree(const NurbsCurve& curve, double flat) : curve_(curve), flat_(flat) {
  if (!(flat > 0.0) || !std::isfinite(flat)) {
    throw std::invalid_argument("The distance within which curves are straight must be above 0.");
  }
  // From knot to knot, as a part between has one polynomial.
  for (CurvePiece& piece : pieces_of(curve_)) {
    parts_.push_back(part_of(std::move(piece)));
    box_.extend(parts_.back().box);
  }
  root_count_ = static_cast<int>(parts_.size());
}

CurveTree::Part CurveTree::part_of(CurvePiece piece) const {
  const Eigen::Index last = piece.points.rows() - 1;
  const Vector3d start = place_of(piece.points.row(0)), end = place_of(piece.points.row(last));
  const double middle = 0.5 * (piece.low + piece.high);
  // With its control points, in whose hull it lies, the curve is as near to the chord.
  bool is_straight = true;
  for (Eigen::Index i = 1; i < last && is_straight; ++i) {
    is_straight = distance_from_chord(place_of(piece.points.row(i)), start, end) <= flat_;
  }
  // A part that no parameter halves any longer is as short as it gets.
  is_straight = is_straight || !(piece.low < middle && middle < piece.high);
  const Eigen::AlignedBox3d box = piece.box();
  return {std::move(piece), box, start, end, is_straight};
}

int CurveTree::halves_of(int number) {
  const auto at = static_cast<std::size_t>(number);
  if (parts_[at].first < 0) {
    // Apart from the parts, which may move in memory when others are added.
    CurvePiece first, second;
    parts_[at].piece.split(first, second);
    parts_[at].first = static_cast<int>(parts_.size());
    parts_.push_back(part_of(std::move(first)));
    parts_.push_back(part_of(std::move(second)));
  }
  return parts_[at].first;
}

}  // namespace hull::network
