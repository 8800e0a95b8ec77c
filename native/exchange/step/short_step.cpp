// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/step/short_step.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace hull::exchange {
namespace {

constexpr std::size_t kLongestLine = 100;
constexpr std::string_view kSpace = " \t\r\n", kOfNumbers = "+-.0123456789E",
                           kEndsToken = " \t\r\n,()=;'";

bool is_one_of(char c, std::string_view characters) {
  return characters.find(c) != characters.npos;
}

class Shortener {
 public:
  explicit Shortener(std::string_view text) : text_(text) { result_.reserve(text.size()); }

  std::string make() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (is_one_of(c, kSpace)) {
        ++at_;
      } else if (c == '\'') {
        put(string_literal());
      } else if (is_one_of(c, kEndsToken)) {
        put(text_.substr(at_, 1));
        if (c == ';') end_line();
      } else {
        take_token();
      }
    }
    return std::move(result_);
  }

 private:
  // A quote within is doubled.
  std::string_view string_literal() const {
    std::size_t end = at_;
    do {
      // A string that does not end goes on to the text's end.
      end = std::min(text_.find('\'', end + 1), text_.size() - 1) + 1;
      // Another quote at once is the second of a doubled one.
    } while (end < text_.size() && text_[end] == '\'');
    return text_.substr(at_, end - at_);
  }

  void take_token() {
    const std::string_view token =
        text_.substr(at_, std::min(text_.find_first_of(kEndsToken, at_), text_.size()) - at_);
    double value = 0.0;
    // Whole numbers stay whole: STEP tells integers from reals by the point.
    const bool is_number =
        is_one_of('.', token) && token.find_first_not_of(kOfNumbers) == token.npos;
    const char* end = token.data() + token.size();
    // Enumerations like .E. have a point and these letters too, but do not read as numbers.
    if (is_number && std::from_chars(token.data(), end, value).ptr == end) {
      put(number(value), token.size());
    } else {
      put(token);
    }
  }

  // STEP wants a point in every real number, and a capital E.
  std::string_view number(double value) {
    char* const begin = digits_.data();
    // The shortest digits that read as the same double.
    char* end = std::to_chars(begin, begin + digits_.size() - 1, value).ptr;
    char* const exponent = std::find(begin, end, 'e');
    if (exponent != end) *exponent = 'E';
    if (std::find(begin, end, '.') == end) {
      // The point goes before the exponent, or to the end: 1E+20 becomes 1.E+20.
      std::copy_backward(exponent, end, end + 1);
      *exponent = '.';
      ++end;
    }
    return {begin, end};
  }

  void put(std::string_view token) { put(token, token.size()); }
  void put(std::string_view token, std::size_t taken) {
    // Between tokens only, and never an empty line before a long one.
    if (result_.size() + token.size() > line_ + kLongestLine && result_.size() > line_) end_line();
    result_ += token;
    at_ += taken;
  }

  void end_line() {
    result_ += '\n';
    line_ = result_.size();
  }

  std::string_view text_;
  std::size_t at_ = 0, line_ = 0;  // in the text; where the result's last line begins
  std::string result_;
  std::array<char, 40> digits_{};
};

}  // namespace

std::string short_step(std::string_view text) { return Shortener(text).make(); }

}  // namespace hull::exchange
