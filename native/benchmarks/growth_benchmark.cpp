// SPDX-License-Identifier: GPL-3.0-or-later
// Construction from arrays, for about 10², 10³, 10⁴ and 10⁵ control faces: time and memory. Both
// are to grow with the number of faces (BigO and RMS tell), 10⁵ faces to take under 2 s and under 1
// GB.
#include <benchmark/benchmark.h>
#include <malloc.h>

#include <fstream>
#include <string>

#include "benchmarks/half_hull.h"
#include "benchmarks/ratio_report.h"
#include "surface/limit_surface.h"

namespace {

using hull::surface::LimitSurface;

double allocated_bytes() {
  const auto info = mallinfo2();
  // In the heap, and in blocks that are mapped by themselves.
  return static_cast<double>(info.uordblks + info.hblkhd);
}

// Bytes of the line `name` of /proc/self/status; "VmHWM" is the most there was since the last
// reset.
double process_bytes(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(name)) return 1024.0 * std::stod(line.substr(name.size() + 1));
  }
  return 0.0;
}

void reset_peak() { std::ofstream("/proc/self/clear_refs") << "5"; }

void BM_Construct(benchmark::State& state) {
  const hull::mesh::MeshArrays mesh = hull::benchmarks::half_hull(static_cast<int>(state.range(0)));
  const auto faces = static_cast<double>(mesh.face_sizes.size());
  const auto build = [&mesh] {
    return hull::surface::LimitSurface(hull::mesh::ControlMesh(mesh),
                                       hull::surface::Scheme::kBiermann);
  };
  for (auto _ : state) benchmark::DoNotOptimize(build());
  // Else pages that the repetitions have freed would count as there before.
  malloc_trim(0);
  reset_peak();
  const double before = allocated_bytes(), resident = process_bytes("VmRSS");
  // Alive while memory is counted.
  const hull::surface::LimitSurface kept = build();
  state.counters["faces"] = faces;
  // An inverted rate is the time of one.
  state.counters["time/face"] = benchmark::Counter(
      faces, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["kB/face"] = (allocated_bytes() - before) / faces / 1e3;
  state.counters["peak_MB"] = (process_bytes("VmHWM") - resident) / 1e6;
  state.SetComplexityN(static_cast<benchmark::IterationCount>(faces));
}

void BM_SetPoints(benchmark::State& state) {
  const hull::mesh::MeshArrays mesh = hull::benchmarks::half_hull(static_cast<int>(state.range(0)));
  hull::surface::LimitSurface surface{hull::mesh::ControlMesh(mesh)};
  for (auto _ : state) surface.set_points(mesh.points);
  const auto faces = static_cast<double>(mesh.face_sizes.size());
  state.counters["faces"] = faces;
  state.counters["time/face"] = benchmark::Counter(
      faces, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.SetComplexityN(static_cast<benchmark::IterationCount>(faces));
}

void sizes(benchmark::internal::Benchmark* b) {
  // 117 faces times the square.
  for (int refine : {1, 3, 10, 29}) b->Arg(refine);
  b->Unit(benchmark::kMillisecond)->Complexity(benchmark::oN);
}

BENCHMARK(BM_Construct)->Apply(sizes);
BENCHMARK(BM_SetPoints)->Apply(sizes);

}  // namespace

int main(int argc, char** argv) {
  return hull::benchmarks::run_and_compare(
      argc, argv, {}, {{"construction, 10^5 faces", "BM_Construct/29", 2000.0}});
}
