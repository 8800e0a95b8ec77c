// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "mesh/mesh_check.h"
#include "mesh/topology.h"
#include "mesh/vectors.h"

namespace hull::mesh {

// A valid control mesh: points (m; x forward, y to port, z up), polygon faces, creases, corners.
// Immutable; copies share the topology.
class ControlMesh {
 public:
  // Throws std::invalid_argument with the message of the first error of check_mesh().
  explicit ControlMesh(MeshArrays arrays);

  // The same mesh with its points elsewhere. Throws std::invalid_argument unless there are as many,
  // and all finite.
  ControlMesh with_points(std::vector<Eigen::Vector3d> points) const;

  const std::vector<Eigen::Vector3d>& points() const { return points_; }
  const Topology& topology() const { return tags_->topology; }
  // Those of check_mesh(), of the points as they are.
  std::vector<MeshProblem> warnings() const;

  // Vertices where the surface is not everywhere a bicubic B-spline: inner ones without exactly
  // four faces, creases with a sector of other than two, corners with one of other than one, darts
  // and cone tips.
  std::vector<int> irregular_vertices() const;

  // Bounds of the points of faces, m: others have no influence on the surface.
  const Eigen::AlignedBox3d& box() const { return box_; }
  // Its diagonal, m: what tolerances refer to.
  double size() const { return size_; }

 private:
  struct Tags {
    Topology topology;
    std::vector<MeshProblem> warnings;  // but for that of faces without area
  };

  void set_points(std::vector<Eigen::Vector3d> points, const Eigen::AlignedBox3d& box);

  std::vector<Eigen::Vector3d> points_;
  Eigen::AlignedBox3d box_;
  double size_ = 0.0;
  std::shared_ptr<const Tags> tags_;
};

}  // namespace hull::mesh
