// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/features/layout_shortfall.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <vector>

#include "mesh/place_text.h"

namespace hull::morphing {
namespace {

std::string at_text(const Vector3d& p, const char* hull) {
  return mesh::place_text(p, 2) + " of the " + hull;
}

// The nearest of some features to a place; -1 where there are none.
int nearest_of(const FeatureGraph& graph, const std::vector<int>& features, const Vector3d& place) {
  int found = -1;
  double least = std::numeric_limits<double>::infinity();
  for (int feature : features) {
    const double distance = graph.features[feature].curve.foot(place, false).distance;
    if (!(distance < least)) continue;
    least = distance;
    found = feature;
  }
  return found;
}

std::string reason(const LayoutFit& fit, double off, double tolerance) {
  if (off <= tolerance) return "Members are folded at " + at_text(*fit.fold, "first hull");
  const bool is_there = fit.largest >= fit.largest_back;
  char text[96];
  std::snprintf(text, sizeof text, "The layout is left %.2e of the length off, farthest at ", off);
  std::string found = text + at_text(is_there ? fit.largest_place : fit.largest_back_place,
                                     is_there ? "second hull" : "layout");
  if (fit.fold) return found + ", and members are folded at " + at_text(*fit.fold, "first");
  if (!fit.fold_ahead) return found;
  return found + ": a closer one folds members at " + at_text(*fit.fold_ahead, "first");
}

std::string remedy(const FeatureGraph& first, const FeatureGraph& second, const LayoutFit& fit) {
  // On the first hull, and where that is in the second one's box.
  Vector3d place, other;
  if (fit.fold || fit.fold_ahead) {
    place = fit.fold ? *fit.fold : *fit.fold_ahead;
    other = second.box.absolute(first.box.relative(place));
  } else {
    other = fit.largest >= fit.largest_back ? fit.largest_place : fit.largest_back_place;
    place = first.box.absolute(second.box.relative(other));
  }
  const int a = nearest_of(first, fit.match.alone_in_first, place);
  const int b = nearest_of(second, fit.match.alone_in_second, other);
  const char* const or_another =
      "take the layout of the other hull, or of a third one, such as the sample coaster's";
  if (a < 0 && b < 0) return std::string("all lines are paired: ") + or_another;
  std::string text;
  // Of one role near one place: perhaps counterparts that were too far apart, or held so.
  if (a >= 0 && b >= 0 && first.features[a].role == second.features[b].role) {
    text = "pair by hand " + first.described(a) + " of the first with " + second.described(b) +
           " of the second, if they belong together";
  } else if (a >= 0) {
    text = "pair by hand " + first.described(a) + " of the first" +
           (b >= 0 ? ", and " + second.described(b) + " of the second" : "") +
           ", with a row that you crease in the other hull";
  } else {
    text = "crease a row of the first hull where the second has " + second.described(b) +
           ", and pair the two by hand";
  }
  return text + ", or " + or_another;
}

}  // namespace

std::string layout_shortfall(const FeatureGraph& first, const FeatureGraph& second,
                             const LayoutFit& fit, double tolerance) {
  const double length = second.box.high.x() - second.box.low.x();
  // By the worse of both ways.
  const double off = length > 0.0 ? std::max(fit.rms, fit.rms_back) / length : 0.0;
  if (off <= tolerance && !fit.fold) return "";
  return reason(fit, off, tolerance) + ": " + remedy(first, second, fit) + ".";
}

}  // namespace hull::morphing
