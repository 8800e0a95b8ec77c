// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stability/stability_criteria.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>

#include "analysis/stability/weathertight.h"

namespace hull::analysis {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double k25 = 25.0 * kDegree, k30 = 30.0 * kDegree, k40 = 40.0 * kDegree;
constexpr double kLastHeel = 90.0 * kDegree;
constexpr double kStep = 5.0 * kDegree;  // between the heels at which features are looked for
constexpr double kAreaTolerance = 1e-8;  // m·rad

std::string in_degrees(double angle) {
  std::ostringstream words;
  words << std::fixed << std::setprecision(1) << angle / kDegree << "°";
  return words.str();
}

class IntactCriteria {
 public:
  IntactCriteria(const HeelingPath& path, const HullBody& body, const StabilityEdges& edges)
      : path_(path), reached_(solve_along(path)) {
    if (reached_ > 0.0) flooding_ = flooding_heel(path, body, edges, reached_);
    end_ = flooding_.value_or(reached_);
    if (!can_flood(body, edges)) unflooded_ = "No opening is given that floods the ship.";
  }

  StabilityReport report() {
    const double to_40 = std::min(k40, flooding_.value_or(k40));
    area("Area under the GZ curve up to 30°", 0.0, k30, 0.055);
    area("Area under the GZ curve up to " + up_to_40(), 0.0, to_40, 0.09);
    area("Area under the GZ curve from 30° to " + up_to_40(), k30, to_40, 0.03);
    lever_beyond_30();
    heel_of_greatest();
    initial_gm();
    report_.flooding_heel = flooding_;
    report_.passes =
        std::all_of(report_.criteria.begin(), report_.criteria.end(),
                    [](const Criterion& c) { return c.outcome == CriterionOutcome::kPass; });
    report_.evaluations = path_.evaluations();
    return std::move(report_);
  }

 private:
  // Solves the curve as far as the ship does not stand on end; the last heel solved.
  double solve_along(const HeelingPath& path) {
    path.at(0.0);
    double heel = 0.0;
    for (int i = 1; i * kStep <= kLastHeel * (1.0 + 1e-12); ++i) {
      if (!path.find(i * kStep)) {
        why_not_ = "There is no righting lever at " + in_degrees(i * kStep) +
                   ": the ship stands on end, or does not settle.";
        break;
      }
      heel = i * kStep;
    }
    return heel;
  }

  std::string up_to_40() const {
    return flooding_ && *flooding_ < k40 ? "flooding at " + in_degrees(*flooding_) : "40°";
  }

  void judge(Criterion c) {
    if (c.value) {
      const bool met = *c.value >= c.limit && c.outcome != CriterionOutcome::kFail;
      c.outcome = met ? CriterionOutcome::kPass : CriterionOutcome::kFail;
    }
    report_.criteria.push_back(std::move(c));
  }

  // Says so if the curve does not reach a heel; true if nothing can be computed.
  bool ends_before(double heel, Criterion& c) const {
    if (end_ >= heel) return false;
    if (flooding_) {
      c.outcome = CriterionOutcome::kFail;
      c.note =
          "The ship floods at " + in_degrees(*flooding_) + ", before " + in_degrees(heel) + ".";
    } else {
      c.note = why_not_;
    }
    return true;
  }

  void area(const std::string& name, double from, double to, double limit) {
    Criterion c{"2.2.1", name, {}, limit, "m·rad", CriterionOutcome::kNotComputed, unflooded_};
    const double needed = from > 0.0 ? std::max(from, to) : to;
    if (!ends_before(needed, c)) {
      c.value = lever_area(path_, from, to, kAreaTolerance);
    } else if (flooding_ && from == 0.0) {
      c.value = lever_area(path_, 0.0, end_, kAreaTolerance);
    }
    judge(std::move(c));
  }

  void lever_beyond_30() {
    Criterion c{"2.2.2", "Greatest GZ at 30° or more",   {},        0.2,
                "m",     CriterionOutcome::kNotComputed, unflooded_};
    if (!ends_before(k30, c)) c.value = greatest_lever(path_, k30, end_).lever;
    judge(std::move(c));
  }

  void heel_of_greatest() {
    Criterion c{"2.2.3", "Heel of the greatest GZ",      {},        k25,
                "rad",   CriterionOutcome::kNotComputed, unflooded_};
    if (end_ > 0.0) {
      c.value = greatest_lever(path_, 0.0, end_).heel;
    } else {
      ends_before(k25, c);
    }
    if (c.value && *c.value < k25) {
      c.note = "Where this is not practicable the Administration may approve alternative criteria.";
    }
    judge(std::move(c));
  }

  void initial_gm() {
    judge({"2.2.4", "Initial metacentric height GM", path_.at(0.0).slope, 0.15, "m",
           CriterionOutcome::kNotComputed, ""});
  }

  const HeelingPath& path_;
  std::string why_not_;  // why the curve ends, unless by flooding or at 90°
  double reached_;
  std::optional<double> flooding_;
  double end_ = 0.0;
  std::string unflooded_;
  StabilityReport report_;
};

}  // namespace

StabilityReport stability_criteria(const HullBody& body, const LoadCase& load,
                                   const StabilityOptions& options) {
  const Weathertight closed(body);
  const HeelingPath path = heeling_path(closed.body(), load, options.trim_mode, options.trim);
  return IntactCriteria(path, body, options.edges).report();
}

}  // namespace hull::analysis
