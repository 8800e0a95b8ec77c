// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>
#include <vector>

#include "analysis/derivatives/body_derivatives.h"
#include "analysis/immersion/body_stamp.h"
#include "analysis/immersion/floating_position.h"
#include "analysis/immersion/hull_body.h"
#include "analysis/immersion/sea_water.h"
#include "resistance/immersed_shell.h"
#include "resistance/source_grid.h"

namespace hull::resistance {

inline constexpr double kGravity = 9.80665;     // m/s², standard
inline constexpr double kWaveTolerance = 1e-3;  // of the resistance, what short waves may add

// Wave resistance at a speed.
struct WaveResistance {
  double speed;       // m/s
  double resistance;  // kN
  // kN: a bound, from the last octave, of what waves shorter than the shortest one add: amplitudes
  // fall off no slower than from a blunt end, and the integrand as λ⁻³. Infinite where less than an
  // octave was taken.
  double error;
  double shortest;  // the largest λ, 1 / cos of the wave's direction, that was taken
};

// Michell's integral for the wave resistance of a thin ship (Michell 1898; as in Wehausen & Laitone
// 1960, equation 20.78): with ν = g / U², the depth d and half breadths' slopes n_x dS,
//
//   R = 4 ρ g² / (π U²) ∫₁^∞ |I(λ)|² λ² / √(λ² - 1) dλ,   I(λ) = ∬ exp(-ν λ² d + i ν λ x) n_x dS
//
// over the exact wetted shell of one side. Closings are left out: behind an open transom the water
// is taken to leave straight. The shell's two sides are taken together for whole hulls, and what
// lies beside the centre plane counts as if it lay in it. Thin-ship theory knows neither viscosity
// nor sinkage and trim.
//
// The shell is integrated and its waves are summed to about 1e-9 of the sums of moduli; where waves
// become short the integral ends once `tolerance` of it is held by the bound of what is left.
// Queries are thread-safe.
class MichellIntegral {
 public:
  // `body` must outlive it; once its surface's points were set, or it was updated or joined to
  // others, all queries throw std::invalid_argument. So does this for numbers that are not
  // finite, a heel, a density, gravity or tolerance that is not positive, for what
  // HullBody::immersion() refuses, and for a hull that is out of the water or, as a catamaran's,
  // wholly beside the centre plane.
  MichellIntegral(const analysis::HullBody& body, const analysis::FloatingPosition& position,
                  double water_density = analysis::kSeaWaterDensity, double gravity = kGravity,
                  double tolerance = kWaveTolerance);

  // Speeds in m/s, each with its result; they share what does not depend on the speed. Throws
  // std::invalid_argument for speeds that are not finite, or whose Froude number on length()
  // is below 0.05 or above 5.
  std::vector<WaveResistance> resistance(const std::vector<double>& speeds) const;

  // The same at one speed of waves up to λ = `shortest`, as nearly as whole intervals come to it,
  // whatever is left then: it varies smoothly with the hull's form. Throws besides where `shortest`
  // is not above 1, or so large that such waves are too many along the ship.
  WaveResistance resistance_to(double speed, double shortest) const;

  // Derivatives of the resistance by the control points, kN/m, the water and the shortest wave
  // staying as they are: that at which resistance() ends, or that of resistance_to().
  // `derivatives`: of the body, otherwise throws, and for `shortest` as resistance_to() does. Of a
  // mirrored body both sides count.
  analysis::Gradient gradient(const analysis::BodyDerivatives& derivatives, double speed) const;
  analysis::Gradient gradient_to(const analysis::BodyDerivatives& derivatives, double speed,
                                 double shortest) const;

  // The free-wave spectrum A(θ) = (2 ν / π) I(1 / cos θ) / cos³ θ, m, of directions θ in rad, below
  // 89°: far behind the ship the water is at
  // ζ = Re ∫ A(θ) exp(-i ν (x cos θ + y sin θ) / cos² θ) dθ over (-π/2, π/2), and
  // R = π/2 ρ U² ∫ |A|² cos³ θ dθ (Eggers, Sharma & Ward 1967; Tuck, Scullen & Lazauskas 2002).
  std::vector<std::complex<double>> amplitudes(double speed,
                                               const std::vector<double>& directions) const;

  // m, of the control mesh.
  double length() const {
    require_current();
    return forward_ - aft_;
  }

 private:
  void require_current() const { stamp_.require_current("Michell's integral"); }
  // ν, checked.
  double wave_number(double speed) const;
  // Of the waves up to λ = shortest of a ship that runs with ν.
  struct WaveRange {
    double nu, shortest;
  };
  WaveScales scales_for(const std::vector<WaveRange>& ranges) const;
  WaveScales scales_to(double nu, double shortest) const;
  SourceGrid sources(const WaveScales& scales) const;
  // kN of the integral for ν.
  double factor(double nu) const;
  double side_factor() const { return body_->mirrored() ? 1.0 : 0.5; }

  const analysis::HullBody* body_;
  analysis::BodyStamp stamp_;
  WayFrame frame_;
  double density_, gravity_, tolerance_;
  double aft_, forward_, deepest_;  // m, of the mesh, along and below the water
};

}  // namespace hull::resistance
