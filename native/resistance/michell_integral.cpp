// SPDX-License-Identifier: GPL-3.0-or-later
#include "resistance/michell_integral.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "analysis/derivatives/corner_derivatives.h"
#include "analysis/hydrostatics/hydrostatics_check.h"
#include "mesh/tolerances.h"
#include "resistance/wave_sums.h"

namespace hull::resistance {
namespace {

using analysis::PointColumns;
using analysis::SpanNode;

constexpr double kLeastFroude = 0.05, kMostFroude = 5.0;
constexpr double kFirstShortest = 16.0, kMostShortest = 128.0;  // λ
// From one grid of sources to a finer one λ grows by so much; beyond where the error is expected to
// have fallen by a share, for it does so in waves.
constexpr double kLeastGrowth = 1.25, kMostGrowth = 8.0, kBeyond = 1.12;
constexpr double kLeastFall = 1.5, kMostFall = 4.0;
constexpr double kRounded = 1.0 + 1e-9;  // of λ, so that an interval that ends there counts
constexpr double kMostTurns = 2e4;  // the phase between the ship's ends of the shortest wave, rad
constexpr double kSteepest = 89.0 / 180.0 * std::numbers::pi;

// How far an integral has to be taken to settle, by how its error has fallen off so far.
double expected_shortest(const WaveIntegral& integral, double tolerance) {
  const double fall = std::clamp(integral.fall, kLeastFall, kMostFall);
  const double excess = integral.error / (tolerance * integral.value);
  return kBeyond * integral.shortest * std::pow(std::max(excess, 1.0), 1.0 / fall);
}

void require_positive(double value, const char* name) {
  if (!(value > 0.0) || !std::isfinite(value)) {
    throw std::invalid_argument(std::string("The ") + name + " must be a number above zero.");
  }
}

// Whether an edge of the control mesh that reaches below the water touches or crosses the centre
// plane.
bool is_on_centre_plane(const mesh::ControlMesh& mesh, const analysis::Plane& water) {
  const mesh::Topology& topology = mesh.topology();
  const double near = kAtCentreLine * mesh.size();
  for (int face = 0; face < topology.face_count(); ++face) {
    const int first = topology.first_half_edge(face);
    for (int h = first; h < first + topology.face_size(face); ++h) {
      const Vector3d& a = mesh.points()[topology.origin(h)];
      const Vector3d& b = mesh.points()[topology.origin(topology.next(h))];
      // What joins the hulls of a catamaran above the water does not put them on the plane.
      if (std::min(water.height(a), water.height(b)) >= 0.0) continue;
      if (a.y() * b.y() <= 0.0 || std::min(std::abs(a.y()), std::abs(b.y())) <= near) return true;
    }
  }
  return false;
}

class Spreading : public ShellVisitor {
 public:
  Spreading(const WayFrame& frame, double factor, SourceGrid& grid)
      : frame_(frame), factor_(factor), grid_(grid) {}

  void at_node(const SpanNode& node, double weight) override {
    grid_.add(frame_.x(node.point), frame_.depth(node.point),
              factor_ * weight * frame_.ahead.dot(node.normal));
  }

 private:
  const WayFrame& frame_;
  double factor_;
  SourceGrid& grid_;
};

// Of ∬ φ(x, d) n_x dS by a span's points, φ that of a grid.
class SpreadingDerivatives : public ShellVisitor {
 public:
  SpreadingDerivatives(const WayFrame& frame, double factor, const SourceGrid& grid,
                       PointColumns& columns)
      : frame_(frame), factor_(factor), grid_(grid), columns_(columns) {}

  void at_node(const SpanNode& node, double weight) override {
    const SourceGrid::Jet jet = grid_.at(frame_.x(node.point), frame_.depth(node.point));
    const double w = factor_ * weight;
    // Depth grows against the water's normal.
    const Vector3d by_place = jet.by_x * frame_.ahead - jet.by_depth * frame_.water.normal;
    // The triple product ahead · (S_u x S_v), by S_u and by S_v, in cyclic order.
    columns_ += node.at * (w * frame_.ahead.dot(node.normal) * by_place).transpose() +
                node.du * (w * jet.value * node.along_v.cross(frame_.ahead)).transpose() +
                node.dv * (w * jet.value * frame_.ahead.cross(node.along_u)).transpose();
  }

  void at_water(const SpanNode& node, double weight) override {
    const double value = grid_.at(frame_.x(node.point), 0.0).value;
    // Where the shell rises a strip of it leaves the water.
    columns_ -= node.at * (factor_ * weight * value * frame_.ahead.dot(node.normal) *
                           frame_.water.normal.transpose());
  }

 private:
  const WayFrame& frame_;
  double factor_;
  const SourceGrid& grid_;
  PointColumns& columns_;
};

}  // namespace

MichellIntegral::MichellIntegral(const analysis::HullBody& body,
                                 const analysis::FloatingPosition& position, double water_density,
                                 double gravity, double tolerance)
    : body_(&body),
      stamp_(body),
      density_(water_density),
      gravity_(gravity),
      tolerance_(tolerance) {
  analysis::check_hydrostatics(position, {}, water_density);
  require_positive(gravity, "gravity");
  require_positive(tolerance, "tolerance");
  if (position.heel != 0.0) {
    throw std::invalid_argument(
        "Michell's integral is for upright ships: set the heel to zero for the wave resistance.");
  }
  const double size = body.surface().mesh().size();
  frame_ = {analysis::water_plane(position), analysis::forward_direction(position.trim, 0.0),
            kZeroHeight * size};
  if (!(body.immersion(frame_.water).volume > 0.0)) {
    throw std::invalid_argument("The hull is out of the water at a draft of " +
                                std::to_string(position.draft) +
                                " m: without immersion it has no wave resistance; set the draft.");
  }
  if (!is_on_centre_plane(body.surface().mesh(), frame_.water)) {
    throw std::invalid_argument(
        "All of the hull lies beside the centre plane: Michell's integral is for hulls on it. Move "
        "one hull of a catamaran there; what both do to each other's waves is then left out.");
  }
  const mesh::ControlMesh& mesh = body.surface().mesh();
  const mesh::Topology& topology = mesh.topology();
  // Of the faces' control points, whose convex hull holds the surface: no source lies beside the
  // grid.
  aft_ = forward_ = frame_.x(mesh.points()[topology.origin(0)]);
  deepest_ = 0.0;
  for (int h = 0; h < topology.half_edge_count(); ++h) {
    const Vector3d& p = mesh.points()[topology.origin(h)];
    aft_ = std::min(aft_, frame_.x(p));
    forward_ = std::max(forward_, frame_.x(p));
    deepest_ = std::max(deepest_, frame_.depth(p));
  }
}

double MichellIntegral::wave_number(double speed) const {
  const double froude = speed / std::sqrt(gravity_ * length());
  // Asked in this way, NaN is refused, too.
  if (!(froude >= kLeastFroude && froude <= kMostFroude)) {
    throw std::invalid_argument(
        "The speed of " + std::to_string(speed) + " m/s is no speed for Michell's integral: on " +
        std::to_string(length()) + " m the Froude number must be from 0.05 to 5.");
  }
  return gravity_ / (speed * speed);
}

WaveScales MichellIntegral::scales_for(const std::vector<WaveRange>& ranges) const {
  WaveScales scales{0.0, 0.0, 0.0};
  const double reach = WaveSums::least_reach(length());
  for (const auto& [nu, shortest] : ranges) {
    // Integrals go on for a few intervals of k, however long the waves that are asked for.
    const double along = std::max(nu * shortest, reach);
    scales.slowest = std::max(scales.slowest, nu);
    scales.along = std::max(scales.along, along);
    scales.decay = std::max(scales.decay, along * along / nu);
  }
  return scales;
}

SourceGrid MichellIntegral::sources(const WaveScales& scales) const {
  SourceGrid grid(aft_, forward_, deepest_, scales);
  Spreading spreading(frame_, side_factor(), grid);
  visit_shell(*body_, frame_, scales, spreading);
  grid.take_all();
  return grid;
}

std::vector<WaveResistance> MichellIntegral::resistance(const std::vector<double>& speeds) const {
  require_current();
  std::vector<WaveRange> ranges;
  for (double speed : speeds) ranges.push_back({wave_number(speed), kFirstShortest});
  std::vector<WaveResistance> results(speeds.size());
  std::vector<WaveIntegral> integrals(speeds.size());
  std::vector<std::size_t> open(speeds.size());
  for (std::size_t i = 0; i < open.size(); ++i) open[i] = i;
  while (!open.empty()) {
    std::vector<WaveRange> own;
    for (std::size_t i : open) own.push_back(ranges[i]);
    // All speeds that are left share the next grid.
    const SourceGrid grid = sources(scales_for(own));
    WaveSums sums(grid);
    std::vector<std::size_t> unsettled;
    for (std::size_t i : open) {
      auto& [nu, shortest] = ranges[i];
      // What was summed on a coarser grid goes along.
      integrals[i] = sums.integral(nu, tolerance_, shortest, std::move(integrals[i]));
      const WaveIntegral& integral = integrals[i];
      results[i] = {speeds[i], factor(nu) * integral.value, factor(nu) * integral.error,
                    integral.shortest};
      const double most = kMostTurns / (nu * length());
      if (integral.settled || shortest >= kMostShortest || kLeastGrowth * shortest > most) continue;
      const double next =
          std::max(expected_shortest(integral, tolerance_), kLeastGrowth * shortest);
      shortest = std::min({next, kMostGrowth * shortest, kMostShortest, most});
      unsettled.push_back(i);
    }
    open = std::move(unsettled);
  }
  return results;
}

double MichellIntegral::factor(double nu) const {
  return 4.0 * density_ * gravity_ * nu / std::numbers::pi;
}

// Checks `shortest`.
WaveScales MichellIntegral::scales_to(double nu, double shortest) const {
  if (!(shortest > 1.0) || !std::isfinite(shortest) || nu * shortest * length() > kMostTurns) {
    throw std::invalid_argument("The shortest wave's λ must be a number above 1, and not beyond " +
                                std::to_string(kMostTurns / (nu * length())) + " at this speed.");
  }
  // At low speeds the integral's beginning alone may take waves that are shorter.
  const double taken = WaveSums::first_reach(nu, length()) / nu;
  return scales_for({{nu, std::max(shortest * kRounded, taken)}});
}

WaveResistance MichellIntegral::resistance_to(double speed, double shortest) const {
  const double nu = wave_number(speed);
  const SourceGrid grid = sources(scales_to(nu, shortest));
  const WaveIntegral integral = WaveSums(grid).integral(nu, 0.0, shortest * kRounded);
  return {speed, factor(nu) * integral.value, factor(nu) * integral.error, integral.shortest};
}

analysis::Gradient MichellIntegral::gradient(const analysis::BodyDerivatives& derivatives,
                                             double speed) const {
  return gradient_to(derivatives, speed, resistance({speed})[0].shortest);
}

analysis::Gradient MichellIntegral::gradient_to(const analysis::BodyDerivatives& derivatives,
                                                double speed, double shortest) const {
  const double nu = wave_number(speed);
  if (&derivatives.body() != body_) {
    throw std::invalid_argument(
        "The derivatives are another body's: give those of the body that Michell's integral is "
        "of.");
  }
  const WaveScales scales = scales_to(nu, shortest);
  SourceGrid grid = sources(scales);
  // From here on the grid holds φ, by which R changes with a source at each place.
  take_derivatives(WaveSums(grid).integral(nu, 0.0, shortest * kRounded), grid);
  const double factor = side_factor() * this->factor(nu);
  const surface::LimitSurface& surface = body_->surface();
  const surface::SurfaceLayout& layout = surface.layout();
  analysis::SurfaceAdjoint::Sum sum(derivatives.adjoint(), 1);
  const auto add_span = [&](const surface::BicubicPoints& points, PointColumns& columns) {
    SpreadingDerivatives spreading(frame_, factor, grid, columns);
    visit_span(points, frame_, scales, spreading);
  };
  for (int leaf = 0; leaf < layout.leaf_count(); ++leaf) {
    PointColumns columns = PointColumns::Zero(16, 3);
    add_span(surface.leaf(leaf), columns);
    sum.add_leaf(leaf, std::move(columns));
  }
  const auto deeper = [&](const std::vector<Vector3d>& points) {
    return goes_on(points, frame_, surface.mesh().size());
  };
  for (int corner = 0; corner < layout.corner_count(); ++corner) {
    const surface::CornerPoints& points = surface.corner(corner);
    if (!deeper(points.outer)) continue;
    sum.add_corner(corner,
                   analysis::corner_derivatives(layout.basis(corner), points, 3, deeper, add_span));
  }
  return sum.by_control_points();
}

std::vector<std::complex<double>> MichellIntegral::amplitudes(
    double speed, const std::vector<double>& directions) const {
  const double nu = wave_number(speed);
  if (directions.empty()) return {};
  std::vector<double> along;
  for (double direction : directions) {
    if (!(std::abs(direction) < kSteepest)) {
      throw std::invalid_argument("Directions of waves must be within 89° of the ship's course.");
    }
    along.push_back(nu / std::cos(direction));
  }
  const double most = *std::max_element(along.begin(), along.end());
  const SourceGrid grid = sources(scales_for({{nu, most / nu}}));
  std::vector<std::complex<double>> amplitudes = WaveSums(grid).amplitudes(nu, along);
  for (std::size_t i = 0; i < along.size(); ++i) {
    amplitudes[i] *= 2.0 * nu / std::numbers::pi * std::pow(along[i] / nu, 3);
  }
  return amplitudes;
}

}  // namespace hull::resistance
