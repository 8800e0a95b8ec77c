// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/grid/hull_grid.h"

#include <cmath>

#include "mesh/tolerances.h"
#include "production/grid/closing_strips.h"
#include "production/grid/grid_points.h"

namespace hull::production {
namespace {

class GridBuilder {
 public:
  GridBuilder(const analysis::HullBody& body, const SidePoints& sides, const GridOptions& options)
      : body_(body),
        surface_(body.surface()),
        sides_(sides),
        options_(options),
        numbers_(surface_.cells(), sides.divisions()) {}

  HullGrid build() {
    grid_.points.resize(numbers_.count());
    done_.resize(numbers_.count(), 0);
    for (int cell = 0; cell < surface_.cell_count(); ++cell) {
      surface::tell(options_.progress, cell, surface_.cell_count());
      add_cell(cell);
    }
    add_knuckles();
    const std::vector<BorderLoop> loops = border_loops();
    if (body_.mirrored()) put_on_centre_plane(loops);
    // The shell's image comes before all closings: their common sides are the shell's.
    std::vector<int> images;
    if (body_.mirrored() && options_.both_sides) images = add_image();
    ClosingStrips strips(grid_, options_, kNoLength * surface_.mesh().size());
    for (const BorderLoop& loop : loops) {
      close(loop, images, strips);
      if (!images.empty() && loop.kind != ClosingKind::kToCentrePlane) {
        close(image_of(loop, images), images, strips);
      }
    }
    return std::move(grid_);
  }

 private:
  void add_cell(int cell) {
    const int nu = sides_.divisions().u(cell), nv = sides_.divisions().v(cell);
    std::vector<Eigen::Vector2d> uv;
    for (int j = 0; j <= nv; ++j) {
      for (int i = 0; i <= nu; ++i) {
        uv.push_back(sides_.uv(cell, i, j));
        const int point = numbers_.at(cell, i, j);
        // A common point is that of the first cell that has it.
        if (done_[point]) continue;
        done_[point] = 1;
        grid_.points[point] = surface_.position(cell, uv.back().x(), uv.back().y());
      }
    }
    for (int j = 0; j < nv; ++j) {
      for (int i = 0; i < nu; ++i) {
        grid_.quads.push_back({numbers_.at(cell, i, j), numbers_.at(cell, i + 1, j),
                               numbers_.at(cell, i + 1, j + 1), numbers_.at(cell, i, j + 1)});
        if (!options_.places) continue;
        // Rows of nu + 1 parameters: the corners counter-clockwise from (i, j).
        const int low = j * (nu + 1) + i, high = low + nu + 1;
        grid_.places.push_back({cell, false, {uv[low], uv[low + 1], uv[high + 1], uv[high]}});
      }
    }
  }

  void add_knuckles() {
    const mesh::Topology& cells = surface_.cells();
    for (int h = 0; h < cells.half_edge_count(); ++h) {
      if (!cells.is_edge_front(h) || !cells.is_crease(h)) continue;
      for (int k = 0; k < sides_.divisions().side(h); ++k) {
        grid_.knuckles.push_back({numbers_.on_side(h, k), numbers_.on_side(h, k + 1)});
      }
    }
  }

  // Closings come in the order of the border's edges.
  std::vector<BorderLoop> border_loops() const {
    std::vector<BorderLoop> loops;
    const auto& border = body_.border();
    for (std::size_t e = 0; e < border.size(); ++e) {
      // The first edge of a loop tells how all of it is closed.
      if (border[e].loop == static_cast<int>(loops.size())) {
        loops.push_back(
            loop_closed_by(body_.closings()[e], body_.mirrored(), surface_.mesh().size()));
      }
      const int h = border[e].half_edge;
      for (int k = 0; k < sides_.divisions().side(h); ++k) {
        loops.back().points.push_back(numbers_.on_side(h, k));
      }
    }
    return loops;
  }

  void put_on_centre_plane(const std::vector<BorderLoop>& loops) {
    const double near = kOnCentrePlane * surface_.mesh().size();
    shared_.assign(numbers_.count(), 0);
    for (const BorderLoop& loop : loops) {
      if (loop.kind != ClosingKind::kToCentrePlane) continue;
      for (int p : loop.points) {
        if (std::abs(grid_.points[p].y()) > near) continue;
        grid_.points[p].y() = 0.0;
        shared_[p] = 1;
      }
    }
  }

  // Numbers of the mirror images, the points' own where both sides share them.
  std::vector<int> add_image() {
    // Points of the grid come before those of closings, which have images of their own.
    std::vector<int> images(numbers_.count());
    for (int p = 0; p < numbers_.count(); ++p) {
      images[p] = p;
      if (shared_[p]) continue;
      images[p] = static_cast<int>(grid_.points.size());
      const Vector3d& own = grid_.points[p];
      grid_.points.push_back({own.x(), -own.y(), own.z()});
    }
    const std::size_t quads = grid_.quads.size(), knuckles = grid_.knuckles.size();
    for (std::size_t q = 0; q < quads; ++q) {
      const std::array<int, 4> own = grid_.quads[q];
      // Mirroring turns a face over: corners run the other way round from the same first one.
      grid_.quads.push_back({images[own[0]], images[own[3]], images[own[2]], images[own[1]]});
      if (!options_.places) continue;
      const QuadPlace place = grid_.places[q];
      grid_.places.push_back(
          {place.cell, true, {place.uv[0], place.uv[3], place.uv[2], place.uv[1]}});
    }
    for (std::size_t k = 0; k < knuckles; ++k) {
      const std::array<int, 2> own = grid_.knuckles[k];
      const std::array<int, 2> image{images[own[0]], images[own[1]]};
      // A knuckle in the centre plane is its own image.
      if (image != own) grid_.knuckles.push_back(image);
    }
    return images;
  }

  static BorderLoop image_of(const BorderLoop& loop, const std::vector<int>& images) {
    BorderLoop image = loop;
    image.end.y() = -image.end.y();
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      // Backwards, so that the image has its own surface on the left again.
      image.points[i] = images[loop.points[loop.points.size() - 1 - i]];
    }
    return image;
  }

  void close(const BorderLoop& loop, const std::vector<int>& images, ClosingStrips& strips) {
    switch (loop.kind) {
      case ClosingKind::kToCentrePlane:
        return strips.close_to_centre_plane(loop, images.empty() ? nullptr : &images);
      case ClosingKind::kToOwnPlane:
        return strips.close_to_own_plane(loop);
      case ClosingKind::kToPoint:
        return strips.close_to_point(loop);
    }
  }

  const analysis::HullBody& body_;
  const surface::LimitSurface& surface_;
  const SidePoints& sides_;
  const GridOptions& options_;
  GridPoints numbers_;
  HullGrid grid_;
  std::vector<char> done_, shared_;  // by point
};

}  // namespace

HullGrid hull_grid(const analysis::HullBody& body, const SidePoints& sides,
                   const GridOptions& options) {
  return GridBuilder(body, sides, options).build();
}

}  // namespace hull::production
