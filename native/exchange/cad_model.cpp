// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/cad_model.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "conversion/centre_line.h"
#include "conversion/patches/flat_patches.h"
#include "conversion/patches/joined_borders.h"
#include "conversion/patches/mirror.h"
#include "conversion/place_error.h"
#include "exchange/cad_report.h"
#include "exchange/regions.h"
#include "exchange/solids/face_integrals.h"
#include "exchange/solids/joined_solids.h"
#include "mesh/tolerances.h"

namespace hull::exchange {
namespace {

// A control point takes about so many bytes in a file, and ten times as many in Open CASCADE's
// memory while the file is read back.
constexpr double kBytesOfPoint = 100.0, kMostBytes = 2e9;
constexpr double kJoined = 0.05;  // share of the time that appendages take

// Before anything is made of them.
void check_size(const conversion::PatchSet& patches, bool mirrored) {
  double points = 0.0;
  for (const conversion::BSplinePatch& patch : patches.patches) {
    points += static_cast<double>(patch.control_points.size());
  }
  if (mirrored) points *= 2.0;
  if (points * kBytesOfPoint <= kMostBytes) return;
  throw std::invalid_argument(
      "the file would have about " + std::to_string(std::lround(points * kBytesOfPoint / 1e6)) +
      " MB (" + std::to_string(std::lround(points / 1e6)) + " million control points of " +
      std::to_string(patches.patches.size()) +
      " patches), more than can be read back: convert with a larger "
      "tolerance, or a mesh of fewer faces, best of quadrilaterals");
}

void extend_box(Eigen::AlignedBox3d& box, const conversion::BSplinePatch& patch) {
  for (int i = 0; i <= kBoxSteps; ++i) {
    for (int j = 0; j <= kBoxSteps; ++j) {
      box.extend(
          patch.position(static_cast<double>(i) / kBoxSteps, static_cast<double>(j) / kBoxSteps));
    }
  }
}

// Regions of the patches that are left, in their order.
std::vector<std::string> regions_of(const conversion::PatchSet& all,
                                    const conversion::PatchSet& kept,
                                    const std::vector<bool>& is_kept,
                                    const std::vector<std::string>& given) {
  // By the patches that are left, so nothing has to be picked.
  if (given.empty()) return find_regions(kept);
  if (given.size() != all.patches.size()) {
    throw std::invalid_argument("regions must be one for each of the " +
                                std::to_string(all.patches.size()) + " patches, not " +
                                std::to_string(given.size()) + ".");
  }
  std::vector<std::string> regions;
  for (std::size_t p = 0; p < given.size(); ++p) {
    // Given for all patches, also for those without area that make no face.
    if (is_kept[p]) regions.push_back(given[p].empty() ? "shell" : given[p]);
  }
  return regions;
}

template <class Refuse>
void check_knots(const conversion::BSplineCurve& c, const Refuse& refuse) {
  // Before they are sorted, as what is no number is in any order.
  if (!std::ranges::all_of(c.knots, [](double knot) { return std::isfinite(knot); })) {
    refuse("a knot is not finite.");
  }
  // Not strictly: knots may be repeated.
  if (!std::ranges::is_sorted(c.knots) || !(c.knots.back() > c.knots.front())) {
    refuse("knots must ascend.");
  }
  // The curve is defined between these.
  const double begin = c.knots[c.degree], end = c.knots[c.points.size()];
  if (!(begin < end)) {
    refuse("its parameters have no range: the knots after the first and before the last " +
           std::to_string(c.degree) + " are all equal.");
  }
  for (std::size_t i = 0; i < c.knots.size(); ++i) {
    const bool is_end = c.knots[i] == begin || c.knots[i] == end;
    const std::size_t next = i + c.degree + (is_end ? 1 : 0);
    if (next >= c.knots.size() || c.knots[i] < c.knots[next]) continue;
    refuse("the knot " + std::to_string(c.knots[i]) +
           " is there too often: at most as often as the degree, and once more at the ends.");
  }
}

void check_curve(const CadCurve& curve) {
  const auto refuse = [&](const std::string& what) {
    throw std::invalid_argument("curve \"" + curve.name + "\": " + what);
  };
  const conversion::BSplineCurve& c = curve.curve;
  if (c.degree < 1 || c.points.size() < static_cast<std::size_t>(c.degree) + 1 ||
      c.knots.size() != c.points.size() + c.degree + 1) {
    refuse(
        "there must be degree + 1 knots more than control points, and at least degree + 1 of "
        "these.");
  }
  check_knots(c, refuse);
  if (!std::ranges::all_of(c.points, [](const Vector3d& p) { return p.allFinite(); })) {
    refuse("a control point is not finite.");
  }
}

std::vector<CadCurve> curves_of(const CadOptions& options, double size) {
  std::vector<CadCurve> curves;
  // A copy, which is clamped and mirrored.
  for (CadCurve curve : options.curves) {
    check_curve(curve);
    curve.curve = conversion::clamped(curve.curve);
    // The image would be the same curve a second time.
    const bool in_plane = std::ranges::all_of(curve.curve.points, [&](const Vector3d& p) {
      return std::abs(p.y()) <= kOnCentrePlane * size;
    });
    curves.push_back(curve);
    if (!options.mirrored || in_plane) continue;
    // Subtracted from zero, as the negative of 0 would be -0.
    for (Vector3d& point : curve.curve.points) point.y() = 0.0 - point.y();
    curves.push_back(std::move(curve));
  }
  return curves;
}

// Turns patches so that they have more knots along v than along u. Open CASCADE's integrals without
// a tolerance, which FreeCAD shows as volumes, integrate along u first, by a rule that is good only
// for few knots: on large faces they are off by 7 % the other way.
void turn_long_sides_to_v(conversion::PatchSet& set) {
  for (std::size_t p = 0; p < set.patches.size(); ++p) {
    if (set.patches[p].count_u <= set.patches[p].count_v) continue;
    // A turned patch begins a corner later, so its corners and sides move on by one.
    set.patches[p] = set.patches[p].turned();
    std::rotate(set.corners[p].begin(), set.corners[p].begin() + 1, set.corners[p].end());
    std::rotate(set.sides[p].begin(), set.sides[p].begin() + 1, set.sides[p].end());
  }
  // They tell of (u, v) as it was.
  set.blocks.clear();
}

// Of which a solid is closed in the centre plane.
bool is_on_one_side(const conversion::PatchSet& set) {
  // From zero, so that a set wholly on one side reaches nothing on the other.
  double low = 0.0, high = 0.0;
  for (const conversion::BSplinePatch& patch : set.patches) {
    for (const Vector3d& point : patch.control_points) {
      low = std::min(low, point.y());
      high = std::max(high, point.y());
    }
  }
  return std::min(-low, high) <= kNearCentrePlane * set.size();
}

void check_solid(const BRepShape& brep) {
  if (brep.free_edges > 0) {
    throw conversion::PlaceError(
        "no solid: " + std::to_string(brep.free_edges) +
            " edges of the hull and its caps have one face only, one of them at " +
            conversion::place_text(*brep.at_free_edge) +
            "; close the hull there with faces, or export without closing",
        *brep.at_free_edge);
  }
  if (brep.solids < brep.parts) {
    throw conversion::PlaceError(
        "no solid: the closed hull, or the part of it at " +
            conversion::place_text(*brep.at_no_solid) +
            ", has no volume or normals that point inwards; turn its faces",
        *brep.at_no_solid);
  }
}

}  // namespace

CadModel make_cad_model(const conversion::PatchSet& patches, const CadOptions& options) {
  check_size(patches, options.mirrored);
  patches.check();
  CadModel model;
  if (options.mirrored || (options.solid && is_on_one_side(patches))) {
    // Only where both sides are to meet there, or a cap is to close it.
    conversion::refuse_near_centre_line(patches.source, patches.size());
    const std::string gap = conversion::gap_warning(patches.source);
    if (!gap.empty()) model.warnings.push_back(gap);
  }
  conversion::WithoutFlatPatches flat = conversion::without_flat_patches(patches);
  if (flat.patches.patches.empty()) {
    throw std::invalid_argument("no patch has an area: nothing to write");
  }
  model.regions = regions_of(patches, flat.patches, flat.is_kept, options.regions);
  model.cells_left_out = std::move(flat.left_out);
  conversion::PatchSet set = options.mirrored ? conversion::with_mirror_image(flat.patches)
                             : options.solid  ? conversion::with_seam_in_plane(flat.patches)
                                              : std::move(flat.patches);
  if (options.mirrored) {
    const std::vector<std::string> half = model.regions;
    model.regions.insert(model.regions.end(), half.begin(), half.end());
  }
  turn_long_sides_to_v(set);
  conversion::join_borders(set);
  // After borders are joined: caps are made from their curves.
  const conversion::Closing closing =
      options.solid ? conversion::closing_of(set) : conversion::Closing{};
  model.brep = make_brep_shape(set, closing);
  // Without a solid open shells are well, and told as such.
  if (options.solid) check_solid(model.brep);
  // In the order of the faces: patches, then caps.
  for (const conversion::Cap& cap : closing.caps) model.regions.push_back(region_of(cap.kind));
  if (options.appendages.empty()) {
    for (const conversion::BSplinePatch& patch : set.patches) extend_box(model.box, patch);
  } else {
    if (!options.mirrored && is_on_one_side(set)) {
      throw std::invalid_argument("appendages are joined to both sides of the hull: mirror it");
    }
    join_appendages(model.brep, model.regions, options.appendages,
                    surface::part_of(options.progress, 0.0, kJoined));
    // Of faces that were cut the surfaces are still whole, as in the report of the file read back.
    model.box = box_of(model.brep.shape);
  }
  model.integrals = integrals_of(model.brep.shape);
  model.size = set.size();
  model.curves = curves_of(options, model.size);
  return model;
}

}  // namespace hull::exchange
