// SPDX-License-Identifier: GPL-3.0-or-later
// The exact surface beside OpenSubdiv's Bfr::Surface<double> (ten levels at irregular points, where
// it is an approximation all the same) on the same mesh. One thread. Times are per iteration;
// the counter "points" is in points a second.
#include <benchmark/benchmark.h>
#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <memory>
#include <random>

#include "benchmarks/half_hull.h"
#include "surface/grid_samples.h"

namespace {

namespace bfr = OpenSubdiv::OPENSUBDIV_VERSION::Bfr;
namespace far = OpenSubdiv::OPENSUBDIV_VERSION::Far;
using hull::LimitSurface;
using hull::Vector3d;

hull::ControlMesh control_mesh(int refine = 1) {
  return hull::ControlMesh(hull::benchmarks::half_hull(refine));
}

// OpenSubdiv's surface of the same mesh with the same creases.
class BfrSurfaces {
 public:
  explicit BfrSurfaces(const hull::MeshArrays& mesh) : mesh_(mesh) {
    far::TopologyDescriptor descriptor;
    descriptor.numVertices = static_cast<int>(mesh.points.size());
    descriptor.numFaces = static_cast<int>(mesh.face_sizes.size());
    descriptor.numVertsPerFace = mesh.face_sizes.data();
    descriptor.vertIndicesPerFace = mesh.face_vertices.data();
    const std::vector<float> weights(mesh.creases.size(), 10.0f);
    descriptor.numCreases = static_cast<int>(mesh.creases.size());
    descriptor.creaseVertexIndexPairs = mesh.creases.empty() ? nullptr : mesh.creases[0].data();
    descriptor.creaseWeights = weights.data();
    OpenSubdiv::Sdc::Options options;
    options.SetVtxBoundaryInterpolation(OpenSubdiv::Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
    using Factory = far::TopologyRefinerFactory<far::TopologyDescriptor>;
    refiner_.reset(
        Factory::Create(descriptor, Factory::Options(OpenSubdiv::Sdc::SCHEME_CATMARK, options)));
  }

  void build(int levels) {
    SurfaceFactory::Options options;
    options.SetApproxLevelSmooth(levels);
    options.SetApproxLevelSharp(levels);
    factory_ = std::make_unique<SurfaceFactory>(*refiner_, options);
    const int faces = static_cast<int>(mesh_.face_sizes.size());
    surfaces_.clear();
    patch_points_.assign(faces, {});
    for (int f = 0; f < faces; ++f) {
      surfaces_.emplace_back(factory_->CreateVertexSurface<double>(f));
      patch_points_[f].resize(3 * surfaces_.back()->GetNumPatchPoints());
    }
  }

  void prepare() {
    const double* points = mesh_.points[0].data();
    for (std::size_t f = 0; f < surfaces_.size(); ++f) {
      surfaces_[f]->PreparePatchPoints(points, 3, patch_points_[f].data(), 3);
    }
  }

  int face_count() const { return static_cast<int>(surfaces_.size()); }
  bfr::Parameterization parameters(int face) const {
    return surfaces_[face]->GetParameterization();
  }

  void evaluate(int face, const double* uv, int order, double* out) const {
    const auto& surface = *surfaces_[face];
    const double* points = patch_points_[face].data();
    if (order == 0) {
      surface.Evaluate(uv, points, 3, out);
    } else if (order == 1) {
      surface.Evaluate(uv, points, 3, out, out + 3, out + 6);
    } else {
      surface.Evaluate(uv, points, 3, out, out + 3, out + 6, out + 9, out + 12, out + 15);
    }
  }

 private:
  using SurfaceFactory = bfr::RefinerSurfaceFactory<>;
  const hull::MeshArrays& mesh_;
  std::unique_ptr<far::TopologyRefiner> refiner_;
  std::unique_ptr<SurfaceFactory> factory_;
  std::vector<std::unique_ptr<bfr::Surface<double>>> surfaces_;
  std::vector<std::vector<double>> patch_points_;
};

constexpr int kGrid = 16;

void BM_GridOurs(benchmark::State& state) {
  const LimitSurface surface(control_mesh(), hull::Scheme::kCatmullClark);
  hull::GridSamples samples;
  for (auto _ : state) {
    hull::evaluate_grid(surface, kGrid, static_cast<int>(state.range(0)), samples);
    benchmark::DoNotOptimize(samples.points.data());
  }
  state.counters["points"] =
      benchmark::Counter(static_cast<double>(surface.cell_count() * (kGrid + 1) * (kGrid + 1)),
                         benchmark::Counter::kIsIterationInvariantRate);
}

// The same number of points, on a grid of each quadrilateral, or each corner's part of other faces.
void BM_GridBfr(benchmark::State& state) {
  const hull::MeshArrays mesh = hull::benchmarks::half_hull();
  BfrSurfaces surfaces(mesh);
  surfaces.build(10);
  surfaces.prepare();
  const int order = static_cast<int>(state.range(0));
  std::int64_t count = 0;
  double out[18];
  for (auto _ : state) {
    count = 0;
    for (int face = 0; face < surfaces.face_count(); ++face) {
      const bfr::Parameterization parameters = surfaces.parameters(face);
      for (int corner = 0; corner < mesh.face_sizes[face]; ++corner) {
        double at[2];
        parameters.GetVertexCoord(corner, at);
        for (int j = 0; j <= kGrid; ++j) {
          for (int i = 0; i <= kGrid; ++i) {
            // Half the face's side from the corner inwards.
            const double s = 0.5 * i / kGrid, t = 0.5 * j / kGrid;
            const double uv[2] = {at[0] + (at[0] - std::floor(at[0]) > 0.5 ? -s : s),
                                  at[1] + (at[1] - std::floor(at[1]) > 0.5 ? -t : t)};
            surfaces.evaluate(face, uv, order, out);
            benchmark::DoNotOptimize(out);
            ++count;
          }
        }
      }
    }
  }
  state.counters["points"] =
      benchmark::Counter(static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate);
}

constexpr int kScattered = 20000;

void BM_ScatteredOurs(benchmark::State& state) {
  const LimitSurface surface(control_mesh(), hull::Scheme::kCatmullClark);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<std::pair<int, Eigen::Vector2d>> places(kScattered);
  for (auto& [cell, uv] : places) {
    cell = static_cast<int>(unit(random) * surface.cell_count());
    uv = {unit(random), unit(random)};
  }
  const int order = static_cast<int>(state.range(0));
  hull::SurfaceJet jet;
  for (auto _ : state) {
    for (const auto& [cell, uv] : places) {
      surface.evaluate(cell, uv.x(), uv.y(), order, jet);
      benchmark::DoNotOptimize(&jet);
    }
  }
  state.counters["points"] = benchmark::Counter(static_cast<double>(kScattered),
                                                benchmark::Counter::kIsIterationInvariantRate);
}

void BM_ScatteredBfr(benchmark::State& state) {
  const hull::MeshArrays mesh = hull::benchmarks::half_hull();
  BfrSurfaces surfaces(mesh);
  surfaces.build(10);
  surfaces.prepare();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<std::pair<int, Eigen::Vector2d>> places(kScattered);
  for (auto& [face, uv] : places) {
    face = static_cast<int>(unit(random) * surfaces.face_count());
    uv = {unit(random), unit(random)};
    if (mesh.face_sizes[face] == 4) continue;
    // In the quarter of a random corner of faces that are cut up.
    const auto corner = static_cast<int>(unit(random) * mesh.face_sizes[face]);
    double at[2];
    surfaces.parameters(face).GetVertexCoord(corner, at);
    uv = {at[0] + 0.5 * uv.x(), at[1] + 0.5 * uv.y()};
  }
  const int order = static_cast<int>(state.range(0));
  double out[18];
  for (auto _ : state) {
    for (const auto& [face, uv] : places) {
      surfaces.evaluate(face, uv.data(), order, out);
      benchmark::DoNotOptimize(out);
    }
  }
  state.counters["points"] = benchmark::Counter(static_cast<double>(kScattered),
                                                benchmark::Counter::kIsIterationInvariantRate);
}

void BM_ConstructCold(benchmark::State& state) {
  const hull::ControlMesh mesh = control_mesh();
  for (auto _ : state) benchmark::DoNotOptimize(LimitSurface(mesh, hull::Scheme::kBiermann));
}

void BM_ConstructWarm(benchmark::State& state) {
  const hull::ControlMesh mesh = control_mesh();
  const auto cache = std::make_shared<hull::BasisCache>();
  for (auto _ : state) {
    benchmark::DoNotOptimize(LimitSurface(mesh, hull::Scheme::kBiermann, cache));
  }
}

void BM_ConstructBfr(benchmark::State& state) {
  const hull::MeshArrays mesh = hull::benchmarks::half_hull();
  BfrSurfaces surfaces(mesh);
  for (auto _ : state) surfaces.build(static_cast<int>(state.range(0)));
}

void BM_SetPointsOurs(benchmark::State& state) {
  const hull::ControlMesh mesh = control_mesh();
  LimitSurface surface(mesh, hull::Scheme::kBiermann);
  for (auto _ : state) surface.set_points(mesh.points());
}

void BM_PreparePatchPointsBfr(benchmark::State& state) {
  const hull::MeshArrays mesh = hull::benchmarks::half_hull();
  BfrSurfaces surfaces(mesh);
  surfaces.build(static_cast<int>(state.range(0)));
  for (auto _ : state) surfaces.prepare();
}

// Cost by number of faces: about 10², 10³, 10⁴, 10⁵.
void BM_ConstructLarge(benchmark::State& state) {
  const hull::ControlMesh mesh = control_mesh(static_cast<int>(state.range(0)));
  const auto cache = std::make_shared<hull::BasisCache>();
  for (auto _ : state) {
    benchmark::DoNotOptimize(LimitSurface(mesh, hull::Scheme::kBiermann, cache));
  }
  state.counters["faces"] = mesh.topology().face_count();
}

BENCHMARK(BM_GridOurs)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_GridBfr)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_ScatteredOurs)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_ScatteredBfr)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_ConstructCold)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_ConstructBfr)->Arg(10)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_ConstructWarm)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_SetPointsOurs)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_PreparePatchPointsBfr)->Arg(6)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_ConstructLarge)->Arg(1)->Arg(3)->Arg(10)->Arg(29)->Unit(benchmark::kMillisecond);

}  // namespace
