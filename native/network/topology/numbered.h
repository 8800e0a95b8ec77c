// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace hull::network {

// Elements under numbers that stay while others come and go; the number of one that was removed is
// given to another.
template <class Element>
class Numbered {
 public:
  explicit Numbered(const char* name) : name_(name) {}

  int add(Element element) {
    ++count_;
    if (free_.empty()) {
      elements_.push_back(std::move(element));
      is_there_.push_back(true);
      return static_cast<int>(elements_.size()) - 1;
    }
    const int number = free_.back();
    free_.pop_back();
    elements_[number] = std::move(element);
    is_there_[number] = true;
    return number;
  }

  void remove(int number) {
    is_there_[number] = false;
    free_.push_back(number);
    --count_;
  }

  bool has(int number) const {
    return number >= 0 && number < end() && is_there_[static_cast<std::size_t>(number)];
  }
  int count() const { return count_; }
  int end() const { return static_cast<int>(elements_.size()); }  // numbers are below it

  // Throws std::invalid_argument where nothing has the number.
  const Element& at(int number) const {
    if (!has(number)) {
      throw std::invalid_argument("There is no " + std::string(name_) + " " +
                                  std::to_string(number) + ".");
    }
    return elements_[static_cast<std::size_t>(number)];
  }
  // REQUIRES: has(number).
  Element& operator[](int number) { return elements_[static_cast<std::size_t>(number)]; }
  const Element& operator[](int number) const {
    return elements_[static_cast<std::size_t>(number)];
  }

  std::vector<int> numbers() const {
    std::vector<int> all;
    for (int number = 0; number < end(); ++number) {
      if (has(number)) all.push_back(number);
    }
    return all;
  }

 private:
  const char* name_;
  std::vector<Element> elements_;
  std::vector<bool> is_there_;
  std::vector<int> free_;
  int count_ = 0;
};

}  // namespace hull::network
