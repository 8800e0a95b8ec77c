// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/immersion/hull_body.h"

namespace hull::analysis {

// Two bodies of a hull's own that have space in common, of which volumes that add up have the
// double.
struct OwnOverlap {
  int first_body, second_body;  // as HullBody::bodies() numbers them
  double volume;                // m³, of both sides
  // Whether HullBody::join({}) counts it once. Where it does not, since the surfaces lie in one
  // another along an area, the volume is an estimate.
  bool is_countable = true;
};

// Whether boxes around two bodies of a hull have space in common. Where not, as where there is one
// body alone, none overlap. Takes no more than a look at each cell.
bool may_overlap(const HullBody& body);

// All pairs that overlap, by the whole surface; what encloses nothing, as a sheet, has no part in
// it. Only where boxes have space in common are surfaces looked at, which takes a fraction of a
// second; of many bodies that lie in one another only the first pairs, for some seconds.
std::vector<OwnOverlap> own_overlaps(const HullBody& body);

}  // namespace hull::analysis
