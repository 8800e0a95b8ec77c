// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of hulls given by formulas, for the tests of the drawing.
#pragma once

#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "drawing/lines_plan/lines_drawing.h"

namespace hull::test {

inline drawing::ShipCurve polyline(std::vector<Eigen::Vector3d> points) {
  return {std::move(points), std::nullopt};
}

inline std::string metres(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f m", value);
  return text;
}

// Wigley's hull, y = B/2 (1 - ξ²)(1 - ζ²), with ξ from -1 at AP to 1 at FP and ζ = (T - z)/T below
// the design waterline; wall-sided above it.
struct Wigley {
  double length = 100.0, beam = 10.0, draft = 6.25, depth = 8.0;

  double half_breadth(double x, double z) const {
    const double along = 2.0 * x / length - 1.0;
    const double below = z < draft ? 1.0 - z / draft : 0.0;
    return 0.5 * beam * (1.0 - along * along) * (1.0 - below * below);
  }

  drawing::NamedCurves station(double x, const std::string& label) const {
    drawing::ShipCurve curve;
    for (int i = 0; i <= 100; ++i) {
      const double z = depth * i / 100.0;
      curve.points.push_back({x, half_breadth(x, z), z});
    }
    return {x, label, {curve}};
  }

  drawing::NamedCurves waterline(double z) const {
    drawing::ShipCurve curve;
    for (int i = 0; i <= 200; ++i) {
      const double x = length * i / 200.0;
      curve.points.push_back({x, half_breadth(x, z), z});
    }
    return {z, metres(z), {curve}};
  }

  drawing::NamedCurves buttock(double y) const {
    // Solved for z on both sides of midship; the widest section bounds it.
    drawing::ShipCurve curve;
    const double reach = 1.0 - 2.0 * y / beam;
    if (reach <= 0.0) return {y, metres(y), {}};
    for (int i = -100; i <= 100; ++i) {
      const double along = std::sqrt(reach) * std::sin(0.5 * 3.141592653589793 * i / 100.0);
      const double below = std::sqrt(std::max(0.0, 1.0 - 2.0 * y / beam / (1.0 - along * along)));
      curve.points.push_back({0.5 * length * (1.0 + along), y, draft * (1.0 - below)});
    }
    curve.points.insert(curve.points.begin(), {curve.points.front().x(), y, depth});
    curve.points.push_back({curve.points.back().x(), y, depth});
    return {y, metres(y), {curve}};
  }

  drawing::NamedDiagonal diagonal(double height, double angle) const {
    drawing::ShipCurve curve;
    for (int i = 0; i <= 200; ++i) {
      const double x = length * i / 200.0;
      // Where the plane meets the side: by halving, from inside to outside.
      double inside = 0.0, outside = beam;
      for (int k = 0; k < 60; ++k) {
        const double y = 0.5 * (inside + outside);
        const double z = height - y * std::tan(angle);
        (z > 0.0 && y < half_breadth(x, z) ? inside : outside) = y;
      }
      curve.points.push_back({x, inside, height - inside * std::tan(angle)});
    }
    return {{height, angle}, angle < 0.5 ? "D1" : "D2", {curve}};
  }

  analysis::OffsetTable offsets(const drawing::LinesDrawing& drawing) const {
    analysis::OffsetTable table;
    for (const drawing::NamedCurves& member : drawing.stations) {
      table.stations.push_back(member.position);
    }
    for (const drawing::NamedCurves& member : drawing.waterlines) {
      table.waterlines.push_back(member.position);
    }
    table.buttocks = {0.0};
    for (const drawing::NamedCurves& member : drawing.buttocks) {
      table.buttocks.push_back(member.position);
    }
    analysis::FeatureOffsets deck{"Deck edge", surface::CreaseKind::kBorder, {}, {}};
    for (const double x : table.stations) {
      for (const double z : table.waterlines) {
        table.half_breadths.push_back({half_breadth(x, z), false});
      }
      for (std::size_t j = 0; j < table.buttocks.size(); ++j) table.heights.push_back({});
      deck.half_breadths.push_back(half_breadth(x, depth));
      deck.heights.push_back(depth);
    }
    table.features = {deck};
    return table;
  }

  drawing::LinesDrawing lines() const {
    drawing::LinesDrawing drawing;
    drawing.title = "Wigley hull";
    drawing.length = length;
    drawing.draft = draft;
    drawing.particulars = {{"Length between perpendiculars", metres(length)},
                           {"Beam", metres(beam)},
                           {"Draft", metres(draft)},
                           {"Depth", metres(depth)}};
    for (int i = 0; i <= 20; ++i) {
      drawing.stations.push_back(station(length * i / 20.0, std::to_string(i)));
    }
    for (int i = 1; i < 8; ++i) drawing.waterlines.push_back(waterline(depth * i / 8.0));
    drawing.waterlines.push_back(waterline(draft));
    drawing.waterlines.back().label = "DWL " + metres(draft);
    for (int i = 1; i < 5; ++i) drawing.buttocks.push_back(buttock(0.1 * beam * i));
    drawing.outlines.push_back(
        polyline({{0, 0, depth}, {0, 0, 0}, {length, 0, 0}, {length, 0, depth}}));
    drawing.outlines.push_back(waterline(depth).curves.front());
    return drawing;
  }
};

// A box-shaped barge with raked ends: everything straight, and all its sections coincide.
inline drawing::LinesDrawing barge_lines() {
  const double length = 60.0, half_beam = 7.0, depth = 4.0, rake = 6.0;
  drawing::LinesDrawing drawing;
  drawing.title = "Barge";
  drawing.length = length;
  drawing.draft = 2.5;
  const auto bottom = [&](double x) {
    const double in = std::min(x, length - x);
    return in < rake ? depth * (1.0 - in / rake) * 0.6 : 0.0;
  };
  for (int i = 0; i <= 10; ++i) {
    const double x = length * i / 10.0;
    drawing.stations.push_back(
        {x,
         std::to_string(i),
         {polyline({{x, 0, bottom(x)}, {x, half_beam, bottom(x)}, {x, half_beam, depth}})}});
  }
  for (const double z : {1.0, 2.0, 2.5, 3.0}) {
    const double in = std::max(0.0, rake * (1.0 - z / (0.6 * depth)));
    drawing.waterlines.push_back(
        {z,
         metres(z),
         {polyline(
             {{in, 0, z}, {in, half_beam, z}, {length - in, half_beam, z}, {length - in, 0, z}})}});
  }
  for (const double y : {2.0, 4.0, 6.0}) {
    drawing.buttocks.push_back({y,
                                metres(y),
                                {polyline({{0, y, depth},
                                           {0, y, 0.6 * depth},
                                           {rake, y, 0},
                                           {length - rake, y, 0},
                                           {length, y, 0.6 * depth},
                                           {length, y, depth}})}});
  }
  drawing.outlines.push_back(polyline(
      {{0, 0, depth}, {0, half_beam, depth}, {length, half_beam, depth}, {length, 0, depth}}));
  drawing.knuckles.push_back(polyline({{0, half_beam, depth},
                                       {0, half_beam, 0.6 * depth},
                                       {rake, half_beam, 0},
                                       {length - rake, half_beam, 0},
                                       {length, half_beam, 0.6 * depth},
                                       {length, half_beam, depth}}));
  return drawing;
}

}  // namespace hull::test
