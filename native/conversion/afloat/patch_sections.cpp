// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/afloat/patch_sections.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/sections/section_arcs.h"
#include "analysis/sections/section_curves.h"
#include "conversion/afloat/plane_edges.h"
#include "mesh/tolerances.h"

namespace hull::conversion {
namespace {

using analysis::SectionCurve;
using analysis::SectionOptions;

// Of the set's size.
constexpr double kLiesFlat = 1e-10;      // pieces nearer to the plane lie in it, unless told
constexpr double kSmallestPiece = 1e-6;  // smaller ones are near it because they are small
constexpr double kKnuckleTurn = 1e-2;    // rad

void check_sections(const std::vector<analysis::Plane>& planes, const SectionOptions& options) {
  for (const analysis::Plane& plane : planes) {
    if (!std::isfinite(plane.offset) || !(std::abs(plane.normal.norm() - 1.0) < 1e-9)) {
      throw std::invalid_argument(
          "The plane of a section must have a normal of unit length and a finite position.");
    }
  }
  if (!(options.chord_tolerance > 0.0)) {
    throw std::invalid_argument("The chord tolerance of a section must be positive.");
  }
  if (options.flat_tolerance && !(*options.flat_tolerance >= 0.0)) {
    throw std::invalid_argument("The flat tolerance of a section must not be negative.");
  }
}

class PatchCutter {
 public:
  PatchCutter(const PatchPieces& pieces, const SectionOptions& options)
      : pieces_(pieces),
        chord_tolerance_(options.chord_tolerance),
        heights_{kZeroHeight * pieces.size(),
                 // A flat tolerance of nothing would leave it to rounding what lies flat.
                 std::max(options.flat_tolerance.value_or(kLiesFlat * pieces.size()),
                          kZeroHeight * pieces.size())},
        // No seam is a crease by itself: where patches meet at an angle, the turn tells.
        shell_{pieces.size(), kKnuckleTurn, [](int, const Eigen::Vector2d&) { return false; },
               [this](int piece, const Eigen::Vector2d& at) { return is_border(piece, at); }} {
    for (const PatchPieces::Piece& piece : pieces.pieces()) {
      Eigen::AlignedBox3d box;
      for (const Vector3d& point : piece.points) box.extend(point);
      boxes_.push_back(box);
    }
  }

  std::vector<SectionCurve> cut(const analysis::Plane& plane) {
    parts_.clear();
    PlaneEdges edges(pieces_, plane);
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      const double middle = plane.height(boxes_[i].center());
      const double half = 0.5 * plane.normal.cwiseAbs().dot(boxes_[i].sizes());
      if (std::abs(middle) > half + heights_.flat) continue;
      add_piece(static_cast<int>(i), plane, edges);
    }
    edges.add_arcs(chord_tolerance_, parts_);
    std::vector<SectionCurve> curves = section_curves(shell_, parts_);
    // Pieces are joined to curves by their own numbers and places, which are told of patches only
    // then.
    for (SectionCurve& curve : curves) bring_to_patches(curve);
    return curves;
  }

 private:
  void add_piece(int number, const analysis::Plane& plane, PlaneEdges& edges) {
    const auto& points = pieces_.pieces()[static_cast<std::size_t>(number)].points;
    const bool is_small = boxes_[static_cast<std::size_t>(number)].diagonal().norm() <
                          kSmallestPiece * pieces_.size();
    const analysis::HeightNet height = analysis::height_net(
        points, plane, heights_, is_small ? analysis::SideFlags{} : analysis::kAllSides);
    if (height.flat) return edges.add_flat(number);
    if (height.divided) edges.add_sides(number, height);
    const surface::SurfacePiece piece{number, 0.0, 0.0, 1.0, points};
    add_section_arcs(piece, height, plane, chord_tolerance_, heights_.zero, net_cut_, parts_);
  }

  bool is_border(int piece, const Eigen::Vector2d& at) const {
    const std::array<double, 4> along{at.x(), at.y(), 1.0 - at.x(), 1.0 - at.y()};
    const std::array<bool, 4> is_on{at.y() == 0.0, at.x() == 1.0, at.y() == 1.0, at.x() == 0.0};
    for (std::size_t k = 0; k < 4; ++k) {
      if (!is_on[k]) continue;
      for (const SideEdge& part : pieces_.set().sides[static_cast<std::size_t>(piece)][k]) {
        // An end between two parts is of both: a border if one of them is.
        if (along[k] < part.begin || along[k] > part.end) continue;
        if (pieces_.uses().is_border(part.edge)) return true;
      }
    }
    return false;
  }

  void bring_to_patches(SectionCurve& curve) const {
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const auto& piece = pieces_.pieces()[static_cast<std::size_t>(curve.cells[i])];
      curve.cells[i] = piece.patch;
      curve.uv[i] = {piece.u + piece.width * curve.uv[i].x(),
                     piece.v + piece.height * curve.uv[i].y()};
    }
  }

  const PatchPieces& pieces_;
  double chord_tolerance_;
  analysis::HeightTolerances heights_;
  analysis::SectionShell shell_;
  std::vector<Eigen::AlignedBox3d> boxes_;
  analysis::SectionParts parts_;
  analysis::NetCut net_cut_;
};

}  // namespace

std::vector<std::vector<SectionCurve>> patch_sections(const PatchPieces& pieces,
                                                      const std::vector<analysis::Plane>& planes,
                                                      const SectionOptions& options) {
  check_sections(planes, options);
  PatchCutter cutter(pieces, options);
  std::vector<std::vector<SectionCurve>> all;
  for (const analysis::Plane& plane : planes) all.push_back(cutter.cut(plane));
  return all;
}

}  // namespace hull::conversion
