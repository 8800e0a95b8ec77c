// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/ratio_report.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <map>

namespace hull::benchmarks {
namespace {

// Prints medians and their scatter, and keeps all times.
class Collector : public benchmark::ConsoleReporter {
 public:
  Collector() : ConsoleReporter(OO_None) {}
  void ReportRuns(const std::vector<Run>& runs) override {
    std::vector<Run> shown;
    for (const Run& run : runs) {
      const std::string name = run.run_name.str();
      // Single repetitions; medians of these are taken below. Runs that failed have no iterations.
      if (run.run_type == Run::RT_Iteration && run.iterations > 0) {
        const bool by_clock = name.find("real_time") != std::string::npos;
        const double time = by_clock ? run.GetAdjustedRealTime() : run.GetAdjustedCPUTime();
        // Adjusted times are in the benchmark's own unit.
        milliseconds_[name].push_back(1e3 * time / benchmark::GetTimeUnitMultiplier(run.time_unit));
      }
      if (run.repetitions <= 1 || run.aggregate_name == "median" || run.aggregate_name == "cv" ||
          run.aggregate_name == "BigO" || run.aggregate_name == "RMS") {
        shown.push_back(run);
      }
    }
    if (!shown.empty()) ConsoleReporter::ReportRuns(shown);
  }

  bool has(const std::string& name) const { return milliseconds_.count(name) > 0; }
  double median(const std::string& name) const {
    std::vector<double> times = milliseconds_.at(name);
    std::sort(times.begin(), times.end());
    const std::size_t half = times.size() / 2;
    return times.size() % 2 ? times[half] : 0.5 * (times[half - 1] + times[half]);
  }

 private:
  std::map<std::string, std::vector<double>> milliseconds_;
};

void print(const Comparison& c, const Collector& times) {
  const double ours = times.median(c.ours), theirs = times.median(c.theirs);
  std::printf("%-46s %9.3f ms %9.3f ms   ratio %5.2f", c.what.c_str(), ours, theirs, theirs / ours);
  if (c.least > 0.0) {
    std::printf("  (at least %.1f)%s", c.least, theirs / ours < c.least ? "  MISSED" : "");
  }
  std::printf("\n");
}

void print(const TimeLimit& limit, const Collector& times) {
  const double ours = times.median(limit.ours);
  std::printf("%-50s %9.3f ms", limit.what.c_str(), ours);
  if (limit.milliseconds > 0.0) {
    std::printf("   (at most %g ms)%s", limit.milliseconds,
                ours > limit.milliseconds ? "  MISSED" : "");
  }
  std::printf("\n");
}

}  // namespace

int run_and_compare(int argc, char** argv, const std::vector<Comparison>& comparisons,
                    const std::vector<TimeLimit>& limits) {
  // What the command line says comes later, and holds.
  std::vector<std::string> words{argv[0], "--benchmark_repetitions=5", "--benchmark_min_time=0.1",
                                 "--benchmark_enable_random_interleaving=true"};
  // Repetitions in random order: a machine that is slower for a while does not hit one side of a
  // comparison alone.
  words.insert(words.end(), argv + 1, argv + argc);
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  int count = static_cast<int>(pointers.size());
  benchmark::Initialize(&count, pointers.data());
  if (benchmark::ReportUnrecognizedArguments(count, pointers.data())) return 1;
  Collector times;
  benchmark::RunSpecifiedBenchmarks(&times);
  std::printf("\n%-46s %12s %12s\n", "Medians", "ours", "theirs");
  for (const Comparison& comparison : comparisons) {
    // Only what the command line's filter let run.
    if (times.has(comparison.ours) && times.has(comparison.theirs)) print(comparison, times);
  }
  for (const TimeLimit& limit : limits) {
    if (times.has(limit.ours)) print(limit, times);
  }
  return 0;
}

}  // namespace hull::benchmarks
