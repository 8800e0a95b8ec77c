// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/appendages/joined_shells.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "analysis/appendages/piece_integrals.h"
#include "surface/parallel_for.h"

namespace hull::analysis {
namespace {

constexpr int kMostHalvingsOfPatch = 16;
constexpr std::size_t kPatchGrain = 4;  // patches that a thread takes at a time
// Of all parts of patches together, before surfaces count as entangled: looks at other members,
// twenty times what samples with appendages take. Whole patches are not counted: how many there are
// tells of the hull's size alone.
constexpr int kMostLooks = 1000000;
// Of the smaller body's box: what closed surfaces may be open by.
constexpr double kOpen = 1e-5;
// Of its box: what a hole's wall measures that is none.
constexpr double kNoWall = 1e-9;

double volume_of(const Eigen::AlignedBox3d& box) { return box.sizes().prod(); }
double area_of(const Eigen::AlignedBox3d& box) {
  const Vector3d s = box.sizes();
  return s.x() * s.y() + s.y() * s.z() + s.z() * s.x();
}

// On all processors, as finding where one patch meets others takes up to milliseconds.
void for_each(std::size_t count, const std::function<void(std::size_t)>& work) {
  const auto all = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) work(i);
  };
  surface::parallel_for(count, surface::kAllProcessors, all, kPatchGrain);
}

double extent(const surface::BezierPatch& patch, int axis) {
  const int step = axis == 0 ? 1 : 4, other = axis == 0 ? 4 : 1;
  // The longest of the control polygons bounds the length of all lines of that direction.
  double longest = 0.0;
  for (int j = 0; j < 4; ++j) {
    double length = 0.0;
    for (int i = 0; i < 3; ++i) {
      length +=
          (patch.point(other * j + step * (i + 1)) - patch.point(other * j + step * i)).norm();
    }
    longest = std::max(longest, length);
  }
  return longest;
}

}  // namespace

JoinedShells::JoinedShells(std::vector<JoinedMember> members, const Vector3d& origin,
                           double tolerance, PartsLeft* parts_left)
    : members_(std::move(members)),
      origin_(origin),
      tolerance_(tolerance),
      looks_left_(kMostLooks),
      parts_left_(parts_left) {
  std::vector<Source> sources;
  for (std::size_t m = 0; m < members_.size(); ++m) {
    const std::vector<surface::BezierPatch>& patches = members_[m].shell.patches();
    for (std::size_t i = 0; i < patches.size(); ++i) {
      const bool has_area = members_[m].without_area.empty() || !members_[m].without_area[i];
      sources.push_back({static_cast<int>(m), has_area, &patches[i]});
    }
  }
  // Into a place for each patch, then in their order: sums are the same to the last bit on any
  // number of threads.
  std::vector<std::vector<Piece>> found(sources.size());
  for_each(sources.size(),
           [&](std::size_t i) { collect(sources[i], *sources[i].patch, 0, found[i]); });
  for (std::vector<Piece>& pieces : found) {
    pieces_.insert(pieces_.end(), std::make_move_iterator(pieces.begin()),
                   std::make_move_iterator(pieces.end()));
  }
  try {
    for_each(pieces_.size(), [&](std::size_t i) {
      pieces_[i].moments = moments_of(pieces_[i], nullptr, parts_left);
    });
    for (const Piece& piece : pieces_) whole_ += piece.moments;
  } catch (const SurfacesInOneAnother&) {
    refuse();
  }
  // It is the caller's, for the making alone: later pieces are cut by water without a limit.
  parts_left_ = nullptr;
  check_closed();
}

// Hulls' parts that count are those that are not there any more.
bool JoinedShells::is_taken(int member, const std::vector<bool>& inside) const {
  const MemberRole role = members_[member].role;
  bool within_solid = false, within_cut = false;
  for (std::size_t m = 0; m < members_.size(); ++m) {
    if (static_cast<int>(m) == member) continue;
    bool& within = members_[m].role == MemberRole::kCut ? within_cut : within_solid;
    within = within || inside[m];
  }
  // The wall of a hole is there only within what is solid, and once where holes meet.
  if (role == MemberRole::kCut) return within_solid && !within_cut;
  const bool is_gone = within_solid || within_cut;
  return role == MemberRole::kHull ? is_gone : !is_gone;
}

void JoinedShells::collect(const Source& source, const surface::BezierPatch& patch, int depth,
                           std::vector<Piece>& pieces) {
  const int member = source.member;
  if (depth > 0 && (looks_left_ -= static_cast<int>(members_.size())) < 0) refuse();
  const Eigen::AlignedBox3d box = patch.box();
  const MemberRole role = members_[member].role;
  std::vector<int> near;
  bool is_among = false;
  double width = std::numeric_limits<double>::infinity(), volume = width, area = width;
  for (std::size_t m = 0; m < members_.size(); ++m) {
    const ClosedShell& other = members_[m].shell;
    if (static_cast<int>(m) == member || !other.box().intersects(box)) continue;
    is_among = true;
    if (!other.comes_near(box)) continue;
    near.push_back(static_cast<int>(m));
    width = std::min(width, other.least_width());
    volume = std::min(volume, volume_of(other.box()));
    area = std::min(area, area_of(other.box()));
  }
  // Outside of all other members: of the hull nothing is gone, and a hole there has no wall.
  if (!is_among && role != MemberRole::kAdded) return;
  const double u = extent(patch, 0), v = extent(patch, 1);
  // Lines are laid through a piece no farther from one another than the other body is thick, or a
  // closed curve of intersection could lie between them.
  if (std::max(u, v) > width && depth < kMostHalvingsOfPatch) {
    surface::BezierPatch low, high;
    patch.split(u > v ? 0 : 1, low, high);
    collect(source, low, depth + 1, pieces);
    collect(source, high, depth + 1, pieces);
    return;
  }
  // No surface of a member that is not near meets this box: the middle tells for all of the piece.
  surface::SurfaceJet jet;
  surface::evaluate_first(patch, 0.5, 0.5, jet);
  std::vector<bool> within(members_.size());
  for (std::size_t m = 0; m < members_.size(); ++m) {
    if (static_cast<int>(m) == member || std::ranges::count(near, static_cast<int>(m))) continue;
    within[m] = members_[m].shell.is_inside(jet.point, parts_left_);
    if (*parts_left_ < 0) refuse();
  }
  if (near.empty() && !is_taken(member, within)) return;
  // The flux of the hull's lost parts counts less, and the normal of what is cut out points into
  // what is left, not out of it; but its area is gained.
  const double sign = role == MemberRole::kAdded ? 1.0 : -1.0;
  const double sense = role == MemberRole::kHull ? -1.0 : 1.0;
  const Eigen::AlignedBox3d& own = members_[member].shell.box();
  pieces.push_back({patch,
                    member,
                    sign,
                    source.has_area ? sense : 0.0,
                    near,
                    within,
                    {},
                    tolerance_ * std::min(volume, volume_of(own)),
                    10.0 * tolerance_ * std::min(area, area_of(own))});
}

ShellMoments JoinedShells::moments_of(const Piece& piece, const Plane* water,
                                      PartsLeft* parts_left) const {
  std::vector<const ClosedShell*> near;
  for (int m : piece.near) near.push_back(&members_[m].shell);
  std::vector<bool> within = piece.within;
  const auto takes = [&](const std::vector<bool>& inside) {
    // Of near members each stretch of a line tells anew; of all others it is known.
    for (std::size_t k = 0; k < piece.near.size(); ++k) within[piece.near[k]] = inside[k];
    return is_taken(piece.member, within);
  };
  const PieceRule rule{origin_, piece.volume_tolerance, piece.area_tolerance, parts_left};
  ShellMoments moments = near.empty() && !water
                             ? whole_patch_moments(piece.patch, rule)
                             : cut_patch_moments(piece.patch, near, takes, water, rule);
  // The factors of flux and area differ, and errors are not to become negative.
  const double area = piece.area * moments.area, error = std::abs(piece.area) * moments.area_error;
  const double volume_error = moments.volume_error;
  moments *= piece.flux;
  moments.area = area;
  moments.area_error = error;
  moments.volume_error = volume_error;
  return moments;
}

ShellMoments JoinedShells::wet_moments_of(const Piece& piece, const Plane& water) const {
  double lowest = water.height(piece.patch.point(0)), highest = lowest;
  for (int i = 1; i < 16; ++i) {
    const double height = water.height(piece.patch.point(i));
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  // A piece in the very plane of the water is above it, as everywhere.
  if (lowest >= 0.0) return {};
  return highest <= 0.0 ? piece.moments : moments_of(piece, &water, nullptr);
}

// By the caller alone: the water cuts few pieces, and many waters are asked for at once.
ShellMoments JoinedShells::change(const Plane& water) const {
  ShellMoments sum;
  try {
    for (const Piece& piece : pieces_) sum += wet_moments_of(piece, water);
  } catch (const SurfacesInOneAnother&) {
    refuse();
  }
  return sum;
}

std::vector<std::string> JoinedShells::idle_cuts() const {
  std::vector<double> walls(members_.size());
  for (const Piece& piece : pieces_) walls[piece.member] += piece.moments.area;
  std::vector<std::string> names;
  for (std::size_t m = 0; m < members_.size(); ++m) {
    const JoinedMember& own = members_[m];
    if (own.role != MemberRole::kCut || !own.appendage) continue;
    // A hole's wall is there only within something solid.
    if (walls[m] <= kNoWall * area_of(own.shell.box())) names.push_back(own.name);
  }
  return names;
}

// A closed surface has no ∫ n dS, and each of its three fluxes is its volume.
void JoinedShells::check_closed() const {
  if (members_.empty()) return;
  Eigen::AlignedBox3d least = members_.front().shell.box();
  for (const JoinedMember& member : members_) {
    // A gap beside the smallest member must not be lost in the size of the hull.
    if (volume_of(member.shell.box()) < volume_of(least)) least = member.shell.box();
  }
  const Vector3d fluxes = whole_.first.diagonal();
  const double open = std::max(whole_.normal.cwiseAbs().maxCoeff() / area_of(least),
                               (fluxes.maxCoeff() - fluxes.minCoeff()) /
                                   std::max(volume_of(least), std::abs(fluxes.mean())));
  if (open > kOpen) refuse();
}

void JoinedShells::refuse() const {
  std::string names;
  for (const JoinedMember& member : members_) {
    if (member.role != MemberRole::kHull) names += (names.empty() ? "" : ", ") + member.name;
  }
  throw std::invalid_argument(
      "The surfaces of " + (names.empty() ? "the hull's own bodies" : "the hull and of " + names) +
      " lie in one another along an area, or are open: let them cross at an angle, as by an end "
      "well within the hull.");
}

ShellMoments moments_of(const ClosedShell& shell) {
  const PieceRule rule{shell.box().center(), 0.0, 1e-12 * area_of(shell.box())};
  ShellMoments sum;
  for (const surface::BezierPatch& patch : shell.patches()) {
    sum += whole_patch_moments(patch, rule);
  }
  return moved(sum, rule.origin);
}

}  // namespace hull::analysis
