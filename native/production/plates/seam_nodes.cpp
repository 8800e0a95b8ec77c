// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/seam_nodes.h"

#include <algorithm>
#include <cmath>

namespace hull::production {

namespace {

// What counts as on a piece, of the cell's side: several of the whole numbers that triangles are
// decided with.
constexpr double kOnPart = 2e-8;

struct Cut {
  double t;
  Vector2d at;
};

// Whether p is in the piece's inside, and where.
bool is_on(const SeamPart& part, const Vector2d& p, double& t) {
  const Vector2d along = part.to - part.from;
  t = (p - part.from).dot(along) / along.squaredNorm();
  // Ends of the piece are no cuts of it.
  const double length = along.norm();
  return t * length > kOnPart && (1.0 - t) * length > kOnPart &&
         (part.from + t * along - p).norm() <= kOnPart;
}

bool is_on_side(const Vector2d& p) {
  return p.x() == 0.0 || p.x() == 1.0 || p.y() == 0.0 || p.y() == 1.0;
}

// Ends nearer to one another than rounding become one; those on sides, which other cells have, too,
// stay where they are.
std::vector<SeamPart> with_common_ends(std::vector<SeamPart> parts) {
  std::vector<Vector2d> ends;
  const auto put = [&ends](Vector2d& p) {
    for (const Vector2d& end : ends) {
      if ((end - p).norm() <= kOnPart) {
        p = end;
        return;
      }
    }
    ends.push_back(p);
  };
  for (const bool on_side : {true, false}) {
    for (SeamPart& part : parts) {
      if (is_on_side(part.from) == on_side) put(part.from);
      if (is_on_side(part.to) == on_side) put(part.to);
    }
  }
  std::erase_if(parts, [](const SeamPart& part) { return part.from == part.to; });
  return parts;
}

}  // namespace

std::vector<SeamPart> noded(const std::vector<SeamPart>& given) {
  const std::vector<SeamPart> parts = with_common_ends(given);
  std::vector<std::vector<Cut>> cuts(parts.size());
  const auto add_end = [&](std::size_t i, const Vector2d& p) {
    double t = 0.0;
    if (is_on(parts[i], p, t)) cuts[i].push_back({t, p});
  };
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const SeamPart &a = parts[i], &b = parts[j];
      // Most pairs are apart in u alone.
      if (std::max(a.from.x(), a.to.x()) < std::min(b.from.x(), b.to.x()) - kOnPart ||
          std::max(b.from.x(), b.to.x()) < std::min(a.from.x(), a.to.x()) - kOnPart) {
        continue;
      }
      const std::size_t before = cuts[i].size() + cuts[j].size();
      add_end(i, b.from);
      add_end(i, b.to);
      add_end(j, a.from);
      add_end(j, a.to);
      // An end of one on the other is the cut that they have: straight pieces have no second one.
      if (cuts[i].size() + cuts[j].size() > before) continue;
      const Vector2d along = a.to - a.from, other = b.to - b.from;
      const double turn = cross(along, other);
      // Parallel: where they lie on one another their ends were found to.
      if (std::abs(turn) <= 1e-14 * along.norm() * other.norm()) continue;
      const double t = cross(b.from - a.from, other) / turn;
      const double s = cross(b.from - a.from, along) / turn;
      if (t <= 0.0 || t >= 1.0 || s <= 0.0 || s >= 1.0) continue;
      const Vector2d at = a.from + t * along;
      // So near to an end it is that end, which is common already.
      const auto near = [&](const Vector2d& p) { return (p - at).norm() <= kOnPart; };
      if (near(a.from) || near(a.to) || near(b.from) || near(b.to)) continue;
      cuts[i].push_back({t, at});
      cuts[j].push_back({s, at});
    }
  }
  std::vector<SeamPart> result;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::sort(cuts[i].begin(), cuts[i].end(), [](const Cut& a, const Cut& b) { return a.t < b.t; });
    Vector2d last = parts[i].from;
    for (const Cut& cut : cuts[i]) {
      // Two other pieces may cut this one at the same point.
      if ((cut.at - last).norm() <= kOnPart) continue;
      result.push_back({last, cut.at, parts[i].curve});
      last = cut.at;
    }
    result.push_back({last, parts[i].to, parts[i].curve});
  }
  return result;
}

double distance_to(const SeamPart& part, const Vector2d& uv, const Vector2d& lengths) {
  const Vector2d a = part.from.cwiseProduct(lengths), b = part.to.cwiseProduct(lengths);
  const Vector2d p = uv.cwiseProduct(lengths), along = b - a;
  const double t = std::clamp((p - a).dot(along) / std::max(along.squaredNorm(), 1e-300), 0.0, 1.0);
  return (a + t * along - p).norm();
}

}  // namespace hull::production
