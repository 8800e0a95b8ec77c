// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/appendages/patch_line.h"

#include <Eigen/Geometry>

#include "analysis/arithmetic/gauss.h"
#include "analysis/immersion/piece_moments.h"

namespace hull::analysis {

PatchLine::PatchLine(const surface::BezierPatch& patch, double v) {
  for (int i = 0; i < 4; ++i) {
    const Vector3d p[] = {patch.point(i), patch.point(4 + i), patch.point(8 + i),
                          patch.point(12 + i)};
    const double s = 1.0 - v;
    arc[i] = s * s * (s * p[0] + 3.0 * v * p[1]) + v * v * (3.0 * s * p[2] + v * p[3]);
    across[i] = 3.0 * (s * s * (p[1] - p[0]) + 2.0 * s * v * (p[2] - p[1]) + v * v * (p[3] - p[2]));
  }
}

Vector3d PatchLine::normal(double u) const {
  const double s = 1.0 - u;
  const Vector3d along = 3.0 * (s * s * (arc[1] - arc[0]) + 2.0 * s * u * (arc[2] - arc[1]) +
                                u * u * (arc[3] - arc[2]));
  return along.cross(arc_point(across, u));
}

void add_stretch(const PatchLine& line, const Vector3d& origin, double begin, double size,
                 double weight, ShellMoments& sum) {
  static const GaussRule rule = gauss_rule(kLineNodes);
  ShellNodes nodes;
  for (int k = 0; k < kLineNodes; ++k) {
    const double u = begin + size * rule.nodes[k];
    nodes.add(line.point(u) - origin, weight * size * rule.weights[k] * line.normal(u));
  }
  add_nodes(nodes, sum);
}

CubicArc side_arc(const surface::BezierPatch& patch, int first, int step) {
  return {patch.point(first), patch.point(first + step), patch.point(first + 2 * step),
          patch.point(first + 3 * step)};
}

surface::BezierPatch transposed(const surface::BezierPatch& patch) {
  surface::BezierPatch other;
  for (int k = 0; k < 3; ++k) {
    for (int j = 0; j < 4; ++j) {
      for (int i = 0; i < 4; ++i) other.x[k][4 * i + j] = patch.x[k][4 * j + i];
    }
  }
  return other;
}

}  // namespace hull::analysis
