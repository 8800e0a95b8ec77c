// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/step/shared_points.h"

#include <algorithm>
#include <cstddef>
#include <unordered_map>

namespace hull::exchange {
namespace {

constexpr std::string_view kPoint = "=CARTESIAN_POINT(", kDigits = "0123456789";

// Where the statement at `begin` ends: after its semicolon and line's end. A quote within a string
// is doubled, which ends one string and begins another.
std::size_t end_of_statement(std::string_view text, std::size_t begin) {
  bool in_string = false;
  for (std::size_t at = begin; at < text.size(); ++at) {
    // Semicolons in strings end nothing.
    if (text[at] == '\'') in_string = !in_string;
    if (text[at] != ';' || in_string) continue;
    return std::min(text.find_first_not_of('\n', at + 1), text.size());
  }
  return text.size();
}

// The characters of a number after '#'.
std::string_view number_at(std::string_view text, std::size_t begin) {
  const std::size_t end = std::min(text.find_first_not_of(kDigits, begin), text.size());
  return text.substr(begin, end - begin);
}

class PointSharer {
 public:
  explicit PointSharer(std::string_view text) : text_(text) {}

  std::string make() {
    // Twice over the text: a point may be referred to before it stands there.
    for_each_statement([this](std::string_view statement) { find_point(statement); });
    std::string result;
    result.reserve(text_.size());
    for_each_statement([&](std::string_view statement) {
      // The header's statements have no numbers.
      const bool is_left_out = statement.starts_with('#') && is_point(statement) &&
                               first_.contains(number_at(statement, 1));
      if (!is_left_out) put(statement, result);
    });
    return result;
  }

 private:
  template <class Visit>
  void for_each_statement(const Visit& visit) const {
    for (std::size_t begin = 0; begin < text_.size();) {
      const std::size_t end = end_of_statement(text_, begin);
      visit(text_.substr(begin, end - begin));
      begin = end;
    }
  }

  static bool is_point(std::string_view statement) {
    return statement.substr(1 + number_at(statement, 1).size()).starts_with(kPoint);
  }

  void find_point(std::string_view statement) {
    if (!statement.starts_with('#') || !is_point(statement)) return;
    const std::string_view number = number_at(statement, 1);
    // Lines end at different places.
    std::string value(statement.substr(1 + number.size()));
    std::erase(value, '\n');
    const auto [known, is_new] = points_.try_emplace(std::move(value), number);
    // The lowest number stays, as statements come in order.
    if (!is_new) first_.emplace(number, known->second);
  }

  void put(std::string_view statement, std::string& result) const {
    bool in_string = false;
    for (std::size_t at = 0; at < statement.size();) {
      const std::size_t next = std::min(statement.find_first_of("'#", at), statement.size());
      result += statement.substr(at, next - at);
      at = next;
      if (at == statement.size()) break;
      // A '#' within a string is no reference.
      in_string ^= statement[at] == '\'';
      result += statement[at++];
      if (statement[at - 1] != '#' || in_string) continue;
      const std::string_view number = number_at(statement, at);
      const auto found = first_.find(number);
      result += found == first_.end() ? number : found->second;
      at += number.size();
    }
  }

  std::string_view text_;
  std::unordered_map<std::string, std::string_view> points_;      // number, by what it is
  std::unordered_map<std::string_view, std::string_view> first_;  // of those left out
};

}  // namespace

std::string with_shared_points(std::string_view text) { return PointSharer(text).make(); }

}  // namespace hull::exchange
