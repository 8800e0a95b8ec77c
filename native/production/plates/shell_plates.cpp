// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/shell_plates.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>

#include "production/plates/across_centre.h"
#include "production/plates/triangle_area.h"

namespace hull::production {
namespace {

constexpr double kAreaTolerance = 1e-11;  // of the surface, in the mean over triangles

std::string place_text(const Vector3d& p) {
  char text[80];
  std::snprintf(text, sizeof text, "(%.3f, %.3f, %.3f) m", p.x(), p.y(), p.z());
  return text;
}

// Sides of triangles by what is beyond them.
class Sides {
 public:
  explicit Sides(const ShellMesh& mesh) : mesh_(mesh) {
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
      for (int i = 0; i < 3; ++i) {
        auto [found, is_first] = triangles_.try_emplace(key(t, i), std::array<int, 2>{t, -1});
        if (is_first) keys_.push_back(found->first);
        if (!is_first) found->second[1] = t;
      }
    }
  }

  std::uint64_t key(int t, int i) const {
    const auto& points = mesh_.triangles[t].points;
    return ShellMesh::pair_key(points[i], points[(i + 1) % 3]);
  }
  // By triangles: the same order each time, and so are sums over them.
  const std::vector<std::uint64_t>& keys() const { return keys_; }
  const std::array<int, 2>& triangles(std::uint64_t key) const { return triangles_.at(key); }
  bool is_open(std::uint64_t key) const {
    return triangles_.at(key)[1] < 0 || mesh_.seams.contains(key);
  }
  int curve(std::uint64_t key) const {
    // Along the surface's border no curve counts, even if one lies there.
    const auto found = mesh_.seams.find(key);
    return triangles_.at(key)[1] < 0 || found == mesh_.seams.end() ? -1 : found->second;
  }

 private:
  const ShellMesh& mesh_;
  std::unordered_map<std::uint64_t, std::array<int, 2>> triangles_;
  std::vector<std::uint64_t> keys_;
};

class Divider {
 public:
  Divider(PlatedShell& shell, const PlatingOptions& options)
      : shell_(shell), mesh_(shell.mesh), options_(options), sides_(shell.mesh) {}

  std::vector<Plate> divide() {
    group();
    if (options_.leave_out_loose) leave_out_loose();
    check();
    measure();
    for (Plate& plate : plates_) {
      plate.loops = loops_of(plate);
      if (options_.across_centre) join_across_centre(shell_, options_.largest_knuckle, plate);
    }
    // Plates abreast of one another stay in the order of their cells.
    std::stable_sort(plates_.begin(), plates_.end(),
                     [](const Plate& a, const Plate& b) { return a.centre.x() < b.centre.x(); });
    return std::move(plates_);
  }
  std::vector<LooseStretch> loose() { return std::move(loose_); }

 private:
  void group();
  void leave_out_loose();
  void check() const;
  bool has_one_plate(const std::array<int, 2>& pair) const {
    return pair[1] >= 0 && plate_of_[pair[0]] == plate_of_[pair[1]];
  }
  // Of a knuckle that no plate may go over.
  bool is_sharp(std::uint64_t key) const {
    const auto knuckle = mesh_.knuckles.find(key);
    return knuckle != mesh_.knuckles.end() && std::abs(knuckle->second) > options_.largest_knuckle;
  }
  void measure();
  std::vector<std::vector<PlateSide>> loops_of(const Plate& plate) const;
  std::vector<PlateSide> sides_of(std::vector<int> loop) const;
  double length_of(const std::vector<PlateSide>& loop) const;
  Vector3d middle(std::uint64_t key) const {
    return 0.5 * (mesh_.points[key >> 32] + mesh_.points[key & 0xffffffffu]);
  }

  PlatedShell& shell_;
  ShellMesh& mesh_;
  const PlatingOptions& options_;
  Sides sides_;
  std::vector<int> plate_of_;  // by triangle
  std::vector<Plate> plates_;
  std::vector<LooseStretch> loose_;
};

void Divider::group() {
  std::vector<int> root(mesh_.triangles.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&root](int t) {
    while (root[t] != t) t = root[t] = root[root[t]];
    return t;
  };
  for (const std::uint64_t key : sides_.keys()) {
    const std::array<int, 2>& pair = sides_.triangles(key);
    if (!sides_.is_open(key)) root[find(pair[0])] = find(pair[1]);
  }
  std::map<int, int> number;
  plate_of_.resize(root.size());
  for (int t = 0; t < static_cast<int>(root.size()); ++t) {
    const auto [found, is_new] = number.try_emplace(find(t), static_cast<int>(plates_.size()));
    if (is_new) plates_.emplace_back();
    plate_of_[t] = found->second;
    plates_[found->second].triangles.push_back(t);
  }
}

// Sides with one plate on both sides part nothing: all can go at once.
void Divider::leave_out_loose() {
  // By curve, so that they are told of in the curves' order.
  std::map<int, LooseStretch> found;
  std::map<int, double> longest;
  for (const std::uint64_t key : sides_.keys()) {
    const auto seam = mesh_.seams.find(key);
    if (seam == mesh_.seams.end() || !has_one_plate(sides_.triangles(key)) || is_sharp(key)) {
      continue;
    }
    LooseStretch& stretch =
        found.try_emplace(seam->second, LooseStretch{seam->second}).first->second;
    const double length = (mesh_.points[key >> 32] - mesh_.points[key & 0xffffffffu]).norm();
    stretch.length += length;
    if (length > longest[seam->second]) {
      longest[seam->second] = length;
      stretch.middle = middle(key);
    }
    // Sides look their seams up in this table: from here on the stretch parts nothing.
    mesh_.seams.erase(seam);
  }
  for (const auto& [curve, stretch] : found) loose_.push_back(stretch);
}

void Divider::check() const {
  for (const std::uint64_t key : sides_.keys()) {
    if (!has_one_plate(sides_.triangles(key))) continue;
    if (const auto seam = mesh_.seams.find(key); seam != mesh_.seams.end()) {
      throw std::invalid_argument(
          "The curve \"" + shell_.curves[seam->second].name +
          "\" has the same plate on both sides at " + place_text(middle(key)) +
          ": let it end on other seams or butts, or on the hull's borders, or leave it out.");
    }
    if (!is_sharp(key)) continue;
    char angle[40];
    std::snprintf(angle, sizeof angle, "%.2g°",
                  std::abs(mesh_.knuckles.at(key)) * 57.29577951308232);
    throw std::invalid_argument("A plate goes over a knuckle of " + std::string(angle) + " at " +
                                place_text(middle(key)) + ": put a seam along the knuckle.");
  }
}

void Divider::measure() {
  double total = 0.0;
  for (const ShellTriangle& t : mesh_.triangles) {
    const Vector3d a = mesh_.points[t.points[0]];
    total += 0.5 * (mesh_.points[t.points[1]] - a).cross(mesh_.points[t.points[2]] - a).norm();
  }
  // In equal shares, whatever the triangles' sizes: the errors' sum is bounded by it.
  const double tolerance = kAreaTolerance * total / static_cast<double>(mesh_.triangles.size());
  double done = 0.0;
  for (Plate& plate : plates_) {
    surface::tell(options_.progress, done++, static_cast<double>(plates_.size()));
    AreaMoments sum;
    for (const int t : plate.triangles) {
      sum += area_moments(shell_.surface, mesh_.triangles[t], tolerance);
      for (const int p : mesh_.triangles[t].points) plate.box.extend(mesh_.points[p]);
    }
    plate.area = sum.area;
    plate.centre = sum.moment / sum.area;
  }
}

// Where borders of the plate touch in a point the loop may go on along any of them: what runs back
// to such a point is a loop of its own, so that none passes a point twice. A plate whose loops were
// joined there would not be the disc with holes that it is.
std::vector<std::vector<PlateSide>> Divider::loops_of(const Plate& plate) const {
  // Triangles have their inside, and so the plate, to the left of their sides.
  std::multimap<int, int> next;
  for (const int t : plate.triangles) {
    for (int i = 0; i < 3; ++i) {
      const auto& points = mesh_.triangles[t].points;
      if (sides_.is_open(sides_.key(t, i))) next.emplace(points[i], points[(i + 1) % 3]);
    }
  }
  std::set<int> touching;
  for (auto side = next.begin(); side != next.end(); ++side) {
    if (next.count(side->first) > 1) touching.insert(side->first);
  }
  std::vector<std::vector<PlateSide>> loops;
  while (!next.empty()) {
    // Loops begin at their points of the lowest number: the same ones each time.
    std::vector<int> loop{next.begin()->first};
    do {
      const auto found = next.find(loop.back());
      if (found == next.end()) break;
      loop.push_back(found->second);
      next.erase(found);
      if (!touching.contains(loop.back())) continue;
      const auto before = std::find(loop.begin(), loop.end() - 1, loop.back());
      if (before == loop.begin() || before == loop.end() - 1) continue;
      loops.push_back(sides_of(std::vector<int>(before, loop.end())));
      loop.erase(before + 1, loop.end());
    } while (loop.back() != loop.front());
    loops.push_back(sides_of(std::move(loop)));
  }
  std::stable_sort(loops.begin(), loops.end(),
                   [this](const auto& a, const auto& b) { return length_of(a) > length_of(b); });
  return loops;
}

double Divider::length_of(const std::vector<PlateSide>& loop) const {
  double length = 0.0;
  for (const PlateSide& side : loop) {
    for (std::size_t i = 1; i < side.points.size(); ++i) {
      length += (mesh_.points[side.points[i]] - mesh_.points[side.points[i - 1]]).norm();
    }
  }
  return length;
}

std::vector<PlateSide> Divider::sides_of(std::vector<int> loop) const {
  const auto n = static_cast<int>(loop.size()) - 1;
  const auto curve = [&](int i) { return sides_.curve(ShellMesh::pair_key(loop[i], loop[i + 1])); };
  int start = 0;
  // A side must not begin in the middle of a curve.
  while (start < n && curve(start) == curve((start + n - 1) % n)) ++start;
  if (start == n) start = 0;
  std::vector<PlateSide> sides;
  for (int k = 0; k < n; ++k) {
    const int i = (start + k) % n;
    if (sides.empty() || sides.back().curve != curve(i)) sides.push_back({curve(i), {loop[i]}});
    sides.back().points.push_back(loop[i + 1]);
  }
  return sides;
}

}  // namespace

std::vector<Vector3d> side_points(const PlatedShell& shell, const PlateSide& side) {
  std::vector<Vector3d> points;
  for (const int p : side.points) {
    points.push_back(shell.mesh.points[p]);
    if (side.mirrored) points.back().y() *= -1.0;
  }
  return points;
}

Plating plating(const surface::LimitSurface& surface, std::vector<SurfaceCurve> curves,
                const PlatingOptions& options) {
  if (!(options.size > 0.0 && std::isfinite(options.size))) {
    throw std::invalid_argument("The size of a plate's triangles must be a length above 0 m.");
  }
  if (!(options.largest_knuckle >= 0.0)) {
    throw std::invalid_argument("The largest knuckle within a plate must be an angle, 0 or more.");
  }
  for (const SurfaceCurve& curve : curves) require_on(surface, curve);
  // A copy of the surface: the plates stay when the given one's points are set.
  auto shell = std::make_shared<PlatedShell>(PlatedShell{surface, std::move(curves), {}});
  shell->mesh = shell_mesh(shell->surface, shell->curves, options.size,
                           surface::part_of(options.progress, 0.0, 0.5));
  PlatingOptions rest = options;
  rest.progress = surface::part_of(options.progress, 0.5, 1.0);
  Divider divider(*shell, rest);
  std::vector<Plate> plates = divider.divide();
  return {std::move(shell), std::move(plates), divider.loose()};
}

}  // namespace hull::production
