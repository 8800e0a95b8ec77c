// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>

#include "production/segments/clipped_polygon.h"
#include "production/segments/segment_grid.h"

namespace hull::production {

void SegmentGrid::find_level_faces(const ClosedModel& model) {
  for (int d = 0; d < 6; ++d) level_faces_[d].resize(planes_[d / 2].size());
  for (const auto& [a, b, c] : model.triangles) {
    const std::array<Vector3d, 3> face{model.points[a], model.points[b], model.points[c]};
    for (int axis = 0; axis < 3; ++axis) {
      const double place = face[0][axis];
      if (face[1][axis] != place || face[2][axis] != place) continue;
      const auto plane = std::lower_bound(planes_[axis].begin(), planes_[axis].end(), place);
      if (plane == planes_[axis].end() || *plane != place) continue;
      const bool up = (face[1] - face[0]).cross(face[2] - face[0])[axis] > 0.0;
      level_faces_[2 * axis + !up][plane - planes_[axis].begin()].push_back(face);
    }
  }
}

// Cuts make the model's own faces in their planes anew, together with the caps beside: of what
// counts as caps these are taken out again.
void SegmentGrid::take_level_faces(const std::array<int, 3>& at, Cell& cell,
                                   const ModelRays& rays) const {
  for (int d = 0; d < 6; ++d) {
    if (cell.caps[d] == 0.0) continue;
    const int axis = d / 2;
    for (const auto& face : level_faces_[d][at[axis] + (d % 2 == 0)]) {
      std::vector<Vector3d> part(face.begin(), face.end());
      for (const int a : {(axis + 1) % 3, (axis + 2) % 3}) {
        part = clipped(part, a, planes_[a][at[a]], 1.0);
        part = clipped(part, a, planes_[a][at[a] + 1], -1.0);
      }
      for (std::size_t k = 1; k + 1 < part.size(); ++k) {
        const Vector3d across = 0.5 * (part[k] - part[0]).cross(part[k + 1] - part[0]);
        if (across.norm() == 0.0) continue;
        take_face({part[0], part[k], part[k + 1]}, across, cell, rays);
        cell.caps[d] = std::max(cell.caps[d] - across.norm(), 0.0);
      }
    }
  }
}

}  // namespace hull::production
