// SPDX-License-Identifier: GPL-3.0-or-later
#include "resistance/immersed_shell.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/arithmetic/gauss.h"
#include "analysis/derivatives/wet_columns.h"
#include "surface/limit_surface.h"

namespace hull::resistance {
namespace {

using analysis::CutSquare;
using analysis::GaussRule;
using analysis::SpanNode;

// Ten nodes do for a phase of 8.2 (wave_rules()).
constexpr double kLinePhase = 8.0;  // over an interval of the waterline, of kOnLine nodes
constexpr int kOnLine = 10;
constexpr double kFirstDecays = 4.0;     // of the shortest waves, from the water down
constexpr int kMostHalvings = 60;        // of a rectangle, in both directions together
constexpr double kSmallestWhole = 1e-6;  // of the size: of squares around a corner

// Nodes of a direction of a rectangle, and the largest |ω| of exp(ω t), t in [0, 1], for which
// Gauss's rule of so many is off by less than 1e-12, by its remainder
// (n!)⁴ / ((2n + 1) (2n)!³) |ω|²ⁿ. The first is exact for the shell alone.
struct WaveRule {
  double most;
  GaussRule rule;
};

const std::array<WaveRule, 8>& wave_rules() {
  static const std::array<WaveRule, 8> rules = {{{2.0, analysis::gauss_rule(6)},
                                                 {3.2, analysis::gauss_rule(7)},
                                                 {4.7, analysis::gauss_rule(8)},
                                                 {6.3, analysis::gauss_rule(9)},
                                                 {8.2, analysis::gauss_rule(10)},
                                                 {12.2, analysis::gauss_rule(12)},
                                                 {16.6, analysis::gauss_rule(14)},
                                                 {21.0, analysis::gauss_rule(16)}}};
  return rules;
}

constexpr double kMostPhase = 20.0;  // in a direction of a rectangle, with kFirstDecays below 21

const GaussRule& wave_rule(double omega) {
  for (const WaveRule& own : wave_rules()) {
    if (omega <= own.most) return own.rule;
  }
  return wave_rules().back().rule;
}

// Part of a span by two parameters in [0, 1].
struct SpanSheet {
  // A node with the area of parameters of the span that the sheet's have there.
  struct Place {
    SpanNode node;
    double scale;
  };

  const surface::BicubicPoints& points;
  const CutSquare& square;

  // Of one s: all of the square, or what is below the water of one that is cut; there t runs from
  // the water's surface across it.
  struct Column {
    double s, begin = 0.0, end = 1.0, scale;
  };

  Column column(double s) const {
    // Of the span's parameters.
    const double area = square.size * square.size;
    if (square.side == CutSquare::Side::kBelow) return {s, 0.0, 1.0, area};
    const analysis::WetColumn wet(square, s);
    // The end on the water comes first: `to` of a column that begins wet, `from` of one that ends
    // so.
    const double begin = wet.to < 1.0 ? wet.to : wet.from, end = wet.to < 1.0 ? wet.from : wet.to;
    return {s, begin, end, wet.any ? area * std::abs(end - begin) : 0.0};
  }

  Place at(const Column& column, double t) const {
    const double across = column.begin + (column.end - column.begin) * t;
    if (square.side == CutSquare::Side::kBelow) {
      return {SpanNode(points, square.u + square.size * column.s, square.v + square.size * across),
              column.scale};
    }
    return {analysis::node_of(points, square, column.s, across), column.scale};
  }
};

struct Rectangle {
  double s, t, width, height;
};

class SheetIntegrator {
 public:
  SheetIntegrator(const SpanSheet& sheet, const WayFrame& frame, const WaveScales& scales,
                  ShellVisitor& visitor)
      : sheet_(sheet), frame_(frame), scales_(scales), visitor_(visitor) {}

  void add(const Rectangle& rectangle, int halvings = 0) {
    const Spread spread = spread_of(rectangle);
    // Phases are those of waves that reach the upper side: further down rectangles may be longer.
    const double along = scales_.along_at(spread.top);
    const double phase_s = along * spread.x_by_s, phase_t = along * spread.x_by_t;
    // From the water down to that depth no wave falls off by more than the rules allow for.
    const double shallow = std::max(spread.top, kFirstDecays / scales_.decay);
    const double decay_s = spread.depth_by_s / shallow, decay_t = spread.depth_by_t / shallow;
    const bool turns = std::max(phase_s, phase_t) > kMostPhase;
    if (halvings < kMostHalvings && (turns || decay_s + decay_t > 1.0)) {
      return halve(rectangle, turns ? phase_s >= phase_t : decay_s >= decay_t, halvings);
    }
    // Phase and decay are the two parts of one complex exponent.
    add_nodes(rectangle, wave_rule(std::hypot(phase_s, kFirstDecays * decay_s)),
              wave_rule(std::hypot(phase_t, kFirstDecays * decay_t)));
  }

 private:
  // How far x and depth spread along the sides, and the least depth, at three nodes by three.
  struct Spread {
    double top, x_by_s = 0.0, x_by_t = 0.0, depth_by_s = 0.0, depth_by_t = 0.0;
  };

  Spread spread_of(const Rectangle& r) const {
    std::array<std::array<double, 3>, 3> x, depth;
    for (int i = 0; i < 3; ++i) {
      const SpanSheet::Column column = sheet_.column(r.s + 0.5 * i * r.width);
      for (int j = 0; j < 3; ++j) {
        const Vector3d p = sheet_.at(column, r.t + 0.5 * j * r.height).node.point;
        x[i][j] = frame_.x(p);
        depth[i][j] = frame_.depth(p);
      }
    }
    const auto range = [](double a, double b, double c) {
      return std::max({a, b, c}) - std::min({a, b, c});
    };
    Spread spread{depth[0][0]};
    for (int k = 0; k < 3; ++k) {
      for (double d : depth[k]) spread.top = std::min(spread.top, d);
      spread.x_by_s = std::max(spread.x_by_s, range(x[0][k], x[1][k], x[2][k]));
      spread.x_by_t = std::max(spread.x_by_t, range(x[k][0], x[k][1], x[k][2]));
      spread.depth_by_s = std::max(spread.depth_by_s, range(depth[0][k], depth[1][k], depth[2][k]));
      spread.depth_by_t = std::max(spread.depth_by_t, range(depth[k][0], depth[k][1], depth[k][2]));
    }
    return spread;
  }

  void halve(const Rectangle& r, bool along_s, int halvings) {
    const double width = along_s ? 0.5 * r.width : r.width,
                 height = along_s ? r.height : 0.5 * r.height;
    add({r.s, r.t, width, height}, halvings + 1);
    add({along_s ? r.s + width : r.s, along_s ? r.t : r.t + height, width, height}, halvings + 1);
  }

  void add_nodes(const Rectangle& r, const GaussRule& by_s, const GaussRule& by_t) {
    for (std::size_t i = 0; i < by_s.nodes.size(); ++i) {
      const SpanSheet::Column column = sheet_.column(r.s + r.width * by_s.nodes[i]);
      if (column.scale == 0.0) continue;
      for (std::size_t j = 0; j < by_t.nodes.size(); ++j) {
        const SpanSheet::Place place = sheet_.at(column, r.t + r.height * by_t.nodes[j]);
        const double weight = place.scale * r.width * r.height * by_s.weights[i] * by_t.weights[j];
        if (weight != 0.0) visitor_.at_node(place.node, weight);
      }
    }
  }

  const SpanSheet& sheet_;
  const WayFrame& frame_;
  const WaveScales& scales_;
  ShellVisitor& visitor_;
};

// The waterline of a square within an interval.
class LineIntegrator {
 public:
  LineIntegrator(const SpanSheet& sheet, const WayFrame& frame, const WaveScales& scales,
                 ShellVisitor& visitor)
      : sheet_(sheet), frame_(frame), scales_(scales), visitor_(visitor) {}

  void add(double begin, double width, int halvings = 0) {
    const auto x = [&](double s) { return frame_.x(sheet_.at(sheet_.column(s), 0.0).node.point); };
    const double middle = begin + 0.5 * width;
    // By halves: a line that turns back, as around a blunt end, has its ends beside one another.
    const double reach = std::abs(x(begin) - x(middle)) + std::abs(x(middle) - x(begin + width));
    // On the water even the shortest waves have all of their height.
    if (halvings < kMostHalvings && scales_.along * reach > kLinePhase) {
      add(begin, 0.5 * width, halvings + 1);
      add(middle, 0.5 * width, halvings + 1);
      return;
    }
    static const GaussRule rule = analysis::gauss_rule(kOnLine);
    for (int i = 0; i < kOnLine; ++i) {
      const double s = begin + width * rule.nodes[i];
      const analysis::WetColumn wet(sheet_.square, s);
      if (!wet.crosses) continue;
      const SpanNode at = analysis::node_of(sheet_.points, sheet_.square, s, wet.at_water());
      const double slope = analysis::slope_across(sheet_.square, at, frame_.water);
      const double weight = rule.weights[i] * width * sheet_.square.size;
      // Where the water is tangent to the surface, a strip has no finite width.
      if (slope > 0.0) visitor_.at_water(at, weight / slope);
    }
  }

 private:
  const SpanSheet& sheet_;
  const WayFrame& frame_;
  const WaveScales& scales_;
  ShellVisitor& visitor_;
};

template <class Points>
bool reaches_below(const Points& points, const WayFrame& frame) {
  return std::any_of(points.begin(), points.end(),
                     [&](const Vector3d& p) { return frame.water.height(p) <= -frame.zero; });
}

}  // namespace

void visit_span(const surface::BicubicPoints& points, const WayFrame& frame,
                const WaveScales& scales, ShellVisitor& visitor) {
  // A span lies within the convex hull of its points.
  if (!reaches_below(points, frame)) return;
  cut_piece(analysis::heights(points, frame.water, frame.zero), [&](const CutSquare& square) {
    if (square.side == CutSquare::Side::kAbove) return;
    const SpanSheet sheet{points, square};
    SheetIntegrator integrator(sheet, frame, scales, visitor);
    if (square.side == CutSquare::Side::kBelow) return integrator.add({0.0, 0.0, 1.0, 1.0});
    LineIntegrator line(sheet, frame, scales, visitor);
    const auto add = [&](double begin, double width) {
      integrator.add({begin, 0.0, width, 1.0});
      line.add(begin, width);
    };
    analysis::WetIntervals(points, frame.water, add).divide(square);
  });
}

void visit_shell(const analysis::HullBody& body, const WayFrame& frame, const WaveScales& scales,
                 ShellVisitor& visitor) {
  const surface::LimitSurface& surface = body.surface();
  const surface::SurfaceLayout& layout = surface.layout();
  for (int leaf = 0; leaf < layout.leaf_count(); ++leaf) {
    visit_span(surface.leaf(leaf), frame, scales, visitor);
  }
  for (int corner = 0; corner < layout.corner_count(); ++corner) {
    const surface::CornerBasis& basis = layout.basis(corner);
    // Around an irregular point rings of spans follow one another, each half as large, without an
    // end.
    surface::CornerRing ring(basis, surface.corner(corner));
    for (; goes_on(ring.points(), frame, surface.mesh().size()); ring.advance()) {
      for (int s = 0; s < basis.segment_count(); ++s) {
        visit_span(ring.segment_points(s), frame, scales, visitor);
      }
    }
  }
}

bool goes_on(const std::vector<Vector3d>& square, const WayFrame& frame, double size) {
  // From one of the points: half of the diameter at least, in one pass.
  double farthest = 0.0;
  for (const Vector3d& p : square) farthest = std::max(farthest, (p - square[0]).squaredNorm());
  return std::sqrt(farthest) >= kSmallestWhole * size && reaches_below(square, frame);
}

}  // namespace hull::resistance
