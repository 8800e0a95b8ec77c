// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/shell_mesh.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "production/plates/cell_triangulation.h"
#include "production/plates/seam_nodes.h"
#include "surface/creases/knuckle_angle.h"
#include "surface/place_in_cell.h"

namespace hull::production {

using Eigen::Vector2d;
using mesh::Topology;
using surface::on_square_side;
using Grid = CellTriangulation::Grid;

namespace {

constexpr std::int64_t kParts = CellTriangulation::kParts;
constexpr std::int64_t kSame = 12;
constexpr int kMostParts = 64;
// Points of the mesh's own keep this part of a triangle's side away from curves.
constexpr double kClear = 0.35;

Grid on_grid(const Vector2d& uv) {
  const auto whole = [](double x) { return std::llround(x * static_cast<double>(kParts)); };
  return {whole(uv.x()), whole(uv.y())};
}

// (0 … kParts) along half-edge h to a place in its cell.
Vector2d on_half_edge(int h, std::int64_t along) {
  return on_square_side(h % 4, static_cast<double>(along) / static_cast<double>(kParts));
}

class Builder {
 public:
  Builder(const surface::LimitSurface& surface, double size)
      : surface_(surface),
        cells_(surface.cells()),
        size_(size),
        on_edge_(cells_.edge_count()),
        front_(cells_.edge_count(), -1),
        lengths_(cells_.edge_count()),
        seams_(surface.cell_count()) {
    mesh_.points.resize(cells_.vertex_count());
    for (int h = 0; h < cells_.half_edge_count(); ++h) {
      const Vector2d uv = on_square_side(h % 4, 0.0);
      mesh_.points[cells_.origin(h)] = surface.position(h / 4, uv.x(), uv.y());
      if (cells_.is_edge_front(h)) front_[cells_.edge(h)] = h;
    }
    for (int e = 0; e < cells_.edge_count(); ++e) lengths_[e] = length_of(front_[e]);
  }

  ShellMesh build(const std::vector<SurfaceCurve>& curves, const surface::Progress& progress) && {
    for (int k = 0; k < static_cast<int>(curves.size()); ++k) {
      for (const CurveStep& step : curves[k].steps) add_step(step, k);
    }
    for (int e = 0; e < cells_.edge_count(); ++e) divide_edge(e);
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
  struct EdgePlace {
    int edge = -1;
    std::int64_t at = 0;  // from the front half-edge's origin
  };

  double length_of(int h) const {
    double length = 0.0;
    Vector3d last = mesh_.points[cells_.origin(h)];
    for (int i = 1; i <= 4; ++i) {
      const Vector2d uv = on_square_side(h % 4, 0.25 * i);
      const Vector3d next = surface_.position(h / 4, uv.x(), uv.y());
      length += (next - last).norm();
      last = next;
    }
    return length;
  }

  // Where on the side of a cell a place of the grid is; corners count to the side that is asked
  // for.
  EdgePlace on_side(int cell, int side, const Grid& at) const {
    const std::int64_t t[] = {at[0], at[1], kParts - at[0], kParts - at[1]};
    const bool on[] = {at[1] == 0, at[0] == kParts, at[1] == kParts, at[0] == 0};
    if (!on[side]) return {};
    const int h = 4 * cell + side;
    return {cells_.edge(h), cells_.is_edge_front(h) ? t[side] : kParts - t[side]};
  }

  int edge_point(const EdgePlace& place) {
    const int h = front_[place.edge];
    if (place.at == 0) return cells_.origin(h);
    if (place.at == kParts) return cells_.origin(cells_.next(h));
    const auto [found, is_new] =
        on_edge_[place.edge].try_emplace(place.at, static_cast<int>(mesh_.points.size()));
    if (is_new) {
      const Vector2d uv = on_half_edge(h, place.at);
      mesh_.points.push_back(surface_.position(h / 4, uv.x(), uv.y()));
    }
    return found->second;
  }

  // The place on the same edge that is there already, within rounding.
  EdgePlace merged(EdgePlace place) const {
    const auto near = [&place](std::int64_t at) { return std::abs(at - place.at) <= kSame; };
    if (near(0)) return {place.edge, 0};
    if (near(kParts)) return {place.edge, kParts};
    const auto after = on_edge_[place.edge].lower_bound(place.at - kSame);
    if (after != on_edge_[place.edge].end() && near(after->first)) place.at = after->first;
    return place;
  }

  // An end of a step on a side of its cell goes to the point that is there.
  Vector2d put_on_sides(int cell, Vector2d uv) {
    for (int side = 0; side < 4; ++side) {
      EdgePlace place = on_side(cell, side, on_grid(uv));
      if (place.edge < 0) continue;
      place = merged(place);
      edge_point(place);
      const int h = 4 * cell + side;
      uv = on_half_edge(h, cells_.is_edge_front(h) ? place.at : kParts - place.at);
    }
    return uv;
  }

  void add_step(const CurveStep& step, int curve) {
    const Vector2d from = put_on_sides(step.cell, step.from);
    const Vector2d to = put_on_sides(step.cell, step.to);
    for (int side = 0; side < 4; ++side) {
      const EdgePlace a = on_side(step.cell, side, on_grid(from));
      const EdgePlace b = on_side(step.cell, side, on_grid(to));
      if (a.edge < 0 || b.edge < 0) continue;
      along_.push_back({a.edge, std::min(a.at, b.at), std::max(a.at, b.at), curve});
      return;
    }
    seams_[step.cell].push_back({from, to, curve});
  }

  // Points of the mesh's own where curves leave room.
  void divide_edge(int e) {
    const int parts = std::clamp(static_cast<int>(std::ceil(lengths_[e] / size_)), 1, kMostParts);
    const auto clear = static_cast<std::int64_t>(kClear * static_cast<double>(kParts) / parts);
    std::vector<std::int64_t> taken;
    for (const auto& [at, point] : on_edge_[e]) taken.push_back(at);
    for (int i = 1; i < parts; ++i) {
      const std::int64_t at = kParts / parts * i;
      const bool free = std::none_of(taken.begin(), taken.end(), [&](std::int64_t other) {
        return std::abs(at - other) < clear;
      });
      if (free) edge_point({e, at});
    }
  }

  template <class Visit>
  void for_each_part(int e, const Visit& visit) {
    std::int64_t last = 0;
    int point = edge_point({e, 0});
    for (const auto& [at, next] : std::map(on_edge_[e])) {
      visit(last, point, at, next);
      last = at;
      point = next;
    }
    visit(last, point, kParts, edge_point({e, kParts}));
  }

  void mark_along(const Along& along) {
    for_each_part(along.edge, [&](std::int64_t a, int p, std::int64_t b, int q) {
      if (a >= along.from && b <= along.to) {
        mesh_.seams.try_emplace(ShellMesh::pair_key(p, q), along.curve);
      }
    });
  }

  void mark_knuckle(int e) {
    const int h = front_[e], twin = cells_.twin(h);
    if (twin < 0 || !cells_.is_crease(h)) return;
    for_each_part(e, [&](std::int64_t a, int p, std::int64_t b, int q) {
      const std::int64_t middle = a + (b - a) / 2;
      const Vector2d one = on_half_edge(h, middle), other = on_half_edge(twin, kParts - middle);
      const double angle = surface::angle_between(
          surface_.normal(h / 4, one.x(), one.y()), surface_.normal(twin / 4, other.x(), other.y()),
          mesh_.points[q] - mesh_.points[p]);
      if (std::isfinite(angle)) mesh_.knuckles.emplace(ShellMesh::pair_key(p, q), angle);
    });
  }

  void triangulate(int cell);
  void add_inner_points(const Vector2d& lengths, const std::vector<SeamPart>& parts,
                        CellTriangulation& net);
  int point_of(int cell, int local, const Grid& at);

  const surface::LimitSurface& surface_;
  const Topology& cells_;
  double size_;
  std::vector<std::map<std::int64_t, int>> on_edge_;
  std::vector<int> front_;
  std::vector<double> lengths_;
  std::vector<std::vector<SeamPart>> seams_;  // by cell
  std::vector<Along> along_;
  ShellMesh mesh_;

  // Of the cell that is being cut: of its net's points.
  std::vector<Grid> grid_;
  std::vector<Vector2d> uv_;
};

void Builder::add_inner_points(const Vector2d& lengths, const std::vector<SeamPart>& parts, CellTriangulation& net) {
  const auto count = [&](double length) {
    return std::clamp(static_cast<int>(std::ceil(length / size_)), 1, kMostParts);
  };
  const int nu = count(lengths.x()), nv = count(lengths.y());
  const double clear = kClear * std::min(lengths.x() / nu, lengths.y() / nv);
  for (int i = 1; i < nu; ++i) {
    for (int j = 1; j < nv; ++j) {
      const Vector2d uv(static_cast<double>(i) / nu, static_cast<double>(j) / nv);
      const bool free = std::none_of(parts.begin(), parts.end(), [&](const SeamPart& part) {
        return distance_to(part, uv, lengths) < clear;
      });
      if (!free) continue;
      const Grid at = on_grid(uv);
      if (net.add(at) == static_cast<int>(grid_.size())) {
        grid_.push_back(at);
        uv_.push_back(uv);
      }
    }
  }
 
}

int Builder::point_of(int cell, int local, const Grid& at) {
  for (int side = 0; side < 4; ++side) {
    if (const EdgePlace place = on_side(cell, side, at); place.edge >= 0) return edge_point(place);
  }
  const Vector2d& uv = uv_[local];
  mesh_.points.push_back(surface_.position(cell, uv.x(), uv.y()));
  return static_cast<int>(mesh_.points.size()) - 1;
}

void Builder::triangulate(int cell) {
  const int h = 4 * cell;
  const auto longer = [&](int a, int b) {
    return std::max({lengths_[cells_.edge(a)], lengths_[cells_.edge(b)], 1e-9 * size_});
  };
  const Vector2d lengths(longer(h, h + 2), longer(h + 1, h + 3));
  CellTriangulation net(lengths);
  grid_.clear();
  uv_.clear();
  for (int side = 0; side < 4; ++side) {
    uv_.push_back(on_square_side(side, 0.0));
    grid_.push_back(on_grid(uv_.back()));
  }
  const auto add = [&](const Grid& at, const Vector2d& uv) {
    const int local = net.add(at);
    if (local == static_cast<int>(grid_.size())) {
      grid_.push_back(at);
      uv_.push_back(uv);
    }
    return local;
  };
  for (int side = 0; side < 4; ++side) {
    const bool front = cells_.is_edge_front(h + side);
    for (const auto& [at, point] : on_edge_[cells_.edge(h + side)]) {
      const Vector2d uv = on_half_edge(h + side, front ? at : kParts - at);
      add(on_grid(uv), uv);
    }
  }
  const std::vector<SeamPart> parts = noded(seams_[cell]);
  std::vector<std::array<int, 2>> ends;
  for (const SeamPart& part : parts) {
    const int a = add(on_grid(part.from), part.from);
    ends.push_back({a, add(on_grid(part.to), part.to)});
  }
  add_inner_points(lengths, parts, net);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    net.constrain(ends[i][0], ends[i][1], parts[i].curve);
  }

  std::vector<int> number;
  for (std::size_t i = 0; i < grid_.size(); ++i) {
    number.push_back(point_of(cell, static_cast<int>(i), grid_[i]));
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
