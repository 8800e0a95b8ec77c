// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "analysis/appendages/appendage.h"
#include "analysis/appendages/joined_shells.h"
#include "analysis/immersion/hull_body.h"

namespace hull::analysis {

// The bodies of a hull, both sides, with what closes them, one member for each connected part. At
// irregular points squares of a ten-millionth of the hull's size are left out.
std::vector<JoinedMember> hull_members(const HullBody& body);

// What the surface encloses of its box's volume; 0 where the box is flat, negative where the
// surface is turned inwards.
double enclosed_share(const ClosedShell& shell);
inline constexpr double kSheetShare = 1e-6;  // no more is a sheet's

// Of these, but for sheets, and of appendages, about the body's centre, to its tolerance.
std::shared_ptr<const JoinedShells> joined_shells(const HullBody& body,
                                                  const std::vector<Appendage>& appendages);

}  // namespace hull::analysis
