// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/splines/network_patches.h"

#include <algorithm>
#include <stdexcept>

#include "network/splines/curve_errors.h"
#include "network/splines/joined_quads.h"
#include "network/splines/patch_problems.h"

namespace hull::network {
namespace {

constexpr int kMostSpansAsked = 64;
// What fitting adds to curves that meet within the network's tolerance is to be little against it.
constexpr double kOfNetworksTolerance = 0.1;

void append(std::vector<double>& key, const Vector3d& value) {
  key.insert(key.end(), {value.x(), value.y(), value.z()});
}

// All that a region's patches depend on, but for numbers of edges.
std::vector<double> key_of(const RegionInput& input, const MergedRegion& region) {
  // Bit by bit: what differs by rounding is made again.
  std::vector<double> key{input.tolerance, static_cast<double>(input.spans)};
  const NetworkFrame& frame = *input.frame;
  for (int edge : region.references) {
    for (const Vector3d& point : input.edges.fitted[static_cast<std::size_t>(edge)].curve.points) {
      append(key, point);
    }
  }
  for (const RegionSide& side : region.sides) {
    key.push_back(static_cast<double>(side.size()));
    const std::vector<double> ends = side_ends(frame, side);
    key.insert(key.end(), ends.begin(), ends.end());
    for (const RegionEdge& edge : side) {
      const auto e = static_cast<std::size_t>(edge.edge);
      key.push_back(edge.is_along ? 1.0 : 0.0);
      // There normals do not count where references are.
      key.push_back(frame.faces.is_border(edge.edge) ? 1.0 : 0.0);
      for (const Vector3d& point : input.edges.fitted[e].curve.points) append(key, point);
      const NormalField& field = (edge.is_along ? frame.normals.left : frame.normals.right)[e];
      for (const Vector3d* part : {&field.start, &field.end, &field.start_slope, &field.end_slope})
        append(key, *part);
    }
  }
  return key;
}

// Patches of a region depend on its own sides alone, once splines and normals of edges are known:
// so regions are made one by one, and those that have not changed are taken over.
class PatchMaker {
 public:
  PatchMaker(const CurveNetwork& network, double tolerance, int spans, const NetworkPatches* before)
      : network_(network),
        edges_(edge_splines(network.frame(), tolerance)),
        // Refers to the splines, which are made before it.
        input_{network.shared_frame(), edges_, tolerance, spans},
        before_(before),
        known_(std::make_shared<NetworkPatches::Known>()),
        edge_errors_(edge_errors(network.frame(), edges_)),
        is_inner_(edges_.fitted.size(), false) {}

  NetworkPatches run() {
    for (const MergedRegion& region :
         merged_regions(network_.frame(), network_.regions(), reference_edges())) {
      add(region);
    }
    name_missed();
    tell_errors();
    JoinedQuads joined = joined_quads(network_.frame(), placed_);
    made_.set = std::move(joined.set);
    made_.edges = std::move(joined.edges);
    made_.known = std::move(known_);
    return std::move(made_);
  }

 private:
  std::vector<bool> reference_edges() const {
    std::vector<bool> is_reference;
    for (const CurveEdge& edge : network_.frame().joined.edges) {
      const NetworkCurve& curve = network_.curves()[static_cast<std::size_t>(edge.curve)];
      is_reference.push_back(curve.role == NetworkCurve::Role::kReference);
    }
    return is_reference;
  }

  void add(const MergedRegion& region) {
    for (int edge : region.references) is_inner_[static_cast<std::size_t>(edge)] = true;
    std::vector<double> key = key_of(input_, region);
    if (const RegionQuads* old = find(key)) {
      // Into a map of its own: what regions once were is not handed on without end.
      keep(region, known_->emplace(std::move(key), *old).first->second);
      return;
    }
    try {
      for (int one : region.regions) network_.check_region(one);
      RegionQuads quads = region_quads(input_, region);
      keep(region, known_->emplace(std::move(key), std::move(quads)).first->second);
    } catch (const std::invalid_argument& fault) {
      // The region stays open, is told of, and all others have their surfaces.
      made_.problems.push_back(open_region(network_.frame(), region.sides, fault.what()));
    }
  }

  const RegionQuads* find(const std::vector<double>& key) const {
    if (before_ == nullptr) return nullptr;
    const auto at = before_->known->find(key);
    return at == before_->known->end() ? nullptr : &at->second;
  }

  void keep(const MergedRegion& region, const RegionQuads& quads) {
    const NetworkFrame& frame = network_.frame();
    std::vector<RegionSide> sides = sides_of_one_curve(frame, region.sides);
    if (!quads.has_short_sides) sides = with_short_sides_joined(frame, std::move(sides));
    // By pointers, which hold: elements of a map stay where they are while others come.
    placed_.push_back({&quads, quad_borders(frame, sides, quads.is_single())});
    made_.spoke_error = std::max(made_.spoke_error, quads.spoke_error);
    // No border follows a reference: what counts is how far the patches are from it.
    for (std::size_t i = 0; i < region.references.size(); ++i) {
      edge_errors_[static_cast<std::size_t>(region.references[i])] = quads.reference_errors[i];
    }
    made_.regions.insert(made_.regions.end(), quads.patches.size(), region.regions.front());
    if (!quads.has_normals) made_.problems.push_back(loose_region(frame, region.sides));
    const auto worst = std::ranges::max_element(quads.reference_errors);
    if (worst != quads.reference_errors.end() && *worst > input_.tolerance) {
      const int edge =
          region.references[static_cast<std::size_t>(worst - quads.reference_errors.begin())];
      const int curve = frame.joined.edges[static_cast<std::size_t>(edge)].curve;
      made_.problems.push_back(
          missed_curve(network_.curves()[static_cast<std::size_t>(curve)].definition.name, curve,
                       edges_.place(frame, edge, 0.5), *worst));
    }
  }

  void name_missed() {
    // Each curve is told once, where it is missed by most.
    std::map<int, std::pair<double, Vector3d>> worst;  // of curves
    for (std::size_t e = 0; e < edges_.fitted.size(); ++e) {
      const double error = edges_.fitted[e].error;
      // Within a region no border is the edge's spline: keep() tells how far the patch is off it.
      if (error <= input_.tolerance || is_inner_[e]) continue;
      auto& curve = worst[network_.frame().joined.edges[e].curve];
      if (error > curve.first) curve = {error, edges_.fitted[e].curve.position(0.5)};
    }
    for (const auto& [curve, missed] : worst) {
      made_.problems.push_back(
          missed_curve(network_.curves()[static_cast<std::size_t>(curve)].definition.name, curve,
                       missed.second, missed.first));
    }
  }

  void tell_errors() {
    made_.curve_errors.assign(network_.curves().size(), 0.0);
    for (std::size_t e = 0; e < edge_errors_.size(); ++e) {
      double& of_curve =
          made_.curve_errors[static_cast<std::size_t>(network_.frame().joined.edges[e].curve)];
      of_curve = std::max(of_curve, edge_errors_[e]);
    }
  }

  const CurveNetwork& network_;
  EdgeSplines edges_;
  RegionInput input_;
  const NetworkPatches* before_;
  std::shared_ptr<NetworkPatches::Known> known_;
  std::vector<double> edge_errors_;
  std::vector<bool> is_inner_;  // of edges: references within a region
  std::vector<PlacedQuads> placed_;
  NetworkPatches made_;
};

}  // namespace

double NetworkPatches::largest_curve_error() const {
  return curve_errors.empty() ? 0.0 : *std::ranges::max_element(curve_errors);
}

NetworkPatches network_patches(const CurveNetwork& network, const PatchOptions& options,
                               const NetworkPatches* before) {
  if (options.spans < 1 || options.spans > kMostSpansAsked) {
    throw std::invalid_argument("spans must be from 1 to " + std::to_string(kMostSpansAsked) + ".");
  }
  if (!(options.tolerance >= 0.0)) {
    throw std::invalid_argument("The patches' tolerance must not be below zero.");
  }
  const double tolerance =
      options.tolerance > 0.0 ? options.tolerance : kOfNetworksTolerance * network.tolerance();
  return PatchMaker(network, tolerance, options.spans, before).run();
}

}  // namespace hull::network
