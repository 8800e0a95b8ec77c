// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "analysis/fairness/course_memory.h"
#include "analysis/fairness/curve_marks.h"
#include "analysis/sections/sections.h"
#include "surface/creases/crease_curves.h"

namespace hull::analysis {

// A curve as its fairness is judged: samples at even arc lengths between knuckles, and marks.
struct CurveFairness {
  enum class Kind { kSection, kCrease, kBorder } kind;
  std::vector<int> vertices;  // of a crease or border: its control vertices
  bool closed;
  double length;                     // m
  std::vector<CurveSample> samples;  // of all stretches
  std::vector<double> arc_lengths;   // per sample, from the curve's start
  std::vector<int> starts;           // stretch i: samples starts[i] … starts[i + 1] - 1
  std::vector<CurveMark> marks;      // by arc length from the curve's start

  int inflection_count() const;
  int extremum_count() const;
};

struct FairnessOptions {
  // Either the largest distance of samples along the curve (m), or how many each stretch has. By
  // default the distance is 1/200 of the mesh's size.
  std::optional<double> step;
  std::optional<int> count;
  // By default 1e-3 over the mesh's size: what bends less is straight to the eye.
  std::optional<double> noise;
  double relative_noise = 1e-3;
  bool marks = true;  // whether marks are looked for, which takes most of the time
};

// Sections by planes, branch by branch as sections() gives them; every sample is exact. Arc
// lengths are right to about 1e-6, as sections are never sampled more coarsely than to 1e-5 of the
// mesh's size, and more so with a finer chord tolerance. Throws std::invalid_argument as
// sections() does, and for options out of range.
std::vector<std::vector<CurveFairness>> section_fairness(const surface::LimitSurface& surface,
                                                         const std::vector<Plane>& planes,
                                                         const SectionOptions& sampling,
                                                         const FairnessOptions& options);

// The same of sections that are there: curves[i] are those by planes[i], as sections() gives them
// to a chord tolerance no coarser than 1e-5 of the mesh's size. Throws std::invalid_argument for
// those of another surface, or of this one before its points were set. `memories`, where given,
// know the sections by each plane of before, and take what is known now. REQUIRES: as many of both
// as planes; no memory twice.
std::vector<std::vector<CurveFairness>> section_fairness(
    const surface::LimitSurface& surface, const std::vector<Plane>& planes,
    const std::vector<std::vector<const SectionCurve*>>& curves, const FairnessOptions& options,
    const std::vector<CourseMemory*>& memories = {});

// Creases and borders, as crease_curves() gives them. With a direction of view (of any length) they
// are judged as seen along it. Else plane curves are judged in their plane, seen against that
// normal whose largest component is positive; others by the length of their curvature vector, which
// has no sign, so that they have extrema but no inflections.
std::vector<CurveFairness> feature_fairness(const surface::LimitSurface& surface,
                                            const std::optional<Vector3d>& direction,
                                            const FairnessOptions& options);

// A line segment.
using Segment3 = std::array<Vector3d, 2>;

// The curvature comb: a tooth from each sample to sample - scale * curvature vector, away from the
// centre of curvature, then the line through the teeth's ends, broken at knuckles. `scale`, in m²,
// is the length of a tooth in m for a curvature of 1/m.
std::vector<Segment3> comb(const CurveFairness& curve, double scale);

// The scale at which 98 % of all teeth, by length of curve, are no longer than `height` (m). 1 if
// all are straight. Throws std::invalid_argument unless height > 0.
double suggested_comb_scale(const std::vector<CurveFairness>& curves, double height);

}  // namespace hull::analysis
