// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/families/agreement.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/fairness/plane_fit.h"
#include "mesh/tolerances.h"

namespace hull::morphing {
namespace {

constexpr std::size_t kNamed = 3;  // elements that a sentence names
// rad, of planes that are parallel: over a region as long as the mesh they part by kInPlane.
constexpr double kParallel = kInPlane;

std::string parent_name(std::size_t k) { return "Parent " + std::to_string(k + 1); }

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < std::min(kNamed, names.size()); ++i) {
    text += (i == 0 ? "" : ", ") + names[i];
  }
  if (names.size() > kNamed) text += " and " + std::to_string(names.size() - kNamed) + " more";
  return text;
}

void add(const std::string& parent, const char* what, const std::vector<std::string>& names,
         const char* remedy, std::vector<std::string>& found) {
  if (names.empty()) return;
  found.push_back(parent + what + listed(names) + ". " + remedy);
}

void compare_counts(const mesh::Topology& first, const mesh::Topology& other,
                    const std::string& parent, std::vector<std::string>& found) {
  const auto compare = [&](int count, int wanted, const char* what) {
    if (count == wanted) return;
    found.push_back(parent + " has " + std::to_string(count) + " " + what + ", the first has " +
                    std::to_string(wanted) +
                    ". Take variants of one hull, or bring one hull's layout to the other first.");
  };
  compare(other.vertex_count(), first.vertex_count(), "points");
  compare(other.face_count(), first.face_count(), "faces");
}

std::string edge_name(const mesh::Topology& t, int h) {
  return std::to_string(t.origin(h)) + "-" + std::to_string(t.origin(t.next(h)));
}

void compare_elements(const mesh::Topology& first, const mesh::Topology& other,
                      const std::string& parent, std::vector<std::string>& found) {
  std::vector<std::string> faces, creases, missing, points;
  for (int f = 0; f < first.face_count(); ++f) {
    // With the same first half-edge the numbers of all are the same.
    bool is_same = first.face_size(f) == other.face_size(f) &&
                   first.first_half_edge(f) == other.first_half_edge(f);
    for (int i = 0; is_same && i < first.face_size(f); ++i) {
      const int h = first.first_half_edge(f) + i;
      is_same = first.origin(h) == other.origin(h);
    }
    if (!is_same) faces.push_back(std::to_string(f));
  }
  add(parent, " has other points around the faces ", faces,
      "Take variants of one hull, or number both alike.", found);
  // Edges go by the numbers of half-edges, which say nothing where faces differ.
  if (!faces.empty()) return;
  for (int h = 0; h < first.half_edge_count(); ++h) {
    if (!first.is_edge_front(h) || first.is_crease(h) == other.is_crease(h)) continue;
    (other.is_crease(h) ? creases : missing).push_back(edge_name(first, h));
  }
  add(parent, " has creases where the first has none: ", creases,
      "Crease the edges of both, or of neither.", found);
  add(parent, " has no creases where the first has them: ", missing,
      "Crease the edges of both, or of neither.", found);
  // Kinds follow from creases: what differs beyond them is corners.
  if (!creases.empty() || !missing.empty()) return;
  for (int v = 0; v < first.vertex_count(); ++v) {
    if (first.kind(v) != other.kind(v)) points.push_back(std::to_string(v));
  }
  add(parent, " and the first have corners at different points: ", points,
      "Make them corners of both, or of neither.", found);
}

std::vector<Vector3d> points_of(const FamilyFlat& flat, const surface::LimitSurface& parent) {
  std::vector<Vector3d> points;
  for (int v : flat.points) points.push_back(parent.mesh().points()[v]);
  return points;
}

void check_flat(const FamilyFlat& flat, int count) {
  if (flat.points.size() < 3) {
    throw std::invalid_argument("The flat " + flat.name + " needs three points or more.");
  }
  for (int v : flat.points) {
    if (v >= 0 && v < count) continue;
    throw std::invalid_argument("The flat " + flat.name + " has the point " + std::to_string(v) +
                                ", but points are 0 to " + std::to_string(count - 1) + ".");
  }
}

double departure(const std::vector<Vector3d>& points, const analysis::Plane& plane) {
  double most = 0.0;
  for (const Vector3d& p : points) most = std::max(most, std::abs(plane.height(p)));
  return most;
}

}  // namespace

std::vector<std::string> differences(const std::vector<surface::LimitSurface>& parents) {
  std::vector<std::string> found;
  for (std::size_t k = 1; k < parents.size(); ++k) {
    const std::string parent = parent_name(k);
    const mesh::Topology& first = parents[0].mesh().topology();
    const mesh::Topology& other = parents[k].mesh().topology();
    if (parents[k].scheme() != parents[0].scheme()) {
      found.push_back(parent + " has another scheme than the first. Give both the same.");
    }
    const std::size_t before = found.size();
    compare_counts(first, other, parent, found);
    // Elements go by numbers, of which there must be as many.
    if (found.size() == before) compare_elements(first, other, parent, found);
  }
  return found;
}

std::vector<std::string> flat_differences(const std::vector<surface::LimitSurface>& parents,
                                          const std::vector<FamilyFlat>& flats) {
  std::vector<std::string> found;
  for (const FamilyFlat& flat : flats) {
    check_flat(flat, parents.at(0).mesh().topology().vertex_count());
    const analysis::Plane first = analysis::fit_plane(points_of(flat, parents[0])).plane;
    // Flat in itself, then parallel to the first one's: by the sine, as normals may point either
    // way.
    for (std::size_t k = 0; k < parents.size(); ++k) {
      const std::vector<Vector3d> points = points_of(flat, parents[k]);
      const analysis::Plane plane = analysis::fit_plane(points).plane;
      if (departure(points, plane) > kInPlane * parents[k].mesh().size()) {
        found.push_back("The flat " + flat.name + " is not flat in parent " +
                        std::to_string(k + 1) + ". Flatten it there, or leave it out.");
      } else if (first.normal.cross(plane.normal).norm() > kParallel) {
        found.push_back("The flat " + flat.name + " is turned in parent " + std::to_string(k + 1) +
                        ": between it and the first members are flat nearly only. Turn it alike "
                        "in both.");
      }
    }
  }
  return found;
}

}  // namespace hull::morphing
