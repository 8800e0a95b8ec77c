// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/stability_criteria.h"

#include <algorithm>
#include <numbers>
#include <string>

#include "analysis/arithmetic/degree.h"
#include "analysis/stability/weathertight.h"

namespace hull::analysis {
namespace {

constexpr double k25 = 25.0 * kDegree, k30 = 30.0 * kDegree, k40 = 40.0 * kDegree;

class IntactCriteria {
 public:
  IntactCriteria(HeelingPath& path, const HullBody& body, const StabilityEdges& edges)
      : path_(path),
        curve_(criteria_curve(path, body, edges)),
        downflooding_(curve_.downflooding_heel),
        deck_edge_(deck_edge_of(body, edges)) {
    if (!curve_.can_flood) unflooded_ = "No downflooding point is given: no heel floods the ship.";
  }

  StabilityReport report() {
    // 40°, or the downflooding angle if that is less (2.2.1).
    const double to_40 = std::min(k40, downflooding_.value_or(k40));
    area("Area under the GZ curve up to 30°", 0.0, k30, 0.055);
    area("Area under the GZ curve up to " + up_to_40(), 0.0, to_40, 0.09);
    area("Area under the GZ curve from 30° to " + up_to_40(), k30, to_40, 0.03);
    lever_beyond_30();
    heel_of_greatest();
    initial_gm();
    report_.downflooding_heel = downflooding_;
    report_.can_flood = curve_.can_flood;
    report_.has_deck_edge = !deck_edge_.empty();
    // Told along with them; no criterion of 2.2 asks for it.
    report_.deck_edge_heel = deck_edge_heel(path_, deck_edge_, curve_.heels);
    report_.passes = all_pass(report_.criteria);
    report_.evaluations = path_.evaluations();
    return std::move(report_);
  }

 private:
  std::string up_to_40() const {
    return downflooding_ && *downflooding_ < k40 ? "flooding at " + in_degrees(*downflooding_)
                                                 : "40°";
  }

  void add(Criterion c) { report_.criteria.push_back(judged(std::move(c))); }

  GreatestLever greatest(double from) {
    return greatest_lever(path_, heels_between(curve_.heels, from, curve_.end()));
  }

  // Says so if the curve does not reach a heel; true if nothing can be computed.
  bool ends_before(double heel, Criterion& c) const {
    if (curve_.end() >= heel) return false;
    if (downflooding_) {
      c.outcome = CriterionOutcome::kFail;
      c.note =
          "The ship floods at " + in_degrees(*downflooding_) + ", before " + in_degrees(heel) + ".";
    } else {
      c.note = curve_.why_it_ends;
    }
    return true;
  }

  Criterion criterion(const char* paragraph, const std::string& name, double limit,
                      const char* unit) const {
    Criterion c;
    c.paragraph = paragraph;
    c.name = name;
    c.limit = limit;
    c.unit = unit;
    c.note = unflooded_;
    return c;
  }

  void area(const std::string& name, double from, double to, double limit) {
    Criterion c = criterion("2.2.1", name, limit, "m·rad");
    // `to` may be a downflooding heel before `from`.
    const double needed = from > 0.0 ? std::max(from, to) : to;
    if (!ends_before(needed, c)) {
      c.value = lever_area(path_, from, to, kCriteriaAreaTolerance);
    } else if (downflooding_ && from == 0.0) {
      // Failed, but what area there is up to flooding is told.
      c.value = lever_area(path_, 0.0, curve_.end(), kCriteriaAreaTolerance);
    }
    add(std::move(c));
  }

  void lever_beyond_30() {
    Criterion c = criterion("2.2.2", "Greatest GZ at 30° or more", 0.2, "m");
    // The top of the curve may lie before 30°: then the lever there is the greatest beyond.
    if (!ends_before(k30, c)) c.value = greatest(k30).lever;
    add(std::move(c));
  }

  void heel_of_greatest() {
    Criterion c = criterion("2.2.3", "Heel of the greatest GZ", k25, "rad");
    // Of a curve that ends early its greatest lever is judged all the same.
    if (curve_.end() > 0.0) {
      c.value = greatest(0.0).heel;
    } else {
      ends_before(k25, c);
    }
    // Not met all the same: whether it is practicable is not for the program to say.
    if (c.value && *c.value < k25) {
      c.note = "Where this is not practicable the Administration may approve alternative criteria.";
    }
    add(std::move(c));
  }

  void initial_gm() {
    Criterion c = criterion("2.2.4", "Initial metacentric height GM", 0.15, "m");
    c.value = path_.at(0.0).slope;
    c.note.clear();  // floods or not
    add(std::move(c));
  }

  HeelingPath& path_;
  const CriteriaCurve curve_;
  const std::optional<double>& downflooding_;
  const DeckEdge deck_edge_;
  std::string unflooded_;
  StabilityReport report_;
};

}  // namespace

StabilityReport stability_criteria(const HullBody& body, const LoadCase& load,
                                   const StabilityOptions& options) {
  const Weathertight closed(body);
  HeelingPath path = heeling_path(closed.body(), load, options.trim_mode, options.trim);
  return IntactCriteria(path, body, options.edges).report();
}

}  // namespace hull::analysis
