// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/sampling/chord_divisions.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "surface/pieces/pieces.h"
#include "surface/sampling/chord_bound.h"

namespace hull::surface {
namespace {

// A block of quadrilaterals of a cell: [i0, i1] x [j0, j1] of its grid.
struct QuadBlock {
  int i0, i1, j0, j1;
  int columns() const { return i1 - i0; }
  int rows() const { return j1 - j0; }
};

// How much a quadrilateral fails by, and along which sides the surface sags.
struct Excess {
  double ratio = 0.0;  // of the bound to the tolerance
  bool u = false, v = false;
};

// Tells whether a cell's divisions do.
class CellCheck {
 public:
  CellCheck(const LimitSurface& surface, double tolerance)
      : surface_(surface), tolerance_(tolerance) {}

  // None if they do; otherwise how a bad one of the quadrilaterals fails.
  std::optional<Excess> excess(int cell, int nu, int nv) {
    cell_ = cell;
    nu_ = nu;
    nv_ = nv;
    const SurfaceNode& root = surface_.layout().root(cell);
    if (root.kind == SurfaceNode::Kind::kLeaf) {
      // A regular cell is one piece, and holds all its quadrilaterals.
      return check_piece({0, nu, 0, nv}, {cell, 0.0, 0.0, 1.0, surface_.leaf(root.index)});
    }
    return check_pieces();
  }

 private:
  // Blocks of whole quadrilaterals within pieces; then those that no piece holds.
  std::optional<Excess> check_pieces() {
    done_.assign(static_cast<std::size_t>(nu_) * nv_, 0);
    std::optional<Excess> worst;
    const double finest = 1.0 / std::max(nu_, nv_);
    for_each_piece(
        // Smaller pieces hold no whole quadrilateral.
        surface_, cell_, [&](const CornerSquare& square) { return !worst && square.size > finest; },
        [&](const SurfacePiece& piece) {
          const QuadBlock block = block_within(piece);
          if (worst || block.columns() < 1 || block.rows() < 1) return;
          for (int j = block.j0; j < block.j1; ++j) {
            std::fill_n(done_.begin() + j * nu_ + block.i0, block.columns(), 1);
          }
          worst = check_piece(block, piece);
        });
    for (int j = 0; j < nv_; ++j) {
      for (int i = 0; i < nu_ && !worst; ++i) {
        if (!done_[j * nu_ + i]) worst = check_quad(i, j);
      }
    }
    return worst;
  }

  QuadBlock block_within(const SurfacePiece& piece) const {
    const auto first = [](double at, int n) { return static_cast<int>(std::ceil(at * n)); };
    const auto last = [](double at, int n) { return static_cast<int>(std::floor(at * n)); };
    return {first(piece.u, nu_), last(piece.u + piece.size, nu_), first(piece.v, nv_),
            last(piece.v + piece.size, nv_)};
  }

  std::optional<Excess> check_piece(const QuadBlock& block, const SurfacePiece& piece) {
    return check_block(block, piece, block_bound(block, piece));
  }

  double block_bound(const QuadBlock& block, const SurfacePiece& piece) const {
    const auto u = [&](int i) { return (static_cast<double>(i) / nu_ - piece.u) / piece.size; };
    const auto v = [&](int j) { return (static_cast<double>(j) / nv_ - piece.v) / piece.size; };
    return smooth_bound(
        bezier_points(piece.points, u(block.i0), u(block.i1), v(block.j0), v(block.j1)),
        block.columns(), block.rows());
  }

  // Halves what fails as a whole, the worse half first.
  std::optional<Excess> check_block(const QuadBlock& block, const SurfacePiece& piece,
                                    double bound) {
    if (bound <= tolerance_) return std::nullopt;
    if (block.columns() == 1 && block.rows() == 1) return check_quad(block.i0, block.j0);
    QuadBlock halves[] = {block, block};
    if (block.columns() >= block.rows()) {
      halves[0].i1 = halves[1].i0 = (block.i0 + block.i1) / 2;
    } else {
      halves[0].j1 = halves[1].j0 = (block.j0 + block.j1) / 2;
    }
    double bounds[] = {block_bound(halves[0], piece), block_bound(halves[1], piece)};
    const int worse = bounds[1] > bounds[0];
    // One that fails is all that is asked for, so the likelier half saves the other.
    if (auto excess = check_block(halves[worse], piece, bounds[worse])) return excess;
    return check_block(halves[1 - worse], piece, bounds[1 - worse]);
  }

  // One quadrilateral, of as many pieces as it may have: by the convex hulls of their parts within
  // it, and of what is left at a knot.
  std::optional<Excess> check_quad(int i, int j) {
    const double u0 = static_cast<double>(i) / nu_, u1 = static_cast<double>(i + 1) / nu_;
    const double v0 = static_cast<double>(j) / nv_, v1 = static_cast<double>(j + 1) / nv_;
    const std::array<Vector3d, 4> corners{
        surface_.position(cell_, u0, v0), surface_.position(cell_, u1, v0),
        surface_.position(cell_, u1, v1), surface_.position(cell_, u0, v1)};
    const QuadGauge gauge(corners);
    double bound = 0.0;
    const auto overlaps = [&](double u, double v, double size) {
      return u < u1 && u + size > u0 && v < v1 && v + size > v0;
    };
    for_each_piece(
        surface_, cell_,
        [&](const CornerSquare& square) {
          if (!overlaps(square.u, square.v, square.size)) return false;
          double most = 0.0;
          for (const Vector3d& p : square.points()) most = std::max(most, gauge.bound(p));
          // What is left is good, or as small as rounding.
          if (most > tolerance_ && square.size > kSmallestSquare) return bound <= tolerance_;
          bound = std::max(bound, most);
          return false;
        },
        [&](const SurfacePiece& piece) {
          if (bound > tolerance_ || !overlaps(piece.u, piece.v, piece.size)) return;
          const auto part = [&piece](double at, double begin) {
            return std::clamp((at - begin) / piece.size, 0.0, 1.0);
          };
          for (const Vector3d& p : bezier_points(piece.points, part(u0, piece.u), part(u1, piece.u),
                                                 part(v0, piece.v), part(v1, piece.v))) {
            bound = std::max(bound, gauge.bound(p));
          }
        });
    if (bound <= tolerance_) return std::nullopt;
    // How far the middle of a side is off its chord.
    const auto sag = [&](double u, double v, int a, int b) {
      const Vector3d chord = corners[b] - corners[a];
      const Vector3d d = surface_.position(cell_, u, v) - corners[a];
      const double square = chord.squaredNorm();
      return (square > 0.0 ? Vector3d(d - d.dot(chord) / square * chord) : d).norm();
    };
    const double um = 0.5 * (u0 + u1), vm = 0.5 * (v0 + v1);
    const double along_u = std::max(sag(um, v0, 0, 1), sag(um, v1, 3, 2));
    const double along_v = std::max(sag(u0, vm, 0, 3), sag(u1, vm, 1, 2));
    // A side that sags less than half as much as the other is left as it is.
    return Excess{bound / tolerance_, 2.0 * along_u >= along_v, 2.0 * along_v >= along_u};
  }

  static constexpr double kSmallestSquare = 0x1p-58;

  const LimitSurface& surface_;
  double tolerance_;
  int cell_ = 0, nu_ = 1, nv_ = 1;
  std::vector<char> done_;
};

// The parts to try after n, given how much too large the bound is: it falls as 1/n² or slower.
int grown(int n, double ratio) {
  // What is more than allowed tells that nothing does.
  if (n == kMostDivisions) return n + 1;
  const int more = static_cast<int>(n * std::min(2.0, std::sqrt(ratio)));
  return std::clamp(more, n + 1, kMostDivisions);
}

// To two digits, as it will be read.
double rounded_up(double length) {
  const double unit = std::pow(10.0, std::floor(std::log10(length)) - 1.0);
  return std::ceil(length / unit) * unit;
}

}  // namespace

CellDivisions::CellDivisions(const mesh::Topology& cells, int n) : cells_(&cells) {
  // Sides of a cell that face each other belong together.
  std::vector<int> parent(cells.edge_count());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&parent](int e) {
    // Union-find with paths halved.
    while (parent[e] != e) e = parent[e] = parent[parent[e]];
    return e;
  };
  for (int cell = 0; cell < cells.face_count(); ++cell) {
    for (int h : {4 * cell, 4 * cell + 1}) parent[root(cells.edge(h))] = root(cells.edge(h + 2));
  }
  strip_of_edge_.assign(cells.edge_count(), -1);
  for (int e = 0; e < cells.edge_count(); ++e) {
    int& strip = strip_of_edge_[root(e)];
    if (strip < 0) {
      strip = strip_count();
      counts_.push_back(n);
    }
    strip_of_edge_[e] = strip;
  }
}

double CellDivisions::quad_count() const {
  double count = 0.0;
  for (int cell = 0; cell < cells_->face_count(); ++cell) {
    count += static_cast<double>(u(cell)) * v(cell);
  }
  return count;
}

std::optional<CellDivisions> chord_divisions(const LimitSurface& surface, double tolerance) {
  CellDivisions divisions(surface.cells(), 1);
  CellCheck check(surface, tolerance);
  std::vector<char> changed(divisions.strip_count(), 1);
  for (bool any = true; any;) {
    any = false;
    // Strips grow after all cells were looked at, so that the order of cells has no part in it; a
    // cell whose strips stayed has passed before.
    std::vector<int> wanted(divisions.strip_count(), 0);
    for (int cell = 0; cell < surface.cell_count(); ++cell) {
      const int strip_u = divisions.strip(4 * cell), strip_v = divisions.strip(4 * cell + 1);
      if (!changed[strip_u] && !changed[strip_v]) continue;
      const auto excess = check.excess(cell, divisions.u(cell), divisions.v(cell));
      if (!excess) continue;
      any = true;
      for (const auto& [strip, sags] : {std::pair(strip_u, excess->u), {strip_v, excess->v}}) {
        const int n = divisions.side(strip == strip_u ? 4 * cell : 4 * cell + 1);
        if (sags) wanted[strip] = std::max(wanted[strip], grown(n, excess->ratio));
      }
    }
    for (int strip = 0; strip < divisions.strip_count(); ++strip) {
      changed[strip] = wanted[strip] > 0;
      if (wanted[strip] > kMostDivisions) return std::nullopt;
      if (wanted[strip] > 0) divisions.set(strip, wanted[strip]);
    }
    if (any && divisions.quad_count() > kMostQuads) return std::nullopt;
  }
  return divisions;
}

CellDivisions chord_divisions_for(const LimitSurface& surface, double chord_tolerance) {
  std::ostringstream message;
  if (!(chord_tolerance > 0.0) || !std::isfinite(chord_tolerance)) {
    message << "The chord tolerance must be a positive length, not " << chord_tolerance << " m.";
    throw std::invalid_argument(message.str());
  }
  if (auto divisions = chord_divisions(surface, chord_tolerance)) return *divisions;
  // Twice as much each time, until that does; one strip that fails ends each trial early.
  double enough = std::max(chord_tolerance, 1e-10 * surface.mesh().size());
  do {
    enough = rounded_up(2.0 * enough);
  } while (!chord_divisions(surface, enough));
  message << "A chord tolerance of " << chord_tolerance << " m takes more than " << kMostDivisions
          << " divisions of a cell, or more than 2^24 quadrilaterals. " << enough << " m would do.";
  throw std::invalid_argument(message.str());
}

}  // namespace hull::surface
