// SPDX-License-Identifier: GPL-3.0-or-later
#include "modelling/transformation/area_matching.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "modelling/transformation/station_spline.h"

namespace hull::modelling {
namespace {

constexpr int kStations = 41;   // at which shifts are found
constexpr int kCompared = 121;  // places at which the curves are compared
constexpr int kMostSteps = 40;
constexpr double kSlowest = 0.97;  // of the difference before: two such steps end the search
constexpr int kMostSlow = 3;
// Of the largest area: sections below it are told nothing by their own areas.
constexpr double kLittle = 0.02;

// One of the two ways. `values`: of all stations, which say how far the hull is changed there.
class Way {
 public:
  virtual ~Way() = default;
  virtual Reshaped solve(const StationSpline& change) const = 0;
  virtual const SurfacePlaces& places() const = 0;
  // What areas of the hull are multiplied by before they are compared with those wanted.
  virtual double scale() const = 0;
  virtual std::vector<double> improved(const WorkingHull& hull, const std::vector<double>& stations,
                                       const std::vector<double>& values) = 0;
};

class ShiftWay : public Way {
 public:
  ShiftWay(const WorkingHull& hull, const TargetCurve& target, const TransformLimits& limits)
      : reshape_(hull.surface(), limits), target_(target) {
    const HullRange parallel = parallel_body(hull);
    largest_ = hull.section_area(0.5 * (parallel.aft + parallel.forward));
    parallel_ = parallel;
  }

  Reshaped solve(const StationSpline& change) const override {
    return reshape_.solve([&](double x) { return change.at(x); });
  }
  const SurfacePlaces& places() const override { return reshape_.places(); }
  // The largest section is left as it is, so that parts of the largest are all that can be met.
  double scale() const override { return target_.largest() / largest_; }

  std::vector<double> improved(const WorkingHull& hull, const std::vector<double>& stations,
                               const std::vector<double>& values) override {
    std::vector<double> now(stations.size()), result(stations.size());
    // Where the stations have come to, with the areas that they have there.
    for (std::size_t i = 0; i < stations.size(); ++i) now[i] = stations[i] + values[i];
    const auto sections = hull.sections(now);
    // In a parallel part areas say nothing: it is stretched between its ends.
    const double full = (1.0 - 1e-6) * target_.largest();
    const double aft = target_.position_of(full, false), fore = target_.position_of(full, true);
    for (std::size_t i = 0; i < stations.size(); ++i) {
      const bool is_parallel = stations[i] >= parallel_.aft && stations[i] <= parallel_.forward;
      const double length = parallel_.forward - parallel_.aft;
      double wanted;
      if (is_parallel) {
        const double t = length > 0.0 ? (stations[i] - parallel_.aft) / length : 0.5;
        wanted = aft + t * (fore - aft);
      } else {
        // To where the target has the same part of its largest area, on the same side of it.
        const double share = std::min(sections[i].area / largest_, 1.0);
        wanted = target_.position_of(share * target_.largest(), stations[i] > parallel_.forward);
      }
      result[i] = values[i] + wanted - now[i];
    }
    return result;
  }

 private:
  LongitudinalReshape reshape_;
  const TargetCurve& target_;
  double largest_;
  HullRange parallel_{};
};

class InflateWay : public Way {
 public:
  InflateWay(const WorkingHull& hull, const TargetCurve& target, const TransformLimits& limits)
      : reshape_(hull.surface(), limits), target_(target) {}

  Reshaped solve(const StationSpline& change) const override {
    return reshape_.solve([&](double x) { return change.at(x); });
  }
  const SurfacePlaces& places() const override { return reshape_.places(); }
  double scale() const override { return 1.0; }

  std::vector<double> improved(const WorkingHull& hull, const std::vector<double>& stations,
                               const std::vector<double>& values) override {
    const auto sections = hull.sections(stations);
    std::vector<double> result = values;
    for (std::size_t i = 0; i < stations.size(); ++i) {
      // Newton's step: an area grows by the girth for each metre outwards.
      const double area = sections[i].area;
      if (area < kLittle * target_.largest()) continue;
      // At the narrow ends a girth says too much: no section by more than a tenth of its size.
      const double most = 0.1 * std::sqrt(area);
      result[i] += std::clamp((target_.at(stations[i]) - area) / sections[i].girth, -most, most);
    }
    return result;
  }

 private:
  NormalReshape reshape_;
  const TargetCurve& target_;
};

// In parts of the largest area wanted; rms: over all places.
struct Difference {
  double largest = 0.0, at = 0.0, rms = 0.0;
};

// `scale`: as of Way.
Difference difference(const WorkingHull& hull, double scale, const TargetCurve& target,
                      const std::vector<double>& places) {
  Difference found;
  for (const analysis::SectionArea& section : hull.sections(places)) {
    const double lack =
        std::abs(scale * section.area - target.at(section.position)) / target.largest();
    found.rms += lack * lack;
    if (lack > found.largest) {
      found.largest = lack;
      found.at = section.position;
    }
  }
  found.rms = std::sqrt(found.rms / static_cast<double>(places.size()));
  return found;
}

void refuse_parted(const WorkingHull& hull, const TargetCurve& target) {
  const auto [aft, forward] = hull.immersed_range();
  if (target.aft() < forward && target.forward() > aft) return;
  throw std::invalid_argument("The sectional area curve wanted does not lie where the hull is.");
}

}  // namespace

AreasMatched match_areas(const analysis::HullBody& body, const analysis::FloatingPosition& position,
                         const TargetCurve& target, AreaMatching how, double tolerance,
                         const TransformLimits& limits) {
  if (!(tolerance > 0.0)) throw std::invalid_argument("The tolerance must be above zero.");
  WorkingHull hull(body, position);
  refuse_parted(hull, target);
  std::unique_ptr<Way> way;
  if (how == AreaMatching::kShift) {
    way = std::make_unique<ShiftWay>(hull, target, limits);
  } else {
    way = std::make_unique<InflateWay>(hull, target, limits);
  }
  const auto [aft, forward] = hull.immersed_range();
  const double margin = AreaCurve::kInside * (forward - aft);
  const std::vector<double> stations = spread(aft + margin, forward - margin, kStations);
  // All along both: where only one of the two is it is compared with nothing.
  const std::vector<double> compared =
      spread(std::min(aft + margin, target.aft()), std::max(forward - margin, target.forward()),
             kCompared);
  std::vector<double> values(kStations, 0.0);
  AreasMatched result{};
  result.moves.assign(hull.points().size(), Vector3d::Zero());
  const Difference first = difference(hull, way->scale(), target, compared);
  result.difference_before = result.difference = first.largest;
  result.difference_at = first.at;
  // A jump of areas, as at a transom or a rudder, may be beyond what sections can follow: the
  // largest difference stands there while all others fall.
  double last = first.rms, least = first.rms;
  for (int slow = 0; result.difference > tolerance && result.iterations < kMostSteps;) {
    values = way->improved(hull, stations, values);
    const StationSpline change(stations, values);
    const Reshaped reshaped = way->solve(change);
    if (reshaped.folded_place >= 0) {
      // What was reached before the fold is still good.
      if (result.iterations > 0) break;
      throw std::invalid_argument(
          "The sectional area curve wanted is too far from what is there: the surface would fold.");
    }
    hull.move(reshaped.moves);
    ++result.iterations;
    const Difference now = difference(hull, way->scale(), target, compared);
    // Not each step is better than the one before: the best is what comes back.
    if (now.rms < least) {
      least = now.rms;
      result.difference = now.largest;
      result.difference_at = now.at;
      result.moves = reshaped.moves;
      result.rms = reshaped.rms;
      result.largest = reshaped.largest;
      result.largest_place = way->places().position(reshaped.largest_place);
    }
    slow = now.rms > kSlowest * last ? slow + 1 : 0;
    if (slow >= kMostSlow) break;
    last = now.rms;
  }
  result.converged = result.difference <= tolerance;
  hull.move(result.moves);
  const analysis::Immersion& immersion = hull.immersion();
  result.volume = immersion.volume;
  result.lcb = immersion.centre_of_buoyancy.x();
  return result;
}

}  // namespace hull::modelling
