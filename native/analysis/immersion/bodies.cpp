// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/immersion/bodies.h"

namespace hull::analysis {
namespace {

void mark_nodes(const surface::SurfaceLayout& layout, const surface::SurfaceNode& node, int body,
                Bodies& bodies) {
  switch (node.kind) {
    case surface::SurfaceNode::Kind::kLeaf:
      bodies.of_leaf[node.index] = body;
      break;
    case surface::SurfaceNode::Kind::kCorner:
      bodies.of_corner[node.index] = body;
      break;
    case surface::SurfaceNode::Kind::kSplit:
      for (const surface::SurfaceNode& child : layout.split(node.index)) {
        mark_nodes(layout, child, body, bodies);
      }
      break;
  }
}

}  // namespace

Bodies bodies_of(const surface::LimitSurface& surface) {
  const surface::SurfaceLayout& layout = surface.layout();
  const mesh::Topology& cells = surface.cells();
  Bodies bodies;
  bodies.of_cell.assign(surface.cell_count(), -1);
  bodies.of_leaf.resize(layout.leaf_count());
  bodies.of_corner.resize(layout.corner_count());
  for (int first = 0; first < surface.cell_count(); ++first) {
    if (bodies.of_cell[first] >= 0) continue;
    const int body = static_cast<int>(bodies.first_cell.size());
    bodies.first_cell.push_back(first);
    bodies.of_cell[first] = body;
    // A list of its own in place of recursion, which would be as deep as a body has cells.
    std::vector<int> waiting{first};
    while (!waiting.empty()) {
      const int cell = waiting.back();
      waiting.pop_back();
      mark_nodes(layout, layout.root(cell), body, bodies);
      for (int h = 4 * cell; h < 4 * cell + 4; ++h) {
        // Across creases, too: a body is what hangs together, knuckles or not.
        const int twin = cells.twin(h);
        if (twin < 0 || bodies.of_cell[twin / 4] >= 0) continue;
        bodies.of_cell[twin / 4] = body;
        waiting.push_back(twin / 4);
      }
    }
  }
  return bodies;
}

}  // namespace hull::analysis
