// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/segments/dowel_holes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "production/models/model_cut.h"
#include "production/segments/clipped_polygon.h"

namespace hull::production {

using Eigen::AlignedBox2d;

namespace {

constexpr int kPlacesAlong = 24;  // tried along a joint's longer side

using Polygon = std::vector<Vector2d>;

double distance_to(const Polygon& polygon, const Vector2d& p) {
  double least = std::numeric_limits<double>::infinity();
  // Polygons are convex: a place is inside where it lies on one side of all of their sides.
  // Without area, all on one line or in one point, it has no inside.
  bool left = polygon.size() > 2, right = left, has_area = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d &a = polygon[i], ab = polygon[(i + 1) % polygon.size()] - a;
    const double length = ab.squaredNorm();
    const double t = length > 0.0 ? std::clamp((p - a).dot(ab) / length, 0.0, 1.0) : 0.0;
    least = std::min(least, (a + t * ab - p).norm());
    const double side = cross(ab, p - a);
    left = left && side >= 0.0;
    right = right && side <= 0.0;
    has_area = has_area || side != 0.0;
  }
  return has_area && (left || right) ? 0.0 : least;
}

// What of a segment is near a plane, on one side of it, seen along the axis: its faces in the plane
// and all others down to a depth.
class JointSide {
 public:
  // upward: the segment is below the plane.
  JointSide(const ClosedModel& model, int axis, double at, bool upward, double depth) {
    const double low = upward ? at - depth : at, high = upward ? at : at + depth;
    for (const auto& t : model.triangles) {
      std::vector<Vector3d> corners;
      bool in_plane = true;
      for (const int corner : t) {
        corners.push_back(model.points[corner]);
        in_plane = in_plane && model.points[corner][axis] == at;
      }
      if (!in_plane) corners = clipped(clipped(corners, axis, low, 1.0), axis, high, -1.0);
      if (corners.empty()) continue;
      Polygon seen;
      for (const Vector3d& p : corners) seen.emplace_back(p[(axis + 1) % 3], p[(axis + 2) % 3]);
      (in_plane ? face_ : around_).push_back(std::move(seen));
    }
  }

  // Whether a place is in the face, with room around it.
  bool has_room(const Vector2d& p, double room) const {
    const auto holds = [&p](const Polygon& one) { return distance_to(one, p) == 0.0; };
    if (std::none_of(face_.begin(), face_.end(), holds)) return false;
    return std::none_of(around_.begin(), around_.end(),
                        [&](const Polygon& one) { return distance_to(one, p) < room; });
  }

 private:
  std::vector<Polygon> face_, around_;
};

struct Joint {
  int axis;
  double at;
  int below, above;  // segments
  AlignedBox2d common;
};

std::optional<Joint> joint_between(const std::vector<ModelSegment>& segments, int i, int j) {
  for (int axis = 0; axis < 3; ++axis) {
    const double at = segments[i].box[1][axis];
    // Planes are numbers of one grid: what is the same is equal to the last bit.
    if (at != segments[j].box[0][axis]) continue;
    const auto seen = [axis](const Vector3d& p) {
      return Vector2d(p[(axis + 1) % 3], p[(axis + 2) % 3]);
    };
    const AlignedBox2d a(seen(segments[i].box[0]), seen(segments[i].box[1]));
    const AlignedBox2d b(seen(segments[j].box[0]), seen(segments[j].box[1]));
    // Segments that meet in an edge or a corner have no joint.
    const AlignedBox2d common = a.intersection(b);
    if (!common.isEmpty() && common.sizes().minCoeff() > 0.0) return Joint{axis, at, i, j, common};
  }
  return std::nullopt;
}

// Whether the segments have faces in common there at all.
bool meet(const JointSide& below, const JointSide& above, const std::vector<Vector2d>& places) {
  return std::any_of(places.begin(), places.end(), [&](const Vector2d& p) {
    return below.has_room(p, 0.0) && above.has_room(p, 0.0);
  });
}

std::vector<Vector2d> places_in(const AlignedBox2d& box) {
  const double step = box.sizes().maxCoeff() / kPlacesAlong;
  const int columns = std::max(1, static_cast<int>(std::lround(box.sizes().x() / step)));
  const int rows = std::max(1, static_cast<int>(std::lround(box.sizes().y() / step)));
  std::vector<Vector2d> places;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const Vector2d share((i + 0.5) / columns, (j + 0.5) / rows);
      places.push_back(box.min() + share.cwiseProduct(box.sizes()));
    }
  }
  return places;
}

// Up to two that are furthest apart, and far enough.
std::vector<Vector2d> furthest(const std::vector<Vector2d>& places, double least) {
  if (places.empty()) return {};
  double most = least;
  std::vector<Vector2d> best{places[places.size() / 2]};
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double distance = (places[i] - places[j]).norm();
      if (distance > most) most = distance, best = {places[i], places[j]};
    }
  }
  return best;
}

}  // namespace

void add_dowel_holes(ModelSegments& result, const Dowels& dowels) {
  std::vector<ModelSegment>& segments = result.segments;
  const double room = 2.0 * dowels.radius;
  const int count = static_cast<int>(segments.size());
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      const std::optional<Joint> joint = i == j ? std::nullopt : joint_between(segments, i, j);
      if (!joint) continue;
      // Of the hole, and as much of the segment below it as its radius.
      const double depth = dowels.depth + dowels.radius;
      const JointSide below(segments[i].model, joint->axis, joint->at, true, depth);
      const JointSide above(segments[j].model, joint->axis, joint->at, false, depth);
      const std::vector<Vector2d> places = places_in(joint->common);
      std::vector<Vector2d> good;
      for (const Vector2d& p : places) {
        if (below.has_room(p, room) && above.has_room(p, room)) good.push_back(p);
      }
      const std::vector<Vector2d> centres = furthest(good, 2.0 * room);
      if (centres.empty()) {
        result.bare_joints += meet(below, above, places);
        continue;
      }
      // One joint after the other, so that holes know those that are there.
      for (const auto& [segment, upward] : {std::pair(i, true), std::pair(j, false)}) {
        segments[segment].model = drilled(segments[segment].model, joint->axis, joint->at, upward,
                                          centres, dowels.radius, dowels.depth, kDowelCorners);
        result.holes += static_cast<int>(centres.size());
      }
    }
  }
  // Of the polygon that is drilled, not of its circle.
  const double disc =
      0.5 * kDowelCorners * std::sin(2.0 * M_PI / kDowelCorners) * dowels.radius * dowels.radius;
  result.holes_volume = result.holes * disc * dowels.depth;
}

}  // namespace hull::production
