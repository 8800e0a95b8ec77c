// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/fairness/colour_maps.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace hull::analysis {
namespace {

// The ends, which differ in hue and also in how the colour blind see them (the blue and vermilion
// of Okabe and Ito 2008, darkened a little).
constexpr Colour kLow{0.02, 0.30, 0.62};
constexpr Colour kHigh{0.78, 0.33, 0.02};
constexpr double kMiddleLength = 96.0;  // of CIELAB: nearly white

constexpr double kWhite[] = {0.95047, 1.0, 1.08883};  // D65

double linear(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }
double gamma(double c) {
  c = std::clamp(c, 0.0, 1.0);
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
}

// CIE's constants as fractions, so that both branches meet.
constexpr double kCubeRootFrom = 216.0 / 24389.0, kSlope = 24389.0 / 27.0;
double lab_root(double t) { return t > kCubeRootFrom ? std::cbrt(t) : (kSlope * t + 16.0) / 116.0; }
double lab_cube(double f) {
  return f * f * f > kCubeRootFrom ? f * f * f : (116.0 * f - 16.0) / kSlope;
}

// Length, angle from the axis of lightness, and hue of a colour as a vector of CIELAB.
struct Polar {
  double length, saturation, hue;
};

Polar polar(const Colour& colour) {
  const double r = linear(colour[0]), g = linear(colour[1]), b = linear(colour[2]);
  const double x = lab_root((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / kWhite[0]);
  const double y = lab_root((0.2126729 * r + 0.7151522 * g + 0.0721750 * b) / kWhite[1]);
  const double z = lab_root((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / kWhite[2]);
  const double lightness = 116.0 * y - 16.0, a = 500.0 * (x - y), c = 200.0 * (y - z);
  const double length = std::sqrt(lightness * lightness + a * a + c * c);
  return {length, std::acos(lightness / length), std::atan2(c, a)};
}

Colour srgb(const Polar& p) {
  const double lightness = p.length * std::cos(p.saturation);
  const double a = p.length * std::sin(p.saturation) * std::cos(p.hue);
  const double c = p.length * std::sin(p.saturation) * std::sin(p.hue);
  const double fy = (lightness + 16.0) / 116.0;
  const double x = kWhite[0] * lab_cube(fy + a / 500.0), y = kWhite[1] * lab_cube(fy);
  const double z = kWhite[2] * lab_cube(fy - c / 200.0);
  return {gamma(3.2404542 * x - 1.5371385 * y - 0.4985314 * z),
          gamma(-0.9692660 * x + 1.8760108 * y + 0.0415560 * z),
          gamma(0.0556434 * x - 0.2040259 * y + 1.0572252 * z)};
}

// Half of the map: from white (0) to an end (1).
Colour towards(const Polar& end, double t) {
  return srgb({kMiddleLength + t * (end.length - kMiddleLength), t * end.saturation, end.hue});
}

constexpr int kTableParts = 512;
Colour from_table(const std::vector<Colour>& table, double t) {
  const double at = std::clamp(t, 0.0, 1.0) * kTableParts;
  const int i = std::min(static_cast<int>(at), kTableParts - 1);
  Colour colour;
  for (int k = 0; k < 3; ++k) colour[k] = table[i][k] + (at - i) * (table[i + 1][k] - table[i][k]);
  return colour;
}

template <class Map>
std::vector<Colour> table_of(const Map& map) {
  std::vector<Colour> table;
  for (int i = 0; i <= kTableParts; ++i) table.push_back(map(static_cast<double>(i) / kTableParts));
  return table;
}

Colour helix(double t) {
  // Start, rotations, hue of Green's paper; from 0.1 to 0.95 of the way from black to white.
  constexpr double kStart = 0.5, kRotations = -1.2, kHue = 1.1;
  const double shade = 0.1 + 0.85 * t;
  const double angle = 2.0 * std::numbers::pi * (kStart / 3.0 + 1.0 + kRotations * shade);
  const double width = 0.5 * kHue * shade * (1.0 - shade);
  const double c = std::cos(angle), s = std::sin(angle);
  const auto part = [&](double of_c, double of_s) {
    return std::clamp(shade + width * (of_c * c + of_s * s), 0.0, 1.0);
  };
  // Green's directions across the axis of greys, along which perceived lightness stays.
  return {part(-0.14861, 1.78277), part(-0.29227, -0.90649), part(1.97294, 0.0)};
}

}  // namespace

Colour diverging_colour(double t) {
  static const std::vector<Colour> table = [] {
    const Polar low = polar(kLow), high = polar(kHigh);
    return table_of([&](double at) {
      return at < 0.5 ? towards(low, 1.0 - 2.0 * at) : towards(high, 2.0 * at - 1.0);
    });
  }();
  return from_table(table, t);
}

Colour sequential_colour(double t) {
  static const std::vector<Colour> table = table_of(helix);
  return from_table(table, t);
}

}  // namespace hull::analysis
