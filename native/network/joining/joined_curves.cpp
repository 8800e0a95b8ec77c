// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/joining/joined_curves.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "network/joining/curve_contacts.h"

namespace hull::network {
namespace {

constexpr double kLoop = 10.0;  // tolerances

// The classes of things that are the same.
class Classes {
 public:
  explicit Classes(std::size_t count) : root_(count) {
    std::iota(root_.begin(), root_.end(), std::size_t{0});
  }
  std::size_t of(std::size_t i) {
    while (root_[i] != i) i = root_[i] = root_[root_[i]];
    return i;
  }
  void unite(std::size_t i, std::size_t k) { root_[of(i)] = of(k); }

 private:
  std::vector<std::size_t> root_;
};

// Marks are places of curves at which something is; those of a contact have one class from the
// beginning, and classes that come together along a curve are united. Each class left is a node.
class Joining {
 public:
  Joining(const std::vector<CurveShape>& shapes, const std::vector<std::string>& names,
          const JoiningOptions& options)
      : shapes_(shapes), names_(names), options_(options) {}

  JoinedCurves run(const ContactTable& contacts) {
    std::vector<Contact> joined, near;
    is_copy_.assign(shapes_.size(), false);
    for (const auto& [curves, of_pair] : contacts) {
      joined.insert(joined.end(), of_pair.joined.begin(), of_pair.joined.end());
      near.insert(near.end(), of_pair.near.begin(), of_pair.near.end());
      const auto& overlaps = of_pair.overlaps;
      result_.problems.insert(result_.problems.end(), overlaps.begin(), overlaps.end());
      if (of_pair.copy >= 0) is_copy_[static_cast<std::size_t>(of_pair.copy)] = true;
    }
    gather(joined);
    unite_along_curves();
    number_nodes();
    place_visits();
    make_edges();
    name_gaps(near);
    return std::move(result_);
  }

 private:
  struct Mark {
    CurvePlace at;
    std::size_t contact;  // its class: two marks of a contact have the same one
    bool is_given;        // an end or a knuckle
  };

  // Contacts, the ends of all pieces, and along each curve in order.
  void gather(const std::vector<Contact>& joined) {
    std::size_t number = 0;
    for (const Contact& contact : joined) {
      if (is_copy(contact)) continue;
      marks_.push_back({contact.first, number, false});
      marks_.push_back({contact.second, number++, false});
    }
    for (std::size_t curve = 0; curve < shapes_.size(); ++curve) {
      if (is_copy_[curve]) continue;
      const auto& pieces = shapes_[curve].pieces;
      for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
        for (double t : {pieces[piece].begin(), pieces[piece].end()}) {
          marks_.push_back(
              {{static_cast<int>(curve), static_cast<int>(piece), t, pieces[piece].point(t)},
               number++,
               true});
        }
      }
    }
    class_count_ = number;
    const auto key = [](const Mark& mark) {
      return std::tuple(mark.at.curve, mark.at.piece, mark.at.parameter, mark.contact);
    };
    // By contacts, too: so nodes have one numbering where several marks are at one parameter.
    std::ranges::sort(marks_, {}, key);
  }

  // Marks one after the other on a curve within the tolerance are one visit.
  void unite_along_curves() {
    Classes classes(class_count_);
    is_one_.assign(marks_.size(), false);
    // Compared with the mark before alone: a row of meetings, each within the tolerance of the
    // next, is one node, however long.
    for (std::size_t i = 1; i < marks_.size(); ++i) {
      const CurvePlace &a = marks_[i - 1].at, &b = marks_[i].at;
      if (a.curve != b.curve || (a.place - b.place).norm() > options_.tolerance || is_whole(a, b)) {
        continue;
      }
      unite(classes, i);
    }
    // Where two nodes have become one, others may have a sliver between them that had none.
    for (bool is_changed = true; is_changed;) is_changed = unite_slivers(classes);
    close_loops(classes);
    for (Mark& mark : marks_) mark.contact = classes.of(mark.contact);
  }

  void unite(Classes& classes, std::size_t i) {
    classes.unite(marks_[i - 1].contact, marks_[i].contact);
    is_one_[i] = true;
  }

  // Nothing is left of a curve between two visits of one node that are within its reach.
  void close_loops(Classes& classes) {
    for (std::size_t i = 1; i < marks_.size(); ++i) {
      const CurvePlace &a = marks_[i - 1].at, &b = marks_[i].at;
      const bool is_loop = a.curve == b.curve && !is_whole(a, b) &&
                           classes.of(marks_[i - 1].contact) == classes.of(marks_[i].contact);
      if (is_loop && (a.place - b.place).norm() <= kLoop * options_.tolerance) is_one_[i] = true;
    }
  }

  // A closed curve that meets nothing, from its start to its end.
  bool is_whole(const CurvePlace& a, const CurvePlace& b) const {
    const auto& pieces = shapes_[static_cast<std::size_t>(a.curve)].pieces;
    return a.piece == 0 && a.parameter == pieces.front().begin() &&
           b.piece + 1 == static_cast<int>(pieces.size()) && b.parameter == pieces.back().end();
  }

  // Two curves from one node to another, all the way within the tolerance of one another: as where
  // they cross at a small angle beside a knuckle. Their nodes are one.
  bool unite_slivers(Classes& classes) {
    std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> gaps;
    for (std::size_t i = 1; i < marks_.size(); ++i) {
      if (is_one_[i] || marks_[i - 1].at.curve != marks_[i].at.curve) continue;
      const std::size_t a = classes.of(marks_[i - 1].contact), b = classes.of(marks_[i].contact);
      if (a != b) gaps[std::minmax(a, b)].push_back(i);
    }
    bool is_changed = false;
    for (const auto& [ends, at] : gaps) {
      for (std::size_t i : at) {
        for (std::size_t k : at) {
          // Both ways: the feet of either curve on the other may show it.
          if (i == k || (is_one_[i] && is_one_[k]) || !is_sliver(i, k)) continue;
          unite(classes, i);
          unite(classes, k);
          is_changed = true;
        }
      }
    }
    return is_changed;
  }

  // Whether what is before a mark is near what is before another one.
  bool is_sliver(std::size_t i, std::size_t k) const {
    constexpr int kParts = 8;
    const CurvePlace &a = marks_[i - 1].at, &b = marks_[i].at;
    const CurvePlace &c = marks_[k - 1].at, &d = marks_[k].at;
    if (a.piece != b.piece || c.piece != d.piece) return false;
    const NurbsCurve& first = piece_of(a);
    const NurbsCurve& second = piece_of(c);
    const double reach = 1.1 * options_.tolerance;
    for (int part = 1; part < kParts; ++part) {
      const double share = static_cast<double>(part) / kParts;
      const Vector3d place = first.point(a.parameter + share * (b.parameter - a.parameter));
      // The nearest place of the whole piece may lie beyond the stretch.
      const double foot = std::clamp(second.nearest_parameter(place), c.parameter, d.parameter);
      if ((second.point(foot) - place).norm() > reach) return false;
    }
    return true;
  }

  const NurbsCurve& piece_of(const CurvePlace& at) const {
    return shapes_[static_cast<std::size_t>(at.curve)].pieces[static_cast<std::size_t>(at.piece)];
  }

  void number_nodes() {
    node_of_class_.assign(class_count_, -1);
    std::vector<int> counts;
    for (const Mark& mark : marks_) {
      // In the order of marks: nodes are numbered along the curves.
      int& node = node_of_class_[mark.contact];
      if (node < 0) {
        node = static_cast<int>(result_.nodes.size());
        result_.nodes.emplace_back(Vector3d::Zero());
        counts.push_back(0);
      }
      result_.nodes[static_cast<std::size_t>(node)] += mark.at.place;
      ++counts[static_cast<std::size_t>(node)];
    }
    for (std::size_t node = 0; node < counts.size(); ++node) result_.nodes[node] /= counts[node];
  }

  // At an end or knuckle there, else at the mark that is nearest to the node.
  void place_visits() {
    for (std::size_t i = 0; i < marks_.size();) {
      std::size_t end = i + 1;
      while (end < marks_.size() && is_one_[end]) ++end;
      const int node = node_of_class_[marks_[i].contact];
      const Vector3d& place = result_.nodes[static_cast<std::size_t>(node)];
      const auto first = marks_.begin() + static_cast<long>(i);
      const auto last = marks_.begin() + static_cast<long>(end);
      // A curve visits a node once, however many marks it has there.
      const auto best = std::min_element(first, last, [&](const Mark& a, const Mark& b) {
        if (a.is_given != b.is_given) return a.is_given;
        return (a.at.place - place).norm() < (b.at.place - place).norm();
      });
      result_.visits.push_back({best->at.curve, best->at.piece, best->at.parameter, node});
      first_pieces_.push_back(first->at.piece);
      i = end;
    }
  }

  void make_edges() {
    for (std::size_t i = 0; i + 1 < result_.visits.size(); ++i) {
      const NodeVisit &a = result_.visits[i], &b = result_.visits[i + 1];
      if (a.curve != b.curve) continue;
      const auto& pieces = shapes_[static_cast<std::size_t>(a.curve)].pieces;
      // That of the marks on either side of what is between, which are of one: visits may be at
      // other knuckles, as a short piece may be all within one.
      const int piece = first_pieces_[i + 1];
      const NurbsCurve& on = pieces[static_cast<std::size_t>(piece)];
      const double low = piece == a.piece ? a.parameter : on.begin();
      const double high = piece == b.piece ? b.parameter : on.end();
      // None between visits at one parameter.
      if (low < high) result_.edges.push_back({a.curve, piece, low, high, a.node, b.node});
    }
  }

  bool is_copy(const Contact& contact) const {
    return is_copy_[static_cast<std::size_t>(contact.first.curve)] ||
           is_copy_[static_cast<std::size_t>(contact.second.curve)];
  }

  // Curves that part from a common node under a small angle are near one another beside it: no gap.
  bool share_node_near(const Contact& contact) const {
    const double reach = 3.0 * options_.near_misses * options_.tolerance;
    std::vector<int> nodes;
    for (const NodeVisit& visit : result_.visits) {
      const Vector3d& node = result_.nodes[static_cast<std::size_t>(visit.node)];
      if (visit.curve == contact.first.curve && (node - contact.first.place).norm() <= reach) {
        nodes.push_back(visit.node);
      }
    }
    return std::ranges::any_of(result_.visits, [&](const NodeVisit& visit) {
      return visit.curve == contact.second.curve &&
             std::ranges::find(nodes, visit.node) != nodes.end();
    });
  }

  void name_gaps(const std::vector<Contact>& near) {
    for (const Contact& contact : near) {
      if (is_copy(contact) || share_node_near(contact)) continue;
      const auto name = [&](const CurvePlace& at) {
        return names_[static_cast<std::size_t>(at.curve)];
      };
      const Vector3d &a = contact.first.place, &b = contact.second.place;
      result_.problems.push_back({NetworkProblem::Kind::kGap,
                                  "Curves " + name(contact.first) + " at " + place_text(a) +
                                      " and " + name(contact.second) + " at " + place_text(b) +
                                      " miss one another by " + length_text((a - b).norm()) +
                                      ", more than the tolerance of " +
                                      length_text(options_.tolerance) +
                                      ": give both a common point there, or a larger tolerance.",
                                  {contact.first.curve, contact.second.curve},
                                  {a, b}});
    }
  }

  const std::vector<CurveShape>& shapes_;
  const std::vector<std::string>& names_;
  const JoiningOptions& options_;
  JoinedCurves result_;
  std::vector<Mark> marks_;
  std::vector<bool> is_one_;  // of a mark: it is of the same visit as the one before
  std::vector<int> node_of_class_;
  std::vector<int> first_pieces_;  // of visits: the piece that comes to them
  std::size_t class_count_ = 0;
  std::vector<bool> is_copy_;
};

}  // namespace

JoinedCurves join_curves(const std::vector<CurveShape>& shapes,
                         const std::vector<std::string>& names, const JoiningOptions& options,
                         const ContactTable& contacts) {
  return Joining(shapes, names, options).run(contacts);
}

}  // namespace hull::network
