// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/appendages/appendage.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace hull::analysis {
namespace {

// The error of cubics for a circle falls with the sixth power of their number: 64 are within 2e-11
// of the radius, 32 within 2e-9.
constexpr int kCircleParts = 64, kBulbParts = 32;
// Sine of the angle below which two directions are one, or the span lies in the section's plane.
constexpr double kNoAngle = 1e-6;

using Outline = std::vector<std::array<Eigen::Vector2d, 4>>;
using Patches = std::vector<surface::BezierPatch>;

void set(surface::BezierPatch& patch, int i, int j, const Vector3d& p) {
  for (int k = 0; k < 3; ++k) patch.x[k][4 * j + i] = p[k];
}

// Straight lines from one arc (v = 0) to another (v = 1).
surface::BezierPatch ruled_patch(const CubicArc& from, const CubicArc& to) {
  surface::BezierPatch patch;
  for (int j = 0; j < 4; ++j) {
    const double v = j / 3.0;
    for (int i = 0; i < 4; ++i) set(patch, i, j, (1.0 - v) * from[i] + v * to[i]);
  }
  return patch;
}

CubicArc line_arc(const Vector3d& a, const Vector3d& b) {
  return {a, a + (b - a) / 3.0, b - (b - a) / 3.0, b};
}

CubicArc reversed(const CubicArc& arc) { return {arc[3], arc[2], arc[1], arc[0]}; }

// Of the unit circle, counter-clockwise.
std::vector<std::array<Eigen::Vector2d, 4>> circle_arcs(int parts) {
  // Handles of this length put the middle of an arc on the circle, too.
  const double angle = 2.0 * std::numbers::pi / parts, reach = 4.0 / 3.0 * std::tan(angle / 4.0);
  const auto at = [&](int i) {
    // The last arc ends in the very point that the first begins in: rounding leaves no gap.
    const double a = angle * (i % parts);
    return Eigen::Vector2d(std::cos(a), std::sin(a));
  };
  const auto turned = [](const Eigen::Vector2d& p) { return Eigen::Vector2d(-p.y(), p.x()); };
  std::vector<std::array<Eigen::Vector2d, 4>> arcs;
  for (int i = 0; i < parts; ++i) {
    const Eigen::Vector2d a = at(i), b = at(i + 1);
    arcs.push_back({a, a + reach * turned(a), b - reach * turned(b), b});
  }
  return arcs;
}

void require_length(double length, const char* what) {
  if (length > 0.0 && std::isfinite(length)) return;
  throw std::invalid_argument(std::string("The ") + what + " must be a positive length.");
}

void require_finite(const Vector3d& p, const char* what) {
  if (p.allFinite()) return;
  throw std::invalid_argument(std::string("The ") + what + " must have finite coordinates.");
}

void require_thickness(double thickness, const char* of) {
  if (thickness >= 0.0 && std::isfinite(thickness)) return;
  throw std::invalid_argument(std::string("The ") + of +
                              "'s thickness must be a positive part of its chord, or 0 for the "
                              "section's own.");
}

// Axis, and two directions across it, right-handed.
struct Frame {
  Vector3d along, first, second;
  Frame(const Vector3d& from, const Vector3d& to) {
    along = to - from;
    require_length(along.norm(), "distance between the ends");
    along.normalize();
    first = along.unitOrthogonal();
    second = along.cross(first);
  }
};

ClosedShell cylinder_shell(const CylinderShape& c) {
  require_finite(c.start, "cylinder's start");
  require_finite(c.end, "cylinder's end");
  require_length(c.start_radius, "radius at the start");
  require_length(c.end_radius, "radius at the end");
  const Frame frame(c.start, c.end);
  Patches patches;
  for (const auto& arc : circle_arcs(kCircleParts)) {
    CubicArc start, end;
    for (int i = 0; i < 4; ++i) {
      const Vector3d across = arc[i].x() * frame.first + arc[i].y() * frame.second;
      start[i] = c.start + c.start_radius * across;
      end[i] = c.end + c.end_radius * across;
    }
    // u runs round the axis and v along it, S_u x S_v outwards. Ends are triangles to the centre,
    // one side of the patch being a point; at the start u runs the other way round.
    patches.push_back(ruled_patch(start, end));
    patches.push_back(ruled_patch(reversed(start), {c.start, c.start, c.start, c.start}));
    patches.push_back(ruled_patch(end, {c.end, c.end, c.end, c.end}));
  }
  return {std::move(patches), std::min(c.start_radius, c.end_radius)};
}

struct FoilSections {
  Outline root, tip;
};

FoilSections sections_of(const FoilShape& foil, const SectionForm& form) {
  const auto thickness = [&](double given) { return given > 0.0 ? given : form.thickness(); };
  return {outline_of(form, thickness(foil.root_thickness), false),
          outline_of(form, thickness(foil.tip_thickness), false)};
}

void check(const FoilShape& foil) {
  require_finite(foil.root, "root's leading edge");
  require_finite(foil.tip, "tip's leading edge");
  require_finite(foil.chord_direction, "chord's direction");
  require_finite(foil.thickness_direction, "thickness' direction");
  require_length(foil.root_chord, "root's chord");
  require_length(foil.tip_chord, "tip's chord");
  require_thickness(foil.root_thickness, "root");
  require_thickness(foil.tip_thickness, "tip");
  // Of unit vectors: its length is the sine of the angle between them.
  const Vector3d normal =
      foil.chord_direction.normalized().cross(foil.thickness_direction.normalized());
  const Vector3d span = foil.tip - foil.root;
  require_length(span.norm(), "distance between root and tip");
  if (normal.norm() < kNoAngle || std::abs(normal.dot(span)) < kNoAngle * span.norm()) {
    throw std::invalid_argument(
        "The directions of the chord, of the thickness and from root to tip lie in a plane: choose "
        "them so that they enclose a body.");
  }
}

// Patches turned so that their normals point outwards.
void add_outwards(Patches& patches, const surface::BezierPatch& patch, bool turn) {
  if (!turn) return patches.push_back(patch);
  surface::BezierPatch other;
  for (int k = 0; k < 3; ++k) {
    for (int j = 0; j < 4; ++j) {
      for (int i = 0; i < 4; ++i) other.x[k][4 * i + j] = patch.x[k][4 * j + i];
    }
  }
  patches.push_back(other);
}

ClosedShell foil_shell(const FoilShape& foil) {
  check(foil);
  const SectionForm form(foil.section);
  const FoilSections sections = sections_of(foil, form);
  const Vector3d along = foil.chord_direction.normalized();
  // The thickness is square to the chord, whatever the angle between the two directions given.
  const Vector3d across =
      (foil.thickness_direction - foil.thickness_direction.dot(along) * along).normalized();
  const auto arc_at = [&](const auto& part, const Vector3d& origin, double chord) {
    CubicArc arc;
    for (int i = 0; i < 4; ++i) {
      arc[i] = origin + chord * (part[i].x() * along + part[i].y() * across);
    }
    return arc;
  };
  std::vector<CubicArc> root, tip;
  for (std::size_t i = 0; i < sections.root.size(); ++i) {
    root.push_back(arc_at(sections.root[i], foil.root, foil.root_chord));
    tip.push_back(arc_at(sections.tip[i], foil.tip, foil.tip_chord));
  }
  // The outline runs counter-clockwise seen against along x across.
  const bool turn = along.cross(across).dot(foil.tip - foil.root) < 0.0;
  Patches patches;
  for (std::size_t i = 0; i < root.size(); ++i) {
    add_outwards(patches, ruled_patch(root[i], tip[i]), turn);
  }
  // Both sides have the same knots. Part i of the upper one lies over part n - 1 - i of the lower
  // one, which runs the other way; straight lines between them fill the plane ends.
  const std::size_t n = root.size();
  for (std::size_t i = 0; i < n / 2; ++i) {
    add_outwards(patches, ruled_patch(reversed(root[i]), root[n - 1 - i]), turn);
    add_outwards(patches, ruled_patch(tip[i], reversed(tip[n - 1 - i])), turn);
  }
  // Where the trailing edge is blunt.
  if ((root[0][0] - root[n - 1][3]).norm() > 0.0 || (tip[0][0] - tip[n - 1][3]).norm() > 0.0) {
    add_outwards(
        patches,
        ruled_patch(line_arc(root[n - 1][3], root[0][0]), line_arc(tip[n - 1][3], tip[0][0])),
        turn);
  }
  const auto thickness = [&](double given) { return given > 0.0 ? given : form.thickness(); };
  const double thin = std::min(foil.root_chord * thickness(foil.root_thickness),
                               foil.tip_chord * thickness(foil.tip_thickness));
  return {std::move(patches), thin};
}

ClosedShell bulb_shell(const BulbShape& bulb) {
  require_finite(bulb.nose, "bulb's nose");
  require_finite(bulb.tail, "bulb's tail");
  require_length(bulb.diameter, "diameter");
  const SectionForm form(bulb.section);
  if (!form.is_symmetric()) {
    throw std::invalid_argument(
        "A body of revolution needs a symmetric section, as 0018 or 63-012, not " + bulb.section +
        ".");
  }
  const Frame frame(bulb.nose, bulb.tail);
  const double length = (bulb.tail - bulb.nose).norm();
  const Outline outline = outline_of(form, bulb.diameter / length, true);
  Patches patches;
  for (const auto& arc : circle_arcs(kBulbParts)) {
    for (const auto& part : outline) {
      surface::BezierPatch patch;
      for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 4; ++i) {
          const Vector3d across = arc[i].x() * frame.first + arc[i].y() * frame.second;
          set(patch, i, j, bulb.nose + length * (part[j].x() * frame.along + part[j].y() * across));
        }
      }
      // The outline runs from the tail to the nose: with u round the axis S_u x S_v points inwards.
      add_outwards(patches, patch, true);
    }
    // A blunt tail is closed by a disc.
    if (outline.front()[0].y() > 0.0) {
      CubicArc rim;
      for (int i = 0; i < 4; ++i) {
        rim[i] = bulb.tail + length * outline.front()[0].y() *
                                 (arc[i].x() * frame.first + arc[i].y() * frame.second);
      }
      patches.push_back(ruled_patch(rim, {bulb.tail, bulb.tail, bulb.tail, bulb.tail}));
    }
  }
  return {std::move(patches), 0.5 * bulb.diameter};
}

}  // namespace

Outline outline_of(const SectionForm& form, double thickness, bool upper_only) {
  // The section's own ordinates in proportion, of the series too, whose form varies with thickness.
  const double factor = thickness / form.thickness();
  const std::vector<double>& knots = form.knots();
  Outline outline;
  const auto add = [&](double from, double to, int side) {
    outline.push_back(outline_part(form, from, to, side, factor));
  };
  for (std::size_t i = knots.size() - 1; i > 0; --i) add(knots[i], knots[i - 1], 1);
  for (std::size_t i = 0; i + 1 < knots.size() && !upper_only; ++i) {
    add(knots[i], knots[i + 1], -1);
  }
  return outline;
}

ClosedShell mirror_image(const ClosedShell& shell) {
  Patches patches;
  for (const surface::BezierPatch& patch : shell.patches()) {
    surface::BezierPatch image = patch;
    // Not -y, which would be -0 in the centre plane. A mirror image is turned inside out.
    for (double& y : image.x[1]) y = 0.0 - y;
    add_outwards(patches, image, true);
  }
  return {std::move(patches), shell.least_width()};
}

ClosedShell shell_of(const AppendageShape& shape) {
  if (const auto* cylinder = std::get_if<CylinderShape>(&shape)) return cylinder_shell(*cylinder);
  if (const auto* foil = std::get_if<FoilShape>(&shape)) return foil_shell(*foil);
  return bulb_shell(std::get<BulbShape>(shape));
}

}  // namespace hull::analysis
