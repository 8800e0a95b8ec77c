// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/regions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "mesh/tolerances.h"

namespace hull::exchange {
namespace {

std::string region_of(const conversion::BSplinePatch& patch, double tolerance, double aft) {
  Eigen::AlignedBox3d box;
  // The patch lies within the hull of its control points, and is plane where these are.
  for (const Vector3d& point : patch.control_points) box.extend(point);
  const Vector3d extent = box.sizes();
  if (extent.y() <= tolerance) {
    return box.center().cwiseAbs().y() > tolerance ? "flat side" : "shell";
  }
  if (extent.z() <= tolerance) {
    const surface::SurfaceJet middle = patch.evaluate(0.5, 0.5);
    // Normals point into the water, so a bottom's points down.
    return middle.du.cross(middle.dv).z() < 0.0 ? "flat bottom" : "deck";
  }
  // Other planes across the ship, as steps of a bottom, are shell.
  return extent.x() <= tolerance && box.min().x() <= aft + tolerance ? "transom" : "shell";
}

}  // namespace

std::vector<std::string> find_regions(const conversion::PatchSet& set) {
  double aft = std::numeric_limits<double>::infinity();
  for (const conversion::BSplinePatch& patch : set.patches) {
    // Of all patches, before any is looked at: a transom is told by how far aft the others are.
    for (const Vector3d& point : patch.control_points) aft = std::min(aft, point.x());
  }
  const double tolerance = kInPlane * set.size();
  std::vector<std::string> regions;
  for (const conversion::BSplinePatch& patch : set.patches) {
    regions.push_back(region_of(patch, tolerance, aft));
  }
  return regions;
}

std::string region_of(conversion::Cap::Kind kind) {
  switch (kind) {
    case conversion::Cap::Kind::kDeck:
      return "deck";
    case conversion::Cap::Kind::kTransom:
      return "transom";
    case conversion::Cap::Kind::kCentrePlane:
      return "centre plane";
    case conversion::Cap::Kind::kOpening:
      break;
  }
  return "opening";
}

analysis::Colour region_colour(const std::string& region) {
  // Told apart by the colour blind too (Okabe & Ito 2008), on a grey shell.
  static const std::map<std::string, analysis::Colour> kColours = {
      {"shell", {0.70, 0.72, 0.75}},      {"flat side", {0.34, 0.71, 0.91}},
      {"flat bottom", {0.84, 0.37, 0.0}}, {"transom", {0.0, 0.62, 0.45}},
      {"deck", {0.94, 0.89, 0.26}},       {"centre plane", {0.80, 0.47, 0.65}},
      {"opening", {0.90, 0.62, 0.0}},
  };
  const auto found = kColours.find(region);
  return found != kColours.end() ? found->second : kColours.at("shell");
}

analysis::Colour colour_of(const std::string& region, const CadOptions& options) {
  const auto given = options.colours.find(region);
  return given != options.colours.end() ? given->second : region_colour(region);
}

}  // namespace hull::exchange
