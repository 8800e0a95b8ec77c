// SPDX-License-Identifier: GPL-3.0-or-later
// A half hull of 140 points as patches at the default tolerance, and as STEP and IGES files of half
// and whole, open and closed, read back and compared. One thread.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "benchmarks/half_hull.h"
#include "benchmarks/ratio_report.h"
#include "conversion/exact/exact_conversion.h"
#include "exchange/iges_file.h"
#include "exchange/step/step_file.h"

namespace {

const hull::surface::LimitSurface& surface() {
  static const hull::surface::LimitSurface built{
      hull::mesh::ControlMesh(hull::benchmarks::half_hull())};
  return built;
}

const hull::conversion::PatchSet& patches() {
  static const hull::conversion::PatchSet made = hull::conversion::exact_patches(surface());
  return made;
}

// A file that is gone at the end.
class ScratchFile {
 public:
  ScratchFile()
      : path_((std::filesystem::temp_directory_path() /
               ("hull_exchange_benchmark_" + std::to_string(getpid())))
                  .string()) {}
  ~ScratchFile() { unlink(path_.c_str()); }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

void BM_ExactPatches(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(hull::conversion::exact_patches(surface()));
}

template <class Write>
void write(benchmark::State& state, const Write& write_file, bool mirrored, bool solid) {
  const ScratchFile file;
  hull::exchange::CadOptions options;
  options.mirrored = mirrored;
  options.solid = solid;
  // Made before the clock runs.
  patches();
  hull::exchange::CadReport report;
  // Each time over the file of before, as the writers replace what is there; it is read back as
  // part of it.
  for (auto _ : state) report = write_file(patches(), file.path(), options);
  state.counters["faces"] = report.faces;
  state.counters["MB"] = static_cast<double>(report.bytes) / 1e6;
}

void BM_StepOfHalf(benchmark::State& state) {
  write(state, hull::exchange::write_step, false, false);
}
void BM_StepOfWhole(benchmark::State& state) {
  write(state, hull::exchange::write_step, true, false);
}
void BM_StepOfSolid(benchmark::State& state) {
  write(state, hull::exchange::write_step, true, true);
}
void BM_IgesOfHalf(benchmark::State& state) {
  write(state, hull::exchange::write_iges, false, false);
}
void BM_IgesOfSolid(benchmark::State& state) {
  write(state, hull::exchange::write_iges, true, true);
}

BENCHMARK(BM_ExactPatches)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_StepOfHalf)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_StepOfWhole)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_StepOfSolid)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_IgesOfHalf)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_IgesOfSolid)->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
  return hull::benchmarks::run_and_compare(
      argc, argv, {{"a STEP file, against an IGES file", "BM_StepOfHalf", "BM_IgesOfHalf"}},
      {{"a half hull of 140 points as patches", "BM_ExactPatches", 50.0},
       {"a half hull of 140 points as a STEP file", "BM_StepOfHalf", 1500.0},
       {"both sides as a STEP file", "BM_StepOfWhole", 1500.0},
       {"both sides as a solid in a STEP file", "BM_StepOfSolid", 1500.0}});
}
