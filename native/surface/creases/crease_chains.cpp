// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/creases/crease_chains.h"

#include <algorithm>

namespace hull::surface {
namespace {

constexpr ChainStep kNoStep{-1, true};

// The crease edges at each vertex of the crease rule, by their front half-edges.
class CreaseEnds {
 public:
  explicit CreaseEnds(const mesh::Topology& t) : t_(t), ends_(t.vertex_count(), {-1, -1}) {
    for (int h = 0; h < t.half_edge_count(); ++h) {
      if (!t.is_crease(h) || !t.is_edge_front(h)) continue;
      add(t.origin(h), h);
      add(t.origin(t.next(h)), h);
    }
  }

  // The step that goes on where this one ends.
  ChainStep after(const ChainStep& step) const {
    const int vertex = step.to(t_);
    // Anywhere else the chain ends.
    if (t_.kind(vertex) != mesh::VertexKind::kCrease) return kNoStep;
    const auto [a, b] = ends_[vertex];
    const int h = a == step.half_edge ? b : a;
    return {h, t_.origin(h) == vertex};
  }

 private:
  void add(int vertex, int h) {
    if (t_.kind(vertex) != mesh::VertexKind::kCrease) return;
    // The crease rule has two of them.
    ends_[vertex][ends_[vertex][0] < 0 ? 0 : 1] = h;
  }

  const mesh::Topology& t_;
  std::vector<std::array<int, 2>> ends_;
};

void turn_around(CreaseChain& chain) {
  std::reverse(chain.vertices.begin(), chain.vertices.end());
  std::reverse(chain.steps.begin(), chain.steps.end());
  for (ChainStep& step : chain.steps) step = step.reversed();
}

CreaseChain chain_through(const mesh::Topology& t, const CreaseEnds& ends, int h) {
  CreaseChain chain{t.twin(h) < 0 ? CreaseKind::kBorder : CreaseKind::kCrease, false, {}, {}};
  // Back to the chain's start, or once around.
  ChainStep back{h, false};
  for (ChainStep next = ends.after(back); next.half_edge >= 0 && next.half_edge != h;
       next = ends.after(back)) {
    back = next;
  }
  const ChainStep start = back.reversed();
  ChainStep step = start;
  do {
    chain.steps.push_back(step);
    chain.vertices.push_back(step.from(t));
    step = ends.after(step);
  } while (step.half_edge >= 0 && step.half_edge != start.half_edge);
  chain.closed = step.half_edge >= 0;
  if (!chain.closed) chain.vertices.push_back(chain.steps.back().to(t));
  const auto is_dart = [&t](int vertex) { return t.kind(vertex) == mesh::VertexKind::kDart; };
  // Knots crowd towards a dart, and numbers do towards t = 0.
  if (is_dart(chain.vertices.back()) && !is_dart(chain.vertices.front())) turn_around(chain);
  return chain;
}

}  // namespace

std::vector<CreaseChain> crease_chains(const mesh::Topology& topology) {
  const CreaseEnds ends(topology);
  std::vector<char> used(topology.edge_count(), 0);
  std::vector<CreaseChain> chains;
  for (int h = 0; h < topology.half_edge_count(); ++h) {
    if (!topology.is_crease(h) || !topology.is_edge_front(h) || used[topology.edge(h)]) continue;
    chains.push_back(chain_through(topology, ends, h));
    for (const ChainStep& step : chains.back().steps) used[topology.edge(step.half_edge)] = 1;
  }
  return chains;
}

}  // namespace hull::surface
