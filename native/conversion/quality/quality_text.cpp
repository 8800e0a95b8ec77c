// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "conversion/quality/quality_report.h"

namespace hull::conversion {
namespace {

constexpr int kWorstPatches = 5;
constexpr std::size_t kNameWidth = 42, kValueWidth = 20;

std::string formatted(const char* format, double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

std::string padded(std::string text, std::size_t width) {
  if (text.size() < width) text.append(width - text.size(), ' ');
  return text;
}

// Three figures, without an exponent where that is short enough.
std::string number(double value) {
  if (value == 0.0) return "0";
  return formatted(std::abs(value) < 1e-4 || std::abs(value) >= 1e6 ? "%.2e" : "%.3g", value);
}

std::string place_of(const Worst& worst) {
  if (!worst.point.allFinite()) return "";
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) text += ", ";
    // Without a minus before zeros.
    text += formatted("%.3f", std::abs(worst.point(axis)) < 5e-4 ? 0.0 : worst.point(axis));
  }
  return text;
}

// One line of the table; `factor` from SI to the unit.
void add_line(std::string& text, const std::string& name, const Worst& worst, double factor,
              const std::string& unit) {
  text += padded(name, kNameWidth);
  if (!worst.is_measured()) {
    text += "-\n";
    return;
  }
  std::string value = number(factor * worst.value);
  value += ' ';
  value += unit;
  text += padded(value, kValueWidth);
  text += place_of(worst);
  text += '\n';
}

void add_entry(std::string& text, const std::string& name, const std::string& value) {
  text += padded(name, kNameWidth);
  text += value;
  text += '\n';
}

void add_worst_patches(std::string& text, const QualityReport& report) {
  std::vector<const PatchQuality*> worst;
  for (const PatchQuality& patch : report.patches) {
    if (patch.distance.value > QualityReport::kExactDistance * report.length) {
      worst.push_back(&patch);
    }
  }
  std::stable_sort(worst.begin(), worst.end(), [](const auto* a, const auto* b) {
    return a->distance.value > b->distance.value;
  });
  if (worst.empty()) return;
  text += "\nPatches farthest off\n";
  for (std::size_t i = 0; i < worst.size() && i < kWorstPatches; ++i) {
    const std::string number = std::to_string(worst[i] - report.patches.data());
    add_line(text, "  patch " + number, worst[i]->distance, 1e3, "mm");
  }
}

}  // namespace

std::string QualityReport::text() const {
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  std::string text;
  text += padded("", kNameWidth);
  text += padded("largest", kValueWidth);
  text += "at x, y, z in m\n";
  add_line(text, "Distance from the surface", distance, 1e3, "mm");
  add_entry(text, "  of the length", number(1e3 * distance_per_length()) + " per mille");
  add_entry(text, "  root mean square", number(1e3 * rms_distance) + " mm");
  add_line(text, "Gap between patches", worst_seams.gap, 1e3, "mm");
  add_line(text, "Angle across seams", worst_seams.angle, kDegrees, "degrees");
  std::string near_points = "  within ";
  near_points += number(1e3 * normal_reach);
  near_points += " mm of irregular points";
  add_line(text, near_points, worst_seams.angle_at_points, kDegrees, "degrees");
  add_line(text, "Jump of curvature across seams", worst_seams.curvature_jump, 1.0, "1/m");
  add_line(text, near_points, worst_seams.curvature_jump_at_points, 1.0, "1/m");
  text += '\n';
  add_entry(text, "Exact share of the area", formatted("%.7g", 100.0 * exact_share) + " %");
  std::string count = std::to_string(patches.size());
  count += " (at least ";
  count += std::to_string(theoretical_patch_count);
  count += ')';
  add_entry(text, "Patches", count);
  add_entry(text, "Knots", std::to_string(knot_count));
  add_entry(text, "Control points", std::to_string(control_point_count));
  add_entry(text, "Length of the hull", formatted("%.3f m", length));
  add_worst_patches(text, *this);
  return text;
}

}  // namespace hull::conversion
