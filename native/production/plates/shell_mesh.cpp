// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/shell_mesh.h"

#include <algorithm>
#include <cmath>

#include "production/plates/edge_points.h"
#include "production/plates/seam_nodes.h"
#include "surface/creases/knuckle_angle.h"

namespace hull::production {

using mesh::Topology;
using surface::on_square_side;
using Grid = CellTriangulation::Grid;

namespace {

constexpr int kMostParts = 64;
// Along a triangle's side the surface turns by about so much, rad.
constexpr double kTurn = 0.07;
// Points of the mesh's own keep this part of a triangle's side away from curves.
constexpr double kClear = 0.35;

class Builder {
 public:
  Builder(const surface::LimitSurface& surface, double size)
      : surface_(surface),
        cells_(surface.cells()),
        size_(size),
        edges_(surface, mesh_),
        seams_(surface.cell_count()) {}

  // The order matters: all points of curves on cells' sides are known before sides are divided, and
  // all points of sides before a cell is cut, so that neighbours share them.
  ShellMesh build(const std::vector<SurfaceCurve>& curves, const surface::Progress& progress) && {
    for (int k = 0; k < static_cast<int>(curves.size()); ++k) {
      for (const CurveStep& step : curves[k].steps) add_step(step, k);
    }
    for (int e = 0; e < cells_.edge_count(); ++e) {
      edges_.divide(e, parts_of(edges_.length(e), edges_.turn(e)), kClear);
    }
    for (const Along& along : along_) mark_along(along);
    for (int e = 0; e < cells_.edge_count(); ++e) mark_knuckle(e);
    for (int c = 0; c < surface_.cell_count(); ++c) {
      surface::tell(progress, c, surface_.cell_count());
      triangulate(c);
    }
    return std::move(mesh_);
  }

 private:
  // A curve along an edge of cells.
  struct Along {
    int edge;
    std::int64_t from, to;
    int curve;
  };

  int parts_of(double length, double turn) const {
    // By length and by turn: what bends is cut finer.
    const double parts = std::ceil(std::max(length / size_, turn / kTurn));
    return static_cast<int>(std::clamp(parts, 1.0, 1.0 * kMostParts));
  }
  void add_step(const CurveStep& step, int curve);
  void mark_along(const Along& along);
  void mark_knuckle(int edge);
  void triangulate(int cell);
  Vector2d lengths_of(int cell) const;
  Vector2d turns_of(int cell) const;
  int add(CellTriangulation& net, const Vector2d& uv);
  void add_inner_points(const Vector2d& lengths, const Vector2d& turns,
                        const std::vector<SeamPart>& parts, CellTriangulation& net);
  int point_of(int cell, int local);

  const surface::LimitSurface& surface_;
  const Topology& cells_;
  double size_;
  ShellMesh mesh_;
  EdgePoints edges_;
  std::vector<std::vector<SeamPart>> seams_;  // by cell
  std::vector<Along> along_;
  std::vector<Vector2d> uv_;  // of the net's points, of the cell that is being cut
};

void Builder::add_step(const CurveStep& step, int curve) {
  const Vector2d from = edges_.put_on_sides(step.cell, step.from);
  const Vector2d to = edges_.put_on_sides(step.cell, step.to);
  // A step with both ends on one side runs along it, and is no piece of the cell's inside.
  for (int side = 0; side < 4; ++side) {
    const EdgePlace a = edges_.on_side(step.cell, side, on_grid(from));
    const EdgePlace b = edges_.on_side(step.cell, side, on_grid(to));
    if (a.edge < 0 || b.edge < 0) continue;
    along_.push_back({a.edge, std::min(a.at, b.at), std::max(a.at, b.at), curve});
    return;
  }
  seams_[step.cell].push_back({from, to, curve});
}

void Builder::mark_along(const Along& along) {
  for (const EdgePoints::Part& part : edges_.parts(along.edge)) {
    if (part.from < along.from || part.to > along.to) continue;
    // Of curves on one another the first has the side.
    mesh_.seams.try_emplace(ShellMesh::pair_key(part.first, part.last), along.curve);
  }
}

void Builder::mark_knuckle(int edge) {
  const int h = edges_.front(edge), twin = cells_.twin(h);
  if (twin < 0 || !cells_.is_crease(h)) return;
  for (const EdgePoints::Part& part : edges_.parts(edge)) {
    // One angle for each part, in its middle, as seen from the two cells.
    const std::int64_t middle = part.from + (part.to - part.from) / 2;
    const Vector2d one = on_half_edge(h, middle),
                   other = on_half_edge(twin, CellTriangulation::kParts - middle);
    const double angle = surface::angle_between(surface_.normal(h / 4, one.x(), one.y()),
                                                surface_.normal(twin / 4, other.x(), other.y()),
                                                mesh_.points[part.last] - mesh_.points[part.first]);
    if (!std::isfinite(angle)) continue;
    mesh_.knuckles.emplace(ShellMesh::pair_key(part.first, part.last), angle);
  }
}

Vector2d Builder::lengths_of(int cell) const {
  const int h = 4 * cell;
  // Of opposite sides the longer one tells how finely the cell is cut.
  const auto longer = [&](int a, int b) {
    return std::max({edges_.length(cells_.edge(a)), edges_.length(cells_.edge(b)), 1e-9 * size_});
  };
  // A cell's side without length must not make the triangulation's square a line.
  return {longer(h, h + 2), longer(h + 1, h + 3)};
}

Vector2d Builder::turns_of(int cell) const {
  const int h = 4 * cell;
  const auto more = [&](int a, int b) {
    return std::max(edges_.turn(cells_.edge(a)), edges_.turn(cells_.edge(b)));
  };
  return {more(h, h + 2), more(h + 1, h + 3)};
}

int Builder::add(CellTriangulation& net, const Vector2d& uv) {
  // The net decides by whole numbers; exact places are kept beside it.
  const int local = net.add(on_grid(uv));
  if (local == static_cast<int>(uv_.size())) uv_.push_back(uv);
  return local;
}

void Builder::add_inner_points(const Vector2d& lengths, const Vector2d& turns,
                               const std::vector<SeamPart>& parts, CellTriangulation& net) {
  const int nu = parts_of(lengths.x(), turns.x()), nv = parts_of(lengths.y(), turns.y());
  const double clear = kClear * std::min(lengths.x() / nu, lengths.y() / nv);
  for (int i = 1; i < nu; ++i) {
    for (int j = 1; j < nv; ++j) {
      const Vector2d uv(static_cast<double>(i) / nu, static_cast<double>(j) / nv);
      const bool free = std::none_of(parts.begin(), parts.end(), [&](const SeamPart& part) {
        return distance_to(part, uv, lengths) < clear;
      });
      if (free) add(net, uv);
    }
  }
}

int Builder::point_of(int cell, int local) {
  const Vector2d& uv = uv_[local];
  for (int side = 0; side < 4; ++side) {
    const EdgePlace place = edges_.on_side(cell, side, on_grid(uv));
    // On a side: the point that the neighbour has there, too.
    if (place.edge >= 0) return edges_.point(place);
  }
  mesh_.points.push_back(surface_.position(cell, uv.x(), uv.y()));
  return static_cast<int>(mesh_.points.size()) - 1;
}

void Builder::triangulate(int cell) {
  const int h = 4 * cell;
  const Vector2d lengths = lengths_of(cell);
  CellTriangulation net(lengths);
  uv_.clear();
  // The net begins with the corners, in this order.
  for (int side = 0; side < 4; ++side) uv_.push_back(on_square_side(side, 0.0));
  for (int side = 0; side < 4; ++side) {
    const bool front = cells_.is_edge_front(h + side);
    for (const auto& [at, point] : edges_.on_edge(cells_.edge(h + side))) {
      add(net, on_half_edge(h + side, front ? at : CellTriangulation::kParts - at));
    }
  }
  const std::vector<SeamPart> parts = noded(seams_[cell]);
  std::vector<std::array<int, 2>> ends;
  for (const SeamPart& part : parts) {
    const int a = add(net, part.from);
    ends.push_back({a, add(net, part.to)});
  }
  add_inner_points(lengths, turns_of(cell), parts, net);
  // Once all points are there: an edge through a point is divided by it.
  for (std::size_t i = 0; i < parts.size(); ++i) {
    net.constrain(ends[i][0], ends[i][1], parts[i].curve);
  }

  std::vector<int> number;
  for (std::size_t i = 0; i < uv_.size(); ++i) {
    number.push_back(point_of(cell, static_cast<int>(i)));
  }
  for (const auto& [a, b, c] : net.triangles()) {
    mesh_.triangles.push_back({cell, {number[a], number[b], number[c]}, {uv_[a], uv_[b], uv_[c]}});
  }
  for (const auto& edge : net.constraints()) {
    mesh_.seams.try_emplace(ShellMesh::pair_key(number[edge.a], number[edge.b]), edge.tag);
  }
}

}  // namespace

ShellMesh shell_mesh(const surface::LimitSurface& surface, const std::vector<SurfaceCurve>& curves,
                     double size, const surface::Progress& progress) {
  return Builder(surface, size).build(curves, progress);
}

}  // namespace hull::production
