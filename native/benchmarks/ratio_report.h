// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace hull::benchmarks {

// Two benchmarks of one run set against each other. The ratio is the median time of `theirs` by
// that of `ours`. Times are those of the processor, or of the clock where the benchmark's name says
// real_time.
struct Comparison {
  std::string what;
  std::string ours, theirs;  // names of benchmarks
  double least = 0.0;        // what the ratio is to reach; 0: nothing in particular
};

// A benchmark whose median time is told, and may have a limit to stay below.
struct TimeLimit {
  std::string what;
  std::string ours;
  double milliseconds = 0.0;  // 0: no limit
};

// Runs Google Benchmark with the program's arguments, by default with five repetitions in random
// order, and prints, after its own table, each comparison of which both sides were run:
//   grid, positions    ours 783 us    Bfr 8463 us    ratio 10.8 (at least 8)
// Returns the program's exit status: 0, whatever the ratios are.
int run_and_compare(int argc, char** argv, const std::vector<Comparison>& comparisons,
                    const std::vector<TimeLimit>& limits);

}  // namespace hull::benchmarks
