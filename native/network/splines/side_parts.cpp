// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/splines/side_parts.h"

#include <algorithm>
#include <cmath>

namespace hull::network {
namespace {

constexpr double kAtNode = 1e-9;  // of an edge: what is nearer to its end is there
// Of an edge: where it may be cut between its ends, so that regions on both sides of it that cut it
// in one place do so bit for bit, and how near to it rounding leaves such a place.
constexpr double kCuts = 1024.0, kAtCut = 1e-13;
constexpr double kFromMiddle = 0.25;  // of a side: nodes nearer to its middle halve it

}  // namespace

SideParts::SideParts(const NetworkFrame& frame, RegionSide side)
    : side_(std::move(side)), ends_(side_ends(frame, side_)) {}

SideParts::Place SideParts::at(double t) const {
  const auto above = std::upper_bound(ends_.begin() + 1, ends_.end() - 1, t);
  const auto part = static_cast<std::size_t>(above - ends_.begin()) - 1;
  return {side_[part], edge_parameter(part, t)};
}

double SideParts::edge_parameter(std::size_t part, double t) const {
  double share = std::clamp((t - ends_[part]) / (ends_[part + 1] - ends_[part]), 0.0, 1.0);
  // Shares of a side are of all its edges' lengths: rounding is taken back to the edge's own
  // places.
  if (share < kAtNode) share = 0.0;
  if (share > 1.0 - kAtNode) share = 1.0;
  const double cut = std::round(share * kCuts) / kCuts;
  if (std::abs(share - cut) < kAtCut) share = cut;
  return side_[part].is_along ? share : 1.0 - share;
}

double SideParts::middle() const {
  const auto above = std::upper_bound(ends_.begin() + 1, ends_.end() - 1, 0.5);
  const double low = *(above - 1), width = *above - low;
  // The cut of the edge there that is nearest to the middle.
  double nearest = low + width * std::round((0.5 - low) / width * kCuts) / kCuts;
  double distance = kFromMiddle;
  // Better a node near the middle than a cut, which divides the edge for its other region, too.
  for (std::size_t i = 1; i + 1 < ends_.size(); ++i) {
    if (std::abs(ends_[i] - 0.5) > distance) continue;
    nearest = ends_[i];
    distance = std::abs(nearest - 0.5);
  }
  return nearest;
}

std::vector<EdgePiece> SideParts::pieces(double begin, double end) const {
  std::vector<EdgePiece> pieces;
  for (std::size_t part = 0; part < side_.size(); ++part) {
    const double low = std::max(begin, ends_[part]), high = std::min(end, ends_[part + 1]);
    if (!(high > low)) continue;
    pieces.push_back({side_[part].edge, edge_parameter(part, low), edge_parameter(part, high),
                      (low - begin) / (end - begin), (high - begin) / (end - begin)});
  }
  // But for rounding they are.
  pieces.front().begin = 0.0;
  pieces.back().end = 1.0;
  return pieces;
}

}  // namespace hull::network
