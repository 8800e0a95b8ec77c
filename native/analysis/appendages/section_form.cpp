// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/appendages/section_form.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>

namespace hull::analysis {
namespace {

constexpr int kStations = 26;
constexpr std::array<double, kStations> kTableX{
    0.0, 0.005, 0.0075, 0.0125, 0.025, 0.05, 0.075, 0.1,  0.15, 0.2,  0.25, 0.3,  0.35,
    0.4, 0.45,  0.5,    0.55,   0.6,   0.65, 0.7,   0.75, 0.8,  0.85, 0.9,  0.95, 1.0};
// Half thickness of 63-012, 64-012, 65-012 in per cent of the chord, and the radius of the leading
// edge in per cent (Report 824).
struct Series {
  int name;
  double radius;
  std::array<double, kStations> y;
};
constexpr std::array<Series, 3> kSeries{
    {{63, 1.087, {0.0,   0.985, 1.194, 1.519, 2.102, 2.925, 3.542, 4.039, 4.799,
                  5.342, 5.712, 5.930, 6.000, 5.920, 5.704, 5.370, 4.935, 4.420,
                  3.840, 3.210, 2.556, 1.902, 1.274, 0.707, 0.250, 0.0}},
     {64, 1.040, {0.0,   0.978, 1.179, 1.490, 2.035, 2.810, 3.394, 3.871, 4.620,
                  5.173, 5.576, 5.844, 5.978, 5.981, 5.798, 5.480, 5.056, 4.548,
                  3.974, 3.350, 2.695, 2.029, 1.382, 0.786, 0.288, 0.0}},
     {65, 1.000, {0.0,   0.923, 1.109, 1.387, 1.875, 2.606, 3.172, 3.647, 4.402,
                  4.975, 5.406, 5.716, 5.912, 5.997, 5.949, 5.757, 5.412, 4.943,
                  4.381, 3.743, 3.059, 2.345, 1.630, 0.947, 0.356, 0.0}}}};
constexpr double kTableThickness = 0.12;
constexpr int kParts = 48;
constexpr double kMeeting = 1e-12;  // of the chord: where two mean lines meet

const Series& series_of(int name) { return *std::ranges::find(kSeries, name, &Series::name); }

double knot(int i) { return std::sqrt(kTableX[i]); }

// y / √x at a station, of the chord; √(2 r) at the leading edge.
double table_ratio(const Series& series, int i) {
  if (i == 0) return std::sqrt(2.0 * 0.01 * series.radius);
  return 0.01 * series.y[i] / knot(i);
}

// Slopes of the natural cubic spline through the ratios, by √x.
std::vector<double> spline_slopes(const Series& series) {
  const int n = kStations;
  std::vector<double> diagonal(n), right(n), slopes(n), upper(n);
  for (int i = 0; i < n; ++i) {
    const double before = i > 0 ? 1.0 / (knot(i) - knot(i - 1)) : 0.0;
    const double after = i + 1 < n ? 1.0 / (knot(i + 1) - knot(i)) : 0.0;
    diagonal[i] = 2.0 * (before + after);
    upper[i] = after;
    if (i > 0) {
      right[i] += 3.0 * before * before * (table_ratio(series, i) - table_ratio(series, i - 1));
    }
    if (i + 1 < n) {
      right[i] += 3.0 * after * after * (table_ratio(series, i + 1) - table_ratio(series, i));
    }
  }
  for (int i = 1; i < n; ++i) {
    const double factor = upper[i - 1] / diagonal[i - 1];
    diagonal[i] -= factor * upper[i - 1];
    right[i] -= factor * right[i - 1];
  }
  for (int i = n - 1; i >= 0; --i) {
    slopes[i] = (right[i] - (i + 1 < n ? upper[i] * slopes[i + 1] : 0.0)) / diagonal[i];
  }
  return slopes;
}

// r and k1 of the mean lines 210 to 250 (Report 537).
struct MeanLine {
  double r, k;
};
constexpr std::array<MeanLine, 5> kMeanLines{
    {{0.0580, 361.4}, {0.1260, 51.64}, {0.2025, 15.957}, {0.2900, 6.643}, {0.3910, 3.230}}};

[[noreturn]] void refuse(const std::string& name) {
  throw std::invalid_argument(
      "\"" + name +
      "\" is no section that is known: give four digits as 0012 or 2412, five as 23012 (210 to "
      "250), or 63-0, 64-0, 65-0 with two digits of thickness, as 63-012.");
}

}  // namespace

SectionForm::SectionForm(const std::string& name) : name_(name) {
  std::string digits = name.starts_with("NACA ") ? name.substr(5) : name;
  if (digits.size() == 6 && digits[2] == '-' && digits[3] == '0') {
    for (const Series& series : kSeries) {
      if (digits.substr(0, 2) == std::to_string(series.name)) series_ = series.name;
    }
    if (series_ == 0) refuse(name);
    digits = "00" + digits.substr(4);
    slopes_ = spline_slopes(series_of(series_));
  }
  if (!std::ranges::all_of(digits, [](unsigned char c) { return std::isdigit(c) != 0; })) {
    refuse(name);
  }
  if (digits.size() != 4 && digits.size() != 5) refuse(name);
  read(digits);
  if (!(thickness_ > 0.0)) refuse(name);
}

void SectionForm::read(const std::string& digits) {
  const auto digit = [&](std::size_t i) { return digits[i] - '0'; };
  thickness_ = 0.01 * std::stoi(digits.substr(digits.size() - 2));
  if (digits.size() == 4) {
    if (digit(0) == 0 && digit(1) == 0) return;
    if (digit(0) == 0 || digit(1) == 0) refuse(name_);
    camber_ = Camber::kFourDigits;
    camber_size_ = 0.01 * digit(0);
    camber_place_ = 0.1 * digit(1);
    return;
  }
  if (digit(0) != 2 || digit(1) < 1 || digit(1) > 5 || digit(2) != 0) refuse(name_);
  camber_ = Camber::kFiveDigits;
  camber_place_ = kMeanLines[digit(1) - 1].r;
  camber_size_ = kMeanLines[digit(1) - 1].k;
}

// y / √x of the table's thickness, and its derivative by √x.
std::array<double, 2> SectionForm::table_ratio_at(double s) const {
  const Series& series = series_of(series_);
  int i = 0;
  while (i + 2 < kStations && knot(i + 1) < s) ++i;
  const double h = knot(i + 1) - knot(i), t = (s - knot(i)) / h, q = 1.0 - t;
  const double a = table_ratio(series, i), b = table_ratio(series, i + 1);
  const double m = h * slopes_[i], n = h * slopes_[i + 1];
  return {q * q * (1.0 + 2.0 * t) * a + t * t * (1.0 + 2.0 * q) * b + t * q * (q * m - t * n),
          (6.0 * t * q * (b - a) + q * (1.0 - 3.0 * t) * m - t * (2.0 - 3.0 * t) * n) / h};
}

std::array<double, 2> SectionForm::thickness_and_slope(double s) const {
  if (series_ != 0) {
    const auto [ratio, slope] = table_ratio_at(s);
    const double factor = thickness_ / kTableThickness;
    return {factor * s * ratio, factor * (ratio + s * slope)};
  }
  const double factor = thickness_ / 0.2, x = s * s;
  return {factor * (0.2969 * s + x * (-0.1260 + x * (-0.3516 + x * (0.2843 - 0.1015 * x)))),
          factor * (0.2969 + s * (-0.2520 + x * (-1.4064 + x * (1.7058 - 0.8120 * x))))};
}

double SectionForm::half_thickness(double x) const { return thickness_and_slope(std::sqrt(x))[0]; }

double SectionForm::mean_line(double x) const {
  const double m = camber_size_, p = camber_place_;
  if (camber_ == Camber::kNone) return 0.0;
  if (camber_ == Camber::kFourDigits) {
    if (x < p) return m / (p * p) * x * (2.0 * p - x);
    return m / ((1.0 - p) * (1.0 - p)) * (1.0 - 2.0 * p + x * (2.0 * p - x));
  }
  if (x < p) return m / 6.0 * x * (x * (x - 3.0 * p) + p * p * (3.0 - p));
  return m / 6.0 * p * p * p * (1.0 - x);
}

std::array<double, 2> SectionForm::mean_slopes(double x, bool behind) const {
  const double m = camber_size_, p = camber_place_;
  if (camber_ == Camber::kNone) return {0.0, 0.0};
  if (camber_ == Camber::kFourDigits) {
    const double factor = 2.0 * m / (behind ? (1.0 - p) * (1.0 - p) : p * p);
    return {factor * (p - x), -factor};
  }
  if (behind) return {-m / 6.0 * p * p * p, 0.0};
  return {m / 6.0 * (3.0 * x * (x - 2.0 * p) + p * p * (3.0 - p)), m * (x - p)};
}

SectionForm::Point SectionForm::outline(double s, int side, double factor, bool behind) const {
  const double x = s * s;
  auto [half, rise] = thickness_and_slope(s);
  half *= side * factor;
  rise *= side * factor;
  const double past = x - camber_place_;
  auto [slope, bend] = mean_slopes(x, std::abs(past) < kMeeting ? behind : past > 0.0);
  bend *= 2.0 * s;
  const double length = std::sqrt(1.0 + slope * slope), cube = length * length * length;
  return {{x - half * slope / length, mean_line(x) + half / length},
          {2.0 * s - rise * slope / length - half * bend / cube,
           2.0 * s * slope + rise / length - half * slope * bend / cube}};
}

std::vector<double> SectionForm::knots() const {
  std::vector<double> all;
  if (series_ == 0) {
    for (int i = 0; i <= kParts; ++i) all.push_back(static_cast<double>(i) / kParts);
  } else {
    for (int i = 0; i + 1 < kStations; ++i) {
      all.push_back(knot(i));
      all.push_back(0.5 * (knot(i) + knot(i + 1)));
    }
    all.push_back(1.0);
  }
  if (camber_ == Camber::kNone) return all;
  const double meeting = std::sqrt(camber_place_);
  const auto after = std::ranges::lower_bound(all, meeting);
  // In place of the one that is nearest, lest there be a very short part.
  const auto nearest = meeting - *(after - 1) < *after - meeting ? after - 1 : after;
  *nearest = meeting;
  return all;
}

}  // namespace hull::analysis
