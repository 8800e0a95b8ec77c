// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/feature_curves.h"

#include <stdexcept>
#include <string>

namespace hull {
namespace {

FeatureKind kind_of(const Topology& t, int h) {
  return t.twin(h) < 0 ? FeatureKind::kBorder : FeatureKind::kCrease;
}

// The edge that continues the chain of h beyond its end, as a half-edge that leaves the end or
// (at a border that runs against its half-edge) arrives there; -1 where the chain ends.
struct Step {
  int half_edge = -1;
  bool forward = true;  // along the half-edge
};

int end_vertex(const Topology& t, const Step& step) {
  return t.origin(step.forward ? t.next(step.half_edge) : step.half_edge);
}

int start_vertex(const Topology& t, const Step& step) {
  return t.origin(step.forward ? step.half_edge : t.next(step.half_edge));
}

// The crease edges at each vertex, as half-edges (fronts).
class CreaseEnds {
 public:
  explicit CreaseEnds(const Topology& t) : t_(t), ends_(t.vertex_count()) {
    for (int h = 0; h < t.half_edge_count(); ++h) {
      if (!t.is_crease(h) || !t.is_edge_front(h)) continue;
      ends_[t.origin(h)].push_back(h);
      ends_[t.origin(t.next(h))].push_back(h);
    }
  }

  Step continuation(const Step& step) const {
    const int vertex = end_vertex(t_, step);
    if (t_.kind(vertex) != VertexKind::kCrease) return {};
    for (int h : ends_[vertex]) {
      if (h == step.half_edge || kind_of(t_, h) != kind_of(t_, step.half_edge)) continue;
      return {h, t_.origin(h) == vertex};
    }
    return {};
  }

 private:
  const Topology& t_;
  std::vector<std::vector<int>> ends_;
};

// Points along the control edge of half-edge h, from its origin, without the last.
void append_edge(const LimitSurface& surface, const Step& step, int samples,
                 std::vector<Vector3d>& points) {
  const Topology& t = surface.mesh().topology();
  const int h = step.half_edge;
  for (int i = 0; i < samples; ++i) {
    const double s = 2.0 * i / samples;               // along the step
    const double along = step.forward ? s : 2.0 - s;  // along the half-edge
    // The first half of the edge is the side v = 0 of cell h, the second the side u = 0 of the
    // cell of the face's next corner.
    points.push_back(along <= 1.0 ? surface.position(h, along, 0.0)
                                  : surface.position(t.next(h), 0.0, 2.0 - along));
  }
}

FeatureCurve trace(const LimitSurface& surface, const CreaseEnds& ends, Step step, int samples,
                   std::vector<char>& used) {
  const Topology& t = surface.mesh().topology();
  const int first = step.half_edge;
  FeatureCurve curve{kind_of(t, first), {}, {}, false};
  Step last = step;
  while (step.half_edge >= 0 && !used[t.edge(step.half_edge)]) {
    used[t.edge(step.half_edge)] = 1;
    curve.vertices.push_back(start_vertex(t, step));
    append_edge(surface, step, samples, curve.points);
    last = step;
    step = ends.continuation(step);
  }
  curve.closed = step.half_edge == first;
  if (curve.closed) {
    curve.points.push_back(curve.points.front());
  } else {
    curve.vertices.push_back(end_vertex(t, last));
    const int h = last.half_edge;
    curve.points.push_back(last.forward ? surface.position(t.next(h), 0.0, 0.0)
                                        : surface.position(h, 0.0, 0.0));
  }
  return curve;
}

// The first edge of the chain of h: found by following it backwards.
Step chain_start(const CreaseEnds& ends, int h) {
  const Step begin{h, false};
  Step step = begin;
  for (;;) {
    const Step next = ends.continuation(step);
    if (next.half_edge < 0 || next.half_edge == h) break;
    step = next;
  }
  return {step.half_edge, !step.forward};
}

}  // namespace

std::vector<FeatureCurve> feature_curves(const LimitSurface& surface, int samples_per_edge) {
  if (samples_per_edge < 1 || samples_per_edge > 1024) {
    throw std::invalid_argument("Feature curves take 1 to 1024 samples per edge, not " +
                                std::to_string(samples_per_edge) + ".");
  }
  const int samples = samples_per_edge + samples_per_edge % 2;
  const Topology& t = surface.mesh().topology();
  const CreaseEnds ends(t);
  std::vector<char> used(t.edge_count(), 0);
  std::vector<FeatureCurve> curves;
  for (int h = 0; h < t.half_edge_count(); ++h) {
    if (!t.is_crease(h) || used[t.edge(h)]) continue;
    const int front = t.is_edge_front(h) ? h : t.twin(h);
    curves.push_back(trace(surface, ends, chain_start(ends, front), samples, used));
  }
  return curves;
}

}  // namespace hull
