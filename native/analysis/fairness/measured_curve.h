// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "surface/pieces/bicubic.h"

namespace hull::analysis {

// A point of a curve and how it bends there.
struct CurveSample {
  Vector3d point = Vector3d::Zero();
  Vector3d tangent = Vector3d::Zero();    // unit; zero where there is none
  Vector3d curvature = Vector3d::Zero();  // vector towards the centre of curvature, 1/m
  // Of a curve judged in a plane: positive where it turns left, seen against the plane's normal.
  // Of a space curve the vector's length.
  double signed_curvature = 0.0;
};

// Of the stretch from one break of a curve to the next.
inline constexpr int kMostProbedParts = 4;

// A curve without knuckles, by its arc length (m) from 0 to length().
class MeasuredCurve {
 public:
  virtual ~MeasuredCurve() = default;

  double length() const { return breaks_.back(); }
  // It ends where it begins, and goes on smoothly there.
  bool closed() const { return closed_; }
  // Arc lengths from 0 to length(), rising: between two of them the curve is as smooth as can be.
  const std::vector<double>& breaks() const { return breaks_; }

  // REQUIRES: 0 <= s <= length().
  virtual CurveSample at(double s) const = 0;

  // The signed curvature at part / parts of the way from break k to the next. A curve may keep it.
  // REQUIRES: 0 < part < parts <= kMostProbedParts.
  virtual double curvature_between(int k, int part, int parts) {
    return at(breaks_[k] + (breaks_[k + 1] - breaks_[k]) * part / parts).signed_curvature;
  }

 protected:
  MeasuredCurve(std::vector<double> breaks, bool closed)
      : breaks_(std::move(breaks)), closed_(closed) {}

  std::vector<double> breaks_;
  bool closed_;
};

}  // namespace hull::analysis
