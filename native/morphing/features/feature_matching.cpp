// SPDX-License-Identifier: GPL-3.0-or-later
#include "morphing/features/feature_matching.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

#include "morphing/features/landmarks.h"

namespace hull::morphing {
namespace {

constexpr int kCompared = 5;  // places along a feature

double distance_between(const FeatureGraph& a, const Feature& f, const FeatureGraph& b,
                        const Feature& g) {
  double sum = 0.0;
  for (int i = 0; i < kCompared; ++i) {
    const double share = i / (kCompared - 1.0);
    sum += (a.box.relative(f.curve.point_at(share * f.curve.length())) -
            b.box.relative(g.curve.point_at(share * g.curve.length())))
               .squaredNorm();
  }
  return std::sqrt(sum / kCompared);
}

// The box of each body's features, relative to the hull's.
std::vector<HullBox> body_boxes(const FeatureGraph& graph) {
  std::vector<std::vector<Vector3d>> corners(graph.body_count);
  for (const Feature& f : graph.features) {
    for (int chain : f.chains) {
      for (const Vector3d& p : graph.curves[chain].spline().points()) {
        corners[f.body].push_back(graph.box.relative(p));
      }
    }
  }
  std::vector<HullBox> boxes;
  for (const std::vector<Vector3d>& points : corners) {
    // A smooth closed body has no lines to go by: it counts as a point at the hull's corner.
    boxes.push_back(points.empty() ? HullBox{Vector3d::Zero(), Vector3d::Zero()} : box_of(points));
  }
  return boxes;
}

class Matching {
 public:
  Matching(const FeatureGraph& first, const FeatureGraph& second)
      : first_(first),
        second_(second),
        is_paired_(first.features.size(), 0),
        is_taken_(second.features.size(), 0) {}

  void add(int i, int j, bool is_given) {
    is_paired_[i] = is_taken_[j] = 1;
    const double distance =
        distance_between(first_, first_.features[i], second_, second_.features[j]);
    match_.pairs.push_back({i, j, distance, is_given});
  }

  void take_given(const std::vector<std::array<int, 2>>& given) {
    for (const auto& [i, j] : given) {
      check(i, is_paired_, "first");
      check(j, is_taken_, "second");
      add(i, j, true);
    }
  }

  void take_nearest(const std::vector<std::array<int, 2>>& apart) {
    const std::vector<int> bodies = paired_bodies(first_, second_);
    std::vector<std::tuple<double, int, int>> candidates;
    const auto count = [](const FeatureGraph& graph, const Feature& f) {
      return std::count_if(graph.features.begin(), graph.features.end(), [&](const Feature& other) {
        return other.body == f.body && other.role == f.role;
      });
    };
    for (int i = 0; i < static_cast<int>(first_.features.size()); ++i) {
      const Feature& f = first_.features[i];
      for (int j = 0; j < static_cast<int>(second_.features.size()); ++j) {
        const Feature& g = second_.features[j];
        // A closed line has no ends that could come to another one's.
        if (is_paired_[i] || is_taken_[j] || f.role != g.role || bodies[f.body] != g.body ||
            f.closed() != g.closed() ||
            std::find(apart.begin(), apart.end(), std::array{i, j}) != apart.end()) {
          continue;
        }
        const double distance = distance_between(first_, f, second_, g);
        // What is called a knuckle is any other crease: two of them may have nothing in common.
        const bool is_only =
            f.role != FeatureRole::kKnuckle && count(first_, f) == 1 && count(second_, g) == 1;
        if (is_only || distance <= kFarthestPair) candidates.emplace_back(distance, i, j);
      }
    }
    // The nearest of all first, then of what is left; equals by their numbers.
    std::sort(candidates.begin(), candidates.end());
    for (const auto& [distance, i, j] : candidates) {
      if (!is_paired_[i] && !is_taken_[j]) add(i, j, false);
    }
  }

  FeatureMatch finished() {
    std::sort(match_.pairs.begin(), match_.pairs.end(),
              [](const FeaturePair& a, const FeaturePair& b) { return a.first < b.first; });
    for (int i = 0; i < static_cast<int>(is_paired_.size()); ++i) {
      if (is_paired_[i]) continue;
      match_.alone_in_first.push_back(i);
      match_.remarks.push_back("In the second hull nothing is paired with " + first_.described(i) +
                               " of the first: pair it by hand, or it is laid onto the smooth "
                               "surface there.");
    }
    for (int j = 0; j < static_cast<int>(is_taken_.size()); ++j) {
      if (is_taken_[j]) continue;
      match_.alone_in_second.push_back(j);
      match_.remarks.push_back("In the first hull nothing is paired with " + second_.described(j) +
                               " of the second: pair it by hand, crease a row of the first hull "
                               "there, or it is rounded off.");
    }
    return std::move(match_);
  }

 private:
  static void check(int number, const std::vector<char>& taken, const char* hull) {
    const int count = static_cast<int>(taken.size());
    if (number < 0 || number >= count) {
      throw std::invalid_argument("The " + std::string(hull) + " hull has no feature " +
                                  std::to_string(number) + ": there are " + std::to_string(count) +
                                  ".");
    }
    if (taken[number]) {
      throw std::invalid_argument("Feature " + std::to_string(number) + " of the " + hull +
                                  " hull is in two pairs: leave one.");
    }
  }

  const FeatureGraph& first_;
  const FeatureGraph& second_;
  std::vector<char> is_paired_, is_taken_;
  FeatureMatch match_;
};

// The features that meet at a control point, by the first hull's numbers where they are paired.
using Meeting = std::map<int, std::set<int>>;

Meeting meeting_features(const FeatureGraph& graph, const std::map<int, int>& numbers) {
  Meeting found;
  for (int i = 0; i < static_cast<int>(graph.features.size()); ++i) {
    // Lines without counterpart do not count: what is left is to be the same on both hulls.
    const auto number = numbers.find(i);
    if (number == numbers.end()) continue;
    for (int node : graph.features[i].nodes) found[node].insert(number->second);
  }
  return found;
}

// Of a line's length: landmarks nearer to a common place than this, on either hull, are left out.
constexpr double kApart = 5e-3;

// Adds a pair of lengths to others, rising in both, where it lies between two of them in both.
void insert_between(const std::array<double, 2>& pair, double first_end, double second_end,
                    std::vector<std::array<double, 2>>& common) {
  // As both lengths rise from pair to pair, the order by the first is that by both.
  const auto after = std::upper_bound(common.begin(), common.end(), pair);
  const std::array<double, 2> low = after == common.begin() ? std::array{0.0, 0.0} : after[-1];
  const std::array<double, 2> high =
      after == common.end() ? std::array{first_end, second_end} : *after;
  const std::array<double, 2> apart{kApart * first_end, kApart * second_end};
  for (int k : {0, 1}) {
    if (pair[k] < low[k] + apart[k] || pair[k] > high[k] - apart[k]) return;
  }
  common.insert(after, pair);
}

}  // namespace

std::vector<int> paired_bodies(const FeatureGraph& first, const FeatureGraph& second) {
  const std::vector<HullBox> boxes = body_boxes(first), others = body_boxes(second);
  std::vector<std::tuple<double, int, int>> candidates;
  for (int i = 0; i < first.body_count; ++i) {
    for (int j = 0; j < second.body_count; ++j) {
      // By both corners, so that extent and place count alike.
      const double off = (boxes[i].low - others[j].low).squaredNorm() +
                         (boxes[i].high - others[j].high).squaredNorm();
      candidates.emplace_back(off, i, j);
    }
  }
  std::sort(candidates.begin(), candidates.end());
  std::vector<int> pair(first.body_count, -1);
  std::set<int> taken;
  for (const auto& [off, i, j] : candidates) {
    if (pair[i] >= 0 || !taken.insert(j).second) continue;
    pair[i] = j;
  }
  return pair;
}

FeatureMatch match_features(const FeatureGraph& first, const FeatureGraph& second,
                            const std::vector<std::array<int, 2>>& given,
                            const std::vector<std::array<int, 2>>& apart) {
  Matching matching(first, second);
  matching.take_given(given);
  matching.take_nearest(apart);
  return matching.finished();
}

double LengthMap::operator()(double length) const {
  // Between inner ends, so that the first and the last stretch go on beyond theirs.
  const auto upper = std::upper_bound(first.begin() + 1, first.end() - 1, length);
  const auto k = upper - first.begin();
  const double share = (length - first[k - 1]) / (first[k] - first[k - 1]);
  return second[k - 1] + share * (second[k] - second[k - 1]);
}

// Nodes come first: landmarks are taken only where there is room between them.
LengthMap length_map(const FeatureGraph& first, const FeatureGraph& second,
                     const FeatureMatch& match, const FeaturePair& pair) {
  std::map<int, int> own, others;
  for (const FeaturePair& each : match.pairs) {
    own[each.first] = each.first;
    others[each.second] = each.first;
  }
  const Meeting at = meeting_features(first, own), at_other = meeting_features(second, others);
  const Feature &f = first.features[pair.first], &g = second.features[pair.second];
  std::vector<std::array<double, 2>> common;
  std::size_t next = 1;
  for (std::size_t i = 1; i + 1 < f.nodes.size(); ++i) {
    const std::set<int>& here = at.at(f.nodes[i]);
    if (here.size() < 2) continue;
    // Beyond those that were found: lengths rise on both lines.
    for (std::size_t j = next; j + 1 < g.nodes.size(); ++j) {
      if (at_other.at(g.nodes[j]) != here) continue;
      common.push_back({f.lengths[i], g.lengths[j]});
      next = j + 1;
      break;
    }
  }
  for (const std::array<double, 2>& pair : common_landmarks(first, f, second, g)) {
    insert_between(pair, f.curve.length(), g.curve.length(), common);
  }
  LengthMap map{{0.0}, {0.0}};
  for (const auto& [own_length, other_length] : common) {
    map.first.push_back(own_length);
    map.second.push_back(other_length);
  }
  map.first.push_back(f.curve.length());
  map.second.push_back(g.curve.length());
  return map;
}

}  // namespace hull::morphing
