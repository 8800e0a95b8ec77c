// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "network/curves/network_curve.h"
#include "network/joining/joining_options.h"
#include "network/joining/network_problem.h"

namespace hull::network {

// A place on a piece of a curve.
struct CurvePlace {
  int curve, piece;
  double parameter;
  Vector3d place;
};

// Two places that are to be one node.
struct Contact {
  CurvePlace first, second;
};

// Of two curves, or of one with itself.
struct PairContacts {
  std::vector<Contact> joined;
  std::vector<Contact> near;  // beyond the tolerance
  std::vector<NetworkProblem> overlaps;
  int copy = -1;  // that of the two which lies on the other one all the way

  bool is_empty() const { return joined.empty() && near.empty() && overlaps.empty(); }
};

// By the numbers of the curves, the lesser one first; pairs without contacts are not there.
using ContactTable = std::map<std::pair<int, int>, PairContacts>;

// What is known of curves of which some have changed since.
struct KnownContacts {
  std::shared_ptr<const ContactTable> table;
  std::vector<bool> is_changed;
};

// Throws std::invalid_argument for a tolerance that is not above zero.
ContactTable contact_table(const std::vector<CurveShape>& shapes,
                           const std::vector<std::string>& names, const JoiningOptions& options,
                           const KnownContacts& known = {});

}  // namespace hull::network
