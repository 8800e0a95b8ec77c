// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "network/curves/network_curve.h"
#include "network/joining/joined_curves.h"

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

struct CurveContacts {
  std::vector<Contact> joined;
  std::vector<Contact> near;  // beyond the tolerance
  std::vector<NetworkProblem> overlaps;
  std::vector<bool> is_copy;  // of curves: those that lie on another one all the way
};

CurveContacts curve_contacts(const std::vector<CurveShape>& shapes,
                             const std::vector<std::string>& names, const JoiningOptions& options);

}  // namespace hull::network
