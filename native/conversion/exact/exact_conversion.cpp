// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/exact/exact_conversion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "conversion/blocks/block_places.h"
#include "conversion/centre_line.h"
#include "conversion/exact/grading.h"
#include "conversion/patches/control_faces.h"
#include "conversion/patches/divide.h"
#include "conversion/patches/matched_knots.h"
#include "mesh/tolerances.h"

namespace hull::conversion {
namespace {

class SetBuilder {
 public:
  SetBuilder(const surface::LimitSurface& surface, const BlockLayout& layout)
      : surface_(surface),
        cells_(surface.cells()),
        layout_(layout),
        points_(vertex_points(surface)),
        is_end_(cells_.vertex_count(), 0) {
    find_ends_in_plane();
    // Where a block's side begins the side beyond, of a neighbour, is divided.
    for (const Block& block : layout.blocks) {
      for (int k = 0; k < 4; ++k) {
        is_end_[cells_.origin(block.half_edges(cells_, k).front())] = 1;
      }
    }
  }

  PatchSet build(std::vector<BSplinePatch> patches) const {
    PatchSet set;
    set.vertex_count = cells_.vertex_count();
    set.edge_count = cells_.edge_count();
    set.cell_faces = faces_of_cells(surface_);
    for (std::size_t p = 0; p < patches.size(); ++p) {
      const Block& block = layout_.blocks[p];
      BSplinePatch& patch = patches[p];
      std::array<int, 4> corners{};
      std::array<PatchSide, 4> sides;
      for (int k = 0; k < 4; ++k) {
        sides[k] = side_of(block.half_edges(cells_, k));
        corners[k] = sides[k].front().from;
        // The patches' own may differ by rounding.
        patch.control_points[patch.side_index(k, 0)] = points_[corners[k]];
      }
      set.corners.push_back(corners);
      set.sides.push_back(std::move(sides));
    }
    set.patches = std::move(patches);
    set.blocks = layout_.blocks;
    return set;
  }

 private:
  // Borders end where they leave the centre plane, so that mirror images can be joined there.
  void find_ends_in_plane() {
    std::vector<char> in(points_.size(), 0), out(points_.size(), 0);
    for (int h = 0; h < cells_.half_edge_count(); ++h) {
      if (cells_.twin(h) >= 0) continue;
      std::vector<char>& found = is_in_plane(h) ? in : out;
      found[cells_.origin(h)] = found[cells_.origin(cells_.next(h))] = 1;
    }
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (in[i] && out[i]) is_end_[i] = 1;
    }
  }

  bool is_in_plane(int h) const {
    for (double t : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
      if (std::abs(point_on_half_edge(surface_, h, t).y()) > kNoLength * surface_.mesh().size()) {
        return false;
      }
    }
    return true;
  }

  // An edge has the least number of the cells' edges that it consists of.
  PatchSide side_of(const std::vector<int>& half_edges) const {
    PatchSide side;
    const double count = static_cast<double>(half_edges.size());
    for (std::size_t i = 0; i < half_edges.size(); ++i) {
      const int h = half_edges[i], from = cells_.origin(h), to = cells_.origin(cells_.next(h));
      // A corner of some block lies here, or the border leaves the centre plane.
      if (i == 0 || is_end_[from]) {
        side.push_back({cells_.edge(h), from, to, static_cast<double>(i) / count, 1.0});
      }
      SideEdge& part = side.back();
      // The same number from both sides, whichever is met first.
      part.edge = std::min(part.edge, cells_.edge(h));
      part.to = to;
      part.end = static_cast<double>(i + 1) / count;
    }
    return side;
  }

  const surface::LimitSurface& surface_;
  const mesh::Topology& cells_;
  const BlockLayout& layout_;
  std::vector<Vector3d> points_;  // per vertex
  std::vector<char> is_end_;      // per vertex: edges end there
};

void check(const ExactOptions& options) {
  const auto refuse = [](const std::string& what, const std::string& range, double value) {
    std::ostringstream words;
    words << "The " << what << " of patches must be " << range << ", not " << value << ".";
    throw std::invalid_argument(words.str());
  };
  const double tolerance = options.tolerance, angle = options.seam_angle;
  const int grading = options.grading, most = options.most_control_points;
  if (!(tolerance >= 1e-10 && tolerance <= 0.1)) {
    refuse("tolerance", "between 1e-10 and 0.1 of the largest extent", tolerance);
  }
  if (!(angle >= 0.0 && angle <= 1.0)) refuse("seam angle", "between 0 and 1 rad", angle);
  if (grading != 0 && (grading < kLeastGrading || grading > kMostGrading)) {
    refuse("grading", "0, or from 2 to 30", grading);
  }
  if (most != 0 && most < kLeastControlPoints) {
    refuse("largest number of control points", "0, or 16 at least", most);
  }
}

}  // namespace

PatchSet exact_patches(const surface::LimitSurface& given, const ExactOptions& options,
                       const surface::Progress& progress) {
  check(options);
  const std::optional<surface::LimitSurface> centred = with_centre_line(given);
  const surface::LimitSurface& surface = centred ? *centred : given;
  const BlockLayout layout(surface);
  const SetBuilder builder(surface, layout);
  PatchSet set = builder.build(graded_patches(surface, layout, options, progress));
  set.source = source_of(given);
  // Bézier patches are divided at all knots, so nothing is left to match or to limit.
  if (options.bezier) return divided(set, cuts_at_knots(set));
  if (options.matched_knots) match_knots(set);
  if (options.most_control_points == 0) return set;
  return divided(set, cuts_for_most_points(set, options.most_control_points));
}

}  // namespace hull::conversion
