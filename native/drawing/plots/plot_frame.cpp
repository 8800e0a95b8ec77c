// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/plots/plot_frame.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace hull::drawing {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

namespace {

// Far below a line's width, so that a curve of many points makes a small file.
constexpr double kMerged = 0.02;  // mm

struct Segment {
  Vector2d a, b;
};

// The part of a segment inside the box (Liang and Barsky 1984).
std::optional<Segment> clipped(const Segment& segment, const AlignedBox2d& box) {
  // What is inside lies beyond the sides by which the segment enters and before those by which it
  // leaves.
  double enter = 0.0, leave = 1.0;
  const Vector2d along = segment.b - segment.a;
  for (int axis = 0; axis < 2; ++axis) {
    for (const auto& [speed, distance] :
         {std::pair(along[axis], box.max()[axis] - segment.a[axis]),
          std::pair(-along[axis], segment.a[axis] - box.min()[axis])}) {
      if (speed == 0.0 && distance < 0.0) return std::nullopt;
      if (speed > 0.0) leave = std::min(leave, distance / speed);
      if (speed < 0.0) enter = std::max(enter, distance / speed);
    }
  }
  if (enter > leave) return std::nullopt;
  // Where nothing is cut the end stays as it is: computed anew, it would be off the next segment's
  // begin by rounding.
  return Segment{segment.a + enter * along, leave < 1.0 ? segment.a + leave * along : segment.b};
}

// Stretches of consecutive finite points.
std::vector<std::vector<Vector2d>> finite_runs(const PlotCurve& curve) {
  std::vector<std::vector<Vector2d>> runs(1);
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    const Vector2d point(curve.x[i], curve.y[i]);
    if (point.allFinite()) {
      runs.back().push_back(point);
    } else if (!runs.back().empty()) {
      runs.emplace_back();
    }
  }
  // The last run is empty where a curve ends in numbers that are not finite.
  if (runs.back().empty()) runs.pop_back();
  return runs;
}

void append(PagePath& path, const Vector2d& point) {
  if (path.empty() || (point - path.back()).norm() >= kMerged) path.push_back(point);
}

void add_run(const PagePath& run, const AlignedBox2d& area, std::vector<PagePath>& paths) {
  PagePath path;
  const auto finish = [&] {
    // What only touches the area, or is shorter than points are merged, is not drawn.
    if (path.size() > 1) paths.push_back(path);
    path.clear();
  };
  for (std::size_t i = 1; i < run.size(); ++i) {
    const std::optional<Segment> seen = clipped({run[i - 1], run[i]}, area);
    if (!seen) {
      finish();
      continue;
    }
    // It left the area and came back elsewhere.
    if (!path.empty() && (seen->a - path.back()).norm() > kMerged) finish();
    append(path, seen->a);
    if (i + 1 == run.size() && path.size() > 1 && (seen->b - path.back()).norm() < kMerged) {
      path.pop_back();  // merged, the path still ends where the curve does
    }
    append(path, seen->b);
  }
  finish();
}

// The points of a run with x in [from, to], with points added there and wherever y is zero.
std::vector<Vector2d> part_between(const std::vector<Vector2d>& run, double from, double to) {
  std::vector<Vector2d> part;
  for (std::size_t i = 1; i < run.size(); ++i) {
    const Vector2d &a = run[i - 1], along = run[i] - run[i - 1];
    if (std::max(a.x(), run[i].x()) < from || std::min(a.x(), run[i].x()) > to) continue;
    std::vector<double> shares{0.0, 1.0};
    const auto cut_at = [&](double distance, double speed) {
      if (speed != 0.0 && distance / speed > 0.0 && distance / speed < 1.0) {
        shares.push_back(distance / speed);
      }
    };
    cut_at(from - a.x(), along.x());
    cut_at(to - a.x(), along.x());
    // Where y changes its sign, so that every piece is above or below as a whole.
    cut_at(-a.y(), along.y());
    std::sort(shares.begin(), shares.end());
    // Points cut at from and to may lie beyond them by rounding.
    const double slack = 1e-12 * (std::abs(from) + std::abs(to));
    for (const double share : shares) {
      const Vector2d point = a + share * along;
      if (point.x() < from - slack || point.x() > to + slack) continue;
      if (part.empty() || part.back() != point) part.push_back(point);
    }
  }
  return part;
}

}  // namespace

std::vector<PagePath> curve_paths(const PlotCurve& curve, const PlotFrame& frame) {
  std::vector<PagePath> paths;
  // Points on the border stay inside it, though rounded.
  AlignedBox2d grown = frame.area;
  grown.extend(frame.area.min() - Vector2d::Constant(1e-9));
  grown.extend(frame.area.max() + Vector2d::Constant(1e-9));
  for (const std::vector<Vector2d>& run : finite_runs(curve)) {
    PagePath path;
    for (const Vector2d& point : run) {
      path.push_back(frame.to_page(curve.x_axis, point.x(), point.y()));
    }
    const bool one_place = std::all_of(path.begin(), path.end(), [&](const Vector2d& point) {
      return (point - path.front()).norm() < kMerged;
    });
    if (one_place) {
      if (grown.contains(path.front())) paths.push_back({path.front()});
    } else {
      add_run(path, grown, paths);
    }
  }
  return paths;
}

std::vector<PagePath> area_polygons(const PlotCurve& curve, double from, double to,
                                    const PlotFrame& frame) {
  const AxisScale& scale = frame.x_axes[curve.x_axis];
  // It may be given from its end to its beginning.
  if (from > to) std::swap(from, to);
  from = std::max(from, scale.low);
  to = std::min(to, scale.high);
  const auto place = [&](double x, double y) {
    // What reaches out of sight is filled up to the frame.
    const double shown = std::clamp(y, frame.y_axis.low, frame.y_axis.high);
    return frame.to_page(curve.x_axis, std::clamp(x, scale.low, scale.high), shown);
  };
  std::vector<PagePath> polygons;
  for (const std::vector<Vector2d>& run : finite_runs(curve)) {
    const std::vector<Vector2d> part = part_between(run, from, to);
    std::size_t first = 0;
    while (first + 1 < part.size()) {
      // The sign of the whole piece: cut at zero, none has both signs, but one of its ends may be
      // zero.
      const bool above = part[first].y() + part[first + 1].y() > 0.0;
      PagePath polygon{place(part[first].x(), 0.0)};
      std::size_t last = first;
      for (; last + 1 < part.size(); ++last) {
        if ((part[last].y() + part[last + 1].y() > 0.0) != above) break;
        append(polygon, place(part[last].x(), part[last].y()));
      }
      append(polygon, place(part[last].x(), part[last].y()));
      append(polygon, place(part[last].x(), 0.0));
      if (polygon.size() > 2) polygons.push_back(std::move(polygon));
      // The point where the sign changes, on y = 0, begins the next polygon.
      first = last;
    }
  }
  return polygons;
}

}  // namespace hull::drawing
