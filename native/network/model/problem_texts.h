// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "network/curves/network_curve.h"
#include "network/joining/edge_shape.h"
#include "network/joining/network_problem.h"

namespace hull::network {

// Each point of a curve that is further off its plane than the tolerance.
std::vector<NetworkProblem> points_off_plane(const CurveDefinition& definition, int curve,
                                             double tolerance);

NetworkProblem wrong_order(const JoinedCurves& joined, const std::vector<EdgeShape>& shapes,
                           const std::vector<std::string>& names, const std::vector<int>& edges);
NetworkProblem halt(int curve, const Vector3d& place, const std::vector<std::string>& names);
NetworkProblem short_edge(int curve, const Vector3d& from, const Vector3d& to, double length,
                          const std::vector<std::string>& names);
NetworkProblem no_tangent_plane(const Vector3d& place, double deviation, std::vector<int> curves,
                                const std::vector<std::string>& names);
NetworkProblem wrong_sides(const std::vector<Vector3d>& corners, std::vector<int> curves,
                           const std::vector<std::string>& names);
NetworkProblem tee(const Vector3d& place, int ending, int passing,
                   const std::vector<std::string>& names);

}  // namespace hull::network
