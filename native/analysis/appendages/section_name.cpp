// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/appendages/section_name.h"

#include <regex>
#include <stdexcept>

namespace hull::analysis {
namespace {

// Parts: camber or lift, its place, reflexed or not (five digits only), thickness, nose and tenths.
const std::regex kDigits(R"((\d)(\d)(\d)?(\d\d)(-([1-9])([2-6]))?)");
// Parts: series, its range of low drag, A of 6A-series, lift, thickness, a.
const std::regex kSeries(
    R"(6([3-5])(\(\d\)|\d)?(A-?|-)(\d)(\d\d)(,? *a *= *(0?\.\d+|[01](\.0*)?))?)");
// The 6A-series' own mean line.
constexpr double kUsual6A = 0.8;

[[noreturn]] void refuse(const std::string& name) {
  throw std::invalid_argument(
      "\"" + name +
      "\" is no section that is known: give four digits as 0012 or 2412, five as 23012 (210 to "
      "250) or 23112 (221 to 251), either with another nose and place of the thickness as 0012-64, "
      "or a series from 63 to 65 or from 63A to 65A as 63-412, 64A010 or 65-215 a=0.5.");
}

SectionMeanLine mean_line_by_digits(const std::string& name, const std::smatch& part) {
  const int first = std::stoi(part[1]), second = std::stoi(part[2]);
  if (!part[3].matched) {
    if (first == 0 && second == 0) return {};
    if (first == 0 || second == 0) refuse(name);
    return SectionMeanLine::four_digits(0.01 * first, 0.1 * second);
  }
  const int third = std::stoi(part[3]);
  // Reflexed lines were published from 221 on, plain ones from 210.
  if (first == 0 || second < 1 + third || second > 5 || third > 1) refuse(name);
  return SectionMeanLine::five_digits(0.15 * first, second, third == 1);
}

NamedSection by_digits(const std::string& name, const std::smatch& part) {
  const double largest = 0.01 * std::stoi(part[4]);
  return {largest,
          part[5].matched
              ? SectionThickness::modified(largest, std::stoi(part[6]), std::stoi(part[7]))
              : SectionThickness::four_digits(largest),
          mean_line_by_digits(name, part)};
}

NamedSection of_series(const std::smatch& part) {
  const bool is_6a = part[3].str().starts_with('A');
  const double lift = 0.1 * std::stoi(part[4]), largest = 0.01 * std::stoi(part[5]);
  const double a = part[6].matched ? std::stod(part[7]) : is_6a ? kUsual6A : 1.0;
  SectionMeanLine line;
  if (lift > 0.0) {
    line = is_6a && a == kUsual6A ? SectionMeanLine::loaded_6a(lift)
                                  : SectionMeanLine::loaded(lift, a);
  }
  return {largest, SectionThickness::series(60 + std::stoi(part[1]), is_6a, largest), line};
}

}  // namespace

NamedSection section_named(const std::string& name) {
  const std::string form = name.starts_with("NACA ") ? name.substr(5) : name;
  std::smatch part;
  const bool has_digits = std::regex_match(form, part, kDigits);
  if (!has_digits && !std::regex_match(form, part, kSeries)) refuse(name);
  // A section without thickness encloses nothing.
  if (part[has_digits ? 4 : 5] == "00") refuse(name);
  return has_digits ? by_digits(name, part) : of_series(part);
}

}  // namespace hull::analysis
