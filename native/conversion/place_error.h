// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "mesh/vectors.h"

namespace hull::conversion {

// "(x, y, z) m" for messages.
std::string place_text(const Vector3d& point);

// What is wrong with patches at one place. The message says where and what to do about it.
class PlaceError : public std::invalid_argument {
 public:
  // `point`: m. `face`: of the control mesh; -1 where it is not known.
  PlaceError(const std::string& message, const Vector3d& point, int face = -1)
      : std::invalid_argument(message), point_(point), face_(face) {}
  // `vertices`: of the control mesh, which are at fault rather than a face.
  PlaceError(const std::string& message, const Vector3d& point, std::vector<int> vertices)
      : std::invalid_argument(message), point_(point), vertices_(std::move(vertices)) {}

  const Vector3d& point() const { return point_; }
  int face() const { return face_; }
  const std::vector<int>& vertices() const { return vertices_; }

 private:
  Vector3d point_;
  int face_ = -1;
  std::vector<int> vertices_;
};

}  // namespace hull::conversion
