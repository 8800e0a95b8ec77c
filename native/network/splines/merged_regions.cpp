// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/splines/merged_regions.h"

#include <algorithm>
#include <map>
#include <optional>

namespace hull::network {
namespace {

// Groups of regions that hang together over references; those that make no quad fall apart again.
class RegionMerger {
 public:
  RegionMerger(const NetworkFrame& frame, const std::vector<std::vector<RegionSide>>& regions,
               const std::vector<bool>& is_reference)
      : frame_(frame), regions_(regions), is_reference_(is_reference) {}

  std::vector<MergedRegion> run() {
    std::vector<bool> is_taken(regions_.size(), false);
    std::vector<MergedRegion> merged;
    for (std::size_t r = 0; r < regions_.size(); ++r) {
      if (is_taken[r]) continue;
      // The same group is found from each of its regions: from the first one is enough.
      const std::vector<int> group = group_of(static_cast<int>(r));
      for (int one : group) is_taken[static_cast<std::size_t>(one)] = true;
      std::optional<MergedRegion> whole;
      if (group.size() > 1) whole = merge(group);
      if (whole) {
        merged.push_back(std::move(*whole));
        continue;
      }
      // What is no quad together stays divided.
      for (int one : group) {
        merged.push_back({{one}, regions_[static_cast<std::size_t>(one)], {}});
      }
    }
    return merged;
  }

 private:
  int beside(const RegionEdge& side, bool is_own) const {
    // To the left of the edge as its region has it, or to its right.
    const std::size_t against = side.is_along == is_own ? 0 : 1;
    return frame_.faces.region_of_side[2 * static_cast<std::size_t>(side.edge) + against];
  }

  // Whether regions on both sides of an edge are one.
  bool is_open(const RegionEdge& side) const {
    const auto edge = static_cast<std::size_t>(side.edge);
    return is_reference_[edge] && !frame_.normals.is_crease[edge] && beside(side, false) >= 0;
  }

  std::vector<int> group_of(int first) const {
    std::vector<int> group{first};
    for (std::size_t i = 0; i < group.size(); ++i) {
      for (const RegionEdge& side : frame_.faces.loops[static_cast<std::size_t>(group[i])]) {
        if (!is_open(side)) continue;
        const int other = beside(side, false);
        if (std::ranges::find(group, other) == group.end()) group.push_back(other);
      }
    }
    return group;
  }

  // The edge after one, around what is joined.
  RegionEdge after(RegionEdge side) const {
    do {
      const auto& loop = frame_.faces.loops[static_cast<std::size_t>(beside(side, true))];
      const auto at = std::ranges::find_if(loop, [&](const RegionEdge& one) {
        return one.edge == side.edge && one.is_along == side.is_along;
      });
      side = at + 1 == loop.end() ? loop.front() : *(at + 1);
      if (is_open(side))
        // Across the edge, into the loop of the other region, which runs against it.
        side.is_along = !side.is_along;
      else
        return side;
    } while (true);
  }

  std::optional<MergedRegion> merge(const std::vector<int>& group) const {
    MergedRegion merged{group, {}, {}};
    std::vector<RegionEdge> border;
    for (int region : group) {
      for (const RegionEdge& side : frame_.faces.loops[static_cast<std::size_t>(region)]) {
        if (!is_open(side)) {
          border.push_back(side);
        } else if (side.is_along) {
          merged.references.push_back(side.edge);
        }
      }
    }
    if (border.empty()) return std::nullopt;
    // The edges that stay, one after the other: if all are met there is one way around.
    std::vector<RegionEdge> loop{border.front()};
    for (RegionEdge side = after(loop.front());
         side.edge != loop.front().edge || side.is_along != loop.front().is_along;
         side = after(side)) {
      loop.push_back(side);
      // Round and round without coming back to the first one.
      if (loop.size() > border.size()) return std::nullopt;
    }
    // More than one way around is no disc.
    if (loop.size() != border.size()) return std::nullopt;
    merged.sides = region_sides(frame_, loop);
    const bool is_quad =
        merged.sides.size() == 4 && sides_of_one_curve(frame_, merged.sides).size() == 4;
    if (!is_quad) return std::nullopt;
    return merged;
  }

  const NetworkFrame& frame_;
  const std::vector<std::vector<RegionSide>>& regions_;
  const std::vector<bool>& is_reference_;
};

}  // namespace

std::vector<MergedRegion> merged_regions(const NetworkFrame& frame,
                                         const std::vector<std::vector<RegionSide>>& regions,
                                         const std::vector<bool>& is_reference) {
  return RegionMerger(frame, regions, is_reference).run();
}

}  // namespace hull::network
