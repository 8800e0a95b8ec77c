// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/grid/folded_loop.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace hull::production {
namespace {

// Both sides have come equally far: parts of the fold's length. Symmetric hulls differ by rounding.
constexpr double kAbreast = 1e-6;
// A point is in the plane: part of the loop's breadth.
constexpr double kInFold = 1e-9;

// -1, 0 or 1: to starboard of the plane, in it, to port.
std::vector<int> sides_of(const std::vector<Vector3d>& points, const std::vector<int>& loop,
                          double plane) {
  double breadth = 0.0;
  for (int p : loop) breadth = std::max(breadth, std::abs(points[p].y() - plane));
  std::vector<int> sides;
  for (int p : loop) {
    const double y = points[p].y() - plane;
    sides.push_back(std::abs(y) <= kInFold * breadth ? 0 : (y > 0.0 ? 1 : -1));
  }
  return sides;
}

// Parts of the length along x and z that have been run through at each point.
std::vector<double> run_along(const std::vector<Vector3d>& points, const std::vector<int>& chain) {
  std::vector<double> run{0.0};
  // Without y, so that sides of a fold that are mirror images have run equally far at the same
  // points.
  for (std::size_t i = 1; i < chain.size(); ++i) {
    Vector3d step = points[chain[i]] - points[chain[i - 1]];
    step.y() = 0.0;
    run.push_back(run.back() + step.norm());
  }
  if (run.back() > 0.0) {
    for (double& r : run) r /= run.back();
  }
  return run;
}

[[noreturn]] void refuse(const Vector3d& p) {
  std::ostringstream words;
  words << "The opening at (" << p.x() << ", " << p.y() << ", " << p.z()
        << ") m passes the plane that it is closed to more than twice. Close it by faces.";
  throw std::invalid_argument(words.str());
}

}  // namespace

std::vector<std::array<int, 2>> lines_across(const std::vector<Vector3d>& points,
                                             const std::vector<int>& loop, double plane) {
  const std::vector<int> sides = sides_of(points, loop, plane);
  const std::size_t n = loop.size();
  // The port side begins where a point that is not to port is followed by one that is.
  std::size_t begin = n, changes = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (sides[i] <= 0 && sides[(i + 1) % n] > 0) {
      begin = i;
      ++changes;
    }
  }
  if (changes != 1) refuse(points[loop[0]]);
  std::vector<int> port, starboard;
  std::size_t i = begin;
  // A point in the plane belongs to both chains; of several that follow one another the one beside
  // the port side does.
  const bool starts_in_plane = sides[begin] == 0;
  if (starts_in_plane) port.push_back(loop[i]);
  for (i = (i + 1) % n; sides[i] > 0; i = (i + 1) % n) port.push_back(loop[i]);
  if (sides[i] == 0) port.push_back(loop[i]);
  for (; i != begin; i = (i + 1) % n) {
    if (sides[i] > 0) refuse(points[loop[i]]);
    starboard.push_back(loop[i]);
  }
  starboard.push_back(loop[begin]);
  std::reverse(starboard.begin(), starboard.end());

  const std::vector<double> a = run_along(points, port), b = run_along(points, starboard);
  std::vector<std::array<int, 2>> lines{{port[0], starboard[0]}};
  std::size_t p = 0, s = 0;
  while (p + 1 < port.size() || s + 1 < starboard.size()) {
    // A side that is at its end is behind the other one for good: 2 is beyond all parts of the
    // length.
    const double port_next = p + 1 < port.size() ? a[p + 1] : 2.0;
    const double starboard_next = s + 1 < starboard.size() ? b[s + 1] : 2.0;
    const double ahead = port_next - starboard_next;
    if (ahead <= kAbreast && p + 1 < port.size()) ++p;
    if (ahead >= -kAbreast && s + 1 < starboard.size()) ++s;
    lines.push_back({port[p], starboard[s]});
  }
  return lines;
}

}  // namespace hull::production
