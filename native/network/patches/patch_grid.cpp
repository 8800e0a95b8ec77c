// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/patches/patch_grid.h"

#include <stdexcept>

namespace hull::network {
namespace {

PatchGrid square_grid(int count) {
  PatchGrid grid;
  for (int k = 0; k <= count; ++k) {
    for (int i = 0; i <= count; ++i) {
      grid.places.emplace_back(static_cast<double>(i) / count, static_cast<double>(k) / count);
    }
  }
  for (int k = 0; k < count; ++k) {
    for (int i = 0; i < count; ++i) {
      const int at = k * (count + 1) + i, up = at + count + 1;
      grid.triangles.push_back({at, at + 1, up + 1});
      grid.triangles.push_back({at, up + 1, up});
    }
  }
  return grid;
}

// Ring r has r places on each side.
PatchGrid ring_grid(const std::vector<Vector2d>& domain, int count) {
  const int sides = static_cast<int>(domain.size());
  Vector2d centre = Vector2d::Zero();
  for (const Vector2d& corner : domain) centre += corner / sides;
  PatchGrid grid{{centre}, {}};
  const auto number = [&](int ring, int side, int i) {
    // After the centre there are rings of 1, 2, ... places a side.
    if (ring == 0) return 0;
    return 1 + sides * ring * (ring - 1) / 2 + (side * ring + i) % (sides * ring);
  };
  for (int ring = 1; ring <= count; ++ring) {
    const double reach = static_cast<double>(ring) / count;
    for (int side = 0; side < sides; ++side) {
      const Vector2d& a = domain[static_cast<std::size_t>(side)];
      const Vector2d& b = domain[static_cast<std::size_t>((side + 1) % sides)];
      for (int i = 0; i < ring; ++i) {
        const Vector2d border = a + static_cast<double>(i) / ring * (b - a);
        // By way of the centre rounding would put places of the border beside it.
        grid.places.emplace_back(ring == count ? border
                                               : Vector2d(centre + reach * (border - centre)));
        grid.triangles.push_back(
            {number(ring, side, i), number(ring, side, i + 1), number(ring - 1, side, i)});
        // On each side a ring has one triangle less that stands on the ring within.
        if (i + 1 < ring) {
          grid.triangles.push_back({number(ring, side, i + 1), number(ring - 1, side, i + 1),
                                    number(ring - 1, side, i)});
        }
      }
    }
  }
  return grid;
}

}  // namespace

PatchGrid patch_grid(const std::vector<Vector2d>& domain, int count) {
  if (count < 1) throw std::invalid_argument("A side of a patch needs one part or more.");
  return domain.size() == 4 ? square_grid(count) : ring_grid(domain, count);
}

}  // namespace hull::network
