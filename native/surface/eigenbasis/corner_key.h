// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>

#include "surface/eigenbasis/neighbourhood.h"

namespace hull::surface {

// Topology of a cell's neighbourhood at its irregular corner (0, 0), the other corners regular.
struct CornerKey {
  Scheme scheme;
  mesh::VertexKind kind;  // of the corner
  bool closed;            // its fan; a dart's and a one-creased cone's are opened at the crease
  int faces;              // in the fan
  int cell;               // position of the cell in the fan
  auto operator<=>(const CornerKey&) const = default;
};

inline CornerKey corner_key(Scheme scheme, const CornerFan& fan) {
  return {scheme, fan.kind, fan.closed, fan.faces, fan.cell};
}

}  // namespace hull::surface
