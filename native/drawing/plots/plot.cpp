// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing/plots/plot.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace hull::drawing {

namespace {

constexpr double kLargest = 1e100;
// Of its size: within what is narrower, numbers differ by little more than rounding, and steps can
// be too small to be counted. Data are widened to it.
constexpr double kNarrowest = 1e-9;

std::string quoted(const std::string& kind, const std::string& name, std::size_t index) {
  std::string words = kind;
  // By the name that its maker gave it, or by its number.
  if (name.empty()) return words.append(" ").append(std::to_string(index));
  return words.append(" \"").append(name).append("\"");
}

[[noreturn]] void refuse(const std::string& what) {
  throw std::invalid_argument("A plot cannot be drawn: " + what);
}

void check_number(double value, const std::string& what) {
  if (!std::isfinite(value)) refuse(what + " is not a finite number");
  if (std::abs(value) > kLargest) refuse(what + " is beyond 1e100");
}

void check_axis(const PlotAxis& axis, const std::string& name) {
  if (!axis.range) return;
  check_number(axis.range->low, "the lower end of " + name);
  check_number(axis.range->high, "the upper end of " + name);
  if (!(axis.range->low < axis.range->high)) {
    refuse("the range of " + name + " ends where it begins, or before: " +
           std::to_string(axis.range->low) + " to " + std::to_string(axis.range->high));
  }
  const double size = std::max(std::abs(axis.range->low), std::abs(axis.range->high));
  if (axis.range->high - axis.range->low < kNarrowest * size || size < 1.0 / kLargest) {
    refuse("the range of " + name +
           " is narrower than a billionth of its larger end, or than 1e-100: give a wider one");
  }
}

void check_curve(const PlotCurve& curve, const std::string& name, std::size_t axis_count) {
  if (curve.x.size() != curve.y.size()) {
    refuse(name + " has " + std::to_string(curve.x.size()) + " x and " +
           std::to_string(curve.y.size()) + " y; they must be as many");
  }
  if (curve.x_axis < 0 || static_cast<std::size_t>(curve.x_axis) >= axis_count) {
    refuse(name + " refers to x axis " + std::to_string(curve.x_axis) + " of " +
           std::to_string(axis_count));
  }
  for (const std::vector<double>* values : {&curve.x, &curve.y}) {
    for (std::size_t i = 0; i < values->size(); ++i) {
      // What is not finite interrupts a curve, and is well; what is too large would overflow in the
      // scales.
      if (std::isfinite((*values)[i])) {
        check_number((*values)[i], "point " + std::to_string(i) + " of " + name);
      }
    }
  }
}

void check_reference(int curve, int least, std::size_t count, const std::string& name) {
  if (curve < least || (curve >= 0 && static_cast<std::size_t>(curve) >= count)) {
    refuse(name + " refers to curve " + std::to_string(curve) + " of " + std::to_string(count));
  }
}

}  // namespace

void check_plot(const Plot& plot) {
  if (plot.x_axes.empty()) refuse("it has no x axis");
  for (std::size_t i = 0; i < plot.x_axes.size(); ++i) {
    check_axis(plot.x_axes[i], quoted("x axis", plot.x_axes[i].label, i));
  }
  check_axis(plot.y_axis, "the y axis");
  for (std::size_t i = 0; i < plot.curves.size(); ++i) {
    check_curve(plot.curves[i], quoted("curve", plot.curves[i].name, i), plot.x_axes.size());
  }
  for (std::size_t i = 0; i < plot.markers.size(); ++i) {
    const std::string name = quoted("marker", plot.markers[i].label, i);
    check_number(plot.markers[i].x, "x of " + name);
    check_number(plot.markers[i].y, "y of " + name);
    // -1 is a marker of no curve.
    check_reference(plot.markers[i].curve, -1, plot.curves.size(), name);
  }
  for (std::size_t i = 0; i < plot.lines.size(); ++i) {
    check_number(plot.lines[i].at, "the position of " + quoted("line", plot.lines[i].label, i));
  }
  for (std::size_t i = 0; i < plot.areas.size(); ++i) {
    const std::string name = quoted("area", plot.areas[i].label, i);
    check_number(plot.areas[i].from, "the beginning of " + name);
    check_number(plot.areas[i].to, "the end of " + name);
    check_reference(plot.areas[i].curve, 0, plot.curves.size(), name);
  }
  for (std::size_t i = 0; i < plot.bars.size(); ++i) {
    const std::string name = quoted("bar", plot.bars[i].label, i);
    check_number(plot.bars[i].length, "the length of " + name);
    if (plot.bars[i].length <= 0.0) refuse("the length of " + name + " is not above zero");
  }
}

}  // namespace hull::drawing
