// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/fairness/curve_marks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/arithmetic/bracketed_maximum.h"
#include "analysis/arithmetic/bracketed_root.h"

namespace hull::analysis {
namespace {

// Between two breaks probes are no further apart than a part of the curve's length, as far as the
// number of them allows.
constexpr int kFewestParts = 2;
constexpr double kProbeDistance = 1.0 / 128.0;
constexpr double kShortestPart = 1e-6;  // of the curve's length
constexpr double kRootWidth = 1e-10, kExtremumWidth = 1e-6;
constexpr double kBulk = 0.95;  // of the length: what bends more is left to its own size

struct Probe {
  double s, curvature;
  bool at_break;
};

// Between two breaks.
void add_probes_between(MeasuredCurve& curve, int first, int last, std::vector<Probe>& result) {
  const double from = curve.breaks()[first], to = curve.breaks()[last];
  const double wanted = std::ceil((to - from) / (kProbeDistance * curve.length()));
  const int parts = static_cast<int>(
      std::clamp(wanted, static_cast<double>(kFewestParts), static_cast<double>(kMostProbedParts)));
  for (int part = 1; part < parts; ++part) {
    const double s = from + (to - from) * part / parts;
    const double curvature = last == first + 1 ? curve.curvature_between(first, part, parts)
                                               : curve.at(s).signed_curvature;
    result.push_back({s, curvature, false});
  }
}

std::vector<Probe> probes(MeasuredCurve& curve) {
  std::vector<Probe> result;
  const std::vector<double>& breaks = curve.breaks();
  const double shortest = kShortestPart * curve.length();
  const auto add_break = [&](int k) {
    result.push_back({breaks[k], curve.at(breaks[k]).signed_curvature, true});
  };
  add_break(0);
  int from = 0;
  // Breaks are probes themselves: curvature may have a corner there.
  for (int to = 1; to < static_cast<int>(breaks.size()); ++to) {
    if (breaks[to] - breaks[from] <= shortest) continue;
    add_probes_between(curve, from, to, result);
    add_break(to);
    from = to;
  }
  return result;
}

double threshold_of(std::vector<Probe> along, const CurvatureNoise& noise) {
  // Weights are the lengths up to the next probe.
  double total = 0.0;
  for (std::size_t i = 0; i + 1 < along.size(); ++i) {
    along[i].s = along[i + 1].s - along[i].s;
    total += along[i].s;
    along[i].curvature = std::abs(along[i].curvature);
  }
  along.pop_back();
  std::sort(along.begin(), along.end(),
            [](const Probe& a, const Probe& b) { return a.curvature < b.curvature; });
  double bulk = 0.0, sum = 0.0;
  for (const Probe& p : along) {
    bulk = p.curvature;
    sum += p.s;
    if (sum >= kBulk * total) break;
  }
  return std::max(noise.absolute, noise.relative * bulk);
}

class Marker {
 public:
  Marker(const MeasuredCurve& curve, std::vector<Probe> along, double threshold)
      : curve_(curve), along_(std::move(along)), threshold_(threshold) {
    if (curve.closed()) start_at_largest();
  }

  std::vector<CurveMark> marks() {
    find_inflections();
    find_extrema();
    std::sort(marks_.begin(), marks_.end(),
              [](const CurveMark& a, const CurveMark& b) { return a.arc_length < b.arc_length; });
    return std::move(marks_);
  }

 private:
  // A closed curve is run through from its greatest curvature on to that again, beyond its length.
  void start_at_largest() {
    along_.pop_back();
    // From there no extremum is cut in two.
    std::size_t start = 0;
    for (std::size_t i = 1; i < along_.size(); ++i) {
      if (along_[i].curvature > along_[start].curvature) start = i;
    }
    std::rotate(along_.begin(), along_.begin() + static_cast<std::ptrdiff_t>(start), along_.end());
    const double length = curve_.length(), first = along_.front().s;
    for (Probe& p : along_) p.s += p.s < first ? length : 0.0;
    along_.push_back({first + length, along_.front().curvature, along_.front().at_break});
  }

  double within(double s) const {
    if (!curve_.closed()) return std::clamp(s, 0.0, curve_.length());
    while (s > curve_.length()) s -= curve_.length();
    while (s < 0.0) s += curve_.length();
    return s;
  }
  double curvature(double s) const { return curve_.at(within(s)).signed_curvature; }

  void add(CurveMark::Kind kind, double s, double value, bool peak) {
    s = within(s);
    marks_.push_back({kind, s, curve_.at(s).point, value, peak});
  }

  void find_inflections() {
    const Probe* last = nullptr;  // that bends to a side
    for (const Probe& p : along_) {
      // However it trembles between two bends that count, there is one inflection, or none.
      if (std::abs(p.curvature) <= threshold_) continue;
      if (last && (last->curvature > 0.0) != (p.curvature > 0.0)) {
        const auto f = [&](double s) { return curvature(s); };
        const double s = bracketed_root(f, last->s, last->curvature, p.s, p.curvature,
                                        kRootWidth * curve_.length());
        add(CurveMark::Kind::kInflection, s, 0.0, false);
      }
      last = &p;
    }
  }

  void find_extrema() {
    std::size_t highest = 0, lowest = 0;
    bool may_be_highest = true, may_be_lowest = true;  // what is looked for next
    for (std::size_t i = 0; i < along_.size(); ++i) {
      const double k = along_[i].curvature;
      if (k > along_[highest].curvature) highest = i;
      if (k < along_[lowest].curvature) lowest = i;
      // A place counts once the curvature is off it by the threshold; from there on it is the other
      // kind that is looked for.
      if (may_be_highest && k < along_[highest].curvature - threshold_) {
        add_extremum(highest, 1.0);
        may_be_highest = false;
        may_be_lowest = true;
        lowest = i;
      } else if (may_be_lowest && k > along_[lowest].curvature + threshold_) {
        add_extremum(lowest, -1.0);
        may_be_lowest = false;
        may_be_highest = true;
        highest = i;
      }
    }
  }

  // The largest value of sign * curvature about a probe that is not exceeded by those beside it.
  void add_extremum(std::size_t at, double sign) {
    if (at == 0 && !curve_.closed()) return;
    const auto known = [&](std::size_t i) {
      return Maximum{along_[i].s, sign * along_[i].curvature};
    };
    Maximum before = known(at > 0 ? at - 1 : along_.size() - 2);
    if (at == 0) before.place -= curve_.length();
    const Maximum here = known(at), after = known(at + 1);
    const auto f = [&](double s) { return sign * curvature(s); };
    const double width = kExtremumWidth * curve_.length();
    const Maximum top = along_[at].at_break ? beside_break(f, before, here, after, width)
                                            : bracketed_maximum(f, before, here, after, width);
    const auto kind = sign > 0.0 ? CurveMark::Kind::kMaximum : CurveMark::Kind::kMinimum;
    add(kind, top.place, sign * top.value, top.value > 0.0);
  }

  // Curvature has a corner at a knot, as a rule, and is often greatest there: a step to each side
  // tells. Where it rises it is smooth up to the next probe.
  template <class Function>
  static Maximum beside_break(const Function& f, const Maximum& before, const Maximum& here,
                              const Maximum& after, double width) {
    Maximum top = here;
    for (const Maximum& end : {before, after}) {
      const double way = end.place - here.place;
      const double place = here.place + std::copysign(std::min(width, 0.5 * std::abs(way)), way);
      const Maximum next{place, f(place)};
      if (!(next.value > here.value)) continue;
      const bool falls = way < 0.0;
      const Maximum found =
          bracketed_maximum(f, falls ? end : here, next, falls ? here : end, width);
      if (found.value > top.value) top = found;
    }
    return top;
  }

  const MeasuredCurve& curve_;
  std::vector<Probe> along_;
  double threshold_;
  std::vector<CurveMark> marks_;
};

}  // namespace

std::vector<CurveMark> curve_marks(MeasuredCurve& curve, const CurvatureNoise& noise) {
  if (!(curve.length() > 0.0)) return {};
  std::vector<Probe> along = probes(curve);
  const double threshold = threshold_of(along, noise);
  return Marker(curve, std::move(along), threshold).marks();
}

}  // namespace hull::analysis
