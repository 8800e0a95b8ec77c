// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/overlay/edge_walk.h"

#include <stdexcept>

namespace hull::morphing {
namespace {

// From triangle to triangle: an edge on the way begins to the right of the line and ends to its
// left, seen from the triangle that is left over it.
class Walker {
 public:
  Walker(const PlaneMesh& ground, const Vector2d& p, const Vector2d& q, const Location* known_end,
         std::vector<Stretch>& stretches)
      : t_(*ground.topology),
        places_(*ground.places),
        p_(p),
        q_(q),
        known_end_(known_end),
        stretches_(stretches),
        axis_(q.x() != p.x() ? 0 : 1) {}

  void run(const Location& from) {
    switch (from.within) {
      case Within::kPoint:
        leave_point(from.index);
        break;
      case Within::kEdge:
        leave_edge(from.index);
        break;
      case Within::kTriangle:
        leave_triangle(from.index);
    }
    while (!ended_) {
      // Each stretch but the last ends on a point or an edge, from where the next one goes on.
      const Location at = stretches_.back().end;
      if (at.within == Within::kPoint) {
        leave_point(at.index);
      } else {
        enter(t_.twin(at.index));
      }
    }
  }

 private:
  // Positive to the left of the line.
  double side(int point) const { return orientation(p_, q_, places_[point]); }
  int target(int h) const { return t_.origin(t_.next(h)); }
  // How far a point of the line is ahead of another one: the sign is exact.
  double ahead(const Vector2d& of, const Vector2d& point) const {
    return q_[axis_] > p_[axis_] ? point[axis_] - of[axis_] : of[axis_] - point[axis_];
  }

  void leave_point(int point) {
    const int begin = t_.outgoing(point);
    int h = begin;
    do {
      const int back = t_.prev(h);
      // Edges of the border are not asked, for the border is a chain beside them: on its first
      // edge's right and its last one's left there is nothing, so that the line leaves between
      // them.
      const double right = t_.twin(h) < 0 ? -1.0 : side(target(h));
      const double left = t_.twin(back) < 0 ? 1.0 : side(t_.origin(back));
      if (right == 0.0 && ahead(places_[point], places_[target(h)]) > 0.0) return follow(h);
      if (right < 0.0 && left > 0.0) return leave_through(t_.next(h));
      h = t_.twin(back);
    } while (h >= 0 && h != begin);
    throw std::logic_error("A walk finds no way on from a point.");
  }

  void leave_edge(int h) {
    if (t_.twin(h) < 0) return enter(h);
    const double left = orientation(places_[t_.origin(h)], places_[target(h)], q_);
    // As the walk begins on the edge, q alone tells into which of its triangles.
    if (left > 0.0) return enter(h);
    if (left < 0.0) return enter(t_.twin(h));
    const bool forward = ahead(places_[t_.origin(h)], places_[target(h)]) > 0.0;
    follow(forward ? h : t_.twin(h));
  }

  void leave_triangle(int triangle) {
    const int first = t_.first_half_edge(triangle);
    double sides[3];
    // Out over the edge that goes from right to left, or through the corner between the two sides.
    for (int i = 0; i < 3; ++i) sides[i] = side(t_.origin(first + i));
    for (int i = 0; i < 3; ++i) {
      const double next = sides[(i + 1) % 3], last = sides[(i + 2) % 3];
      if (sides[i] < 0.0 && next > 0.0) return leave_through(first + i);
      if (sides[i] == 0.0 && last < 0.0 && next > 0.0) {
        return reach(t_.origin(first + i), triangle);
      }
    }
    throw std::logic_error("A walk finds no way on from a triangle.");
  }

  // Into the triangle of h over h, which begins to the left of the line and ends to its right.
  void enter(int h) {
    const int opposite = t_.origin(t_.prev(h));
    const double left = side(opposite);
    if (left == 0.0) return reach(opposite, t_.face(h));
    // The next edge begins to the right of the line, where h ends; the one before ends to its left.
    leave_through(left > 0.0 ? t_.next(h) : t_.prev(h));
  }

  // Out of the triangle of h over h, which begins to the right of the line and ends to its left.
  void leave_through(int h) {
    if (t_.twin(h) < 0) return end_within(t_.face(h));
    // As the edge runs from right to left, q within the triangle is to its left.
    const double left = orientation(places_[t_.origin(h)], places_[target(h)], q_);
    if (left > 0.0) return end_within(t_.face(h));
    if (left == 0.0) return end_at({t_.face(h), -1, {Within::kEdge, h}});
    stretches_.push_back({t_.face(h), -1, {Within::kEdge, h}});
  }

  // Within a triangle towards one of its corners, which is on the line.
  void reach(int point, int triangle) {
    // How far the corner is ahead of q; then, by exact signs, it is q itself where that is zero.
    const double beyond = ahead(q_, places_[point]);
    if (beyond > 0.0) return end_within(triangle);
    const Stretch stretch{triangle, -1, {Within::kPoint, point}};
    if (beyond == 0.0) return end_at(stretch);
    stretches_.push_back(stretch);
  }

  // Along h, from its beginning or from within it.
  void follow(int h) {
    const double beyond = ahead(q_, places_[target(h)]);
    // On the edge's line, and before its end.
    if (beyond > 0.0) return end_at({-1, h, {Within::kEdge, h}});
    const Stretch stretch{-1, h, {Within::kPoint, target(h)}};
    if (beyond == 0.0) return end_at(stretch);
    stretches_.push_back(stretch);
  }

  void end_within(int triangle) {
    if (known_end_ == nullptr) return end_at({triangle, -1, {Within::kTriangle, triangle}});
    if (known_end_->within != Within::kEdge || t_.face(known_end_->index) != triangle) {
      throw std::logic_error("A walk ends beside its border point.");
    }
    end_at({triangle, -1, *known_end_});
  }

  void end_at(const Stretch& stretch) {
    ended_ = true;
    stretches_.push_back(stretch);
  }

  const mesh::Topology& t_;
  const std::vector<Vector2d>& places_;
  const Vector2d p_, q_;
  const Location* known_end_;
  std::vector<Stretch>& stretches_;
  int axis_;  // along which p and q differ
  bool ended_ = false;
};

}  // namespace

void walk(const PlaneMesh& ground, const Location& from, const Vector2d& p, const Vector2d& q,
          const Location* end, std::vector<Stretch>& stretches) {
  Walker(ground, p, q, end, stretches).run(from);
}

}  // namespace hull::morphing
