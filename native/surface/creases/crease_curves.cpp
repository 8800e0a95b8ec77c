// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/creases/crease_curves.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "surface/eigenbasis/dart_walk.h"

namespace hull::surface {
namespace {

// Of the mesh's size: what may be left at a dart.
constexpr double kDartTolerance = 1e-14;
constexpr int kMostDartKnots = 120;
// A chain that a dart ends needs so many edges for the ends not to reach each other.
constexpr std::size_t kDartChainEdges = 4;

// An end of an open chain: what belongs to the spline there, from the inside outwards.
struct ChainEnd {
  std::vector<Vector3d> points;  // beyond a corner; in place of the chain's last two at a dart
  std::vector<double> knots;     // distances from the end: beyond the last inner knot, outwards
  double error = 0.0;
};

// A corner, and the point before.
ChainEnd corner_end(const Vector3d& last, const Vector3d& before, double step) {
  // The ghost point makes the uniform spline pass through `last`: (q + 4 p + 2 p - q) / 6 = p.
  // Negative distances are beyond the end.
  return {{2.0 * last - before}, {0.0, -step, -2.0 * step, -3.0 * step}, 0.0};
}

// A dart, p0, with the next two points p1, p2 of the chain, all of the level the walk is at. Each
// subdivision moves p0 by the smooth rule and the others by the crease's. The control point of a
// cubic B-spline for knots a, b, c is the value of the blossom there (Ramshaw 1989), of the uniform
// spans of one level: f(1/2, 1, 2) = 5/6 f(0, 1, 2) + 1/6 f(1, 2, 3), and so on.
ChainEnd dart_end(DartWalk& walk, Vector3d p1, Vector3d p2, double step, double tolerance,
                  int most_knots) {
  ChainEnd end;
  Vector3d p0 = walk.point();
  double distance = step;
  for (int k = 0; k < most_knots && walk.extent() > tolerance; ++k) {
    end.points.push_back((5.0 * p1 + p2) / 6.0);
    end.knots.push_back(distance *= 0.5);
    // One subdivision on: the point at 1 becomes the one at 2, and the first new one is at 1.
    p2 = (p0 + 6.0 * p1 + p2) / 8.0;
    p1 = 0.5 * (p0 + p1);
    walk.advance();
    p0 = walk.point();
  }
  // f(0, 1, 2), f(0, 0, 1), and in place of f(0, 0, 0) the surface's own point.
  end.points.insert(end.points.end(), {p1, (2.0 * p0 + p1) / 3.0, walk.limit()});
  end.knots.insert(end.knots.end(), 4, 0.0);
  end.error = walk.extent();
  return end;
}

// The spline of an open chain.
class OpenChain {
 public:
  OpenChain(const LimitSurface& surface, const CreaseChain& chain)
      : tolerance_(kDartTolerance * surface.mesh().size()),
        length_(static_cast<double>(chain.steps.size())) {
    const mesh::Topology& t = surface.mesh().topology();
    for (int v : chain.vertices) points_.push_back(surface.mesh().points()[v]);
    const auto is_dart = [&t](int vertex) { return t.kind(vertex) == mesh::VertexKind::kDart; };
    // The half-edges that leave the darts along the chain.
    if (is_dart(chain.vertices.front())) first_.emplace(surface, chain.steps.front().left(t));
    if (is_dart(chain.vertices.back())) last_.emplace(surface, chain.steps.back().right(t));
    while ((first_ || last_) && points_.size() <= kDartChainEdges) subdivide();
  }

  CubicSpline spline() {
    const std::size_t n = points_.size();
    const ChainEnd first = end(first_, 0, 1, kMostDartKnots);
    // Towards t = length knots can be no closer than numbers there are.
    const int most = 50 - static_cast<int>(std::ceil(std::log2(length_ / step_)));
    const ChainEnd last = end(last_, static_cast<int>(n) - 1, -1, most);
    dart_error_ = std::max(first.error, last.error);
    std::vector<Vector3d> points(first.points.rbegin(), first.points.rend());
    points.insert(points.end(), points_.begin() + (first_ ? 2 : 0),
                  points_.end() - (last_ ? 2 : 0));
    // Rising t: what belongs to the first end is given from the inside outwards, so backwards.
    std::vector<double> knots(first.knots.rbegin(), first.knots.rend());
    for (std::size_t i = 1; i + 1 < n; ++i) knots.push_back(step_ * static_cast<double>(i));
    points.insert(points.end(), last.points.begin(), last.points.end());
    for (double distance : last.knots) knots.push_back(length_ - distance);
    return CubicSpline(std::move(points), std::move(knots));
  }

  double dart_error() const { return dart_error_; }

 private:
  // The end at point i, the chain going on to i + inwards.
  ChainEnd end(std::optional<DartWalk>& walk, int i, int inwards, int most_knots) const {
    const Vector3d& before = points_[i + inwards];
    if (!walk) return corner_end(points_[i], before, step_);
    return dart_end(*walk, before, points_[i + 2 * inwards], step_, tolerance_, most_knots);
  }

  void subdivide() {
    std::vector<Vector3d> finer;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (i > 0) finer.push_back(0.5 * (points_[i - 1] + points_[i]));
      // The crease rule (Greshake 5.6); corners stay, and darts are put where their walks have
      // them.
      const bool inner = i > 0 && i + 1 < points_.size();
      finer.push_back(inner ? Vector3d((points_[i - 1] + 6.0 * points_[i] + points_[i + 1]) / 8.0)
                            : points_[i]);
    }
    points_ = std::move(finer);
    step_ *= 0.5;
    if (first_) {
      first_->advance();
      points_.front() = first_->point();
    }
    if (last_) {
      last_->advance();
      points_.back() = last_->point();
    }
  }

  double tolerance_, length_;
  double step_ = 1.0;  // of t between points
  double dart_error_ = 0.0;
  std::vector<Vector3d> points_;
  std::optional<DartWalk> first_, last_;
};

CubicSpline closed_spline(const std::vector<Vector3d>& control, const std::vector<int>& vertices) {
  const int n = static_cast<int>(vertices.size());
  std::vector<Vector3d> points;
  std::vector<double> knots;
  for (int i = -1; i <= n + 1; ++i) points.push_back(control[vertices[(i + n) % n]]);
  for (int i = -3; i <= n + 3; ++i) knots.push_back(i);
  return CubicSpline(std::move(points), std::move(knots));
}

std::vector<CreaseCurve::Edge> edges_of(const mesh::Topology& t, const CreaseChain& chain) {
  std::vector<CreaseCurve::Edge> edges;
  const auto next = [&t](int h) { return h < 0 ? -1 : t.next(h); };
  for (const ChainStep& step : chain.steps) {
    const int left = step.left(t), right = step.right(t);
    edges.push_back({left, next(left), right, next(right)});
  }
  return edges;
}

// Where a half-edge has the point `along` (0 to 1) of its edge: on the side v = 0 of its own cell
// in the first half, then on the side u = 0 of the face's next cell.
CellPlace place_on(int half_edge, int next, double along) {
  if (half_edge < 0) return {};
  if (along <= 0.5) return {half_edge, 2.0 * along, 0.0};
  return {next, 0.0, 2.0 * (1.0 - along)};
}

}  // namespace

CreaseCurve::CreaseCurve(CreaseKind kind, bool closed, std::vector<int> vertices,
                         std::vector<Edge> edges, CubicSpline spline, double dart_error)
    : kind_(kind),
      closed_(closed),
      vertices_(std::move(vertices)),
      edges_(std::move(edges)),
      spline_(std::move(spline)),
      dart_error_(dart_error) {}

CellPlace CreaseCurve::left(double t) const {
  const int i = std::min(static_cast<int>(t), edge_count() - 1);
  return place_on(edges_[i].left, edges_[i].after_left, t - i);
}

CellPlace CreaseCurve::right(double t) const {
  const int i = std::min(static_cast<int>(t), edge_count() - 1);
  // The half-edge at the right runs against the curve.
  return place_on(edges_[i].right, edges_[i].after_right, 1.0 - (t - i));
}

std::vector<CreaseCurve> crease_curves(const LimitSurface& surface) {
  std::vector<CreaseCurve> curves;
  const mesh::Topology& t = surface.mesh().topology();
  for (CreaseChain& chain : crease_chains(t)) {
    std::vector<CreaseCurve::Edge> edges = edges_of(t, chain);
    if (chain.closed) {
      CubicSpline spline = closed_spline(surface.mesh().points(), chain.vertices);
      curves.emplace_back(chain.kind, true, std::move(chain.vertices), std::move(edges),
                          std::move(spline), 0.0);
    } else {
      OpenChain open(surface, chain);
      CubicSpline spline = open.spline();
      curves.emplace_back(chain.kind, false, std::move(chain.vertices), std::move(edges),
                          std::move(spline), open.dart_error());
    }
  }
  return curves;
}

}  // namespace hull::surface
