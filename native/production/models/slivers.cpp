// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/models/slivers.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <unordered_map>

#include "production/models/directed_side.h"

namespace hull::production {
namespace {

using CornerNumbers = std::array<int, 3>;

class Flipper {
 public:
  Flipper(const std::vector<Vector3d>& points, std::vector<CornerNumbers>& triangles, double least)
      : points_(points), triangles_(triangles), least_(least) {
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t) enter(t);
  }

  // One pass; whether anything was flipped.
  bool pass() {
    bool any = false;
    for (int t = 0; t < static_cast<int>(triangles_.size()); ++t) any = flip(t) || any;
    return any;
  }

 private:
  void enter(int t) {
    for (int k = 0; k < 3; ++k) {
      owner_[directed_key(triangles_[t][k], triangles_[t][(k + 1) % 3])] = t;
    }
  }

  void leave(int t) {
    for (int k = 0; k < 3; ++k) {
      owner_.erase(directed_key(triangles_[t][k], triangles_[t][(k + 1) % 3]));
    }
  }

  Vector3d area(int a, int b, int c) const {
    return (points_[b] - points_[a]).cross(points_[c] - points_[a]);
  }

  // Over the longest side.
  double height(int a, int b, int c) const {
    const double longest =
        std::max({(points_[b] - points_[a]).squaredNorm(), (points_[c] - points_[b]).squaredNorm(),
                  (points_[a] - points_[c]).squaredNorm()});
    return longest > 0.0 ? area(a, b, c).norm() / longest : 0.0;
  }

  int longest_side(const CornerNumbers& t) const {
    int best = 0;
    double most = -1.0;
    for (int k = 0; k < 3; ++k) {
      const double length = (points_[t[(k + 1) % 3]] - points_[t[k]]).squaredNorm();
      if (length > most) most = length, best = k;
    }
    return best;
  }

  bool flip(int t) {
    const CornerNumbers own = triangles_[t];
    const double before = height(own[0], own[1], own[2]);
    if (before >= least_) return false;
    const int side = longest_side(own);
    const int c = own[side], a = own[(side + 1) % 3], b = own[(side + 2) % 3];  // b is between
    // Beyond the longest side, from c to a, there is d: the diagonal a-c of these four becomes b-d.
    // Were b and d neighbours already, that side would belong to four triangles.
    const auto beyond = owner_.find(directed_key(a, c));
    if (beyond == owner_.end()) return false;
    const int other = beyond->second;
    const CornerNumbers& next = triangles_[other];
    const int d = *std::find_if(next.begin(), next.end(), [=](int p) { return p != a && p != c; });
    if (d == b || owner_.contains(directed_key(b, d)) || owner_.contains(directed_key(d, b))) {
      return false;
    }
    const Vector3d normal = area(a, c, d);
    // Both new triangles face as the one beyond does: b lies between a and c as d sees it.
    const bool keeps = area(a, b, d).dot(normal) > 0.0 && area(b, c, d).dot(normal) > 0.0;
    // Strictly better, so that this ends.
    if (!keeps || std::min(height(a, b, d), height(b, c, d)) <= 2.0 * before) return false;
    leave(t);
    leave(other);
    triangles_[t] = {a, b, d};
    triangles_[other] = {b, c, d};
    enter(t);
    enter(other);
    return true;
  }

  const std::vector<Vector3d>& points_;
  std::vector<CornerNumbers>& triangles_;
  double least_;                                  // height over the longest side
  std::unordered_map<std::uint64_t, int> owner_;  // by directed side
};

}  // namespace

void flip_slivers(const std::vector<Vector3d>& points, std::vector<CornerNumbers>& triangles,
                  double height) {
  Flipper flipper(points, triangles, height);
  while (flipper.pass()) {
  }
}

}  // namespace hull::production
