// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/families/family_way.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/arithmetic/bezier.h"
#include "analysis/arithmetic/bracketed_root.h"

namespace hull::morphing {
namespace {

// Where members are measured: the volume's cubic goes through the first four, the moments' quartics
// through five, and the last tells whether they are right.
constexpr std::array<double, 6> kNodes{0.0, 0.25, 0.75, 1.0, 0.5, 0.375};
// Of an interval of t, and of the volume at its beginning: a root there is found from both sides,
// and differs by rounding.
constexpr double kSameRoot = 1e-12;
constexpr double kWayTolerance = 1e-12;  // of t, which is of the order of 1: some roundings

// Members of a family along a way, as bodies: one after the other, the same surface moved.
class WayBody {
 public:
  WayBody(const HullFamily& family, const FamilyWay& way, bool mirrored,
          analysis::Openings openings)
      : family_(family),
        way_(way),
        surface_(family.parents()[0]),
        body_(moved(0.0), mirrored, openings) {}
  // The body refers to this object's surface.
  WayBody(const WayBody&) = delete;
  WayBody& operator=(const WayBody&) = delete;

  const surface::LimitSurface& surface() const { return surface_; }

  void go_to(double t) {
    moved(t);
    body_.update();
  }
  analysis::Immersion below(const analysis::Plane& water) const { return body_.immersion(water); }

 private:
  const surface::LimitSurface& moved(double t) {
    // From both ends each time, and not from the member before, so that rounding does not add up.
    const std::vector<Vector3d> a = family_.points(way_.from), b = family_.points(way_.to);
    std::vector<Vector3d> points(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) points[i] = (1.0 - t) * a[i] + t * b[i];
    surface_.set_points(std::move(points));
    return surface_;
  }

  const HullFamily& family_;
  const FamilyWay& way_;
  surface::LimitSurface surface_;
  analysis::HullBody body_;
};

// Above all of a surface.
analysis::Plane plane_above(const surface::LimitSurface& surface) {
  // The surface lies within the hull of its control points.
  double top = surface.mesh().points().front().z();
  for (const Vector3d& p : surface.mesh().points()) top = std::max(top, p.z());
  return {Vector3d::UnitZ(), top + 1e-3 * surface.mesh().size()};
}

// Coefficients of 1, t, t² … of the polynomials through values (rows) at the first nodes.
template <int kCount>
Eigen::Matrix<double, kCount, 3> through_nodes(const Eigen::Matrix<double, kCount, 3>& values) {
  Eigen::Matrix<double, kCount, kCount> powers;
  for (int i = 0; i < kCount; ++i) {
    for (int j = 0; j < kCount; ++j) powers(i, j) = std::pow(kNodes[i], j);
  }
  return powers.fullPivLu().solve(values);
}

double polynomial(const Eigen::Vector4d& c, double t) {
  return c[0] + t * (c[1] + t * (c[2] + t * c[3]));
}

// The Bézier coefficients of the cubic on an interval, less a value.
analysis::BezierCubic on_interval(const Eigen::Vector4d& c, double low, double high, double less) {
  const double h = high - low, start = polynomial(c, low) - less;
  // Taylor's terms from the lower end, with the width's powers in them.
  const double d1 = h * (c[1] + low * (2.0 * c[2] + 3.0 * low * c[3]));
  const double d2 = h * h * (2.0 * c[2] + 6.0 * low * c[3]), d3 = 6.0 * h * h * h * c[3];
  return {start, start + d1 / 3.0, start + 2.0 * d1 / 3.0 + d2 / 6.0,
          start + d1 + d2 / 2.0 + d3 / 6.0};
}

}  // namespace

WholeVolume::WholeVolume(const HullFamily& family, const FamilyWay& way, bool mirrored) {
  WayBody body(family, way, mirrored, analysis::Openings::kClosed);
  std::array<double, kNodes.size()> volumes;
  std::array<Vector3d, kNodes.size()> moments;
  for (std::size_t i = 0; i < kNodes.size(); ++i) {
    body.go_to(kNodes[i]);
    // All of it under water: the volume up to the deck.
    const analysis::Immersion whole = body.below(plane_above(body.surface()));
    volumes[i] = whole.volume;
    // Moments are polynomials, centres quotients of them.
    moments[i] = whole.volume * whole.centre_of_buoyancy;
  }
  Eigen::Matrix<double, 4, 3> of_volume = Eigen::Matrix<double, 4, 3>::Zero();
  // One column of three: moments take all.
  for (int i = 0; i < 4; ++i) of_volume(i, 0) = volumes[i];
  volume_ = through_nodes<4>(of_volume).col(0);
  Eigen::Matrix<double, 5, 3> of_moments;
  for (int i = 0; i < 5; ++i) of_moments.row(i) = moments[i].transpose();
  moments_ = through_nodes<5>(of_moments).transpose();
  departure_ = 0.0;
  // What is no number, as of members without volume, is the most, and stays.
  const auto take = [this](double off) {
    if (!(off <= departure_)) departure_ = off;
  };
  for (std::size_t i = 4; i < kNodes.size(); ++i) {
    // Nodes that the cubic was not made of.
    take(std::abs(volume_at(kNodes[i]) - volumes[i]) / std::abs(volumes[i]));
  }
  // Five nodes make the quartics: only the sixth tells of them.
  const double t = kNodes.back();
  const Vector3d centre = moments.back() / volumes.back();
  const double size = family.parents()[0].mesh().size();
  take((centre_at(t) - centre).norm() / size);
}

double WholeVolume::volume_at(double t) const { return polynomial(volume_, t); }

Vector3d WholeVolume::centre_at(double t) const {
  Eigen::Matrix<double, 5, 1> powers;
  for (int j = 0; j < 5; ++j) powers[j] = std::pow(t, j);
  return moments_ * powers / volume_at(t);
}

std::vector<double> WholeVolume::at_volume(double wanted, double low, double high) const {
  if (!(low < high) || !std::isfinite(high - low) || !std::isfinite(wanted)) {
    throw std::invalid_argument("A range of t goes from a lower to a higher number.");
  }
  const analysis::BezierCubic cubic = on_interval(volume_, low, high, wanted);
  std::vector<double> found;
  const double rounding = kSameRoot * std::abs(volume_at(low));
  // A root at the beginning is none of the signs' changes.
  const bool has_low = std::abs(cubic[0]) <= rounding;
  if (has_low) found.push_back(low);
  for (double root : analysis::sign_changes(cubic)) {
    const double t = low + (high - low) * root;
    // Where the volume is the wanted one to rounding all the way from there it is the same root:
    // half way is where it would be off.
    const bool is_low =
        has_low && found.size() == 1 && std::abs(analysis::evaluate(cubic, 0.5 * root)) <= rounding;
    if (is_low) continue;
    if (found.empty() || t - found.back() > kSameRoot * (high - low)) found.push_back(t);
  }
  return found;
}

std::optional<double> t_of_displacement(const HullFamily& family, const FamilyWay& way,
                                        const WayWater& water, double wanted, double low,
                                        double high) {
  if (!(low < high) || !std::isfinite(high - low) || !std::isfinite(wanted)) {
    throw std::invalid_argument("A range of t goes from a lower to a higher number.");
  }
  WayBody body(family, way, water.mirrored, water.openings);
  const auto excess = [&](double t) {
    body.go_to(t);
    // The draft goes along with the member.
    const double draft = (1.0 - t) * water.drafts[0] + t * water.drafts[1];
    const analysis::Plane plane = analysis::water_plane({draft, water.trim, 0.0, water.draft_at});
    return body.below(plane).volume - wanted;
  };
  // No polynomial, and perhaps of several roots: the first change of sign among a few stations.
  double before = low, at_before = excess(low);
  for (int i = 1; i < kWayStations; ++i) {
    const double t = i + 1 == kWayStations ? high : low + (high - low) * i / (kWayStations - 1);
    const double at_t = excess(t);
    if (at_before == 0.0 || (at_before > 0.0) != (at_t > 0.0) || at_t == 0.0) {
      return analysis::bracketed_root(excess, before, at_before, t, at_t, kWayTolerance);
    }
    before = t;
    at_before = at_t;
  }
  return std::nullopt;
}

}  // namespace hull::morphing
