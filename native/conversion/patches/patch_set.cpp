// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/patches/patch_set.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>
#include <string>

#include "conversion/place_error.h"

namespace hull::conversion {
namespace {

struct Use {
  int patch = -1, side = -1;
  const SideEdge* part = nullptr;
};

// What can only come from a mesh whose points are closer together than the rounding of its size, or
// almost in the centre plane.
constexpr char kRemedy[] =
    "; merge points that almost coincide there, and put those meant to be on the centre line at y "
    "= 0";

[[noreturn]] void refuse_at(const BSplinePatch& patch, const Vector3d& point,
                            const std::string& what) {
  throw PlaceError("patch of cell " + std::to_string(patch.cell) + ", at " + place_text(point) +
                       ": " + what + kRemedy,
                   point);
}

// Of numbers that do not fit one another: no mesh is to blame.
[[noreturn]] void refuse(const BSplinePatch& patch, const std::string& what) {
  throw std::invalid_argument("patch of cell " + std::to_string(patch.cell) + ": " + what);
}

double gap_of(const PatchSet& set, const Use& first, const Use& second) {
  return gap_between(set.curve(first.patch, first.side, *first.part),
                     set.curve(second.patch, second.side, *second.part).reversed());
}

void check_vertex(const PatchSet& set, int p, int vertex) {
  if (vertex >= 0 && vertex < set.vertex_count) return;
  refuse(set.patches[p], "there is no vertex " + std::to_string(vertex));
}

void check_side(const PatchSet& set, int p, int k) {
  const BSplinePatch& patch = set.patches[p];
  check_vertex(set, p, set.corners[p][k]);
  // Exactly: ends of parts are copies of the next ones' beginnings.
  double at = 0.0;
  int vertex = set.corners[p][k];
  for (const SideEdge& part : set.sides[p][k]) {
    if (part.edge < 0 || part.edge >= set.edge_count) {
      refuse(patch, "there is no edge " + std::to_string(part.edge));
    }
    check_vertex(set, p, part.to);
    // Negated, so that what is not a number is refused too.
    if (part.from != vertex || part.begin != at || !(part.end > at)) {
      refuse(patch, "edge " + std::to_string(part.edge) + " does not begin where side " +
                        std::to_string(k) + " has come to");
    }
    vertex = part.to;
    at = part.end;
  }
  if (at != 1.0 || vertex != set.corners[p][(k + 1) % 4]) {
    refuse(patch, "the edges of side " + std::to_string(k) + " do not reach its end");
  }
}

// Vertices within sides lie there.
void check_inner_vertices(const PatchSet& set, const std::vector<Use>& vertices, double tolerance) {
  for (int p = 0; p < static_cast<int>(set.patches.size()); ++p) {
    for (int k = 0; k < 4; ++k) {
      const PatchSide& side = set.sides[p][k];
      for (std::size_t i = 0; i + 1 < side.size(); ++i) {
        // By a patch that has its corner there; none where a border only turns into another one.
        const Use& use = vertices[side[i].to];
        if (use.patch < 0) continue;
        const BSplinePatch& other = set.patches[use.patch];
        const Vector3d& corner = other.control_points[other.side_index(use.side, 0)];
        const Vector3d here = set.patches[p].side_curve(k).position(side[i].end);
        if (!((here - corner).norm() <= tolerance)) {
          refuse_at(set.patches[p], corner,
                    "vertex " + std::to_string(side[i].to) + " is not on the side where cell " +
                        std::to_string(other.cell) + " has it");
        }
      }
    }
  }
}

void check_numbers(const PatchSet& set) {
  const size_t count = set.patches.size();
  if (set.corners.size() != count || set.sides.size() != count) {
    throw std::invalid_argument(std::to_string(count) + " patches, but corners of " +
                                std::to_string(set.corners.size()) + " and sides of " +
                                std::to_string(set.sides.size()));
  }
  if (!set.blocks.empty() && set.blocks.size() != count) {
    throw std::invalid_argument(std::to_string(count) + " patches, but blocks of " +
                                std::to_string(set.blocks.size()));
  }
  for (size_t p = 0; p < count; ++p) {
    for (int k = 0; k < 4; ++k) check_side(set, static_cast<int>(p), k);
  }
}

// The second patch of an edge runs along it the other way.
void check_joint(const PatchSet& set, const Use& first, const Use& second, double tolerance) {
  const BSplinePatch &one = set.patches[first.patch], &two = set.patches[second.patch];
  const std::string edge = "edge " + std::to_string(first.part->edge);
  const std::string other = " as the patch of cell " + std::to_string(one.cell);
  if (first.part->from != second.part->to || first.part->to != second.part->from) {
    refuse(two, edge + " does not run between the same vertices, the other way," + other);
  }
  if (!(gap_of(set, first, second) <= tolerance)) {
    refuse_at(two, set.curve(first.patch, first.side, *first.part).position(0.5),
              edge + " has not the same curve" + other);
  }
}

// Calls visit(first, second) for every edge with two patches, and for more than two again.
template <class Visit>
void for_each_joint(const PatchSet& set, const Visit& visit) {
  std::vector<Use> uses(set.edge_count);
  for (int p = 0; p < static_cast<int>(set.patches.size()); ++p) {
    for (int k = 0; k < 4; ++k) {
      for (const SideEdge& part : set.sides[p][k]) {
        // The first use stays for all later ones, so that a third one is seen.
        Use& use = uses[part.edge];
        if (use.patch >= 0) {
          visit(use, Use{p, k, &part});
        } else {
          use = {p, k, &part};
        }
      }
    }
  }
}

}  // namespace

double PatchSet::size() const {
  Eigen::AlignedBox3d box;
  for (const BSplinePatch& patch : patches) {
    for (const Vector3d& point : patch.control_points) box.extend(point);
  }
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

double PatchSet::largest_gap() const {
  double largest = 0.0;
  for_each_joint(*this, [&](const Use& first, const Use& second) {
    largest = std::max(largest, gap_of(*this, first, second));
  });
  return largest;
}

void PatchSet::check() const {
  // Each check leans on those before it.
  for (const BSplinePatch& patch : patches) patch.check();
  check_numbers(*this);
  std::vector<Use> vertex_use(vertex_count);
  for (int p = 0; p < static_cast<int>(patches.size()); ++p) {
    for (int k = 0; k < 4; ++k) {
      Use& vertex = vertex_use[corners[p][k]];
      if (vertex.patch < 0) vertex = {p, k};
      const auto corner = [this](int patch, int side) {
        return patches[patch].control_points[patches[patch].side_index(side, 0)];
      };
      // Bitwise, not within a tolerance: corners are copies of one computed point.
      if (corner(p, k) != corner(vertex.patch, vertex.side)) {
        refuse_at(patches[p], corner(p, k),
                  "vertex " + std::to_string(corners[p][k]) + " is not where cell " +
                      std::to_string(patches[vertex.patch].cell) + " has it");
      }
    }
  }
  const double tolerance = kLargestGap * size();
  check_inner_vertices(*this, vertex_use, tolerance);
  std::vector<bool> full(edge_count, false);
  for_each_joint(*this, [&](const Use& first, const Use& second) {
    const int edge = first.part->edge;
    if (full[edge]) {
      refuse(patches[second.patch], "edge " + std::to_string(edge) + " has more than 2 patches");
    }
    check_joint(*this, first, second, tolerance);
    full[edge] = true;
  });
}

}  // namespace hull::conversion
