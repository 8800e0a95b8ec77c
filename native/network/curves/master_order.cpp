// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/curves/master_order.h"

#include <algorithm>
#include <stdexcept>

namespace hull::network {
namespace {

std::vector<int> masters_of(const CurveDefinition& curve) {
  std::vector<int> masters;
  for (const EndCondition* end : {&curve.start, &curve.end}) {
    if (end->kind == EndCondition::Kind::kSlaveTangent ||
        end->kind == EndCondition::Kind::kSlaveCurvature) {
      masters.push_back(end->master);
    }
  }
  return masters;
}

enum class State { kNew, kBegun, kDone };

// Depth first, without recursion: chains of slaves may be long.
class Ordering {
 public:
  explicit Ordering(const std::vector<CurveDefinition>& definitions)
      : definitions_(definitions), states_(definitions.size(), State::kNew) {}

  std::vector<int> run() {
    for (std::size_t curve = 0; curve < definitions_.size(); ++curve) {
      if (states_[curve] == State::kNew) follow(static_cast<int>(curve));
    }
    return std::move(order_);
  }

 private:
  void follow(int first) {
    path_ = {first};
    while (!path_.empty()) {
      // It stays on the path until all its masters are done, and is come back to after each of
      // them.
      const int curve = path_.back();
      states_[static_cast<std::size_t>(curve)] = State::kBegun;
      const int master = next_master(curve);
      if (master >= 0) {
        path_.push_back(master);
        continue;
      }
      states_[static_cast<std::size_t>(curve)] = State::kDone;
      // Behind its masters, which were done before.
      order_.push_back(curve);
      path_.pop_back();
    }
  }

  int next_master(int curve) const {
    const CurveDefinition& definition = definitions_[static_cast<std::size_t>(curve)];
    for (int master : masters_of(definition)) {
      if (master < 0 || master >= static_cast<int>(definitions_.size())) {
        throw std::invalid_argument("The master of curve " + definition.name + " is not there.");
      }
      const State state = states_[static_cast<std::size_t>(master)];
      // It is on the path, and so depends on the curve.
      if (state == State::kBegun) throw_circle(master);
      if (state == State::kNew) return master;
    }
    return -1;
  }

  [[noreturn]] void throw_circle(int master) const {
    std::string names;
    // What leads to the circle is not part of it.
    for (auto at = std::ranges::find(path_, master); at != path_.end(); ++at) {
      names += definitions_[static_cast<std::size_t>(*at)].name + ", slave of ";
    }
    throw std::invalid_argument("Curves are slaves of one another in a circle: " + names +
                                definitions_[static_cast<std::size_t>(master)].name +
                                ". Give one of them an end of its own.");
  }

  const std::vector<CurveDefinition>& definitions_;
  std::vector<State> states_;
  std::vector<int> path_, order_;
};

}  // namespace

std::vector<int> masters_first(const std::vector<CurveDefinition>& definitions) {
  return Ordering(definitions).run();
}

}  // namespace hull::network
