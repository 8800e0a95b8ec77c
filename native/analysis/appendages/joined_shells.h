// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/appendages/appendage.h"
#include "analysis/appendages/closed_shell.h"
#include "analysis/immersion/shell_moments.h"
#include "analysis/sections/plane_cut.h"

namespace hull::analysis {

// What a body is to the ship: one of the hull's own, which is counted already, one that is added
// to it, or one that is cut out of it.
enum class MemberRole { kHull, kAdded, kCut };

struct JoinedMember {
  ClosedShell shell;
  MemberRole role;
  std::string name;                  // for messages
  std::vector<bool> without_area{};  // patches that are no wetted surface; none: all are
  // What it was made of; none for the hull's bodies and for mirror images.
  std::optional<Appendage> appendage{};
};

// A ship's hull with bodies joined to it and others cut out: the boundary of
//
//   (hull ∪ added bodies) ∖ what is cut out,
//
// by what it has more than the hull's own surfaces: of a hull the part within other bodies less, of
// an added body the part outside of all others more, of what is cut out the part within the rest,
// turned round. So integrals over surfaces that meet are sums over parts of each, with the exact
// curves where they meet as limits.
//
// Within a patch, lines u -> S(u, v) are divided at their crossings with the other surfaces and
// with the water; on each part the integrands but the area's are polynomials, and Gauss' rule of
// eight nodes is exact. Along v a rule tells its own error, and intervals, which begin and end
// where crossings leave the patch, are halved until that is small.
class JoinedShells {
 public:
  // `origin`: moments are about it. `tolerance`: of integrals, relative to the smaller body of a
  // pair. Throws std::invalid_argument where surfaces lie in one another, as of a keel whose root
  // is in the plane of a flat bottom, or are so near to one another, so often, that *parts_left, of
  // lines where they are divided to find where they cross, fall below zero; a processor looks at
  // some three million a second.
  JoinedShells(std::vector<JoinedMember> members, const Vector3d& origin, double tolerance,
               PartsLeft* parts_left);

  // What the wet surface has more than that of the hulls alone, about the origin.
  ShellMoments change(const Plane& water) const;
  // The same without water.
  const ShellMoments& whole_change() const { return whole_; }

  const std::vector<JoinedMember>& members() const { return members_; }

  // Names of bodies to be cut out, without mirror images, of which nothing lies in the rest.
  std::vector<std::string> idle_cuts() const;

 private:
  // A part of a patch that counts, all of it unless other surfaces are near.
  struct Piece {
    surface::BezierPatch patch;
    int member;
    double flux, area;         // factors of its integrals
    std::vector<int> near;     // members whose surfaces may cross it
    std::vector<bool> within;  // of each member; of near ones not told
    ShellMoments moments;      // without water, factors included
    double volume_tolerance, area_tolerance;
  };

  // A member's whole patch.
  struct Source {
    int member;
    bool has_area;
    const surface::BezierPatch* patch;
  };

  // Appends those of `patch`, which is the source's or, by halves, a part of it.
  void collect(const Source& source, const surface::BezierPatch& patch, int depth,
               std::vector<Piece>& pieces);
  // Whether a point of a member's surface counts, by what it is inside of.
  bool is_taken(int member, const std::vector<bool>& inside) const;
  ShellMoments moments_of(const Piece& piece, const Plane* water, PartsLeft* parts_left) const;
  ShellMoments wet_moments_of(const Piece& piece, const Plane& water) const;
  void check_closed() const;
  [[noreturn]] void refuse() const;

  std::vector<JoinedMember> members_;
  Vector3d origin_;
  double tolerance_;
  PartsLeft looks_left_;   // of parts of patches at other members
  PartsLeft* parts_left_;  // while it is made
  std::vector<Piece> pieces_;
  ShellMoments whole_;
};

// Of a whole shell, about the origin.
ShellMoments moments_of(const ClosedShell& shell);

}  // namespace hull::analysis
