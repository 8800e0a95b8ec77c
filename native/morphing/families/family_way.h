// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "analysis/hydrostatics/hydrostatics.h"
#include "morphing/families/hull_family.h"

namespace hull::morphing {

// A way through a family: members with the weights (1 - t) from + t to, any t.
struct FamilyWay {
  std::vector<double> from, to;
};

// Volume and first moments of the whole hull, its openings closed, along a way. Points of surface
// and closings are linear in t, and volume is an integral of triple products of points and
// derivatives: a cubic in t; moments, of products of four, are quartics. So four and five
// evaluations tell all of them exactly; a sixth tells whether it is so. It is not where a closing
// changes its kind between the members, which `departure` tells.
//
// That is the volume up to the deck. What water at a draft displaces is none of these polynomials,
// as the water cuts members along other curves: t_of_displacement() looks for it step by step.
class WholeVolume {
 public:
  // Throws std::invalid_argument as HullFamily::points() does and where faces are turned inwards.
  WholeVolume(const HullFamily& family, const FamilyWay& way, bool mirrored);

  // Coefficients of 1, t, t² …: m³, and m⁴ of ∫ (x, y, z) dV.
  const Eigen::Vector4d& volume() const { return volume_; }
  const Eigen::Matrix<double, 3, 5>& moments() const { return moments_; }
  // By how much a member is off, as a part of volume: rounding, of polynomials; no number where
  // members have no volume.
  double departure() const { return departure_; }

  double volume_at(double t) const;
  Vector3d centre_at(double t) const;
  // All t between low and high, rising, at which the volume is as wanted, m³.
  std::vector<double> at_volume(double wanted, double low, double high) const;

 private:
  Eigen::Vector4d volume_;
  Eigen::Matrix<double, 3, 5> moments_;
  double departure_;
};

// How members lie in the water while a displacement is looked for: drafts between those at t = 0
// and at t = 1 in proportion.
struct WayWater {
  bool mirrored = true;
  analysis::Openings openings = analysis::Openings::kClosed;
  std::array<double, 2> drafts{};  // m
  double trim = 0.0;               // rad, by the stern
  double draft_at = 0.0;           // m: where drafts are measured
};

// A t between low and high at which members displace as wanted, m³, to 1e-12 in t or rounding; none
// where the displacement is on the same side of it in all of kWayStations places from low to high.
// Throws std::invalid_argument as HullBody::immersion() does.
std::optional<double> t_of_displacement(const HullFamily& family, const FamilyWay& way,
                                        const WayWater& water, double wanted, double low,
                                        double high);
inline constexpr int kWayStations = 9;

}  // namespace hull::morphing
