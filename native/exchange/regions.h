// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "conversion/caps/caps.h"
#include "exchange/cad_options.h"

namespace hull::exchange {

// Of every patch the part of the hull that it belongs to as a whole: "flat side" (y constant, away
// from the centre plane), "flat bottom" (z constant, normal down), "deck" (z constant, normal up),
// "transom" (x constant, furthest aft); all others, and those that are plane only in part, "shell".
// Constant to kInPlane of the set's size.
std::vector<std::string> find_regions(const conversion::PatchSet& set);

// "deck", "transom", "centre plane", "opening".
std::string region_of(conversion::Cap::Kind kind);

// The colour that a region of this name has unless another one is asked for.
analysis::Colour region_colour(const std::string& region);

// The one that it has by these options.
analysis::Colour colour_of(const std::string& region, const CadOptions& options);

}  // namespace hull::exchange
