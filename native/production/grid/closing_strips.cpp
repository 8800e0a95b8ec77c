// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/grid/closing_strips.h"

#include <algorithm>
#include <cmath>

#include "mesh/tolerances.h"
#include "production/grid/folded_loop.h"

namespace hull::production {

BorderLoop loop_closed_by(const analysis::ClosingPatch& closing, bool mirrored, double size) {
  // Caps run along the border at v = 0, against its direction, and end where the straight lines do,
  // at v = 1.
  const Vector3d a = surface::evaluate_bicubic(closing.cap, 0.0, 1.0, 0).point;
  const Vector3d b = surface::evaluate_bicubic(closing.cap, 1.0, 1.0, 0).point;
  // Lines to a plane keep their x and z.
  const auto keeps = [&](const Vector3d& end, const Vector3d& from) {
    return std::hypot(end.x() - from.x(), end.z() - from.z()) <= kNoLength * size;
  };
  if (!keeps(a, closing.border[3]) || !keeps(b, closing.border[0])) {
    return {{}, ClosingKind::kToPoint, a};
  }
  const bool centre = mirrored && std::abs(a.y()) <= kNoLength * size;
  return {{}, centre ? ClosingKind::kToCentrePlane : ClosingKind::kToOwnPlane, a};
}

int ClosingStrips::add_point(const Vector3d& p) {
  grid_.points.push_back(p);
  return static_cast<int>(grid_.points.size()) - 1;
}

void ClosingStrips::add_quad(int a, int b, int c, int d) {
  std::array<int, 4> quad{a, b, c, d};
  int distinct = 0;
  for (int k = 0; k < 4; ++k) distinct += quad[k] != quad[(k + 1) % 4];
  // Where lines have no length nothing is left, or the border's side run through twice.
  if (distinct < 3 || a == c || b == d) return;
  grid_.quads.push_back(quad);
  if (options_.places) grid_.places.emplace_back();
}

int ClosingStrips::parts_of(const std::vector<Line>& lines) const {
  if (!options_.parts_across) return 1;
  // All of the loop's lines at once: neighbours have the same number of parts, to share their
  // points.
  ClosingLines ends;
  for (const Line& line : lines) {
    ends.push_back({grid_.points[line.from], grid_.points[line.to]});
  }
  return options_.parts_across(ends);
}

void ClosingStrips::divide(std::vector<Line>& lines) {
  const int parts = parts_of(lines);
  for (Line& line : lines) {
    line.points = {line.from};
    const Vector3d from = grid_.points[line.from], to = grid_.points[line.to];
    for (int k = 1; k < parts; ++k) {
      const double s = static_cast<double>(k) / parts;
      line.points.push_back(line.from == line.to ? line.from : add_point(from + s * (to - from)));
    }
    line.points.push_back(line.to);
  }
}

void ClosingStrips::add_strip(const Line& line, const Line& next) {
  // Against the border's direction, in which the shell has the same sides.
  for (std::size_t k = 0; k + 1 < line.points.size(); ++k) {
    add_quad(next.points[k], line.points[k], line.points[k + 1], next.points[k + 1]);
  }
}

void ClosingStrips::add_end(const Line& line, const Line& next) {
  // A fan from the undivided line's end, as that line has no points between for a strip.
  for (std::size_t k = 0; k + 1 < next.points.size(); ++k) {
    add_quad(line.from, next.points[k + 1], next.points[k], next.points[k]);
  }
  add_quad(line.from, line.to, next.to, next.to);
}

void ClosingStrips::close_ring(std::vector<Line> lines) {
  divide(lines);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    add_strip(lines[i], lines[(i + 1) % lines.size()]);
  }
}

void ClosingStrips::close_to_centre_plane(const BorderLoop& loop, const std::vector<int>* images) {
  std::vector<Line> lines;
  for (int p : loop.points) {
    const Vector3d from = grid_.points[p];
    const bool on_plane = from.y() == 0.0;
    const int to = images ? (*images)[p] : on_plane ? p : add_point({from.x(), 0.0, from.z()});
    lines.push_back({p, to, {}});
  }
  close_ring(std::move(lines));
}

void ClosingStrips::close_to_point(const BorderLoop& loop) {
  // One point for all lines: quadrilaterals become triangles there.
  const int apex = add_point(loop.end);
  std::vector<Line> lines;
  for (int p : loop.points) lines.push_back({p, apex, {}});
  close_ring(std::move(lines));
}

void ClosingStrips::close_to_own_plane(const BorderLoop& loop) {
  const bool is_flat = std::all_of(loop.points.begin(), loop.points.end(), [&](int p) {
    return std::abs(grid_.points[p].y() - loop.end.y()) <= no_length_;
  });
  // A pole, or a border that lies in the plane: there is nothing to close.
  if (is_flat) return;
  std::vector<Line> lines;
  for (const auto& [from, to] : lines_across(grid_.points, loop.points, loop.end.y())) {
    lines.push_back({from, to, {}});
  }
  divide(lines);
  // Where the border passes the plane between two of its points its own side is the last line.
  const auto shorten = [](Line& line) { line.points = {line.from, line.to}; };
  const bool first = lines.front().from != lines.front().to && lines.size() > 1;
  const bool last = lines.back().from != lines.back().to && lines.size() > 1;
  if (first) shorten(lines.front());
  if (last) shorten(lines.back());
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    const bool whole = lines[i].points.size() == lines[i + 1].points.size();
    if (whole) {
      add_strip(lines[i], lines[i + 1]);
    } else if (i == 0) {
      add_end(lines[0], lines[1]);
    } else {
      // The same seen from the other end.
      Line end = lines[i + 1], line = lines[i];
      std::swap(end.from, end.to);
      std::swap(line.from, line.to);
      std::reverse(line.points.begin(), line.points.end());
      add_end(end, line);
    }
  }
}

}  // namespace hull::production
