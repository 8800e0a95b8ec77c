// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "network/patches/region_sides.h"
#include "network/patches/transfinite_patch.h"

namespace hull::network {

// A curve of a network, and what it is on the hull. Knuckles are creases of the surface, whatever
// the curves that cross them tell; of all others it is found.
struct NetworkCurve {
  enum class Kind {
    kStation,
    kWaterline,
    kButtock,
    kDiagonal,
    kFree,
    kKnuckle,
    kProfile,
    kDeckEdge,
  };
  // What it is for B-spline patches: they have borders along boundaries, and only pass through
  // references. All may be borders, also those that end on another curve.
  enum class Role { kBoundary, kReference };
  CurveDefinition definition;
  Kind kind = Kind::kFree;
  Role role = Role::kBoundary;
};

struct NetworkOptions {
  JoiningOptions joining{1e-3};
  double plane_angle = 0.035;  // rad: how far edges may be off the tangent plane of their node
};

// How a curve lies in the surface: edges of it on the network's border, along a knuckle of the
// surface, and where it is smooth.
struct CurveRole {
  int border = 0, crease = 0, smooth = 0;
};

// Curves joined to nodes, edges and regions, with tangent planes, as far as they allow; what they
// do not is named. Immutable.
class CurveNetwork {
 public:
  // Throws std::invalid_argument for options that are none. All that is wrong with curves is among
  // problems(); where the curves themselves cannot be made, or do not make regions, there are none.
  CurveNetwork(std::vector<NetworkCurve> curves, const NetworkOptions& options);

  // With another curve in place of one, and what follows from it; where curves stay as they are,
  // what they meet is not looked for again. Throws std::invalid_argument for a number that none
  // has.
  CurveNetwork with_curve(int number, NetworkCurve curve) const;
  // The same with all curves given, of which several may be others than before. Throws
  // std::invalid_argument where they are not as many.
  CurveNetwork with_curves(std::vector<NetworkCurve> curves) const;

  const std::vector<NetworkCurve>& curves() const { return curves_; }
  const std::vector<CurveShape>& shapes() const { return shapes_; }
  const std::vector<NetworkProblem>& problems() const { return problems_; }
  // What the joined part is made of; without regions that is no more than nodes and edges.
  const NetworkFrame& frame() const { return *frame_; }
  std::shared_ptr<const NetworkFrame> shared_frame() const { return frame_; }
  double tolerance() const { return options_.joining.tolerance; }
  // Sides of each region, counterclockwise seen from outside.
  const std::vector<std::vector<RegionSide>>& regions() const { return regions_; }
  // Of each curve; all zero without regions.
  std::vector<CurveRole> roles() const;

  // Throws std::invalid_argument for a region of one side, or more than ten, or with an edge that
  // comes to a halt, and for a number that none has.
  void check_region(int region) const;
  // The surface within a region that check_region() has no objection to.
  TransfinitePatch patch(int region) const;

 private:
  CurveNetwork(std::vector<NetworkCurve> curves, const NetworkOptions& options,
               const CurveNetwork* before);
  bool make_shapes();
  KnownContacts known_from(const CurveNetwork& before) const;
  void join(const CurveNetwork* before);
  void name_halts();
  void name_short_edges();
  void name_planes();
  void name_tees();
  void name_sides();
  std::vector<std::string> names() const;
  const std::string& name(int curve) const;

  std::vector<NetworkCurve> curves_;
  NetworkOptions options_;
  std::vector<CurveShape> shapes_;
  std::vector<NetworkProblem> problems_;
  std::shared_ptr<const ContactTable> contacts_;
  std::shared_ptr<NetworkFrame> frame_;
  std::vector<bool> has_halt_;  // of edges
  std::vector<std::vector<RegionSide>> regions_;
};

// Where curves come within a tolerance, m, of one another, of each coherent stretch once, whether
// anything hangs together by it or not. Throws std::invalid_argument as network_curve_shapes() and
// contact_table() do.
std::vector<Contact> network_meetings(const std::vector<NetworkCurve>& curves, double tolerance);

// All that is wrong with curves as a network, the notes last; empty where nothing is.
std::vector<NetworkProblem> network_check(const std::vector<NetworkCurve>& curves,
                                          const NetworkOptions& options);

}  // namespace hull::network
