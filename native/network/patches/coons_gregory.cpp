// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/patches/coons_gregory.h"

#include <array>

#include "network/patches/dual.h"

namespace hull::network {
namespace {

// Hermite's cubics: of values at 0 and 1, and of slopes there.
std::array<Dual, 4> hermite(const Dual& t) {
  const double u = t.value, w = 1.0 - u;
  const auto of = [&](double value, double slope) { return Dual{value, slope * t.by}; };
  return {of(w * w * (1.0 + 2.0 * u), -6.0 * u * w), of(u * u * (3.0 - 2.0 * u), 6.0 * u * w),
          of(u * w * w, w * (1.0 - 3.0 * u)), of(-u * u * w, u * (3.0 * u - 2.0))};
}

// A side and the derivative across it, both in the sense of the square's coordinates.
struct Border {
  DualPlace place, across;
  SideJet at_low, at_high;  // where the coordinate along it is 0 and 1
};

// `turned`: the side runs against its coordinate; `inwards`: whether the coordinate across rises
// into the patch.
Border border_of(const RibbonedSide& side, const Dual& t, bool is_turned, bool is_inwards) {
  const double along_sense = is_turned ? -1.0 : 1.0, across_sense = is_inwards ? 1.0 : -1.0;
  const auto jet_at = [&](double u) {
    SideJet jet = side(is_turned ? 1.0 - u : u);
    jet.slope *= along_sense;
    jet.ribbon *= across_sense;
    // The mixed derivative turns with both.
    jet.ribbon_slope *= along_sense * across_sense;
    return jet;
  };
  const SideJet jet = jet_at(t.value);
  return {along(jet.point, jet.slope, t), along(jet.ribbon, jet.ribbon_slope, t), jet_at(0.0),
          jet_at(1.0)};
}

// Where u is at its end, the ribbon of the side along u is in the way of that of the side along v:
// the twist is its. Where v is, the other way round; between them by the distances from both.
DualPlace twist(const Vector3d& along_u, const Vector3d& along_v, const Dual& from_u_end,
                const Dual& from_v_end) {
  const Dual sum = from_u_end + from_v_end;
  if (!(sum.value > 0.0)) return fixed(0.5 * (along_u + along_v));
  const Dual share = from_v_end / sum;
  return share * fixed(along_u) + (1.0 - share) * fixed(along_v);
}

}  // namespace

PatchPoint coons_gregory(const std::vector<RibbonedSide>& sides, const Vector2d& place) {
  const Dual u{place[0], {1.0, 0.0}}, v{place[1], {0.0, 1.0}};
  const std::array<Border, 2> along_u{border_of(sides[0], u, false, true),
                                      border_of(sides[2], u, true, false)};
  const std::array<Border, 2> along_v{border_of(sides[3], v, true, true),
                                      border_of(sides[1], v, false, false)};
  const auto hu = hermite(u), hv = hermite(v);
  const std::array<Dual, 2> from_u{u, 1.0 - u}, from_v{v, 1.0 - v};
  // A Boolean sum: the surface between two sides, that between the others, less what both have in
  // common, the corners with their slopes and twists.
  DualPlace sum;
  for (std::size_t i : {0u, 1u}) {
    sum = sum + hu[i] * along_v[i].place + hu[i + 2] * along_v[i].across;
    sum = sum + hv[i] * along_u[i].place + hv[i + 2] * along_u[i].across;
  }
  for (std::size_t i : {0u, 1u}) {
    for (std::size_t k : {0u, 1u}) {
      // At the corner i of u and k of v: the ribbon of the side along u is the slope along v, and
      // the other way round.
      const SideJet& at_u = i == 0 ? along_u[k].at_low : along_u[k].at_high;
      const SideJet& at_v = k == 0 ? along_v[i].at_low : along_v[i].at_high;
      sum = sum - hu[i] * hv[k] * fixed(at_u.point);
      sum = sum - hu[i] * hv[k + 2] * fixed(at_u.ribbon);
      sum = sum - hu[i + 2] * hv[k] * fixed(at_v.ribbon);
      sum = sum - hu[i + 2] * hv[k + 2] *
                      twist(at_u.ribbon_slope, at_v.ribbon_slope, from_u[i], from_v[k]);
    }
  }
  return {sum.value, sum.by.col(0), sum.by.col(1)};
}

}  // namespace hull::network
