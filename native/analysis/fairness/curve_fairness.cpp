// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/fairness/curve_fairness.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <string>

#include "analysis/fairness/feature_course.h"
#include "analysis/fairness/section_course.h"
#include "surface/parallel_for.h"

namespace hull::analysis {
namespace {

constexpr double kStep = 1.0 / 200.0;   // of the mesh's size
constexpr double kNoise = 1e-3;         // over the mesh's size
constexpr double kPlaneCurve = 1e-9;    // of the mesh's size
constexpr double kCoarsest = 1e-5;      // of the mesh's size: chords of sections
constexpr double kOnCutSurface = 1e-7;  // of the mesh's size: places of sections, with some room
constexpr int kMostSamples = 100000;    // of one stretch
constexpr double kTallest = 0.98;

struct Rules {
  double step;
  int count;  // 0: by step
  CurvatureNoise noise;
  bool marks;
};

Rules rules_from(const surface::LimitSurface& surface, const FairnessOptions& options) {
  const double size = surface.mesh().size();
  if (options.step && options.count) {
    throw std::invalid_argument("Give either the step between samples or their count, not both.");
  }
  Rules rules{options.step.value_or(kStep * size),
              options.count.value_or(0),
              {options.noise.value_or(kNoise / size), options.relative_noise},
              options.marks};
  if (!(rules.step > 0.0) || !std::isfinite(rules.step)) {
    throw std::invalid_argument("The step between samples must be a positive length, not " +
                                std::to_string(rules.step) + " m.");
  }
  if (options.count && (rules.count < 2 || rules.count > kMostSamples)) {
    throw std::invalid_argument("A stretch takes 2 to 100000 samples, not " +
                                std::to_string(rules.count) + ".");
  }
  const auto is_noise = [](double value) { return value >= 0.0 && std::isfinite(value); };
  if (!is_noise(rules.noise.absolute) || !is_noise(rules.noise.relative)) {
    throw std::invalid_argument(
        "Noise is what curvature has to exceed to count: a number of 0 or more, in 1/m or relative "
        "to the curve's own.");
  }
  return rules;
}

void add_stretch(MeasuredCurve& curve, const Rules& rules, CurveFairness& result) {
  const double before = result.length, length = curve.length();
  int count = rules.count;
  if (count == 0) {
    // Rounding of the length must not make one interval more.
    const double intervals = std::ceil(length / rules.step * (1.0 - 1e-12));
    count = 1 + static_cast<int>(std::clamp(intervals, 1.0, kMostSamples - 1.0));
  }
  for (int i = 0; i < count; ++i) {
    const double s = length * i / (count - 1);
    result.samples.push_back(curve.at(s));
    result.arc_lengths.push_back(before + s);
  }
  result.starts.push_back(static_cast<int>(result.samples.size()));
  result.length += length;
  if (!rules.marks) return;
  for (CurveMark& mark : curve_marks(curve, rules.noise)) {
    mark.arc_length += before;
    result.marks.push_back(mark);
  }
}

CurveFairness judged(const surface::LimitSurface& surface, const Plane& plane,
                     const SectionCurve& curve, const Rules& rules, CourseMemory* memory) {
  CurveFairness result{CurveFairness::Kind::kSection, {}, curve.closed, 0.0, {}, {}, {0}, {}};
  for (const SmoothStretch& stretch : smooth_stretches(curve)) {
    SectionCourse course(surface, plane, curve, stretch, memory);
    add_stretch(course, rules, result);
    course.keep();
  }
  return result;
}

// A place in each cell tells: more would cost as much as judging does.
void require_cut_of(const surface::LimitSurface& surface, const SectionCurve& curve, double size) {
  for (std::size_t i = 0; i < curve.cells.size(); ++i) {
    const int cell = curve.cells[i];
    if (i > 0 && cell == curve.cells[i - 1]) continue;
    const Eigen::Vector2d& uv = curve.uv[i];
    if (cell < surface.cell_count() &&
        (surface.position(cell, uv.x(), uv.y()) - curve.points[i]).norm() <= kOnCutSurface * size) {
      continue;
    }
    throw std::invalid_argument(
        "A section is out of date: the surface's points were set since it was cut, or it is "
        "another's. Cut it anew.");
  }
}

int count_of(const std::vector<CurveMark>& marks, bool inflections) {
  return static_cast<int>(std::count_if(marks.begin(), marks.end(), [&](const CurveMark& m) {
    return (m.kind == CurveMark::Kind::kInflection) == inflections;
  }));
}

}  // namespace

int CurveFairness::inflection_count() const { return count_of(marks, true); }
int CurveFairness::extremum_count() const { return count_of(marks, false); }

std::vector<std::vector<CurveFairness>> section_fairness(const surface::LimitSurface& surface,
                                                         const std::vector<Plane>& planes,
                                                         const SectionOptions& sampling,
                                                         const FairnessOptions& options) {
  rules_from(surface, options);  // what is out of range is known before anything is cut
  SectionOptions fine = sampling;
  // Arc lengths are told by the points, however few a drawing needs.
  fine.chord_tolerance = std::min(fine.chord_tolerance, kCoarsest * surface.mesh().size());
  const auto cut = sections(surface, planes, fine);
  std::vector<std::vector<const SectionCurve*>> curves(planes.size());
  for (std::size_t i = 0; i < cut.size(); ++i) {
    for (const SectionCurve& curve : cut[i]) curves[i].push_back(&curve);
  }
  return section_fairness(surface, planes, curves, options);
}

std::vector<std::vector<CurveFairness>> section_fairness(
    const surface::LimitSurface& surface, const std::vector<Plane>& planes,
    const std::vector<std::vector<const SectionCurve*>>& curves, const FairnessOptions& options,
    const std::vector<CourseMemory*>& memories) {
  assert(curves.size() == planes.size());
  assert(memories.empty() || memories.size() == planes.size());
  const Rules rules = rules_from(surface, options);
  const double size = surface.mesh().size();
  std::vector<std::vector<CurveFairness>> result(planes.size());
  constexpr std::size_t kGrain = 2;  // a plane's curves take some 100 microseconds
  surface::parallel_for(
      planes.size(), surface::kAllProcessors,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          CourseMemory* memory = memories.empty() ? nullptr : memories[i];
          for (const SectionCurve* curve : curves[i]) require_cut_of(surface, *curve, size);
          if (memory) memory->begin(surface);
          for (const SectionCurve* curve : curves[i]) {
            result[i].push_back(judged(surface, planes[i], *curve, rules, memory));
          }
        }
      },
      kGrain);
  return result;
}

std::vector<CurveFairness> feature_fairness(const surface::LimitSurface& surface,
                                            const std::optional<Vector3d>& direction,
                                            const FairnessOptions& options) {
  const Rules rules = rules_from(surface, options);
  std::optional<Vector3d> view;
  if (direction) {
    const double length = direction->norm();
    if (!(length > 0.0) || !std::isfinite(length)) {
      throw std::invalid_argument("The direction of view must not be zero, and be finite.");
    }
    view = *direction / length;
  }
  std::vector<CurveFairness> result;
  for (const surface::CreaseCurve& curve : surface::crease_curves(surface)) {
    const auto kind = curve.kind() == surface::CreaseKind::kBorder ? CurveFairness::Kind::kBorder
                                                                   : CurveFairness::Kind::kCrease;
    result.push_back({kind, curve.vertices(), curve.closed(), 0.0, {}, {}, {0}, {}});
    const auto seen_along =
        view ? view : normal_of_plane_curve(curve, kPlaneCurve * surface.mesh().size());
    FeatureCourse course(curve, seen_along);
    add_stretch(course, rules, result.back());
  }
  return result;
}

std::vector<Segment3> comb(const CurveFairness& curve, double scale) {
  std::vector<Segment3> segments;
  segments.reserve(2 * curve.samples.size());
  for (const CurveSample& at : curve.samples) {
    segments.push_back({at.point, at.point - scale * at.curvature});
  }
  for (std::size_t i = 0; i + 1 < curve.starts.size(); ++i) {
    for (int k = curve.starts[i]; k + 1 < curve.starts[i + 1]; ++k) {
      // Teeth came first, one for each sample.
      segments.push_back({segments[k][1], segments[k + 1][1]});
    }
  }
  return segments;
}

double suggested_comb_scale(const std::vector<CurveFairness>& curves, double height) {
  if (!(height > 0.0) || !std::isfinite(height)) {
    throw std::invalid_argument("The height of a comb must be a positive length, not " +
                                std::to_string(height) + " m.");
  }
  // Curvatures with the lengths of curve that have them.
  std::vector<std::array<double, 2>> bends;
  double total = 0.0;
  for (const CurveFairness& curve : curves) {
    for (std::size_t i = 0; i + 1 < curve.starts.size(); ++i) {
      for (int k = curve.starts[i]; k + 1 < curve.starts[i + 1]; ++k) {
        const double length = curve.arc_lengths[k + 1] - curve.arc_lengths[k];
        bends.push_back({curve.samples[k].curvature.norm(), length});
        total += length;
      }
    }
  }
  std::sort(bends.begin(), bends.end());
  double sum = 0.0, tallest = 0.0;
  // By length, not by samples: a tight radius at a stem has many samples, and would make all other
  // teeth too short to see.
  for (const auto& [bend, length] : bends) {
    sum += length;
    tallest = bend;
    if (sum >= kTallest * total) break;
  }
  return tallest > 0.0 ? height / tallest : 1.0;
}

}  // namespace hull::analysis
