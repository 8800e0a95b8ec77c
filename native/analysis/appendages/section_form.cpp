// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/appendages/section_form.h"

#include <algorithm>
#include <cmath>

namespace hull::analysis {
namespace {

constexpr int kParts = 48;
constexpr double kError = 5e-7;  // of the chord, at the places looked at
constexpr int kMostHalvings = 7;
constexpr double kSameJoint = 1e-9;  // closer places, √x, differ by rounding

Eigen::Vector2d on_cubic(const std::array<Eigen::Vector2d, 4>& p, double t) {
  const double q = 1.0 - t;
  return q * q * (q * p[0] + 3.0 * t * p[1]) + t * t * (3.0 * q * p[2] + t * p[3]);
}

// Makes a knot of a place where formulas meet.
void set_joint(std::vector<double>& knots, std::vector<double>& set, double joint) {
  const auto after = std::ranges::lower_bound(knots, joint);
  const auto nearest = joint - *(after - 1) < *after - joint ? after - 1 : after;
  const bool is_set = std::ranges::count(set, *nearest) > 0;
  if (is_set && std::abs(*nearest - joint) > kSameJoint) {
    // Ends and other joints stay, however short the part between.
    knots.insert(after, joint);
  } else {
    // In place of the one that is nearest, lest there be a very short part.
    *nearest = joint;
  }
  set.push_back(joint);
}

}  // namespace

SectionForm::SectionForm(const std::string& name) : name_(name), form_(section_named(name)) {
  const std::vector<double> even = even_knots();
  knots_.push_back(0.0);
  for (std::size_t i = 0; i + 1 < even.size(); ++i) add_knots(even[i], even[i + 1], 0);
}

double SectionForm::half_thickness(double x) const { return form_.thickness.at(std::sqrt(x))[0]; }

SectionForm::Point SectionForm::outline(double s, int side, double factor, bool behind) const {
  // By s = √x the round nose is a smooth curve: y goes with s there.
  const double x = s * s;
  auto [half, rise] = form_.thickness.at(s);
  half *= side * factor;
  rise *= side * factor;
  auto [slope, bend] = form_.mean_line.perpendicular_slopes(x, behind);
  bend *= 2.0 * s;
  // The normal is (-slope, 1) / length; its derivatives by s are -bend / cube and -slope bend /
  // cube, with bend by s, too.
  const double length = std::sqrt(1.0 + slope * slope), cube = length * length * length;
  // At the nose of loaded lines the slope is infinite, but like a logarithm: s times it is zero.
  return {{x - half * slope / length, mean_line(x) + half / length},
          {2.0 * s - rise * slope / length - half * bend / cube,
           2.0 * s * form_.mean_line.held_slopes(x, behind)[0] + rise / length -
               half * slope * bend / cube}};
}

// Those of the thickness, with one between any two, or evenly where it is one formula or two.
std::vector<double> SectionForm::even_knots() const {
  const std::vector<double> own = form_.thickness.knots();
  std::vector<double> all, joints;
  if (own.size() <= 3) {
    for (int i = 0; i <= kParts; ++i) all.push_back(static_cast<double>(i) / kParts);
    // Where two formulas meet there has to be a knot.
    joints.assign(own.begin() + 1, own.end() - 1);
  } else {
    for (std::size_t i = 0; i + 1 < own.size(); ++i) {
      all.push_back(own[i]);
      all.push_back(0.5 * (own[i] + own[i + 1]));
    }
    all.push_back(1.0);
  }
  for (const double x : form_.mean_line.joints()) joints.push_back(std::sqrt(x));
  std::vector<double> set{0.0, 1.0};
  for (const double joint : joints) set_joint(all, set, joint);
  return all;
}

void SectionForm::add_knots(double from, double to, int depth) {
  // Both sides have the same knots, as the plane ends of foils need them.
  const double error = std::max(largest_error(from, to, 1), largest_error(from, to, -1));
  if (error > kError && depth < kMostHalvings) {
    const double middle = 0.5 * (from + to);
    add_knots(from, middle, depth + 1);
    add_knots(middle, to, depth + 1);
  } else {
    knots_.push_back(to);
  }
}

// How far the cubic is beside the outline: along it another parameter does not matter.
double SectionForm::largest_error(double from, double to, int side) const {
  const std::array<Eigen::Vector2d, 4> cubic = outline_part(*this, from, to, side, 1.0);
  double largest = 0.0;
  for (const double t : {0.25, 0.5, 0.75}) {
    const Point point = outline(from + t * (to - from), side, 1.0, true);
    const Eigen::Vector2d off = on_cubic(cubic, t) - point.place;
    const Eigen::Vector2d along = point.slope.normalized();
    largest = std::max(largest, std::abs(along.x() * off.y() - along.y() * off.x()));
  }
  return largest;
}

std::array<Eigen::Vector2d, 4> outline_part(const SectionForm& form, double from, double to,
                                            int side, double factor) {
  // Of both ends the tangent within the part, whichever way it is run through.
  const SectionForm::Point a = form.outline(from, side, factor, to > from),
                           b = form.outline(to, side, factor, from > to);
  const double third = (to - from) / 3.0;
  return {a.place, a.place + third * a.slope, b.place - third * b.slope, b.place};
}

}  // namespace hull::analysis
