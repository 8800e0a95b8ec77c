// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/coarsened_mesh.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "mesh/parent_faces.h"
#include "surface/eigenbasis/subdivision_rules.h"
#include "surface/eigenbasis/weight_row.h"

namespace hull::surface {
namespace {

using mesh::ParentFaces;
// Where points of three faces alternate, as around a cube, different meshes have one subdivision.
// Of these the one nearest to the points as they are is taken: each step of the search costs so
// much.
constexpr double kDamping = 1e-4;
constexpr int kMostSteps = 30;
constexpr double kSettled = 1e-15;  // of the size

using Columns = Eigen::Matrix<double, Eigen::Dynamic, 3>;
using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

// Makes the coarser mesh of chosen faces, its points still those of the finer one.
class Coarsener {
 public:
  Coarsener(const mesh::ControlMesh& fine, Scheme scheme, const ParentFaces& parents)
      : fine_(fine), scheme_(scheme), parents_(parents) {
    number_points();
    mesh::MeshArrays arrays = tagged_faces();
    problems_ = mesh::check_mesh(arrays);
    if (is_mesh()) mesh_.emplace(std::move(arrays));
  }

  bool is_mesh() const {
    return std::none_of(problems_.begin(), problems_.end(), [](const mesh::MeshProblem& problem) {
      return problem.severity == mesh::Severity::kError;
    });
  }

  // What is wrong, with the first point of it in the finer mesh. REQUIRES: !is_mesh().
  std::string fault() const {
    // Errors come first.
    const mesh::MeshProblem& problem = problems_.front();
    const std::string words =
        "its faces, put together around their common points, would make no valid "
        "mesh";
    if (problem.elements.empty()) return words;
    const int element = problem.elements.front();
    const bool is_face = problem.kind == mesh::ElementKind::kFace;
    return words + ", as at point " +
           std::to_string(is_face ? first_point(element) : points_[element]);
  }

  // REQUIRES: is_mesh().
  CoarsenedMesh fitted() const {
    const Rows rows = subdivision();
    const Columns given = own_points(rows);
    Eigen::SparseMatrix<double> normal = rows.transpose() * rows;
    for (int i = 0; i < normal.rows(); ++i) normal.coeffRef(i, i) += kDamping;
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(normal);
    // Steps of the proximal point method: each minimises the squared distances plus kDamping times
    // the square of the way from where it begins, so that the end is the undamped minimum, and what
    // the rows do not determine stays as it began.
    Columns points(rows.cols(), 3);
    for (std::size_t i = 0; i < points_.size(); ++i) points.row(i) = given.row(points_[i]);
    for (int step = 0; step < kMostSteps; ++step) {
      const Columns change = solver.solve(rows.transpose() * (given - rows * points));
      points += change;
      if (change.cwiseAbs().maxCoeff() < kSettled * fine_.size()) break;
    }
    return outcome(points, (given - rows * points).rowwise().norm());
  }

 private:
  const mesh::Topology& fine() const { return fine_.topology(); }

  // In the finer mesh, of a face of the coarser one.
  int first_point(int face) const {
    const auto begin = parents_.sizes.begin();
    return fine().origin(parents_.cells[std::accumulate(begin, begin + face, 0)]);
  }

  void number_points() {
    number_.assign(fine().vertex_count(), -1);
    for (int h : parents_.cells) number_[fine().origin(h)] = 0;
    for (int v = 0; v < fine().vertex_count(); ++v) {
      const bool is_isolated = fine().outgoing(v) < 0;
      // Isolated points are of no part, and would be lost: they go along with every part.
      if (number_[v] < 0 && !is_isolated) continue;
      number_[v] = static_cast<int>(points_.size());
      points_.push_back(v);
    }
  }

  mesh::MeshArrays tagged_faces() const {
    mesh::MeshArrays arrays;
    arrays.face_sizes = parents_.sizes;
    std::size_t first = 0;
    for (int size : parents_.sizes) {
      for (int k = 0; k < size; ++k) {
        const int h = parents_.cells[first + k];
        const int here = number_[fine().origin(h)];
        arrays.face_vertices.push_back(here);
        if (!fine().is_crease(h)) continue;
        // A crease of the finer mesh that leaves a vertex point is half of one: its other half ends
        // at the vertex point of the next cell.
        arrays.creases.push_back(
            {here, number_[fine().origin(parents_.cells[first + (k + 1) % size])]});
      }
      first += size;
    }
    // All corners are named, as by refined_mesh().
    arrays.round_border_corners = true;
    for (int v : points_) {
      arrays.points.push_back(fine_.points()[v]);
      const mesh::VertexKind kind = fine().kind(v);
      if (kind == mesh::VertexKind::kCorner || kind == mesh::VertexKind::kCone) {
        arrays.corners.push_back(number_[v]);
      }
    }
    return arrays;
  }

  // Points of the finer mesh as sums of those of the coarser one; none of other parts.
  Rows subdivision() const {
    const mesh::Topology& coarse = mesh_->topology();
    const auto value = [&coarse](int h) { return WeightRow(coarse.origin(h)); };
    std::vector<Eigen::Triplet<double>> entries;
    for (int v : points_) {
      if (fine().outgoing(v) < 0) entries.emplace_back(v, number_[v], 1.0);
    }
    // Cell c of the parents is the face that refining the coarser mesh would number c: so its
    // corner k is what the rules give at half-edge 4c + k.
    std::vector<char> is_known(fine().vertex_count(), 0);
    for (std::size_t cell = 0; cell < parents_.cells.size(); ++cell) {
      int h = parents_.cells[cell];
      for (int k = 0; k < 4; ++k, h = fine().next(h)) {
        const int v = fine().origin(h);
        if (is_known[v]) continue;
        is_known[v] = 1;
        const int refined = 4 * static_cast<int>(cell) + k;
        const WeightRow row = refined_value<WeightRow>(coarse, scheme_, refined, value);
        for (const auto& [point, weight] : row.entries()) {
          entries.emplace_back(v, point, weight);
        }
      }
    }
    Rows rows(fine().vertex_count(), coarse.vertex_count());
    rows.setFromTriplets(entries.begin(), entries.end());
    return rows;
  }

  // Those of other parts are left at zero.
  Columns own_points(const Rows& rows) const {
    Columns points = Columns::Zero(rows.rows(), 3);
    for (int v = 0; v < fine().vertex_count(); ++v) {
      if (Rows::InnerIterator(rows, v)) points.row(v) = fine_.points()[v].transpose();
    }
    return points;
  }

  CoarsenedMesh outcome(const Columns& points, const Eigen::VectorXd& distances) const {
    std::vector<Vector3d> placed(points_.size());
    for (std::size_t i = 0; i < placed.size(); ++i) placed[i] = points.row(i).transpose();
    int largest_point = 0;
    const double largest = distances.maxCoeff(&largest_point);
    const double rms = distances.norm() / std::sqrt(static_cast<double>(distances.size()));
    return {mesh_->with_points(std::move(placed)),
            points_,
            parents_.cells,
            rms,
            largest,
            largest_point};
  }

  const mesh::ControlMesh& fine_;
  Scheme scheme_;
  const ParentFaces& parents_;
  std::vector<int> number_, points_;  // of the finer mesh's points in the coarser one; the reverse
  std::vector<mesh::MeshProblem> problems_;
  std::optional<mesh::ControlMesh> mesh_;
};

// The way by which a part's points are nearest to subdivided ones.
const ParentFaces& nearest(const mesh::ControlMesh& fine, Scheme scheme,
                           const std::vector<ParentFaces>& ways) {
  if (ways.size() == 1) return ways.front();
  const ParentFaces* best = nullptr;
  double least = 0.0;
  for (const ParentFaces& way : ways) {
    const Coarsener coarsener(fine, scheme, way);
    if (!coarsener.is_mesh()) continue;
    // Divided by the number of all points, not the part's, which is the same for all ways.
    const double rms = coarsener.fitted().rms;
    if (best == nullptr || rms < least) {
      best = &way;
      least = rms;
    }
  }
  return best == nullptr ? ways.front() : *best;
}

// All parts in one, faces in the order of their first cells.
ParentFaces joined(const std::vector<ParentFaces>& parts) {
  struct Face {
    const int* cells;
    int size;
  };
  std::vector<Face> faces;
  for (const ParentFaces& part : parts) {
    const int* cells = part.cells.data();
    for (int size : part.sizes) {
      faces.push_back({cells, size});
      cells += size;
    }
  }
  // The finer mesh may interleave its parts, and the order of cells is to follow its faces.
  std::sort(faces.begin(), faces.end(),
            [](const Face& a, const Face& b) { return *a.cells < *b.cells; });
  ParentFaces all;
  for (const Face& face : faces) {
    all.cells.insert(all.cells.end(), face.cells, face.cells + face.size);
    all.sizes.push_back(face.size);
  }
  return all;
}

}  // namespace

CoarsenedMesh coarsened_mesh(const LimitSurface& surface) {
  const mesh::ControlMesh& fine = surface.mesh();
  std::vector<ParentFaces> chosen;
  for (const std::vector<ParentFaces>& ways : mesh::parent_faces(fine.topology())) {
    chosen.push_back(nearest(fine, surface.scheme(), ways));
  }
  const ParentFaces parents = joined(chosen);
  const Coarsener coarsener(fine, surface.scheme(), parents);
  if (!coarsener.is_mesh()) {
    throw std::invalid_argument("The mesh is no subdivided one: " + coarsener.fault() +
                                ". Take back what changed faces or creases there.");
  }
  return coarsener.fitted();
}

}  // namespace hull::surface
