// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/immersion/bodies.h"
#include "analysis/immersion/closings.h"
#include "analysis/immersion/immersion.h"
#include "analysis/immersion/shell_parts.h"
#include "analysis/sections/cell_boxes.h"
#include "surface/limit_surface.h"
#include "surface/surface_stamp.h"

namespace hull::analysis {

struct Appendage;
class JoinedShells;
struct ProfilePart;

// How the openings of a shell are taken (closings.h tells which are open at all): they let the
// water in, or are covered, as by a weathertight deck.
enum class Openings { kOpen, kClosed };

// A limit surface as the shell of a floating body, for many waters: what does not depend on the
// water is computed once. Its bodies, if they are several, add up.
//
// With the finest tolerance polynomial integrands (volume, its moments, waterplane) are integrated
// exactly where the water does not cut, and to about 1e-13 of the whole where it does; the wetted
// surface to about 1e-9. With a coarser one all of them are right to about that, relative to the
// whole. Estimates come with the results. Queries are thread-safe among themselves.
//
// After surface.set_points() all queries below update() throw std::invalid_argument until it is
// called, but for those that tell what the body was made with.
class HullBody {
 public:
  // `mirrored`: the surface is the port half (y >= 0) and counts twice. `surface` must outlive the
  // body. Throws std::invalid_argument unless the tolerance is positive and below 1e-2.
  HullBody(const surface::LimitSurface& surface, bool mirrored,
           Openings openings = Openings::kClosed, double tolerance = kFinest);

  // The same body of a copy of its surface, that is of one with its layout and points: nothing is
  // computed again. Throws std::invalid_argument if the body is out of date.
  HullBody(const HullBody& body, const surface::LimitSurface& copy);

  // The hull alone, without what is joined, for one water alone, not heeled: from the next update()
  // on there is no more than its immersion, whose wetted surface is not measured, sections and
  // places. What is above the water is not computed, and faces that come to be turned inwards are
  // not noticed.
  HullBody(const HullBody& body, const surface::LimitSurface& copy, const Plane& water);

  // To be called after surface.set_points(). Only what has moved is computed again, but for what
  // is joined to the body; where join() throws, so does this, and the body is the hull alone until
  // the next time.
  void update();

  // From now on immersion() and all that follows from it are those of the hull's bodies, each point
  // of space counted once, with what is added to them and without what is cut out of them
  // (appendages/joined_shells.h). None: of the hull alone, where bodies that overlap are counted
  // once. Throws std::invalid_argument, and leaves the body as it was, as JoinedShells and
  // shell_of() do, and if the body is for one water alone.
  void join(std::vector<Appendage> appendages);
  // Null without join().
  const JoinedShells* joined() const { return joined_.get(); }
  // What of the profile the bodies change that are joined (appendages/profile_union.h); null
  // without join().
  const std::vector<ProfilePart>* joined_profile() const { return current().profile_.get(); }

  const surface::LimitSurface& surface() const { return stamp_.surface(); }
  // LimitSurface::revision() of the points that the body was computed of.
  int revision() const { return stamp_.revision(); }
  // How often update() and join() changed the body: who keeps what it answered, and asks for more,
  // compares this (body_stamp.h).
  int version() const { return version_; }
  // Whether its queries answer.
  bool is_current() const { return stamp_.is_current(); }
  bool mirrored() const { return mirrored_; }
  double tolerance() const { return tolerance_; }
  // About which its integrals are kept.
  const Vector3d& centre() const { return parts_.rules().centre; }
  Openings openings() const { return openings_; }
  // Which connected body (hull, rudder, demi-hull) each cell belongs to.
  const Bodies& bodies() const { return bodies_; }
  const CellBoxes& boxes() const { return current().boxes_; }
  const std::vector<BorderEdge>& border() const { return current().border_; }
  // What closes the shell, on the modelled side.
  const std::vector<ClosingPatch>& closings() const { return current().closings_; }

  // Of the whole shell without closings, both sides, about the origin.
  ShellMoments shell_moments() const;

  // Of both sides; the wetted surface without closings. Throws std::invalid_argument if the plane
  // is not finite, as refuse_flooding() does, and if the faces of a body are turned inwards.
  Immersion immersion(const Plane& water) const;

  // m³ of the immersed body abaft x, both sides; as exact as the volume of immersion(). Throws
  // std::invalid_argument as that does, if the water is heeled, if x is not finite, and after
  // join().
  double volume_abaft(const Plane& water, double x) const;

  // Throws std::invalid_argument if the water rises above an opening that is not closed ("floods at
  // …").
  void refuse_flooding(const Plane& water) const;

  // The same with all openings closed.
  HullBody closed() const;

  // Of the openings that are not closed, on both sides.
  DownfloodingPoint downflooding_point(const Vector3d& up) const;
  double lowest_opening(const Vector3d& up) const { return downflooding_point(up).height; }

 private:
  const HullBody& current() const {
    stamp_.require_current("The body");
    return *this;
  }
  HullBody(const HullBody& body, const surface::LimitSurface& copy,
           const std::optional<Plane>& water);
  void close();
  void take(const std::vector<Appendage>& appendages);
  std::string inversion() const;

  void check_immersed(const Plane& water) const;
  // What lies below all of one or two planes, the water's surface among them.
  using Planes = std::span<const Plane>;
  template <class Cut>
  void add_wet(const std::vector<ShellPart>& parts, Planes planes, const Cut& cut,
               ShellMoments& sum) const;
  struct Wet {
    ShellMoments shell, caps;
  };
  Wet wet_part(Planes planes) const;
  ShellMoments wet_corner(int corner, Planes planes) const;

  surface::SurfaceStamp stamp_;
  int version_ = 0;
  bool mirrored_;
  Openings openings_;
  double tolerance_;
  std::optional<Plane> water_;  // the only one, if there is one
  Bodies bodies_;
  ShellParts parts_;
  CellBoxes boxes_;
  std::vector<BorderEdge> border_;
  std::vector<ClosingPatch> closings_;
  std::vector<ShellPart> caps_;
  std::shared_ptr<const std::vector<Appendage>> appendages_;
  std::shared_ptr<const JoinedShells> joined_;
  std::shared_ptr<const std::vector<ProfilePart>> profile_;
  std::string inversion_;  // what is wrong with the direction of faces; empty if nothing is
};

}  // namespace hull::analysis
