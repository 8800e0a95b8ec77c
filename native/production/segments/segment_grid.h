// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "production/models/closed_model.h"
#include "production/segments/segment_rules.h"
#include "surface/progress.h"

namespace hull::production {

// Numbers of a grid's planes: from and to along each axis.
struct SegmentBox {
  std::array<int, 3> low, high;
};

class ModelRays;

// A model in the cells of a grid of planes, with what is to be known of each so that any box of
// cells can be judged without cutting anything anew.
//
// A face that looks towards the tool is reached unless something is in between; for each face and
// direction the first such thing is found once, on the whole model, by rays from its middle and
// near its corners: in a box it is in the way if it is within the box. So accessibility is that of
// the segment, as if all others had been taken away.
class SegmentGrid {
 public:
  // Throws std::invalid_argument for a machine without sizes, and for one that is so small that the
  // grid would have more than kMostBoxes boxes.
  SegmentGrid(const ClosedModel& model, const SegmentRules& rules,
              const surface::Progress& progress);

  const std::array<std::vector<double>, 3>& planes() const { return planes_; }
  SegmentVerdict judged(const SegmentBox& box) const;
  double volume(const SegmentBox& box) const;

 private:
  struct Cell {
    double volume = 0.0;
    Eigen::AlignedBox3d box;       // of what is there
    std::array<double, 6> caps{};  // areas in the cell's sides, as directions
    // By direction and the plane at which a box ends on the tool's side: the area that is not
    // reached in it.
    std::array<std::vector<double>, 6> hidden;
    // Faces turned exactly away from a direction: where they are, and their area.
    std::array<std::vector<std::pair<double, double>>, 6> backs;
    std::array<double, 3> uncut{};  // area too steep for layers across an axis
  };

  void take_faces(const ClosedModel& piece, const std::array<int, 3>& at, Cell& cell,
                  const ModelRays& rays);
  void find_level_faces(const ClosedModel& model);
  bool take_cap(const std::array<Vector3d, 3>& face, double area, const std::array<int, 3>& at,
                Cell& cell) const;
  void take_level_faces(const std::array<int, 3>& at, Cell& cell, const ModelRays& rays) const;
  void take_face(const std::array<Vector3d, 3>& face, const Vector3d& across, Cell& cell,
                 const ModelRays& rays) const;
  const Cell& cell(int i, int j, int k) const;
  template <class Function>
  void each_cell(const SegmentBox& box, const Function& function) const;
  SegmentVerdict judged_along(const SegmentBox& box, const Eigen::AlignedBox3d& extents,
                              int direction) const;

  SegmentRules rules_;
  std::array<std::vector<double>, 3> planes_;
  // The model's own faces in planes between cells, by the direction that they face and the plane.
  std::array<std::vector<std::vector<std::array<Vector3d, 3>>>, 6> level_faces_;
  std::vector<Cell> cells_;
  double size_ = 0.0;
  double faces_ = 0.0, face_ = 0.0;  // how many the model has, and the mean area of one
};

}  // namespace hull::production
