// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/blocks/block_layout.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "conversion/blocks/block_places.h"
#include "mesh/groups.h"

namespace hull::conversion {
namespace {

class Cutter {
 public:
  explicit Cutter(const surface::LimitSurface& surface)
      : cells_(surface.cells()),
        cuts_(cells_.edge_count(), 0),
        crossed_(cells_.vertex_count(), 0),
        irregular_(cells_.vertex_count(), 0) {
    for (int h = 0; h < cells_.half_edge_count(); ++h) {
      if (begins_at_irregular_knot(surface, h)) irregular_[cells_.origin(h)] = 1;
    }
    for (int h = 0; h < cells_.half_edge_count(); ++h) {
      if (!cells_.is_crease(h)) continue;
      cross(h);
      crossed_[cells_.origin(h)] = 1;
    }
    on_crease_ = crossed_;
  }

  // Lines that join two irregular points, the shortest first: one cut does the work of two.
  void cut_between_irregular_points() {
    std::vector<std::vector<int>> joining;
    for (int h = 0; h < cells_.half_edge_count(); ++h) {
      if (!irregular_[cells_.origin(h)] || is_cut(h)) continue;
      std::vector<int> line = straight_line(h);
      if (irregular_[end_of(line.back())]) joining.push_back(std::move(line));
    }
    std::stable_sort(joining.begin(), joining.end(),
                     [](const auto& a, const auto& b) { return a.size() < b.size(); });
    for (const std::vector<int>& line : joining) {
      // Each line was found from both its ends; the second time it is cut.
      if (is_free(line)) {
        for (int h : line) cross(h);
      }
    }
  }

  // From all irregular points, a step for each line in turn.
  void cut_from_irregular_points() {
    std::vector<int> heads;
    for (int h = 0; h < cells_.half_edge_count(); ++h) {
      // A border vertex's edge that no half-edge leaves by is cut already.
      if (irregular_[cells_.origin(h)]) heads.push_back(h);
    }
    run(std::move(heads));
  }

  // Per region between creases, its rectangles' corners, see least_block_count(). `region`: of each
  // cell.
  std::vector<int> corner_counts(const std::vector<int>& region) const {
    std::vector<int> corners(cells_.face_count(), 0);
    for (int h = 0; h < cells_.half_edge_count(); ++h) {
      int& count = corners[region[h / 4]];
      const int vertex = cells_.origin(h);
      if (irregular_[vertex]) {
        ++count;
        if (!is_cut(h) && !irregular_[end_of(straight_line(h).back())]) count += 2;
      } else if (cells_.is_crease(h) && cells_.is_crease(cells_.prev(h))) {
        ++count;
      }
    }
    return corners;
  }

  // Whether the line ahead of h comes to a cut, and not back to where it began.
  bool reaches_cut(int h) const {
    const int begin = h;
    while (!crossed_[end_of(h)]) {
      h = ahead_of(h);
      if (h == begin) return false;
    }
    return true;
  }

  // Along the line of h, both ways.
  void cut_along(int h) {
    std::vector<int> heads{h};
    // Backwards too: two turns bring the half-edge that leaves the other way.
    if (!crossed_[cells_.origin(h)]) {
      crossed_[cells_.origin(h)] = 1;
      const int beside = cells_.next(cells_.twin(h));
      heads.push_back(cells_.next(cells_.twin(beside)));
    }
    run(std::move(heads));
  }

  const std::vector<char>& cuts() const { return cuts_; }
  bool is_cut(int h) const { return cuts_[cells_.edge(h)] != 0; }

 private:
  void cut(int h) { cuts_[cells_.edge(h)] = 1; }
  // Cuts along h and marks the point at its end.
  void cross(int h) {
    cut(h);
    crossed_[end_of(h)] = 1;
  }
  int end_of(int h) const { return cells_.origin(cells_.next(h)); }
  // The half-edge straight ahead of h. REQUIRES: the point between is regular and not on a border.
  int ahead_of(int h) const { return cells_.next(cells_.twin(cells_.next(h))); }

  // From h to the next irregular point, crease or border.
  std::vector<int> straight_line(int h) const {
    std::vector<int> line{h};
    while (!irregular_[end_of(line.back())] && !on_crease_[end_of(line.back())] &&
           line.size() < cuts_.size()) {
      line.push_back(ahead_of(line.back()));
    }
    return line;
  }

  // Whether a line neither runs along cuts nor crosses one.
  bool is_free(const std::vector<int>& line) const {
    return std::all_of(line.begin(), line.end(), [&](int h) {
      return !is_cut(h) && (h == line.back() || !crossed_[end_of(h)]);
    });
  }

  void run(std::vector<int> heads) {
    while (!heads.empty()) {
      // A step each in turn: of two lines that meet, the one that is there first goes on (the
      // motorcycles of the graph).
      std::vector<int> still;
      for (int h : heads) {
        if (is_cut(h)) continue;
        const bool ends = irregular_[end_of(h)] || crossed_[end_of(h)];
        cross(h);
        if (!ends) still.push_back(ahead_of(h));
      }
      heads = std::move(still);
    }
  }

  const mesh::Topology& cells_;
  std::vector<char> cuts_;       // per edge
  std::vector<char> crossed_;    // per vertex: a cut passes or ends there
  std::vector<char> irregular_;  // per vertex
  std::vector<char> on_crease_;  // per vertex, borders included
};

// The cell beyond a cell's side u = 1, and beyond v = 1, by its side v = 0.
int right_of(const mesh::Topology& cells, int side) {
  return cells.next(cells.twin(cells.next(side)));
}
int above(const mesh::Topology& cells, int side) {
  return cells.twin(cells.next(cells.next(side)));
}

// The block with the cell that has `side` at its lower left corner.
Block block_from(const mesh::Topology& cells, const Cutter& cutter, int side) {
  Block block;
  for (int column = side;; column = right_of(cells, column)) {
    int height = 0;
    for (int at = column;; at = above(cells, at)) {
      block.sides.push_back(at);
      ++height;
      if (cutter.is_cut(cells.next(cells.next(at)))) break;
    }
    assert(block.count_u == 0 || height == block.count_v);
    block.count_v = height;
    ++block.count_u;
    if (cutter.is_cut(cells.next(column))) break;
  }
  return block;
}

// The direction, along u or along v, in which a block must be cut because it is beside itself, as a
// ring is: such a patch would be closed, and readers of CAD files make of that what they like.
enum class CutAcross { kNone, kU, kV };

CutAcross cut_of_ring(const mesh::Topology& cells, const Block& block) {
  if (block.sides.size() == 1) return CutAcross::kNone;
  std::vector<int> own;
  for (int side : block.sides) own.push_back(side / 4);
  std::ranges::sort(own);
  CutAcross needed = CutAcross::kNone;
  for (int k = 0; k < 4; ++k) {
    for (int h : block.half_edges(cells, k)) {
      if (cells.twin(h) < 0 || !std::ranges::binary_search(own, cells.twin(h) / 4)) continue;
      // Sides 1 and 3 are at the ends of u.
      const bool along_u = k % 2 == 1 ? block.count_u > 1 : block.count_v == 1;
      needed = along_u ? CutAcross::kU : CutAcross::kV;
      if (k % 2 == 1) return needed;
    }
  }
  return needed;
}

// A block's cells from i on along u, `count` of them, and likewise along v.
Block part_of(const Block& block, int i, int count_u, int j, int count_v) {
  Block part;
  part.count_u = count_u;
  part.count_v = count_v;
  for (int a = i; a < i + count_u; ++a) {
    for (int b = j; b < j + count_v; ++b) part.sides.push_back(block.side(a, b));
  }
  return part;
}

// Blocks beside themselves are halved until none is; `cuts` takes the new lines.
void halve_rings(const mesh::Topology& cells, std::vector<Block>& blocks, std::vector<char>& cuts) {
  for (std::size_t b = 0; b < blocks.size();) {
    const Block block = blocks[b];
    const CutAcross across = cut_of_ring(cells, block);
    if (across == CutAcross::kNone) {
      ++b;
      continue;
    }
    // The halves are looked at again, as a torus is beside itself both ways.
    const int nu = block.count_u, nv = block.count_v;
    if (across == CutAcross::kU) {
      blocks[b] = part_of(block, 0, nu / 2, 0, nv);
      blocks.push_back(part_of(block, nu / 2, nu - nu / 2, 0, nv));
    } else {
      blocks[b] = part_of(block, 0, nu, 0, nv / 2);
      blocks.push_back(part_of(block, 0, nu, nv / 2, nv - nv / 2));
    }
    for (int h : blocks[b].half_edges(cells, across == CutAcross::kU ? 1 : 2)) {
      cuts[cells.edge(h)] = 1;
    }
  }
}

}  // namespace

std::vector<int> Block::half_edges(const mesh::Topology& cells, int k) const {
  std::vector<int> result;
  const int last_u = count_u - 1, last_v = count_v - 1;
  for (int i = 0; i < (k % 2 == 0 ? count_u : count_v); ++i) {
    int h = k == 0   ? side(i, 0)
            : k == 1 ? side(last_u, i)
            : k == 2 ? side(last_u - i, last_v)
                     : side(0, last_v - i);
    for (int turn = 0; turn < k; ++turn) h = cells.next(h);
    result.push_back(h);
  }
  return result;
}

BlockLayout::BlockLayout(const surface::LimitSurface& surface) {
  const mesh::Topology& cells = surface.cells();
  Cutter cutter(surface);
  cutter.cut_between_irregular_points();
  cutter.cut_from_irregular_points();
  std::vector<char> taken(cells.face_count(), 0);
  const auto take_blocks = [&] {
    for (int h = 0; h < cells.half_edge_count(); ++h) {
      if (taken[h / 4] || !cutter.is_cut(h) || !cutter.is_cut(cells.prev(h))) continue;
      blocks.push_back(block_from(cells, cutter, h));
      for (int side : blocks.back().sides) taken[side / 4] = 1;
    }
  };
  take_blocks();
  // What is left has no corners: tubes and closed surfaces.
  for (int cell = 0; cell < cells.face_count(); ++cell) {
    while (!taken[cell]) {
      // From cut to cut if there are any: a round beside a cut would make one block more.
      int chosen = -1;
      for (int side = 4 * cell; side < 4 * cell + 4; ++side) {
        if (cutter.is_cut(side)) continue;
        if (chosen < 0 || (!cutter.reaches_cut(chosen) && cutter.reaches_cut(side))) chosen = side;
      }
      cutter.cut_along(chosen);
      take_blocks();
    }
  }
  cuts = cutter.cuts();
  halve_rings(cells, blocks, cuts);
}

int least_block_count(const surface::LimitSurface& surface) {
  const mesh::Topology& cells = surface.cells();
  mesh::Groups groups(cells.face_count());
  for (int h = 0; h < cells.half_edge_count(); ++h) {
    if (!cells.is_crease(h)) groups.join(h / 4, cells.twin(h) / 4);
  }
  std::vector<int> region(cells.face_count());
  for (int cell = 0; cell < cells.face_count(); ++cell) region[cell] = groups.find(cell);
  const std::vector<int> corners = Cutter(surface).corner_counts(region);
  int count = 0;
  for (int cell = 0; cell < cells.face_count(); ++cell) {
    // What has no corners, as tubes, is one rectangle joined to itself.
    if (region[cell] == cell) count += std::max(1, (corners[cell] + 3) / 4);
  }
  return count;
}

}  // namespace hull::conversion
