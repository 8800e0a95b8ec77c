// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "modelling/transformation/area_curve.h"
#include "modelling/transformation/fair_shifts.h"

namespace hull::modelling {

// Which part of the body's sections is shifted, with what coefficients.
enum class ShiftedPart {
  kWhole,  // A, B: shift(x) = A x sin(π|x|) + B a(x)
  kApart,  // A of the fore and A of the aft body, each with x sin(π|x|) of its own half
  kFore,   // A of the fore body alone
  kAft,    // A of the aft body alone
  kFair    // A, B: by the two functions of FairShifts, which bend the hull's lines the least
};

// Sections in this range stay; the shift fades to nothing within `fade`, m, on either side.
struct HeldRange {
  double aft, forward, fade;
};

struct ShiftSettings {
  double length_pp = 0.0;  // m, from x = 0: x runs from -1 there to 1 at the forward perpendicular
  ShiftedPart part = ShiftedPart::kWhole;
  std::optional<HullRange> parallel;         // the parallel middle body as it is
  std::optional<HullRange> parallel_wanted;  // and as it is to be; absent: as it is
  std::vector<HeldRange> held;
};

// Shifts of sections along the ship as functions of x (Koelman 1999, eq. 5.4, 5.5; Lackenby 1950),
// in m for a coefficient of 1. a(x) is the sectional area divided by the largest.
//
// Where the sections at the perpendiculars have an area, as at an immersed transom or a bulb, it is
// taken off a(x), smoothly from the largest section to the end, so that the hull keeps its length.
//
// With a parallel middle body x is counted from its ends, so that x sin(π|x|) leaves all of it, and
// a(x) moves it as a whole. Beyond the perpendiculars x sin(π|x|) goes on as it is, up to where it
// is extreme (|x| = 1.56), and then stays.
//
// The fairest shifts leave both perpendiculars and the parallel middle body's length, and bend
// lines the less the more these are inclined (fair_shifts.h).
class ShiftFunctions {
 public:
  // Throws std::invalid_argument for lengths that are none, and ranges that are not in order.
  ShiftFunctions(const ShiftSettings& settings, const WorkingHull& hull,
                 const SurfacePlaces& places);

  ShiftedPart part() const { return settings_.part; }
  int count() const { return part() == ShiftedPart::kFore || part() == ShiftedPart::kAft ? 1 : 2; }
  // Of coefficient k.
  double value(int k, double x) const;
  // What the parallel body's change asks for, whatever the coefficients, m.
  double parallel_change(double x) const;
  bool changes_parallel_body() const { return settings_.parallel_wanted.has_value(); }

  // Slopes at places between two x: a column for the parallel body's change, then one for each
  // coefficient.
  Eigen::MatrixXd slopes(double from, double to) const;
  // The least of 1 + shift' by such slopes: at 0 sections overtake one another.
  static double least_stretch(const Eigen::MatrixXd& slopes,
                              const std::vector<double>& coefficients);

 private:
  void check() const;
  double towards_end(double x) const;  // x sin(π|x|)
  double by_area(double x) const;      // a(x) without what the ends have
  double freedom(double x) const;
  FairShifts fair_shifts(const WorkingHull& hull, const SurfacePlaces& places) const;

  ShiftSettings settings_;
  HullRange parallel_;
  std::optional<AreaCurve> areas_;
  double area_at_ap_ = 0.0, area_at_fp_ = 0.0;  // of these
  std::optional<FairShifts> fair_;
};

}  // namespace hull::modelling
