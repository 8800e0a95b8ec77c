// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/section_arcs.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace hull {
namespace {

constexpr int kDeepestSample = 10;  // up to 1025 points an arc

// The crossing of one cut square as a curve over its u (after the exchange, if swapped).
class Crossing {
 public:
  Crossing(const SurfacePiece& piece, const CutSquare& square) : piece_(piece), square_(square) {}

  SectionPoint at(double u) const {
    const double v = std::clamp(crossing(square_.height, u), 0.0, 1.0);
    const double s = square_.u + square_.size * (square_.swapped ? v : u);
    const double t = square_.v + square_.size * (square_.swapped ? u : v);
    const Eigen::Vector2d uv(piece_.u + piece_.size * s, piece_.v + piece_.size * t);
    return {evaluate_bicubic(piece_.points, s, t, 0).point, piece_.cell,
            uv.cwiseMax(0.0).cwiseMin(1.0)};
  }

 private:
  const SurfacePiece& piece_;
  const CutSquare& square_;
};

double distance_to_chord(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d chord = b - a;
  const double length2 = chord.squaredNorm();
  if (length2 == 0.0) return (p - a).norm();
  const double t = std::clamp((p - a).dot(chord) / length2, 0.0, 1.0);
  return (p - a - t * chord).norm();
}

// Appends the points after `a` up to and including `b`.
void sample(const Crossing& curve, double u_a, const SectionPoint& a, double u_b,
            const SectionPoint& b, double tolerance, int depth, SectionArc& arc) {
  // Three inner points, so that an S-shaped arc is not taken for a straight one.
  const double u_m = 0.5 * (u_a + u_b);
  const SectionPoint m = curve.at(u_m);
  double off = distance_to_chord(m.point, a.point, b.point);
  for (double t : {0.25, 0.75}) {
    off = std::max(off, distance_to_chord(curve.at(u_a + t * (u_b - u_a)).point, a.point, b.point));
  }
  if (off <= tolerance || depth == kDeepestSample) {
    arc.push_back(b);
    return;
  }
  sample(curve, u_a, a, u_m, m, tolerance, depth + 1, arc);
  sample(curve, u_m, m, u_b, b, tolerance, depth + 1, arc);
}

void add_arcs(const SurfacePiece& piece, const CutSquare& square, double chord_tolerance,
              std::vector<SectionArc>& arcs) {
  const Breaks breaks = crossing_breaks(square.height);
  const Crossing curve(piece, square);
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    const BezierCubic column = square.height.along_v(0.5 * (breaks[k] + breaks[k + 1]));
    if ((column[0] < 0.0) == (column[3] < 0.0)) continue;
    SectionArc arc{curve.at(breaks[k])};
    sample(curve, breaks[k], arc.front(), breaks[k + 1], curve.at(breaks[k + 1]), chord_tolerance,
           0, arc);
    arcs.push_back(std::move(arc));
  }
}

// One end of an arc: index 2 * arc, + 1 for the last point.
struct End {
  Vector3d point;
  int index;
};

struct Meeting {
  double distance;
  int a, b;
};

// For each end the one it is joined to, or -1.
std::vector<int> match_ends(const std::vector<SectionArc>& arcs, double tolerance) {
  std::vector<End> ends;
  for (int i = 0; i < static_cast<int>(arcs.size()); ++i) {
    ends.push_back({arcs[i].front().point, 2 * i});
    ends.push_back({arcs[i].back().point, 2 * i + 1});
  }
  // Along a direction that no usual plane is square to, few ends share a coordinate.
  const Vector3d along = Vector3d(0.61, 0.53, 0.59).normalized();
  std::sort(ends.begin(), ends.end(),
            [&](const End& x, const End& y) { return along.dot(x.point) < along.dot(y.point); });
  std::vector<Meeting> meetings;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t j = i + 1; j < ends.size(); ++j) {
      if (along.dot(ends[j].point - ends[i].point) > tolerance) break;
      const double distance = (ends[i].point - ends[j].point).norm();
      if (distance <= tolerance) meetings.push_back({distance, ends[i].index, ends[j].index});
    }
  }
  std::sort(meetings.begin(), meetings.end(), [](const Meeting& x, const Meeting& y) {
    return std::tie(x.distance, x.a, x.b) < std::tie(y.distance, y.a, y.b);
  });
  std::vector<int> partner(2 * arcs.size(), -1);
  for (const Meeting& m : meetings) {
    if (partner[m.a] >= 0 || partner[m.b] >= 0) continue;
    partner[m.a] = m.b;
    partner[m.b] = m.a;
  }
  return partner;
}

double length_of(const SectionArc& arc) {
  double length = 0.0;
  for (std::size_t i = 1; i < arc.size(); ++i) length += (arc[i].point - arc[i - 1].point).norm();
  return length;
}

}  // namespace

std::vector<SectionArc> section_arcs(const SurfacePiece& piece, const Plane& plane,
                                     double zero_tolerance, double chord_tolerance) {
  std::vector<SectionArc> arcs;
  const BezierBicubic height = heights(piece.points, plane, zero_tolerance);
  cut_piece(height, [&](const CutSquare& square) {
    if (square.side == CutSquare::Side::kCut) add_arcs(piece, square, chord_tolerance, arcs);
  });
  return arcs;
}

std::vector<JoinedArcs> join_arcs(const std::vector<SectionArc>& all, double tolerance) {
  // Arcs that only nick a square's corner would be joined to themselves.
  std::vector<SectionArc> arcs;
  for (const SectionArc& arc : all) {
    if (length_of(arc) > tolerance) arcs.push_back(arc);
  }
  const std::vector<int> partner = match_ends(arcs, tolerance);
  std::vector<char> used(arcs.size(), 0);
  std::vector<JoinedArcs> curves;
  for (int i = 0; i < static_cast<int>(arcs.size()); ++i) {
    if (used[i]) continue;
    // Back to the beginning of the curve, or round to where we are.
    int begin = 2 * i;
    while (partner[begin] >= 0) {
      const int before = partner[begin] ^ 1;
      begin = before;
      if (before == 2 * i) break;
    }
    JoinedArcs curve{{}, {}, partner[begin] >= 0};
    for (int end = begin; !used[end / 2];) {
      used[end / 2] = 1;
      SectionArc arc = arcs[end / 2];
      if (end & 1) std::reverse(arc.begin(), arc.end());
      const std::size_t joint = curve.points.size();
      if (joint > 0) {
        curve.joints.push_back(static_cast<int>(joint) - 1);
        curve.points.insert(curve.points.end(), arc.begin() + 1, arc.end());
      } else {
        curve.points = std::move(arc);
      }
      const int next = partner[end ^ 1];
      if (next < 0) break;
      end = next;
    }
    if (curve.closed) {
      curve.points.back() = curve.points.front();
      curve.joints.push_back(static_cast<int>(curve.points.size()) - 1);
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace hull
