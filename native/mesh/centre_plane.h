// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "mesh/control_mesh.h"

// The centre line of a half hull: the border edges of its control mesh that lie in the centre plane
// y = 0. Files of other programs have it there only nearly.
namespace hull::mesh {

// The points of the mesh, with both ends of every border edge whose ends are within kOnCentrePlane
// of the size of the plane put on it exactly; all others as they are. The curve of such a border
// is in the plane, too, since it depends on the points of the border alone.
std::vector<Eigen::Vector3d> points_with_centre_line(const ControlMesh& mesh);

// The vertices, in order, that were probably meant to be on the centre line, but are not within
// kOnCentrePlane: ends of border edges that run along the plane, rising from it by less than a
// hundredth of their length, within kNearCentrePlane, once the others are on it. None is left when
// all of them have been put there.
std::vector<int> vertices_near_centre_line(const ControlMesh& mesh);

// The vertices, in order, of gaps in the centre line: border points between such that are within
// kOnCentrePlane, themselves further off, but not beyond kAtCentreLine, where these are fewer than
// half of the border points that follow one another that near to the plane. A bar keel as a whole
// is none, nor is a deck's edge. They may be meant, as a well's opening is.
std::vector<int> gaps_in_centre_line(const ControlMesh& mesh);

}  // namespace hull::mesh
