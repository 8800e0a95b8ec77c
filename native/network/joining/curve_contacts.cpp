// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/joining/curve_contacts.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "network/crossings/curve_meetings.h"

namespace hull::network {
namespace {

constexpr double kAll = 0.99;  // of a length: all of it
// Near zones are wider than asked by up to twice this; less of it takes more straight parts.
constexpr double kFlat = 0.05;  // of the tolerance

class Contacting {
 public:
  Contacting(const std::vector<CurveShape>& shapes, const std::vector<std::string>& names,
             const JoiningOptions& options)
      : shapes_(shapes), names_(names), options_(options), trees_(shapes.size()) {}

  ContactTable run(const KnownContacts& known) {
    const int count = static_cast<int>(shapes_.size());
    ContactTable table;
    for (int i = 0; i < count; ++i) {
      for (int k = i; k < count; ++k) {
        if (known.table && !known.is_changed[static_cast<std::size_t>(i)] &&
            !known.is_changed[static_cast<std::size_t>(k)]) {
          // A known pair that is not in the table has no contacts, and none is looked for again.
          const auto at = known.table->find({i, k});
          if (at != known.table->end()) table.insert(*at);
          continue;
        }
        contacts_ = {};
        if (i == k) {
          within(i);
        } else {
          between(i, k);
        }
        if (!contacts_.is_empty()) table.emplace(std::pair(i, k), std::move(contacts_));
      }
    }
    return table;
  }

 private:
  // Made where they are asked for first.
  std::vector<CurveTree>& pieces(int curve) {
    auto& trees = trees_[static_cast<std::size_t>(curve)];
    if (trees.empty()) {
      for (const NurbsCurve& piece : shapes_[static_cast<std::size_t>(curve)].pieces) {
        trees.emplace_back(piece, kFlat * options_.tolerance);
      }
    }
    return trees;
  }
  const std::string& name(int curve) const { return names_[static_cast<std::size_t>(curve)]; }
  CurvePlace place(int curve, int piece, double parameter) {
    const NurbsCurve& of = pieces(curve)[static_cast<std::size_t>(piece)].curve();
    return {curve, piece, parameter, of.point(parameter)};
  }

  // Pieces that are not one after the other, and the two ends of the whole.
  void within(int curve) {
    const int count = static_cast<int>(pieces(curve).size());
    const int last = count - 1;
    const CurvePlace start = place(curve, 0, pieces(curve).front().curve().begin());
    const CurvePlace end = place(curve, last, pieces(curve).back().curve().end());
    const bool is_closed = (start.place - end.place).norm() <= options_.tolerance;
    for (int a = 0; a < count; ++a) {
      // Neighbours always meet, in their knuckle, and so do both ends of a closed curve.
      for (int b = a + 2; b < count; ++b) {
        if (!(is_closed && a == 0 && b == last)) meet(curve, a, curve, b);
      }
    }
    // A closed curve begins and ends in one node.
    if (is_closed) contacts_.joined.push_back({start, end});
  }

  void between(int i, int k) {
    double shared = 0.0;
    for (int a = 0; a < static_cast<int>(pieces(i).size()); ++a) {
      for (int b = 0; b < static_cast<int>(pieces(k).size()); ++b) shared += meet(i, a, k, b);
    }
    if (!(shared > 0.0)) return;
    const double first = length_of(i), second = length_of(k);
    if (shared < kAll * std::min(first, second)) return;
    if (shared >= kAll * std::max(first, second)) name_duplicate(i, k);
    // What lies on the other all the way is not joined, too.
    contacts_.copy = first < kAll * second ? i : k;
  }

  double length_of(int curve) {
    double length = 0.0;
    for (const CurveTree& tree : pieces(curve)) {
      const NurbsCurve& c = tree.curve();
      Vector3d before = c.point(c.begin());
      // By as many chords as stretches are measured with, to which it is compared.
      for (int i = 1; i <= 32; ++i) {
        const Vector3d next = c.point(c.begin() + (c.end() - c.begin()) * i / 32.0);
        length += (next - before).norm();
        before = next;
      }
    }
    return length;
  }

  // The length that they share.
  double meet(int i, int a, int k, int b) {
    CurveTree& first = pieces(i)[static_cast<std::size_t>(a)];
    CurveTree& second = pieces(k)[static_cast<std::size_t>(b)];
    const double far = options_.near_misses * options_.tolerance;
    // The wide reach first: where nothing is within it, as of most pairs, that is all.
    const CurveMeetings near = curve_meetings(first, second, far);
    if (near.points.empty() && near.overlaps.empty()) return 0.0;
    const CurveMeetings joined = curve_meetings(first, second, options_.tolerance);
    for (const CurveMeeting& at : joined.points) {
      contacts_.joined.push_back(
          {{i, a, at.first, at.first_place}, {k, b, at.second, at.second_place}});
    }
    if (!joined.points.empty()) {
      meet_ends(i, a, k, b, joined);
      meet_ends(k, b, i, a, joined);
    }
    double shared = 0.0;
    for (const CurveOverlap& stretch : joined.overlaps) {
      shared += stretch.length;
      name_overlap(i, k, stretch);
    }
    keep_near(i, a, k, b, near, joined);
    return shared;
  }

  // Ends and knuckles are nodes even where the curve crosses the other one just before: no further
  // off than a touch is long.
  void meet_ends(int i, int a, int k, int b, const CurveMeetings& joined) {
    const CurveTree& tree = pieces(i)[static_cast<std::size_t>(a)];
    const CurveTree& other = pieces(k)[static_cast<std::size_t>(b)];
    const NurbsCurve &first = tree.curve(), &second = other.curve();
    const double reach = longest_touch(tree, other, options_.tolerance);
    for (double t : {first.begin(), first.end()}) {
      const CurvePlace end = place(i, a, t);
      const auto is_near = [&](const CurveMeeting& at) {
        return (at.first_place - end.place).norm() <= reach;
      };
      if (std::ranges::none_of(joined.points, is_near)) continue;
      const CurvePlace foot = place(k, b, second.nearest_parameter(end.place));
      if ((end.place - foot.place).norm() > options_.tolerance) continue;
      contacts_.joined.push_back({end, foot});
    }
  }

  // What comes near, but nowhere within the tolerance.
  void keep_near(int i, int a, int k, int b, const CurveMeetings& near,
                 const CurveMeetings& joined) {
    for (const CurveMeeting& at : near.points) {
      if (at.distance() <= options_.tolerance) continue;
      contacts_.near.push_back(
          {{i, a, at.first, at.first_place}, {k, b, at.second, at.second_place}});
    }
    for (const CurveOverlap& stretch : near.overlaps) {
      const auto is_in = [&](double t) {
        return t >= stretch.first_low && t <= stretch.first_high;
      };
      // A wide stretch has many places: of one that is joined nowhere its beginning is told.
      const bool is_joined = std::ranges::any_of(joined.points, is_in, &CurveMeeting::first) ||
                             std::ranges::any_of(joined.overlaps, is_in, &CurveOverlap::first_low);
      if (is_joined) continue;
      contacts_.near.push_back({place(i, a, stretch.first_low), place(k, b, stretch.second_low)});
    }
  }

  void name_overlap(int i, int k, const CurveOverlap& stretch) {
    contacts_.overlaps.push_back(
        {NetworkProblem::Kind::kOverlap,
         "Curves " + name(i) + " and " + name(k) + " lie on one another over " +
             length_text(stretch.length) + ", from " + place_text(stretch.start) + " to " +
             place_text(stretch.end) + ": end one of them where the stretch begins.",
         {i, k},
         {stretch.start, stretch.end}});
  }

  void name_duplicate(int i, int k) {
    const Vector3d start = contacts_.overlaps.front().places.front();
    const Vector3d end = contacts_.overlaps.back().places.back();
    // One sentence in place of those of all stretches.
    contacts_.overlaps.clear();
    contacts_.overlaps.push_back({NetworkProblem::Kind::kDuplicate,
                                  "Curves " + name(i) + " and " + name(k) + " are the same, from " +
                                      place_text(start) + " to " + place_text(end) +
                                      ": remove one of them.",
                                  {i, k},
                                  {start, end}});
  }

  const std::vector<CurveShape>& shapes_;
  const std::vector<std::string>& names_;
  const JoiningOptions& options_;
  std::vector<std::vector<CurveTree>> trees_;
  PairContacts contacts_;  // of the pair that is looked at
};

}  // namespace

ContactTable contact_table(const std::vector<CurveShape>& shapes,
                           const std::vector<std::string>& names, const JoiningOptions& options,
                           const KnownContacts& known) {
  if (!(options.tolerance > 0.0) || !std::isfinite(options.tolerance) ||
      !(options.near_misses >= 1.0)) {
    throw std::invalid_argument(
        "A network's tolerance must be above zero, and near misses be named from one tolerance "
        "on.");
  }
  return Contacting(shapes, names, options).run(known);
}

}  // namespace hull::network
