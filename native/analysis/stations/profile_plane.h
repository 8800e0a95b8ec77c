// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "analysis/appendages/profile_union.h"
#include "analysis/immersion/hull_body.h"

namespace hull::analysis {

// One body of the ship and the plane of its profile: the centre plane, or of a body beside it the
// one amidst that.
struct ProfilePlane {
  int body;
  bool is_half;  // of the port half, whose border is closed in the plane
  Plane plane;
};

ProfilePlane profile_plane(const HullBody& ship, int body);

// The profile of each of the hull's bodies, as profile_area.h has it, by chords: 32 of each cubic
// of a border, 16 of each arc of the section by the plane.
std::vector<ProfileOutline> hull_outlines(const HullBody& ship);

// By what the profile is more with the hull's bodies and appendages counted once than the sum of
// the bodies' profiles.
std::shared_ptr<const std::vector<ProfilePart>> joined_profile(
    const HullBody& ship, const std::vector<Appendage>& appendages);

}  // namespace hull::analysis
