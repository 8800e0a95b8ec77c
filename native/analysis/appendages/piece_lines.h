// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/appendages/piece_integrals.h"

namespace hull::analysis {

// The line u -> S(u, v) of a patch, and S_v along it.
struct PatchLine {
  CubicArc arc, across;

  PatchLine(const surface::BezierPatch& patch, double v);
  Vector3d point(double u) const { return arc_point(arc, u); }
  Vector3d normal(double u) const;
  // Adds the integrals of a stretch, by Gauss' rule of eight nodes.
  void add_stretch(const Vector3d& origin, double begin, double size, double weight,
                   ShellMoments& sum) const;
};

// How often a line crosses each surface, and the water.
using LineCounts = std::vector<int>;

// The lines of a piece, divided where they cross other surfaces and the water.
class PieceLines {
 public:
  PieceLines(const surface::BezierPatch& patch, const std::vector<const ClosedShell*>& surfaces,
             const Takes& takes, const Plane* water, const PieceRule& rule)
      : patch_(patch),
        surfaces_(surfaces),
        takes_(takes),
        water_(water),
        origin_(rule.origin),
        parts_left_(rule.parts_left) {
    crossings_.resize(surfaces.size());
  }

  // From now on v and u change places, which turns the normal round.
  void transpose();
  // Where the surfaces and the water cross a side: v = 0 by (0, 1), u = 0 by (0, 4), v = 1 by
  // (12, 1), u = 1 by (3, 4).
  std::vector<double> side_breaks(int first, int step) const;
  // Of the stretches of the line at v that are taken, by du.
  ShellMoments along(double v);
  // Of that line; of the one at v.
  const LineCounts& counts() const { return counts_; }
  const LineCounts& counts_at(double v);

 private:
  std::vector<double> line_breaks(const PatchLine& line);
  void count_touches();
  void spend(int parts) const;
  bool is_inside(int surface, const PatchLine& line, double u) const;
  void add_water(const CubicArc& arc, std::vector<double>& breaks) const;

  surface::BezierPatch patch_;
  const std::vector<const ClosedShell*>& surfaces_;
  const Takes& takes_;
  const Plane* water_;
  Vector3d origin_;
  PartsLeft* parts_left_;
  std::vector<std::vector<ArcCrossing>> crossings_;
  LineCounts counts_;
  int touched_ = 0;
};

}  // namespace hull::analysis
