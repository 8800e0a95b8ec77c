// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace hull::analysis {

// What is kept by key. Once there are more than `most` entries, those of before are forgotten.
template <class Key, class Kept>
class KeptEntries {
 public:
  explicit KeptEntries(std::size_t most) : most_(most) {}

  std::size_t size() const { return entries_.size(); }
  void clear() { entries_.clear(); }

  // The entry of each key, until the next call; of a key that was there before among these a new
  // one, which is not kept: two threads must not write the same.
  std::vector<Kept*> of(const std::vector<Key>& keys) {
    if (entries_.size() > most_) entries_.clear();
    of_repeated_.clear();
    of_repeated_.reserve(keys.size());
    std::set<Kept*> taken;
    std::vector<Kept*> kept;
    for (const Key& key : keys) {
      Kept* entry = &entries_[key];
      kept.push_back(taken.insert(entry).second ? entry : &of_repeated_.emplace_back());
    }
    return kept;
  }

 private:
  std::size_t most_;
  std::map<Key, Kept> entries_;
  std::vector<Kept> of_repeated_;
};

}  // namespace hull::analysis
