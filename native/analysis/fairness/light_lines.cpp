// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/fairness/light_lines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "analysis/arithmetic/bracketed_root.h"
#include "surface/creases/crease_curves.h"

namespace hull::analysis {
namespace {

constexpr double kNotSeen = std::numeric_limits<double>::quiet_NaN();
constexpr int kDefaultLines = 20, kMostLines = 2000;
constexpr double kAlong = 1e-9;  // sine of the angle at which directions are taken for parallel
constexpr int kPartsOfEdge = 16;

Vector3d unit(const Vector3d& v, const char* name) {
  const double length = v.norm();
  if (!(length > 0.0) || !std::isfinite(length)) {
    std::string message = name;
    message += " must not be zero, and be finite.";
    throw std::invalid_argument(message);
  }
  return v / length;
}

Eye checked(const Eye& eye) {
  if (eye.point) {
    if (!eye.point->allFinite()) throw std::invalid_argument("The eye's point must be finite.");
    return eye;
  }
  return {unit(eye.direction, "The direction to the eye"), std::nullopt};
}

double require_positive(double value, const char* name) {
  if (value > 0.0 && std::isfinite(value)) return value;
  std::string message = name;
  message += " must be above zero, not ";
  message += std::to_string(value);
  message += '.';
  throw std::invalid_argument(message);
}

// Creases as seen: one side turned to the eye, the other one away.
class CreaseOutline {
 public:
  CreaseOutline(const surface::LimitSurface& surface, const Eye& eye,
                const surface::CreaseCurve& curve)
      : surface_(surface), eye_(eye), curve_(curve) {}

  void add_to(std::vector<LevelCurve>& curves) {
    const int count = curve_.edge_count() * kPartsOfEdge;
    for (int i = 0; i < count; ++i) {
      add_part(static_cast<double>(i) / kPartsOfEdge, static_cast<double>(i + 1) / kPartsOfEdge,
               curves);
    }
    open_ = false;
  }

 private:
  double turned(const surface::CellPlace& place) const {
    const Vector3d normal = surface_.normal(place.cell, place.u, place.v);
    return normal.dot(eye_.from(surface_.position(place.cell, place.u, place.v)));
  }
  // Negative where it is part of the outline.
  double both(double t) const { return turned(curve_.left(t)) * turned(curve_.right(t)); }

  void add_part(double t0, double t1, std::vector<LevelCurve>& curves) {
    const double f0 = both(t0), f1 = both(t1);
    // Of a side that is seen edge on the sign is rounding.
    const bool in0 = f0 < -kFacing, in1 = f1 < -kFacing;
    if (!in0 && !in1) {
      open_ = false;
      return;
    }
    const auto change = [&] {
      return bracketed_root([&](double t) { return both(t); }, t0, f0, t1, f1, 1e-12);
    };
    const bool crosses = (f0 < 0.0) != (f1 < 0.0);
    if (!open_) {
      LevelCurve& curve = curves.emplace_back();
      curve.level = 0.0;
      curve.closed = false;
      // The outline begins where the sign changes, or at t0 where rounding hides that.
      add_point(in0 || !crosses ? t0 : change(), curve);
    }
    add_point(in1 || !crosses ? t1 : change(), curves.back());
    open_ = in1;
  }

  void add_point(double t, LevelCurve& curve) const {
    const surface::CellPlace place = curve_.left(t);
    curve.points.push_back(curve_.evaluate(t, 0).point);
    curve.cells.push_back(place.cell);
    curve.uv.emplace_back(place.u, place.v);
  }

  static constexpr double kFacing = 1e-12;
  const surface::LimitSurface& surface_;
  const Eye& eye_;
  const surface::CreaseCurve& curve_;
  bool open_ = false;  // the last curve goes on
};

}  // namespace

Vector3d Eye::from(const Vector3d& p) const {
  return point ? Vector3d((*point - p).normalized()) : direction;
}

LightLines::LightLines(const LightBank& bank) : bank_(bank) {
  bank_.line_direction = unit(bank.line_direction, "The direction of the lines of light");
  const Vector3d light = unit(bank.light_direction, "The direction to the lines of light");
  // Along the lines themselves the direction to them makes no difference.
  up_ = light - light.dot(bank_.line_direction) * bank_.line_direction;
  if (!(up_.norm() > kAlong)) {
    throw std::invalid_argument(
        "The direction to the lines of light must not be that of the lines: choose one across "
        "them.");
  }
  up_.normalize();
  across_ = bank_.line_direction.cross(up_);
  bank_.eye = checked(bank.eye);
  require_positive(bank.spacing, "The spacing of the lines of light");
  if (!std::isfinite(bank.phase)) throw std::invalid_argument("The phase must be finite.");
  if (bank.distance) require_positive(*bank.distance, "The distance of the lines of light");
  if (bank.lines && (*bank.lines < 0 || *bank.lines > kMostLines)) {
    throw std::invalid_argument("There are 0 to 2000 lines of light to each side, not " +
                                std::to_string(*bank.lines) + ".");
  }
  period_ = bank.distance ? kNoPeriod : 2.0 * std::numbers::pi / bank.spacing;
}

double LightLines::operator()(const Vector3d& point, const Vector3d& normal) const {
  const Vector3d eye = bank_.eye.from(point);
  // The way to the eye, mirrored about the normal.
  const Vector3d ray = 2.0 * normal.dot(eye) * normal - eye;
  const double across = ray.dot(across_), up = ray.dot(up_);
  if (!bank_.distance) {
    if (across * across + up * up < kAlong * kAlong) return kNotSeen;
    // Into the period around line 0.
    return std::remainder(std::atan2(across, up) / bank_.spacing - bank_.phase, period_);
  }
  const double height = *bank_.distance - up_.dot(point);
  if (!(up > kAlong) || !(height > 0.0)) return kNotSeen;
  // Where the ray meets the plane of the lines.
  return (across_.dot(point) + height * across / up) / bank_.spacing - bank_.phase;
}

std::vector<double> LightLines::numbers() const {
  int most = bank_.lines.value_or(kDefaultLines);
  if (!bank_.distance && !bank_.lines) {
    most = static_cast<int>(std::min(0.25 * period_ + 1e-9, static_cast<double>(kMostLines)));
  }
  std::vector<double> numbers;
  for (int k = -most; k <= most; ++k) {
    // All around, a line has one number only.
    if (k > -0.5 * period_ + 1e-9 && k <= 0.5 * period_ + 1e-9) numbers.push_back(k);
  }
  return numbers;
}

std::vector<LevelCurve> reflection_lines(const surface::LimitSurface& surface,
                                         const LightBank& bank, const LevelOptions& options) {
  const LightLines lines(bank);
  return level_curves(surface, lines, lines.numbers(), options, lines.period());
}

std::vector<LevelCurve> isophotes(const surface::LimitSurface& surface, const Vector3d& direction,
                                  const std::vector<double>& angles, const LevelOptions& options) {
  const Vector3d along = unit(direction, "The direction of isophotes");
  std::vector<double> levels;
  for (const double angle : angles) {
    if (!(angle >= 0.0 && angle <= std::numbers::pi)) {
      throw std::invalid_argument("The angles of isophotes lie between 0 and pi, not " +
                                  std::to_string(angle) + ".");
    }
    // The cosine of a right angle is 0 to rounding only.
    const double level = std::cos(angle);
    levels.push_back(std::abs(level) < 1e-15 ? 0.0 : level);
  }
  const auto function = [along](const Vector3d&, const Vector3d& normal) {
    return normal.dot(along);
  };
  std::vector<LevelCurve> curves = level_curves(surface, function, levels, options);
  for (LevelCurve& curve : curves) {
    // Levels come back bit by bit as they were given.
    const auto at = std::find(levels.begin(), levels.end(), curve.level) - levels.begin();
    curve.level = angles[static_cast<std::size_t>(at)];
  }
  return curves;
}

std::vector<LevelCurve> silhouette(const surface::LimitSurface& surface, const Eye& eye,
                                   const LevelOptions& options) {
  const Eye from = checked(eye);
  const auto function = [from](const Vector3d& point, const Vector3d& normal) {
    return normal.dot(from.from(point));
  };
  std::vector<LevelCurve> curves = level_curves(surface, function, {0.0}, options);
  for (const surface::CreaseCurve& crease : surface::crease_curves(surface)) {
    if (crease.kind() == surface::CreaseKind::kCrease) {
      CreaseOutline(surface, from, crease).add_to(curves);
    }
  }
  return curves;
}

}  // namespace hull::analysis
