// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/model/curve_network.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "network/joining/connected_part.h"
#include "network/model/problem_texts.h"

namespace hull::network {
namespace {

constexpr std::size_t kMostSidesOfRegion = 10;

bool is_knuckle(const NetworkCurve& curve) { return curve.kind == NetworkCurve::Kind::kKnuckle; }

}  // namespace

CurveNetwork::CurveNetwork(std::vector<NetworkCurve> curves, const NetworkOptions& options)
    : CurveNetwork(std::move(curves), options, nullptr) {}

CurveNetwork::CurveNetwork(std::vector<NetworkCurve> curves, const NetworkOptions& options,
                           const CurveNetwork* before)
    : curves_(std::move(curves)), options_(options), frame_(std::make_shared<NetworkFrame>()) {
  if (!(options.plane_angle >= 0.0) || !(options.plane_angle < 0.5 * std::numbers::pi)) {
    throw std::invalid_argument("plane_angle must be from 0 to less than a right angle.");
  }
  if (make_shapes()) join(before);
  // What prevents a surface comes before what is only worth knowing.
  std::ranges::stable_sort(problems_, {}, &NetworkProblem::is_note);
}

const std::string& CurveNetwork::name(int curve) const {
  return curves_[static_cast<std::size_t>(curve)].definition.name;
}

std::vector<std::string> CurveNetwork::names() const {
  std::vector<std::string> all;
  for (const NetworkCurve& curve : curves_) all.push_back(curve.definition.name);
  return all;
}

bool CurveNetwork::make_shapes() {
  std::vector<CurveDefinition> definitions;
  for (std::size_t i = 0; i < curves_.size(); ++i) {
    // Here, where each point off its plane is told with its place: network_curve_shapes() stops at
    // the first.
    definitions.push_back(curves_[i].definition);
    for (NetworkProblem& off :
         points_off_plane(definitions.back(), static_cast<int>(i), options_.joining.tolerance)) {
      problems_.push_back(std::move(off));
    }
  }
  if (!problems_.empty()) return false;
  try {
    shapes_ = network_curve_shapes(definitions, options_.joining.tolerance);
  } catch (const std::invalid_argument& fault) {
    problems_.push_back({NetworkProblem::Kind::kShape, fault.what(), {}, {}});
    return false;
  }
  return true;
}

KnownContacts CurveNetwork::known_from(const CurveNetwork& before) const {
  if (!before.contacts_) return {};
  KnownContacts known{before.contacts_, {}};
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    // Contacts have texts with the curves' names.
    known.is_changed.push_back(shapes_[i].pieces != before.shapes_[i].pieces ||
                               name(static_cast<int>(i)) != before.name(static_cast<int>(i)));
  }
  return known;
}

CurveNetwork CurveNetwork::with_curve(int number, NetworkCurve curve) const {
  if (number < 0 || number >= static_cast<int>(curves_.size())) {
    throw std::invalid_argument("There is no curve " + std::to_string(number) + ".");
  }
  std::vector<NetworkCurve> curves = curves_;
  curves[static_cast<std::size_t>(number)] = std::move(curve);
  return with_curves(std::move(curves));
}

CurveNetwork CurveNetwork::with_curves(std::vector<NetworkCurve> curves) const {
  if (curves.size() != curves_.size()) {
    throw std::invalid_argument("The network has " + std::to_string(curves_.size()) +
                                " curves: give as many, not " + std::to_string(curves.size()) +
                                ".");
  }
  return CurveNetwork(std::move(curves), options_, this);
}

void CurveNetwork::join(const CurveNetwork* before) {
  const KnownContacts known = before == nullptr ? KnownContacts{} : known_from(*before);
  // Kept, for a state of the network that follows from this one.
  contacts_ = std::make_shared<const ContactTable>(
      contact_table(shapes_, names(), options_.joining, known));
  NetworkFrame frame;
  frame.joined = join_curves(shapes_, names(), options_.joining, *contacts_);
  // Tangent planes are brought from node to node along edges, and regions are faces of one shell.
  keep_connected(frame.joined, shapes_, names());
  problems_ = frame.joined.problems;
  if (frame.joined.edges.empty()) return;
  const NetworkFrame* known_frame = before == nullptr ? nullptr : before->frame_.get();
  // Without known contacts nothing is said of which curves have changed.
  frame.shapes = known_frame == nullptr || known.is_changed.empty()
                     ? edge_shapes(frame.joined, shapes_)
                     : edge_shapes(frame.joined, shapes_,
                                   {&known_frame->joined, &known_frame->shapes, known.is_changed});
  frame.order = node_order(frame.joined, frame.shapes);
  try {
    frame.faces = region_faces(frame.joined, frame.shapes, frame.order);
  } catch (const NetworkFault& fault) {
    // Edges and nodes stay without regions, so that the place can be shown.
    problems_.push_back(wrong_order(frame.joined, frame.shapes, names(), fault.edges));
    *frame_ = std::move(frame);
    return;
  }
  std::vector<bool> knuckles;
  for (const NetworkCurve& curve : curves_) knuckles.push_back(is_knuckle(curve));
  // Last, as planes are parted where faces are beyond the border.
  frame.normals = edge_normals(frame.joined, frame.shapes, frame.order, frame.faces, knuckles,
                               options_.plane_angle);
  *frame_ = std::move(frame);
  for (const auto& loop : frame_->faces.loops) regions_.push_back(region_sides(*frame_, loop));
  name_halts();
  name_short_edges();
  name_planes();
  name_sides();
  name_tees();
}

void CurveNetwork::name_halts() {
  for (std::size_t e = 0; e < frame_->shapes.size(); ++e) {
    const std::optional<Vector3d> place = frame_->shapes[e].halt();
    // Of all edges, as check_region() asks for those of its region.
    has_halt_.push_back(place.has_value());
    if (place) problems_.push_back(halt(frame_->joined.edges[e].curve, *place, names()));
  }
}

// Over such an edge tangent planes turn as over a long one, and the surface beside it suffers.
void CurveNetwork::name_short_edges() {
  const double least = options_.joining.near_misses * options_.joining.tolerance;
  for (std::size_t e = 0; e < frame_->shapes.size(); ++e) {
    const double length = frame_->shapes[e].length();
    if (length >= least) continue;
    const CurveEdge& edge = frame_->joined.edges[e];
    problems_.push_back(
        short_edge(edge.curve, frame_->joined.nodes[static_cast<std::size_t>(edge.from)],
                   frame_->joined.nodes[static_cast<std::size_t>(edge.to)], length, names()));
  }
}

void CurveNetwork::name_planes() {
  for (std::size_t node = 0; node < frame_->joined.nodes.size(); ++node) {
    const TangentPlanes& planes = frame_->normals.planes[node];
    if (planes.has_planes) continue;
    // All that meet there: which of them is to be moved is for the user to say.
    std::set<int> curves;
    for (const EdgeEnd& end : frame_->order.around[node]) {
      curves.insert(frame_->joined.edges[static_cast<std::size_t>(end.edge)].curve);
    }
    problems_.push_back(no_tangent_plane(frame_->joined.nodes[node], planes.deviation,
                                         {curves.begin(), curves.end()}, names()));
  }
}

void CurveNetwork::name_sides() {
  for (const auto& sides : regions_) {
    if (sides.size() >= 2 && sides.size() <= kMostSidesOfRegion) continue;
    std::vector<Vector3d> corners;
    std::set<int> curves;
    for (const RegionSide& side : sides) {
      const CurveEdge& first = frame_->joined.edges[static_cast<std::size_t>(side.front().edge)];
      corners.push_back(
          frame_->joined
              .nodes[static_cast<std::size_t>(side.front().is_along ? first.from : first.to)]);
      for (const RegionEdge& edge : side) {
        curves.insert(frame_->joined.edges[static_cast<std::size_t>(edge.edge)].curve);
      }
    }
    problems_.push_back(wrong_sides(corners, {curves.begin(), curves.end()}, names()));
  }
}

// A curve that ends at a node that another one passes, which has surface on its other side.
void CurveNetwork::name_tees() {
  const NetworkFrame& frame = *frame_;
  for (std::size_t node = 0; node < frame.joined.nodes.size(); ++node) {
    const auto& around = frame.order.around[node];
    const auto curve_of = [&](const EdgeEnd& end) {
      return frame.joined.edges[static_cast<std::size_t>(end.edge)].curve;
    };
    // Sectors beyond the border have no normal.
    const bool is_inner = std::ranges::all_of(frame.normals.planes[node].normals,
                                              [](const Vector3d& n) { return !n.isZero(0.0); });
    // Two ends of the curve that passes, one of that which ends.
    if (!is_inner || around.size() != 3) continue;
    for (const EdgeEnd& end : around) {
      const int curve = curve_of(end);
      const auto count = std::ranges::count(around, curve, curve_of);
      if (count != 1) continue;
      const auto passes = std::ranges::find_if(
          around, [&](const EdgeEnd& other) { return curve_of(other) != curve; });
      if (std::ranges::count(around, curve_of(*passes), curve_of) != 2) continue;
      problems_.push_back(tee(frame.joined.nodes[node], curve, curve_of(*passes), names()));
    }
  }
}

std::vector<CurveRole> CurveNetwork::roles() const {
  std::vector<CurveRole> roles(curves_.size());
  const NetworkFrame& frame = *frame_;
  // Without regions nothing is known of the surface.
  for (std::size_t e = 0; e < frame.normals.is_crease.size(); ++e) {
    CurveRole& role = roles[static_cast<std::size_t>(frame.joined.edges[e].curve)];
    const bool is_border = frame.faces.is_border(static_cast<int>(e));
    ++(is_border ? role.border : frame.normals.is_crease[e] ? role.crease : role.smooth);
  }
  return roles;
}

void CurveNetwork::check_region(int region) const {
  if (region < 0 || region >= static_cast<int>(regions_.size())) {
    throw std::invalid_argument("There is no region " + std::to_string(region) + ".");
  }
  const auto& sides = regions_[static_cast<std::size_t>(region)];
  if (sides.size() < 2 || sides.size() > kMostSidesOfRegion) {
    throw std::invalid_argument("Region " + std::to_string(region) + " has " +
                                std::to_string(sides.size()) +
                                " sides: a patch has two to ten. Divide it by a curve.");
  }
  for (const RegionSide& side : sides) {
    for (const RegionEdge& edge : side) {
      // Ribbons are along and across the side's direction.
      if (!has_halt_[static_cast<std::size_t>(edge.edge)]) continue;
      throw std::invalid_argument(
          "Region " + std::to_string(region) + " has an edge of curve " +
          name(frame_->joined.edges[static_cast<std::size_t>(edge.edge)].curve) +
          " that comes to a halt: without a direction there is no tangent plane.");
    }
  }
}

TransfinitePatch CurveNetwork::patch(int region) const {
  check_region(region);
  return TransfinitePatch(ribboned_sides(frame_, regions_[static_cast<std::size_t>(region)]));
}

std::vector<Contact> network_meetings(const std::vector<NetworkCurve>& curves, double tolerance) {
  std::vector<CurveDefinition> definitions;
  std::vector<std::string> names;
  for (const NetworkCurve& curve : curves) {
    definitions.push_back(curve.definition);
    names.push_back(curve.definition.name);
  }
  const std::vector<CurveShape> shapes = network_curve_shapes(definitions, tolerance);
  std::vector<Contact> meetings;
  for (const auto& [pair, contacts] : contact_table(shapes, names, {tolerance})) {
    meetings.insert(meetings.end(), contacts.joined.begin(), contacts.joined.end());
  }
  return meetings;
}

std::vector<NetworkProblem> network_check(const std::vector<NetworkCurve>& curves,
                                          const NetworkOptions& options) {
  return CurveNetwork(curves, options).problems();
}

}  // namespace hull::network
