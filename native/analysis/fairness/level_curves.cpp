// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/fairness/level_curves.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <unordered_map>

#include "analysis/arithmetic/bracketed_root.h"
#include "analysis/fairness/cell_places.h"
#include "surface/parallel_for.h"
#include "surface/queries/infinity.h"

namespace hull::analysis {
namespace {

// Values this little below a level are on it: of flat regions the whole is on one side.
constexpr double kOnLevel = 1e-12;
constexpr double kRootOfEdge = 1e-14;  // of a grid's edge
constexpr int kDeepest = 6;            // up to 64 chords in a square of the grid

struct Place {
  int cell;
  Eigen::Vector2d uv;
};

// The surface and the function on the grid, whatever the level.
struct Samples {
  surface::Tessellation grid;
  std::vector<double> values;  // per normal
  struct Range {
    double at, low, high;  // values are from at + low to at + high, by the shortest way round
  };
  std::vector<Range> ranges;  // per cell
};

// The shortest way from one value to another.
double step_between(double from, double to, double period) {
  return std::isinf(period) ? to - from : std::remainder(to - from, period);
}

Samples take_samples(const surface::LimitSurface& surface, const NormalFunction& function,
                     int divisions, double period) {
  Samples samples{surface::tessellate(surface, divisions), {}, {}};
  samples.values = normal_field(samples.grid, function);
  const std::size_t squares = static_cast<std::size_t>(divisions) * divisions;
  for (std::size_t q = 0; q < samples.grid.quads.size(); ++q) {
    const auto& normals = samples.grid.corner_normals[q];
    if (q % squares == 0) samples.ranges.push_back({samples.values[normals[0]], 0.0, 0.0});
    auto& range = samples.ranges.back();
    for (const int normal : normals) {
      const double step = step_between(range.at, samples.values[normal], period);
      if (std::isnan(step)) {
        range = {0.0, -surface::kInfinity, surface::kInfinity};  // no level can be left out
        continue;
      }
      range.low = std::min(step, range.low);
      range.high = std::max(step, range.high);
    }
  }
  return samples;
}

class Tracer {
 public:
  Tracer(const surface::LimitSurface& surface, const NormalFunction& function,
         const Samples& samples, const LevelOptions& options, double period, double level)
      : surface_(surface),
        function_(function),
        samples_(samples),
        n_(options.divisions),
        tolerance_(options.chord_tolerance),
        period_(period),
        level_(level) {}

  std::vector<LevelCurve> curves() {
    for (int cell = 0; cell < surface_.cell_count(); ++cell) march(cell);
    return join();
  }

 private:
  struct Crossing {
    Place place;
    Vector3d point;
    int before = -1, after = -1;  // segments that end and start here
  };
  struct Segment {
    int from, to;
    int cell;
  };

  double wrapped(double value) const { return step_between(level_, value, period_); }
  double height(int cell, const Eigen::Vector2d& uv) const {
    const surface::SurfaceJet jet = surface_.evaluate(cell, uv.x(), uv.y(), 1);
    // At irregular knots, where there are no derivatives, the tangent plane is asked for.
    Vector3d normal = surface::unit_normal(jet.du, jet.dv);
    if (normal.isZero(0.0)) normal = surface_.normal(cell, uv.x(), uv.y());
    return wrapped(function_(jet.point, normal));
  }

  void march(int cell) {
    const auto& range = samples_.ranges[cell];
    // In a wider range the shortest way to the level may be the wrong one: all squares are tried.
    if (range.high - range.low < 0.5 * period_) {
      const double level = step_between(range.at, level_, period_);
      if (level < range.low - kOnLevel || level > range.high + kOnLevel) return;
    }
    const std::size_t squares = static_cast<std::size_t>(n_) * n_;
    for (std::size_t q = cell * squares; q < (cell + 1) * squares; ++q) {
      march_square(cell, static_cast<int>(q));
    }
  }

  Eigen::Vector2d corner_uv(int square, int corner) const {
    const int in_cell = square % (n_ * n_);
    const int i = in_cell % n_ + (corner == 1 || corner == 2 ? 1 : 0);
    const int j = in_cell / n_ + (corner >= 2 ? 1 : 0);
    return {static_cast<double>(i) / n_, static_cast<double>(j) / n_};
  }

  void march_square(int cell, int square) {
    const auto& normals = samples_.grid.corner_normals[square];
    std::array<double, 4> heights;
    int above = 0;
    for (int k = 0; k < 4; ++k) {
      heights[k] = wrapped(samples_.values[normals[k]]);
      if (std::isnan(heights[k])) return;
      if (heights[k] >= -kOnLevel) above |= 1 << k;
    }
    if (above == 0 || above == 15) return;
    const auto is_above = [&](int k) { return (above >> (k % 4) & 1) != 0; };
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    // The change of sign is where values wrap, half a period from the level.
    if (*high - *low >= 0.5 * period_) return;
    // With what is above on the left, curves leave through edges that go up and enter through
    // those that go down, run through counter-clockwise.
    std::array<int, 2> enters{-1, -1}, leaves{-1, -1};
    int count = 0;
    for (int k = 0; k < 4; ++k) {
      if (is_above(k) == is_above(k + 1)) continue;
      auto& list = is_above(k) ? enters : leaves;
      list[list[0] >= 0 ? 1 : 0] = k;
      ++count;
    }
    const auto add = [&](int from, int to) {
      add_segment(crossing(cell, square, from), crossing(cell, square, to), cell);
    };
    if (count == 2) return add(enters[0], leaves[0]);
    const Eigen::Vector2d centre = 0.5 * (corner_uv(square, 0) + corner_uv(square, 2));
    // Joined above in the middle, curves turn around the corners that are below. An edge k that is
    // entered through starts above and ends below, at corner k + 1.
    const bool joined = height(cell, centre) >= 0.0;
    for (const int k : enters) add(k, (k + (joined ? 1 : 3)) % 4);
  }

  // Where edge k of a square meets the level.
  int crossing(int cell, int square, int k) {
    const auto& normals = samples_.grid.corner_normals[square];
    const int a = normals[k], b = normals[(k + 1) % 4];
    // Squares beside one another have the same two normals there, and share the crossing; those on
    // two sides of a crease have not.
    const std::uint64_t key = static_cast<std::uint64_t>(std::min(a, b)) << 32 |
                              static_cast<std::uint32_t>(std::max(a, b));
    const auto [at, is_new] = numbers_.try_emplace(key, static_cast<int>(crossings_.size()));
    if (!is_new) return at->second;
    const Eigen::Vector2d from = corner_uv(square, k), to = corner_uv(square, (k + 1) % 4);
    const double fa = wrapped(samples_.values[a]), fb = wrapped(samples_.values[b]);
    double t = 0.0;
    if ((fa > 0.0) != (fb > 0.0)) {
      // Where the function is not defined between the corners, the curve ends there.
      const auto f = [&](double x) {
        const double found = height(cell, from + x * (to - from));
        return std::isnan(found) ? 0.0 : found;
      };
      t = bracketed_root(f, 0.0, fa, 1.0, fb, kRootOfEdge);
    } else {
      // Of two signs only by kOnLevel: the level passes through a corner.
      t = std::abs(fa) <= std::abs(fb) ? 0.0 : 1.0;
    }
    const Eigen::Vector2d uv = from + t * (to - from);
    crossings_.push_back({{cell, uv}, surface_.position(cell, uv.x(), uv.y())});
    return at->second;
  }

  void add_segment(int from, int to, int cell) {
    const int segment = static_cast<int>(segments_.size());
    segments_.push_back({from, to, cell});
    crossings_[from].after = segment;
    crossings_[to].before = segment;
  }

  std::vector<LevelCurve> join() {
    std::vector<LevelCurve> curves;
    std::vector<char> used(segments_.size(), 0);
    const auto follow = [&](int segment) {
      LevelCurve& curve = curves.emplace_back();
      curve.level = level_;
      const int start = segments_[segment].from;
      add_point(crossings_[start].place, crossings_[start].point, curve);
      int end = start;
      while (segment >= 0 && !used[segment]) {
        used[segment] = 1;
        end = segments_[segment].to;
        add_between(segments_[segment], curve);
        segment = crossings_[end].after;
      }
      curve.closed = end == start;
    };
    // Open curves from their begin; whatever they leave is closed and may begin anywhere.
    for (const Crossing& crossing : crossings_) {
      if (crossing.before < 0 && crossing.after >= 0) follow(crossing.after);
    }
    for (int i = 0; i < static_cast<int>(segments_.size()); ++i) {
      if (!used[i]) follow(i);
    }
    return curves;
  }

  static void add_point(const Place& place, const Vector3d& point, LevelCurve& curve) {
    curve.points.push_back(point);
    curve.cells.push_back(place.cell);
    curve.uv.push_back(place.uv);
  }

  // Where a crossing is in a cell beside it.
  Eigen::Vector2d in_cell(const Crossing& crossing, int cell) const {
    const Place& place = crossing.place;
    if (place.cell == cell) return place.uv;
    for (const surface::CellPlace& at : cell_places(surface_.cells(), place.cell, place.uv)) {
      if (at.cell == cell) return {at.u, at.v};
    }
    return Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  }

  void add_between(const Segment& segment, LevelCurve& curve) const {
    const Crossing &a = crossings_[segment.from], &b = crossings_[segment.to];
    const Eigen::Vector2d from = in_cell(a, segment.cell), to = in_cell(b, segment.cell);
    if (std::isfinite(tolerance_) && from.allFinite() && to.allFinite()) {
      refine({segment.cell, from}, a.point, {segment.cell, to}, b.point, kDeepest, curve);
    }
    if (to.allFinite()) {
      add_point({segment.cell, to}, b.point, curve);
    } else {
      add_point(b.place, b.point, curve);
    }
  }

  void refine(const Place& a, const Vector3d& p, const Place& b, const Vector3d& q, int depth,
              LevelCurve& curve) const {
    if (depth == 0) return;
    Place middle{a.cell, 0.5 * (a.uv + b.uv)};
    if (!settle(middle, b.uv - a.uv)) return;
    const Vector3d m = surface_.position(middle.cell, middle.uv.x(), middle.uv.y());
    const Vector3d chord = q - p;
    const double length2 = chord.squaredNorm();
    const double along = length2 > 0.0 ? std::clamp((m - p).dot(chord) / length2, 0.0, 1.0) : 0.0;
    if ((m - p - along * chord).norm() <= tolerance_) return;
    refine(a, p, middle, m, depth - 1, curve);
    add_point(middle, m, curve);
    refine(middle, m, b, q, depth - 1, curve);
  }

  // Moves a place across a chord onto the level, by secants. False if it is not near.
  bool settle(Place& place, const Eigen::Vector2d& chord) const {
    const Eigen::Vector2d across(-chord.y(), chord.x());
    const auto at = [&](double x) -> Eigen::Vector2d {
      return (place.uv + x * across).cwiseMax(0.0).cwiseMin(1.0);
    };
    double x0 = 0.0, f0 = height(place.cell, at(x0));
    double x1 = 1e-3, f1 = height(place.cell, at(x1));
    for (int step = 0; step < 30; ++step) {
      if (f0 == 0.0 || f0 == f1) break;
      const double next = x0 - f0 * (x1 - x0) / (f1 - f0);
      if (!(std::abs(next) <= 1.0)) return false;
      x1 = x0;
      f1 = f0;
      x0 = next;
      f0 = height(place.cell, at(x0));
      if (!(std::abs(x0 - x1) > 1e-13)) break;
    }
    if (!(std::abs(f0) <= 1e-10)) return false;
    place.uv = at(x0);
    return true;
  }

  const surface::LimitSurface& surface_;
  const NormalFunction& function_;
  const Samples& samples_;
  int n_;
  double tolerance_, period_, level_;
  std::unordered_map<std::uint64_t, int> numbers_;  // of crossings, by the grid's edge
  std::vector<Crossing> crossings_;
  std::vector<Segment> segments_;
};

}  // namespace

std::vector<LevelCurve> level_curves(const surface::LimitSurface& surface,
                                     const NormalFunction& function,
                                     const std::vector<double>& levels, const LevelOptions& options,
                                     double period) {
  if (options.divisions < 1 || options.divisions > 64) {
    throw std::invalid_argument("Curves are looked for on 1 to 64 divisions of a cell, not " +
                                std::to_string(options.divisions) + ".");
  }
  if (!(options.chord_tolerance > 0.0)) {
    throw std::invalid_argument("The chord tolerance must be a positive length, not " +
                                std::to_string(options.chord_tolerance) + " m.");
  }
  for (const double level : levels) {
    if (!std::isfinite(level)) throw std::invalid_argument("Levels must be finite numbers.");
  }
  const Samples samples = take_samples(surface, function, options.divisions, period);
  std::vector<std::vector<LevelCurve>> found(levels.size());
  surface::parallel_for(
      levels.size(), surface::kAllProcessors,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          found[i] = Tracer(surface, function, samples, options, period, levels[i]).curves();
        }
      },
      1);
  std::vector<LevelCurve> curves;
  for (auto& of_level : found) {
    std::move(of_level.begin(), of_level.end(), std::back_inserter(curves));
  }
  return curves;
}

}  // namespace hull::analysis
