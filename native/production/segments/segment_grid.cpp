// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/segments/segment_grid.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "production/models/model_cut.h"
#include "production/segments/axis_rays.h"

namespace hull::production {

using Eigen::AlignedBox3d;

namespace {

constexpr int kFewestPlanes = 4, kMostPlanes = 64;
// Of the model's size: rays begin so far off a face, as the tool has a radius.
constexpr double kOffFace = 1e-3;
constexpr double kSamePlane = 1e-9;
constexpr double kFlat = 1e-9;  // 1 - |n| of faces that are across an axis
// Of the model's area: less is not seen as hidden.
constexpr double kNoArea = 1e-5;

AlignedBox3d box_of(const ClosedModel& model) {
  AlignedBox3d box;
  for (const Vector3d& p : model.points) box.extend(p);
  return box;
}

// Planes from end to end of the model, evenly; an even number of layers, so that one plane is in
// the middle, which of a hull is the centre plane.
std::vector<double> spaced(double low, double high, int layers, double size) {
  std::vector<double> planes(layers + 1);
  for (int i = 0; i <= layers; ++i) planes[i] = low + (high - low) * i / layers;
  planes.back() = high;  // exactly, so that nothing is left above
  if (std::abs(planes[layers / 2]) < kSamePlane * size) planes[layers / 2] = 0.0;
  return planes;
}

int layers_for(double extent, double longest, int planes, const SegmentRules& rules) {
  // At least so many that a layer fits the machine whichever way round the segment lies.
  const double wanted =
      std::max(std::round(planes * extent / longest), std::ceil(extent / rules.machine.minCoeff()));
  // Bounded before it is a whole number, which may not hold it; in this order what is no number is
  // the fewest.
  const int layers =
      static_cast<int>(std::min(std::max(1.0 * kFewestPlanes, wanted), 1.0 * kMostPlanes));
  return layers + layers % 2;
}

std::array<int, 3> layers_for(const Vector3d& sizes, const SegmentRules& rules) {
  // Fewer and fewer along the longest side, until the boxes can be looked through.
  for (int planes = rules.planes; planes >= kFewestPlanes; --planes) {
    std::array<int, 3> layers;
    double boxes = 1.0;
    for (int a = 0; a < 3; ++a) {
      layers[a] = layers_for(sizes[a], sizes.maxCoeff(), planes, rules);
      boxes *= 0.5 * layers[a] * (layers[a] + 1.0);
    }
    if (boxes <= kMostBoxes) return layers;
  }
  throw std::invalid_argument(
      "The model would have too many segments for so small a machine: take a larger one, or a "
      "smaller model.");
}

}  // namespace

// Of the whole model, along each axis.
class ModelRays {
 public:
  ModelRays(const ClosedModel& model, double off)
      : along_{AxisRays(model, 0), AxisRays(model, 1), AxisRays(model, 2)}, off_(off) {}

  // What is nearest in the way of a tool from +axis or -axis, of rays from the face's middle and
  // from near its corners.
  double in_the_way(const std::array<Vector3d, 3>& face, const Vector3d& normal, int axis,
                    bool up) const {
    const Vector3d middle = (face[0] + face[1] + face[2]) / 3.0;
    double nearest = along_[axis].first_entry(middle + off_ * normal, up);
    for (const Vector3d& corner : face) {
      // Not at the corner itself, where the faces beside would be met.
      const Vector3d from = corner + 0.02 * (middle - corner) + off_ * normal;
      const double at = along_[axis].first_entry(from, up);
      nearest = up ? std::min(nearest, at) : std::max(nearest, at);
    }
    return nearest;
  }

 private:
  std::array<AxisRays, 3> along_;
  double off_;
};

SegmentGrid::SegmentGrid(const ClosedModel& model, const SegmentRules& rules,
                         const surface::Progress& progress)
    : rules_(rules) {
  if (!(rules.machine.minCoeff() > 0.0) || !rules.machine.allFinite() || !(rules.least >= 0.0) ||
      rules.planes < kFewestPlanes || rules.planes > kMostPlanes) {
    throw std::invalid_argument(
        "A machine takes pieces of positive sizes, and the grid has 4 to 64 layers.");
  }
  const AlignedBox3d box = box_of(model);
  size_ = box.diagonal().norm();
  faces_ = static_cast<double>(model.triangles.size());
  face_ = model.area() / faces_;
  const std::array<int, 3> counts = layers_for(box.sizes(), rules);
  for (int a = 0; a < 3; ++a) {
    planes_[a] = spaced(box.min()[a], box.max()[a], counts[a], size_);
  }
  find_level_faces(model);
  const ModelRays rays(model, kOffFace * size_);
  const auto layers = [this](int a) { return static_cast<int>(planes_[a].size()) - 1; };
  cells_.resize(static_cast<std::size_t>(layers(0)) * layers(1) * layers(2));
  // Slices off a rest that shrinks, along x, of these along y, of these along z: each triangle is
  // cut a few times, not once for each cell.
  ClosedModel after_x = model;
  for (int i = 0; i < layers(0); ++i) {
    surface::tell(progress, i, layers(0));
    CutModel x = cut(after_x, 0, planes_[0][i + 1]);
    after_x = std::move(x.above);
    for (int j = 0; j < layers(1); ++j) {
      CutModel y = cut(x.below, 1, planes_[1][j + 1]);
      x.below = std::move(y.above);
      for (int k = 0; k < layers(2); ++k) {
        CutModel z = cut(y.below, 2, planes_[2][k + 1]);
        y.below = std::move(z.above);
        const std::size_t number = (static_cast<std::size_t>(i) * layers(1) + j) * layers(2) + k;
        take_faces(z.below, {i, j, k}, cells_[number], rays);
      }
    }
  }
}

void SegmentGrid::take_faces(const ClosedModel& piece, const std::array<int, 3>& at, Cell& cell,
                             const ModelRays& rays) {
  cell.volume = piece.volume();
  cell.box = box_of(piece);
  for (int d = 0; d < 6; ++d) cell.hidden[d].assign(planes_[d / 2].size(), 0.0);
  for (const auto& [a, b, c] : piece.triangles) {
    const std::array<Vector3d, 3> face{piece.points[a], piece.points[b], piece.points[c]};
    const Vector3d across = 0.5 * (face[1] - face[0]).cross(face[2] - face[0]);
    const double area = across.norm();
    if (area > 0.0 && !take_cap(face, area, at, cell)) take_face(face, across, cell, rays);
  }
  take_level_faces(at, cell, rays);
}

// Whether the face is in a plane between cells.
bool SegmentGrid::take_cap(const std::array<Vector3d, 3>& face, double area,
                           const std::array<int, 3>& at, Cell& cell) const {
  // Even directions look up their axis: their side of the cell is its upper plane.
  for (int d = 0; d < 6; ++d) {
    const int axis = d / 2, plane = at[axis] + (d % 2 == 0);
    // Outer planes are no cuts: what lies there is the model's own.
    if (plane == 0 || plane + 1 == static_cast<int>(planes_[axis].size())) continue;
    const double place = planes_[axis][plane];
    if (face[0][axis] != place || face[1][axis] != place || face[2][axis] != place) continue;
    cell.caps[d] += area;
    return true;
  }
  return false;
}

void SegmentGrid::take_face(const std::array<Vector3d, 3>& face, const Vector3d& across, Cell& cell,
                            const ModelRays& rays) const {
  const double area = across.norm();
  const Vector3d normal = across / area;
  for (int axis = 0; axis < 3; ++axis) {
    const double steep = std::abs(normal[axis]);
    // The blade can't cut within 45 degrees of the layers' normal; faces just across it are the
    // layers' own sides.
    if (steep > std::sin(0.25 * M_PI + kTurnedAway) && steep < 1.0 - kFlat) {
      cell.uncut[axis] += area;
    }
    for (int d = 2 * axis; d <= 2 * axis + 1; ++d) {
      const bool up = d % 2 == 0;
      const double towards = up ? normal[axis] : -normal[axis];
      // 1 - |n| is of second order in the angle: 1e-9 are 4.5e-5 rad.
      if (towards < kFlat - 1.0) {
        cell.backs[d].emplace_back(face[0][axis], area);
        continue;
      }
      const std::vector<double>& planes = planes_[axis];
      std::vector<double>& hidden = cell.hidden[d];
      const bool turned_away = towards < -std::sin(kTurnedAway);
      const double entry = turned_away ? 0.0 : rays.in_the_way(face, normal, axis, up);
      // For all planes at which a box could end on the tool's side: judging a box is a sum then.
      for (std::size_t i = 0; i < planes.size(); ++i) {
        const bool beyond = up ? planes[i] <= entry : planes[i] >= entry;
        if (turned_away || !beyond) hidden[i] += area;
      }
    }
  }
}

const SegmentGrid::Cell& SegmentGrid::cell(int i, int j, int k) const {
  const std::size_t rows = planes_[1].size() - 1, columns = planes_[2].size() - 1;
  return cells_[(i * rows + j) * columns + k];
}

template <class Function>
void SegmentGrid::each_cell(const SegmentBox& box, const Function& function) const {
  for (int i = box.low[0]; i < box.high[0]; ++i) {
    for (int j = box.low[1]; j < box.high[1]; ++j) {
      for (int k = box.low[2]; k < box.high[2]; ++k) function(cell(i, j, k));
    }
  }
}

double SegmentGrid::volume(const SegmentBox& box) const {
  double sum = 0.0;
  each_cell(box, [&sum](const Cell& cell) { sum += cell.volume; });
  return sum;
}

SegmentVerdict SegmentGrid::judged(const SegmentBox& box) const {
  AlignedBox3d extents;
  each_cell(box, [&extents](const Cell& cell) { extents.extend(cell.box); });
  SegmentVerdict best;
  if (extents.isEmpty()) return best;
  const bool milled = rules_.making == SegmentMaking::kMilling;
  // Layers are the same from either side.
  for (int direction = 0; direction < 6; direction += milled ? 1 : 2) {
    const SegmentVerdict one = judged_along(box, extents, direction);
    if (best.direction < 0 || one.penalty < best.penalty) best = one;
  }
  return best;
}

SegmentVerdict SegmentGrid::judged_along(const SegmentBox& box, const AlignedBox3d& extents,
                                         int direction) const {
  const int axis = direction / 2;
  const bool up = direction % 2 == 0, milled = rules_.making == SegmentMaking::kMilling;
  SegmentVerdict verdict;
  verdict.direction = direction;
  const double back = up ? extents.min()[axis] : extents.max()[axis];
  const int last = up ? box.high[axis] : box.low[axis];
  const double cut_plane = planes_[axis][up ? box.low[axis] : box.high[axis]];
  const bool is_cut = std::abs(cut_plane - back) <= kSamePlane * size_;
  double back_area = 0.0;
  // Sums of what each cell knows, so that a box costs as much as it has cells.
  each_cell(box, [&](const Cell& cell) {
    if (cell.box.isEmpty()) return;
    if (!milled) {
      verdict.inaccessible += cell.uncut[axis];
      return;
    }
    verdict.inaccessible += cell.hidden[direction][last];
    for (const auto& [place, area] : cell.backs[direction]) {
      const bool is_back = std::abs(place - back) <= kSamePlane * size_;
      (is_back ? back_area : verdict.inaccessible) += area;
    }
    // The back is on the side away from the tool; a cut there is a plane to lie on.
    const double side = up ? cell.box.min()[axis] : cell.box.max()[axis];
    if (is_cut && side == cut_plane) back_area += cell.caps[direction ^ 1];
  });
  if (verdict.inaccessible < kNoArea * face_ * faces_) verdict.inaccessible = 0.0;
  verdict.has_back = !milled || back_area > kSamePlane * size_ * size_;
  Vector3d across = extents.sizes();
  const double along = across[axis];
  across[axis] = 0.0;
  // The two sizes across, by size: either way round.
  const double wide = across.maxCoeff(), narrow = across.sum() - wide;
  const double slack = 1.0 + kSamePlane;
  verdict.fits = along <= slack * rules_.machine[2] &&
                 wide <= slack * std::max(rules_.machine[0], rules_.machine[1]) &&
                 narrow <= slack * std::min(rules_.machine[0], rules_.machine[1]) &&
                 extents.sizes().minCoeff() >= rules_.least;
  verdict.penalty = (verdict.has_back ? 0.0 : kNoBackPlane) + verdict.inaccessible / face_ +
                    (verdict.fits ? 0.0 : kOutsideSizes);
  return verdict;
}

}  // namespace hull::production
