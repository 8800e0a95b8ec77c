// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/weather_criterion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "analysis/arithmetic/degree.h"
#include "analysis/hydrostatics/hydrostatics.h"
#include "analysis/stability/weathertight.h"
#include "analysis/stations/lateral_profile.h"

namespace hull::analysis {
namespace {

constexpr double kCodeGravity = 9.81;  // m/s², the code's
constexpr double kGust = 1.5;
constexpr double kSteepestHeel = 16.0 * kDegree, kOfDeckEdge = 0.8;
constexpr double kLastHeelOfWind = 50.0 * kDegree;
constexpr double kStepOfWind = 5.0 * kDegree;

void check(const WeatherOptions& options) {
  const auto refuse = [](const char* what) { throw std::invalid_argument(what); };
  for (const WindArea& part : options.wind_areas) {
    if (!(part.area >= 0.0) || !std::isfinite(part.area) || !std::isfinite(part.z)) {
      refuse("A wind area must be a number of m² that is not negative, at a finite height.");
    }
  }
  if (options.wind_lever && !(*options.wind_lever > 0.0 && std::isfinite(*options.wind_lever))) {
    refuse("The lever of the wind area must be a positive number of metres.");
  }
  if (!(options.wind_pressure > 0.0) || !std::isfinite(options.wind_pressure)) {
    refuse("The wind's pressure must be a positive number of pascals.");
  }
  if (!(options.beam >= 0.0) || !std::isfinite(options.beam) || !std::isfinite(options.midship)) {
    refuse("Beam and place of the mean draft must be finite numbers, the beam not negative.");
  }
}

class Weather {
 public:
  Weather(HeelingPath& path, const HullBody& closed, const HullBody& body, const LoadCase& load,
          const WeatherOptions& options)
      : path_(path),
        options_(options),
        closed_(closed),
        load_(load),
        curve_(criteria_curve(path, body, options.stability.edges)),
        deck_edge_(deck_edge_of(body, options.stability.edges)) {
    result_.downflooding_heel = curve_.downflooding_heel;
    result_.deck_edge_heel = deck_edge_heel(path, deck_edge_, curve_.heels);
  }

  WeatherCriterion evaluate() {
    take_wind();
    take_roll();
    result_.steady_heel = heel_under(result_.steady_lever);
    if (result_.steady_heel) lean_to_leeward();
    judge_steady_heel();
    judge_areas();
    result_.passes = all_pass(result_.criteria);
    result_.evaluations = path_.evaluations();
    return std::move(result_);
  }

 private:
  void take_wind() {
    const LateralProfile profile = lateral_profile(closed_, upright().immersion.water);
    double area = 0.0, moment = 0.0;
    const auto add = [&](double part, double z) {
      area += part;
      moment += part * z;
    };
    if (options_.hull_profile) add(profile.above.area, profile.above.centre.z());
    for (const WindArea& part : options_.wind_areas) add(part.area, part.z);
    if (!(area > 0.0)) {
      throw std::invalid_argument(
          "The ship has no wind area: count the hull's profile, or give areas above the water.");
    }
    result_.wind_area = area;
    result_.wind_lever = options_.wind_lever.value_or(moment / area - profile.below.centre.z());
    if (!(result_.wind_lever > 0.0)) {
      std::ostringstream words;
      words << "The wind area's centre is " << -result_.wind_lever
            << " m below that of the underwater profile: give its height above the base line.";
      throw std::invalid_argument(words.str());
    }
    // Over 1000, as the pressure is in Pa and the mass in t.
    result_.steady_lever =
        options_.wind_pressure * area * result_.wind_lever / (1000.0 * kCodeGravity * load_.mass_t);
    result_.gust_lever = kGust * result_.steady_lever;
  }

  void take_roll() {
    const HeeledState& state = upright();
    const double draft = draft_in(state.immersion.water, options_.midship);
    // For the waterline's length and breadth; upright, at the trim of the load.
    const Hydrostatics p =
        hydrostatics(closed_, {draft, state.trim, 0.0, options_.midship}, {}, load_.water_density);
    result_.draft = draft;
    result_.beam = options_.beam > 0.0 ? options_.beam : p.waterline_beam;
    result_.waterline_length = p.waterline_length;
    result_.block_coefficient = path_.volume() / (result_.waterline_length * result_.beam * draft);
    RollingShip ship;
    ship.waterline_length = result_.waterline_length;
    ship.beam = result_.beam;
    ship.draft = draft;
    ship.block_coefficient = result_.block_coefficient;
    ship.kg = load_.centre_of_gravity.z();
    ship.gm = state.slope;
    ship.keel_area = options_.keel_area;
    ship.sharp_bilges = options_.sharp_bilges;
    ship.period = options_.roll_period;
    // A ship that does not stand upright has no period: that is no wrong input but a criterion
    // that is not met.
    if (!ship.period && !(ship.gm > 0.0)) {
      why_no_roll_ = "GM is not positive: the ship has no period of roll.";
      return;
    }
    result_.roll = angle_of_roll(ship);
  }

  const HeeledState& upright() { return path_.at(0.0); }

  std::vector<double> heels_to_end(double from) const {
    return heels_between(curve_.heels, from, curve_.heels.back());
  }

  // Of stable equilibrium under a heeling lever, nearest to upright.
  std::optional<double> heel_under(double lever) {
    if (upright().righting_lever < lever) return lever_rises_to(path_, curve_.heels, lever);
    // With a list to windward she is upright again only under more wind: back to where the lever
    // falls short.
    for (double heel = -kStepOfWind; heel > -kLastHeelOfWind; heel -= kStepOfWind) {
      const HeeledState* state = path_.find(heel);
      if (!state) return std::nullopt;
      if (state->righting_lever < lever) {
        return lever_rises_to(path_, {heel, heel + kStepOfWind}, lever);
      }
    }
    return std::nullopt;
  }

  // From the steady heel over the gust's intercepts to where the curve ends.
  void lean_to_leeward() {
    const double lever = result_.gust_lever;
    const std::vector<double> heels = heels_to_end(*result_.steady_heel);
    const GreatestLever top = greatest_lever(path_, heels);
    // Else GZ, less at the steady heel, comes up to it before the top, and may fall to it beyond.
    if (!(top.lever > lever)) return;
    // With the top among the heels the two intercepts are not missed where both are within a step.
    result_.gust_heel = lever_rises_to(path_, with(heels, top.heel), lever);
    if (!result_.gust_heel) return;
    std::vector<double> beyond = heels_to_end(*result_.gust_heel);
    if (top.heel > *result_.gust_heel) beyond = with(beyond, top.heel);
    // At the intercept itself rounding decides which lever is greater.
    beyond.erase(beyond.begin());
    result_.second_intercept = lever_falls_to(path_, beyond, lever);
    double last = std::min(kLastHeelOfWind, curve_.end());
    if (result_.second_intercept) last = std::min(last, *result_.second_intercept);
    result_.last_heel = last;
  }

  static std::vector<double> with(const std::vector<double>& heels, double heel) {
    std::vector<double> all = heels;
    all.push_back(heel);
    return heels_between(all, heels.front(), heels.back());
  }

  void judge_steady_heel() {
    Criterion c;
    c.paragraph = "2.3.1.2";
    c.name = "Heel under the steady wind, φ0";
    c.unit = "rad";
    c.bound = Criterion::Bound::kAtMost;
    c.limit = kSteepestHeel;
    c.value = result_.steady_heel;
    if (result_.deck_edge_heel) c.limit = std::min(c.limit, kOfDeckEdge * *result_.deck_edge_heel);
    if (!c.value) {
      c.outcome = CriterionOutcome::kFail;
      c.note =
          upright().righting_lever < result_.steady_lever
              ? "The steady wind's lever is above the whole curve of GZ."
              : "GZ is above the steady wind's lever upright, and to windward as far as 50° or "
                "where she stands on end: her list to windward is too large.";
    } else if (deck_edge_.empty()) {
      c.note = "No deck edge is known: only 16° is asked for.";
    } else if (result_.deck_edge_heel == 0.0) {
      c.note = "The deck edge is under water upright: mark the one that is meant.";
    }
    result_.criteria.push_back(judged(std::move(c)));
  }

  void judge_areas() {
    Criterion c;
    c.paragraph = "2.3.1.4";
    c.name = "Area b, of GZ above the gust's lever, against area a";
    c.unit = "m·rad";
    // In the order in which one needs the other: the first that is missing is told.
    if (!result_.steady_heel) {
      c.outcome = CriterionOutcome::kFail;
      c.note = "There is no heel under the steady wind to roll from.";
    } else if (!result_.roll) {
      c.outcome = CriterionOutcome::kFail;
      c.note = why_no_roll_;
    } else if (!result_.gust_heel) {
      c.outcome = CriterionOutcome::kFail;
      c.note = "The gust's lever is above the whole curve of GZ.";
    } else {
      compare_areas(c);
    }
    result_.criteria.push_back(judged(std::move(c)));
  }

  void compare_areas(Criterion& c) {
    const double first = *result_.gust_heel, lever = result_.gust_lever;
    const double windward = *result_.steady_heel - result_.roll->angle;
    result_.windward_heel = windward;
    // Between the gust's lever and GZ: where GZ is negative, to windward, it adds to what she
    // gains.
    result_.area_a =
        lever * (first - windward) - lever_area(path_, windward, first, kCriteriaAreaTolerance);
    result_.area_b = 0.0;
    // If she floods before the gust's lever is met there is no area b.
    if (*result_.last_heel > first) {
      result_.area_b = lever_area(path_, first, *result_.last_heel, kCriteriaAreaTolerance) -
                       lever * (*result_.last_heel - first);
    }
    c.value = result_.area_b;
    c.limit = *result_.area_a;
    c.note = why_it_ends() + (result_.roll->out_of_range.empty() ? "" : " ") +
             result_.roll->out_of_range;
  }

  std::string why_it_ends() const {
    const double last = *result_.last_heel;
    std::string words = "Area b ends at " + in_degrees(last);
    // Compared exactly: `last` is one of these numbers.
    if (result_.second_intercept == last) {
      words += ", where GZ falls below the gust's lever.";
    } else if (last == kLastHeelOfWind) {
      words += ".";
    } else if (result_.downflooding_heel == last) {
      words += ", where the ship floods.";
    } else {
      words += ". " + curve_.why_it_ends;
    }
    if (!curve_.can_flood) words += " No downflooding point is given: no heel floods the ship.";
    return words;
  }

  HeelingPath& path_;
  const WeatherOptions& options_;
  const HullBody& closed_;
  const LoadCase& load_;
  const CriteriaCurve curve_;
  const DeckEdge deck_edge_;
  std::string why_no_roll_;
  WeatherCriterion result_;
};

}  // namespace

WeatherCriterion weather_criterion(const HullBody& body, const LoadCase& load,
                                   const WeatherOptions& options) {
  check(options);
  const Weathertight closed(body);
  HeelingPath path =
      heeling_path(closed.body(), load, options.stability.trim_mode, options.stability.trim);
  return Weather(path, closed.body(), body, load, options).evaluate();
}

}  // namespace hull::analysis
