// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string>

#include "conversion/quality/quality_report.h"

namespace hull::conversion {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

std::string json_of(double value) {
  if (!std::isfinite(value)) return "null";
  std::array<char, 32> buffer{};
  // The shortest digits that are read back as the same number, whatever the locale.
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  return {buffer.data(), end};
}

std::string json_of(const Vector3d& point) {
  if (!point.allFinite()) return "null";
  std::string text = "[";
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) text += ", ";
    text += json_of(point(axis));
  }
  return text += ']';
}

// Puts together an object, or an array, of texts that are JSON.
class JsonList {
 public:
  explicit JsonList(int depth) : indent_(static_cast<std::size_t>(2 * depth), ' ') {}

  void add(const std::string& value) {
    text_ += text_.empty() ? "\n" : ",\n";
    text_ += indent_;
    text_ += value;
  }
  void add(const std::string& name, const std::string& value) {
    std::string entry = "\"";
    entry += name;
    entry += "\": ";
    entry += value;
    add(entry);
  }
  void add(const std::string& name, double value) { add(name, json_of(value)); }
  void add(const std::string& name, int value) { add(name, std::to_string(value)); }

  std::string between(char first, char last) const {
    std::string result(1, first);
    result += text_;
    if (!text_.empty()) {
      result += '\n';
      result.append(indent_, 2);
    }
    result += last;
    return result;
  }

 private:
  std::string indent_, text_;
};

// The value as `name`, and where: null if nothing was measured.
void add_worst(JsonList& list, const std::string& name, const std::string& unit, double factor,
               const Worst& worst) {
  const bool known = worst.is_measured();
  const auto named = [&name](const char* ending) {
    std::string result = name;
    return result += ending;
  };
  std::string value_name = named("_");
  value_name += unit;
  list.add(value_name, known ? json_of(factor * worst.value) : "null");
  list.add(named("_at_m"), json_of(worst.point));
  const bool has_cell = worst.place.cell >= 0;
  list.add(named("_at_cell"), has_cell ? std::to_string(worst.place.cell) : "null");
  std::string uv = "null";
  if (has_cell) {
    uv = "[";
    uv += json_of(worst.place.u);
    uv += ", ";
    uv += json_of(worst.place.v);
    uv += ']';
  }
  list.add(named("_at_uv"), uv);
}

std::string json_of(const PatchQuality& patch) {
  JsonList list(3);
  list.add("cells", patch.cells);
  add_worst(list, "largest_distance", "m", 1.0, patch.distance);
  list.add("rms_distance_m", patch.cells > 0 ? json_of(patch.rms_distance) : "null");
  list.add("area_m2", patch.cells > 0 ? json_of(patch.area) : "null");
  list.add("exact_area_m2", patch.cells > 0 ? json_of(patch.exact_area) : "null");
  list.add("knots", patch.knot_count);
  list.add("control_points", patch.control_point_count);
  return list.between('{', '}');
}

void add_seam_values(JsonList& list, const SeamQuality& seam) {
  add_worst(list, "largest_gap", "m", 1.0, seam.gap);
  add_worst(list, "largest_seam_angle", "deg", kDegrees, seam.angle);
  add_worst(list, "largest_seam_angle_at_points", "deg", kDegrees, seam.angle_at_points);
  add_worst(list, "largest_curvature_jump", "per_m", 1.0, seam.curvature_jump);
  add_worst(list, "largest_curvature_jump_at_points", "per_m", 1.0, seam.curvature_jump_at_points);
}

std::string json_of(const SeamQuality& seam) {
  JsonList list(3);
  std::string patches = "[";
  patches += std::to_string(seam.patches[0]);
  patches += ", ";
  patches += std::to_string(seam.patches[1]);
  patches += ']';
  list.add("edge", seam.edge);
  list.add("patches", patches);
  list.add("is_smooth", seam.is_smooth ? "true" : "false");
  add_seam_values(list, seam);
  return list.between('{', '}');
}

template <class Part>
std::string array_of(const std::vector<Part>& parts) {
  JsonList list(2);
  for (const Part& part : parts) list.add(json_of(part));
  return list.between('[', ']');
}

}  // namespace

std::string QualityReport::json() const {
  JsonList list(1);
  list.add("length_m", length);
  list.add("normal_reach_m", normal_reach);
  add_worst(list, "largest_distance", "m", 1.0, distance);
  list.add("largest_distance_per_length", distance_per_length());
  list.add("rms_distance_m", rms_distance);
  list.add("area_m2", area);
  list.add("exact_share", exact_share);
  add_seam_values(list, worst_seams);
  list.add("patch_count", static_cast<int>(patches.size()));
  list.add("theoretical_patch_count", theoretical_patch_count);
  list.add("knot_count", knot_count);
  list.add("control_point_count", control_point_count);
  list.add("patches", array_of(patches));
  list.add("seams", array_of(seams));
  return list.between('{', '}') + "\n";
}

}  // namespace hull::conversion
