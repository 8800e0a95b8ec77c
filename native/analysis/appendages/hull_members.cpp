// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/appendages/hull_members.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/appendages/piece_integrals.h"
#include "surface/pieces/pieces.h"

namespace hull::analysis {
namespace {

constexpr double kFinestJoint = 1e-12;
constexpr double kSquare = 1e-7;  // of the mesh's size
constexpr double kThickness =
    0.125;  // of the least side of a hull's box, what lines should not miss

constexpr double kFlat = 1e-9;  // of a box's diagonal: what its thickness is by rounding

struct HullPatches {
  std::vector<surface::BezierPatch> patches;
  std::vector<bool> without_area;
};

surface::BezierPatch mirror_image(const surface::BezierPatch& patch) {
  surface::BezierPatch image;
  for (int k = 0; k < 3; ++k) {
    for (int j = 0; j < 4; ++j) {
      for (int i = 0; i < 4; ++i) {
        // u and v change places, as mirroring turns the normal inwards.
        image.x[k][4 * i + j] = k == 1 ? 0.0 - patch.x[k][4 * j + i] : patch.x[k][4 * j + i];
      }
    }
  }
  return image;
}

void add(HullPatches& all, const surface::BicubicPoints& points, bool is_closing, bool mirrored) {
  all.patches.push_back(surface::BezierPatch::from_bspline(points));
  all.without_area.push_back(is_closing);
  if (!mirrored) return;
  all.patches.push_back(mirror_image(all.patches.back()));
  all.without_area.push_back(is_closing);
}

}  // namespace

std::vector<JoinedMember> hull_members(const HullBody& body) {
  const surface::LimitSurface& surface = body.surface();
  const Bodies& bodies = body.bodies();
  std::vector<HullPatches> all(bodies.first_cell.size());
  const double least = kSquare * surface.mesh().size();
  for (std::size_t cell = 0; cell < bodies.of_cell.size(); ++cell) {
    HullPatches& own = all[bodies.of_cell[cell]];
    for_each_piece(
        surface, static_cast<int>(cell),
        [&](const surface::CornerSquare& square) { return square.extent() > least; },
        [&](const surface::SurfacePiece& piece) {
          add(own, piece.points, false, body.mirrored());
        });
  }
  // Closings count for volumes and for what is inside, but not for the wetted surface.
  for (const ClosingPatch& closing : body.closings()) {
    add(all[bodies.of_cell[closing.cell]], closing.cap, true, body.mirrored());
  }
  std::vector<JoinedMember> members;
  for (HullPatches& own : all) {
    Eigen::AlignedBox3d box;
    for (const surface::BezierPatch& patch : own.patches) box.extend(patch.box());
    ClosedShell shell(std::move(own.patches), kThickness * box.sizes().minCoeff());
    members.push_back({std::move(shell), MemberRole::kHull, "hull", std::move(own.without_area)});
  }
  return members;
}

double enclosed_share(const ClosedShell& shell) {
  const Eigen::AlignedBox3d& box = shell.box();
  // Of a sheet square to an axis both volumes are rounding.
  if (box.sizes().minCoeff() <= kFlat * box.diagonal().norm()) return 0.0;
  // The volume is exact at once, and the area, which takes time, is not asked for.
  const PieceRule rule{box.center(), 0.0, std::numeric_limits<double>::infinity()};
  double fluxes = 0.0;
  for (const surface::BezierPatch& patch : shell.patches()) {
    fluxes += whole_patch_moments(patch, rule).first.trace();
  }
  // A third of the sum of the fluxes of (x, 0, 0), (0, y, 0) and (0, 0, z) is the volume.
  return fluxes / 3.0 / box.volume();
}

std::shared_ptr<const JoinedShells> joined_shells(const HullBody& body,
                                                  const std::vector<Appendage>& appendages) {
  std::vector<JoinedMember> members = hull_members(body);
  // Nothing is within a sheet, and lines as near as it is thin would have no end.
  std::erase_if(members, [](const JoinedMember& member) {
    return std::abs(enclosed_share(member.shell)) <= kSheetShare;
  });
  for (const Appendage& appendage : appendages) {
    const MemberRole role = appendage.is_cut ? MemberRole::kCut : MemberRole::kAdded;
    ClosedShell shell = shell_of(appendage.shape);
    // Without the appendage, which is listed once.
    if (appendage.mirrored) members.push_back({mirror_image(shell), role, appendage.name});
    members.push_back({std::move(shell), role, appendage.name, {}, appendage});
  }
  // Parts of lines, some four million a second and processor: three times what the sailing yacht's
  // rudder takes, which is a part of its hull's mesh, and five times what the samples' appendages
  // take. A box keel of the hull's own takes eleven million. With those of own_overlaps(), which
  // is asked where this is refused, less than two seconds of two processors.
  PartsLeft parts_left = appendages.empty() ? 12000000 : 20000000;
  return std::make_shared<const JoinedShells>(
      std::move(members), body.centre(), std::max(kFinestJoint, body.tolerance()), &parts_left);
}

}  // namespace hull::analysis
