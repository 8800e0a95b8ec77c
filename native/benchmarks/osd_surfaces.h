// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <opensubdiv/bfr/refinerSurfaceFactory.h>
#include <opensubdiv/far/stencilTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <memory>
#include <vector>

#include "mesh/mesh_check.h"

// What is compared with: OpenSubdiv's two ways to evaluate, in doubles, on the same mesh with the
// same creases. Both approximate at irregular points, however many levels they are given.
namespace hull::benchmarks {

namespace bfr = OpenSubdiv::OPENSUBDIV_VERSION::Bfr;
namespace far = OpenSubdiv::OPENSUBDIV_VERSION::Far;

inline std::unique_ptr<far::TopologyRefiner> make_refiner(const mesh::MeshArrays& mesh) {
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
  return std::unique_ptr<far::TopologyRefiner>(
      Factory::Create(descriptor, Factory::Options(OpenSubdiv::Sdc::SCHEME_CATMARK, options)));
}

// One Bfr::Surface per face.
class BfrSurfaces {
 public:
  explicit BfrSurfaces(const mesh::MeshArrays& mesh) : mesh_(mesh), refiner_(make_refiner(mesh)) {}

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
  const mesh::MeshArrays& mesh_;
  std::unique_ptr<far::TopologyRefiner> refiner_;
  std::unique_ptr<SurfaceFactory> factory_;
  std::vector<std::unique_ptr<bfr::Surface<double>>> surfaces_;
  std::vector<std::vector<double>> patch_points_;
};

// Far::LimitStencilTable: the grid's points as rows of weights in the control points. `mesh` must
// outlive it.
class LimitStencils {
 public:
  // The grid (i/n, j/n) of every cell.
  LimitStencils(const mesh::MeshArrays& mesh, int n, int order, int levels)
      : points_(mesh.points), order_(order) {
    const std::unique_ptr<far::TopologyRefiner> refiner = make_refiner(mesh);
    far::TopologyRefiner::AdaptiveOptions adaptive(levels);
    refiner->RefineAdaptive(adaptive);
    // A quadrilateral is one "ptex face" of four cells; a cell of another face is one by itself.
    const Grid quarters[] = {
        {n, 0.0, 0.0, 0.5}, {n, 0.5, 0.0, 0.5}, {n, 0.5, 0.5, 0.5}, {n, 0.0, 0.5, 0.5}};
    const Grid whole(n, 0.0, 0.0, 1.0);
    Factory::LocationArrayVec places;
    int face = 0;
    for (int size : mesh.face_sizes) {
      for (int corner = 0; corner < size; ++corner) {
        const Grid& grid = size == 4 ? quarters[corner] : whole;
        places.emplace_back();
        places.back().ptexIdx = size == 4 ? face : face++;
        places.back().numLocations = static_cast<int>(grid.s.size());
        places.back().s = grid.s.data();
        places.back().t = grid.t.data();
      }
      if (size == 4) ++face;
    }
    Factory::Options options;
    options.generate1stDerivatives = order > 0;
    options.generate2ndDerivatives = order > 1;
    table_.reset(Factory::Create(*refiner, places, nullptr, nullptr, options));
    for (int k = 0; k < (order + 1) * (order + 2) / 2; ++k) values_[k].resize(count());
  }

  int count() const { return table_->GetNumStencils(); }
  const double* points() const { return values_[0][0].p.data(); }

  void evaluate() {
    const auto* from = reinterpret_cast<const Value*>(points_.data());
    table_->UpdateValues(from, values_[0].data());
    if (order_ > 0) table_->UpdateDerivs(from, values_[1].data(), values_[2].data());
    if (order_ > 1) {
      table_->Update2ndDerivs(from, values_[3].data(), values_[4].data(), values_[5].data());
    }
  }

 private:
  using Factory = far::LimitStencilTableFactoryReal<double>;
  struct Value {
    Eigen::Vector3d p;
    void Clear() { p.setZero(); }
    void AddWithWeight(const Value& other, double weight) { p += weight * other.p; }
  };
  struct Grid {
    std::vector<double> s, t;
    Grid(int n, double u, double v, double size) {
      for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n; ++j) {
          s.push_back(u + size * i / n);
          t.push_back(v + size * j / n);
        }
      }
    }
  };

  const std::vector<Eigen::Vector3d>& points_;
  int order_;
  std::unique_ptr<const far::LimitStencilTableReal<double>> table_;
  std::vector<Value> values_[6];
};

}  // namespace hull::benchmarks
