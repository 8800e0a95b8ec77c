// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/features/layout_start.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "modelling/reshape/reshape.h"

namespace hull::morphing {
namespace {

// So stiff that nothing but bending decides on moves between what is prescribed.
constexpr double kStiff = 10.0;
constexpr int kFewestPoints = 9;  // of a counterpart's stretch

// The length along a feature at a control point of one of its chains, by the chain's own direction.
double length_at(const FeatureGraph& graph, const Feature& feature, std::size_t k, double t) {
  const surface::CreaseCurve& chain = graph.curves[feature.chains[k]];
  // A line may come near itself: the foot is kept to the chain that the point is of.
  const double from_begin = feature.curve.foot(chain.evaluate(t, 0).point).length;
  return std::clamp(from_begin, feature.lengths[k], feature.lengths[k + 1]);
}

// Shifts of control points of paired features, from where the box has brought them.
std::map<int, Vector3d> feature_shifts(const FeatureGraph& graph, const FeatureGraph& other,
                                       const FeatureMatch& match) {
  std::map<int, Vector3d> shifts;
  for (const FeaturePair& pair : match.pairs) {
    const Feature &f = graph.features[pair.first], &g = other.features[pair.second];
    const LengthMap map = length_map(graph, other, match, pair);
    for (std::size_t k = 0; k < f.chains.size(); ++k) {
      const surface::CreaseCurve& chain = graph.curves[f.chains[k]];
      for (std::size_t i = 0; i < chain.vertices().size(); ++i) {
        const double t = static_cast<double>(i);
        // What a limit point lacks its control point is shifted by: whole lines of them go along.
        const Vector3d here = other.box.absolute(graph.box.relative(chain.evaluate(t, 0).point));
        const Vector3d there = g.curve.point_at(map(length_at(graph, f, k, t)));
        // Where lines meet the first one decides.
        shifts.emplace(chain.vertices()[i], there - here);
      }
    }
  }
  return shifts;
}

}  // namespace

std::vector<Vector3d> in_box(const std::vector<Vector3d>& points, const HullBox& from,
                             const HullBox& to) {
  std::vector<Vector3d> scaled;
  for (const Vector3d& p : points) scaled.push_back(to.absolute(from.relative(p)));
  return scaled;
}

std::vector<Vector3d> points_near(const surface::LimitSurface& surface, const FeatureGraph& graph,
                                  const FeatureGraph& other, const FeatureMatch& match,
                                  const std::vector<int>& held) {
  std::vector<Vector3d> points = in_box(surface.mesh().points(), graph.box, other.box);
  const std::map<int, Vector3d> shifts = feature_shifts(graph, other, match);
  if (shifts.empty()) return points;
  surface::LimitSurface scaled = surface;
  scaled.set_points(points);
  modelling::ReshapeOptions options;
  options.stiffness = kStiff;
  std::vector<char> is_held(points.size(), 0);
  for (int v : held) is_held[v] = 1;
  std::vector<Vector3d> prescribed;
  for (const auto& [v, shift] : shifts) {
    options.limits.prescribed.push_back(v);
    // What is in the centre plane stays there, wherever its line goes.
    prescribed.push_back(is_held[v] ? Vector3d(shift.x(), 0.0, shift.z()) : shift);
  }
  for (int v : held) {
    // Others of the centre plane go anywhere within it.
    if (!shifts.count(v)) options.limits.limits.held.push_back({v, Vector3d::UnitY()});
  }
  const modelling::Reshape reshape(scaled, options);
  // Nothing is wanted of the surface: the rest goes with what is prescribed by bending alone.
  const std::vector<Vector3d> none(reshape.places().count(), Vector3d::Zero());
  const modelling::Reshaped found = reshape.solve(none, prescribed);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] += found.moves[i];
  return points;
}

std::vector<modelling::FitCurve> counterpart_curves(const FeatureGraph& graph,
                                                    const FeatureGraph& other,
                                                    const FeatureMatch& match, double spacing) {
  std::vector<modelling::FitCurve> curves;
  for (const FeaturePair& pair : match.pairs) {
    const Feature &f = graph.features[pair.first], &g = other.features[pair.second];
    const LengthMap map = length_map(graph, other, match, pair);
    for (std::size_t k = 0; k < f.chains.size(); ++k) {
      const double begin = map(f.lengths[k]), end = map(f.lengths[k + 1]);
      const int count = std::max(kFewestPoints, 1 + static_cast<int>((end - begin) / spacing));
      modelling::FitCurve curve;
      for (int i = 0; i < count; ++i) {
        const double length = i + 1 == count ? end : begin + (end - begin) * i / (count - 1);
        curve.points.push_back(g.curve.point_at(length));
      }
      // In the chain's own direction.
      if (f.is_backward[k]) std::reverse(curve.points.begin(), curve.points.end());
      curve.chain = f.chains[k];
      curve.whole = !graph.curves[f.chains[k]].closed();
      curves.push_back(std::move(curve));
    }
  }
  return curves;
}

}  // namespace hull::morphing
