// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hull::surface {

// Which weights a smooth edge between a crease or corner vertex and a smooth vertex takes.
enum class Scheme {
  kBiermann,     // from the sector's valence: tangent planes at creases (Greshake 2021, 5.3)
  kCatmullClark  // always 1/4: what Blender's Subdivision Surface modifier and OpenSubdiv show
};

}  // namespace hull::surface
