// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/mesh_check.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>

#include "mesh/tolerances.h"

namespace hull::mesh {
namespace {

// Elements found with one kind of problem.
struct Finding {
  Severity severity;
  ElementKind kind;
  const char* singular;  // "has a coordinate that is not a number"
  const char* plural;
  const char* remedy;
  std::vector<int> elements = {};
};

std::string element_name(const Finding& finding, std::size_t i) {
  if (finding.kind != ElementKind::kEdge) return std::to_string(finding.elements[i]);
  return std::to_string(finding.elements[2 * i]) + "–" +
         std::to_string(finding.elements[2 * i + 1]);
}

void report(const Finding& finding, std::vector<MeshProblem>& problems) {
  if (finding.elements.empty()) return;
  const bool edges = finding.kind == ElementKind::kEdge;
  const std::size_t count = finding.elements.size() / (edges ? 2 : 1);
  const std::string noun = edges                                  ? "edge"
                           : finding.kind == ElementKind::kFace   ? "face"
                           : finding.kind == ElementKind::kVertex ? "point"
                                                                  : "mesh";
  std::string message = (count == 1 ? noun : std::to_string(count) + " " + noun + "s") + " ";
  message[0] = static_cast<char>(std::toupper(message[0]));
  constexpr std::size_t kNamed = 5;
  if (count > 1) message += "(";
  for (std::size_t i = 0; i < std::min(count, kNamed); ++i) {
    message += (i > 0 ? ", " : "") + element_name(finding, i);
  }
  if (count > kNamed) message += ", …";
  if (count > 1) message += ")";
  message +=
      std::string(" ") + (count == 1 ? finding.singular : finding.plural) + ". " + finding.remedy;
  problems.push_back({finding.severity, finding.kind, finding.elements, message});
}

void report_mesh(const std::string& message, std::vector<MeshProblem>& problems) {
  problems.push_back({Severity::kError, ElementKind::kMesh, {}, message});
}

// Sizes and indices; false if the arrays can't be walked safely.
bool check_arrays(const MeshArrays& mesh, std::vector<MeshProblem>& problems) {
  const std::size_t before = problems.size();
  if (mesh.face_sizes.empty()) {
    report_mesh("The mesh has no faces. Add at least one face.", problems);
  }
  const auto too_many = [&problems](std::size_t count, std::size_t limit, const std::string& what) {
    if (count <= limit) return false;
    report_mesh("The mesh has " + std::to_string(count) + " " + what + "; at most " +
                    std::to_string(limit) + " are handled.",
                problems);
    return true;
  };
  // Before all else: beyond these limits the numbers below do not fit into int.
  if (too_many(mesh.points.size(), kMaxPoints, "points") ||
      too_many(mesh.face_vertices.size(), kMaxHalfEdges, "face corners") ||
      too_many(mesh.face_sizes.size(), kMaxHalfEdges, "faces")) {
    return false;
  }
  const int vertex_count = static_cast<int>(mesh.points.size());
  Finding small{Severity::kError, ElementKind::kFace, "has fewer than three corners",
                "have fewer than three corners",
                "A face needs at least three: add corners, or delete the face."};
  Finding large{Severity::kError, ElementKind::kFace, "has more than 128 corners",
                "have more than 128 corners", "Cut into smaller faces."};
  // Sizes may be anything yet, and their sum too large for int.
  std::int64_t total = 0;
  for (std::size_t f = 0; f < mesh.face_sizes.size(); ++f) {
    const int size = mesh.face_sizes[f];
    if (size < 3) small.elements.push_back(static_cast<int>(f));
    if (size > kMaxValence) large.elements.push_back(static_cast<int>(f));
    total += size;
  }
  report(small, problems);
  report(large, problems);
  if (total != static_cast<std::int64_t>(mesh.face_vertices.size())) {
    report_mesh("The face sizes add up to " + std::to_string(total) + ", but there are " +
                    std::to_string(mesh.face_vertices.size()) + " face corners.",
                problems);
  }
  const auto in_range = [vertex_count](int v) { return v >= 0 && v < vertex_count; };
  const auto say_range = [&](const char* what, std::size_t which, int v) {
    report_mesh(std::string(what) + " " + std::to_string(which) + " names point " +
                    std::to_string(v) + ", but the points are 0 to " +
                    std::to_string(vertex_count - 1) + ".",
                problems);
  };
  for (std::size_t i = 0; i < mesh.face_vertices.size(); ++i) {
    if (in_range(mesh.face_vertices[i])) continue;
    say_range("Face corner", i, mesh.face_vertices[i]);
    break;
  }
  for (std::size_t i = 0; i < mesh.creases.size(); ++i) {
    const auto& [a, b] = mesh.creases[i];
    if (in_range(a) && in_range(b)) continue;
    say_range("Crease", i, in_range(a) ? b : a);
    break;
  }
  for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
    if (in_range(mesh.corners[i])) continue;
    say_range("Corner", i, mesh.corners[i]);
    break;
  }
  return problems.size() == before;
}

void check_points(const MeshArrays& mesh, std::vector<MeshProblem>& problems) {
  Finding not_finite{Severity::kError, ElementKind::kVertex,
                     "has a coordinate that is not a finite number",
                     "have coordinates that are not finite numbers", "Type the position anew."};
  Finding far{Severity::kError, ElementKind::kVertex, "lies more than 1e9 m from the origin",
              "lie more than 1e9 m from the origin", "Check the units."};
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (!mesh.points[i].allFinite()) {
      not_finite.elements.push_back(static_cast<int>(i));
    } else if (mesh.points[i].cwiseAbs().maxCoeff() > kMaxCoordinate) {
      far.elements.push_back(static_cast<int>(i));
    }
  }
  report(not_finite, problems);
  report(far, problems);
}

// REQUIRES: the faces' numbers of points are in range.
void check_size(const MeshArrays& mesh, std::vector<MeshProblem>& problems) {
  Eigen::AlignedBox3d box;
  for (int v : mesh.face_vertices) box.extend(mesh.points[v]);
  // Of a point that is no number check_points() has told.
  if (!box.sizes().allFinite() || box.sizes().maxCoeff() >= kLeastSize) return;
  std::ostringstream words;
  words << "The mesh has no size: all points of its faces lie at (" << box.center().x() << ", "
        << box.center().y() << ", " << box.center().z()
        << ") m. Undo what moved them together, or check the units.";
  problems.push_back({Severity::kError, ElementKind::kMesh, {}, words.str()});
}

// One corner of a face: the edge that leaves it, as a sortable key.
struct Side {
  int low, high, half_edge;
  bool forward;  // from low to high
  bool same_edge(const Side& other) const { return low == other.low && high == other.high; }
};

class Connectivity {
 public:
  explicit Connectivity(const MeshArrays& mesh) {
    begin_.push_back(0);
    for (int size : mesh.face_sizes) begin_.push_back(begin_.back() + size);
    face_.resize(mesh.face_vertices.size());
    for (int f = 0; f < face_count(); ++f) {
      for (int h = begin_[f]; h < begin_[f + 1]; ++h) face_[h] = f;
    }
    for (int h = 0; h < static_cast<int>(face_.size()); ++h) {
      const int a = mesh.face_vertices[h], b = mesh.face_vertices[next(h)];
      sides_.push_back({std::min(a, b), std::max(a, b), h, a < b});
    }
    // An edge's half-edges come together, in the order of their numbers: no two keys are the same,
    // so that what is found comes in one order everywhere.
    std::sort(sides_.begin(), sides_.end(), [](const Side& x, const Side& y) {
      return std::tie(x.low, x.high, x.half_edge) < std::tie(y.low, y.high, y.half_edge);
    });
  }

  int face_count() const { return static_cast<int>(begin_.size()) - 1; }
  int begin(int face) const { return begin_[face]; }
  int next(int h) const { return h + 1 == begin_[face_[h] + 1] ? begin_[face_[h]] : h + 1; }
  int prev(int h) const { return h == begin_[face_[h]] ? begin_[face_[h] + 1] - 1 : h - 1; }
  int twin(int h) const { return twin_[h]; }
  bool has_edge(int a, int b) const {
    const Side wanted{std::min(a, b), std::max(a, b), 0, true};
    return std::binary_search(sides_.begin(), sides_.end(), wanted,
                              [](const Side& x, const Side& y) {
                                return std::tie(x.low, x.high) < std::tie(y.low, y.high);
                              });
  }

  // Pairs half-edges; reports edges that can't be paired.
  bool pair_sides(std::vector<MeshProblem>& problems) {
    Finding crowded{Severity::kError, ElementKind::kEdge, "belongs to more than two faces",
                    "belong to more than two faces",
                    "Delete the extra faces or split the mesh along the edge."};
    Finding turned{Severity::kError, ElementKind::kEdge,
                   "is run through in the same direction by both its faces",
                   "are run through in the same direction by both their faces",
                   "Turn the faces to the same side (recalculate normals)."};
    twin_.assign(face_.size(), -1);
    for (std::size_t i = 0; i < sides_.size();) {
      std::size_t j = i + 1;
      while (j < sides_.size() && sides_[j].same_edge(sides_[i])) ++j;
      Finding* finding = j - i > 2 ? &crowded : nullptr;
      if (j - i == 2) {
        if (sides_[i].forward == sides_[i + 1].forward) {
          finding = &turned;
        } else {
          twin_[sides_[i].half_edge] = sides_[i + 1].half_edge;
          twin_[sides_[i + 1].half_edge] = sides_[i].half_edge;
        }
      }
      if (finding) {
        finding->elements.insert(finding->elements.end(), {sides_[i].low, sides_[i].high});
      }
      i = j;
    }
    report(crowded, problems);
    report(turned, problems);
    return crowded.elements.empty() && turned.elements.empty();
  }

  // Faces met by turning around the origin of h; `closed` if the turn came round.
  int fan_size(int h, bool& closed) const {
    int faces = 1;
    for (int i = twin_[prev(h)]; i >= 0; i = twin_[prev(i)]) {
      // Pairs are one to one: a turn that meets no border comes back to h itself.
      if (i == h) {
        closed = true;
        return faces;
      }
      ++faces;
    }
    // A border ended the turn: the rest of the fan lies to the other side of h.
    for (int i = twin_[h]; i >= 0; i = twin_[next(i)]) ++faces;
    closed = false;
    return faces;
  }

 private:
  std::vector<int> begin_, face_, twin_;
  std::vector<Side> sides_;
};

// Repeated corners within a face; they would make edges from a point to itself or pinched faces.
bool check_repeats(const MeshArrays& mesh, std::vector<MeshProblem>& problems) {
  Finding repeats{Severity::kError, ElementKind::kFace, "has the same point twice",
                  "have the same point twice", "Remove the repeated corner."};
  std::vector<int> corners;
  std::size_t begin = 0;
  for (std::size_t f = 0; f < mesh.face_sizes.size(); ++f) {
    const auto first = mesh.face_vertices.begin() + static_cast<std::ptrdiff_t>(begin);
    corners.assign(first, first + mesh.face_sizes[f]);
    std::sort(corners.begin(), corners.end());
    if (std::adjacent_find(corners.begin(), corners.end()) != corners.end()) {
      repeats.elements.push_back(static_cast<int>(f));
    }
    begin += static_cast<std::size_t>(mesh.face_sizes[f]);
  }
  report(repeats, problems);
  return repeats.elements.empty();
}

void check_fans(const MeshArrays& mesh, const Connectivity& connectivity,
                std::vector<MeshProblem>& problems) {
  Finding pinched{Severity::kError, ElementKind::kVertex, "joins faces that share no edge there",
                  "join faces that share no edge there",
                  "Split the point, one for each part of the surface."};
  Finding crowded{Severity::kError, ElementKind::kVertex, "has more than 128 faces around it",
                  "have more than 128 faces around them", "Model the place with fewer faces."};
  Finding isolated{Severity::kWarning, ElementKind::kVertex, "belongs to no face",
                   "belong to no face", "Points without faces have no influence on the surface."};
  Finding thin{Severity::kWarning, ElementKind::kVertex, "lies between only two faces",
               "lie between only two faces",
               "The surface is flattened there: dissolve the point, or crease its edges."};
  Finding cone{Severity::kWarning, ElementKind::kVertex,
               "is tagged a corner, but fewer than two creases meet there",
               "are tagged corners, but fewer than two creases meet there",
               "The surface has a tip there: tag creases too, or untag the corner."};
  std::vector<int> faces(mesh.points.size(), 0), creases(mesh.points.size(), 0);
  std::vector<int> start(mesh.points.size(), -1);
  for (std::size_t h = 0; h < mesh.face_vertices.size(); ++h) {
    const int v = mesh.face_vertices[h];
    ++faces[v];
    start[v] = static_cast<int>(h);
  }
  std::vector<std::array<int, 2>> unique;
  for (const auto& [a, b] : mesh.creases) {
    if (a != b && connectivity.has_edge(a, b)) unique.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(unique.begin(), unique.end());
  // An edge may be named twice, or from both ends.
  unique.erase(std::unique(unique.begin(), unique.end()), unique.end());
  for (const auto& [a, b] : unique) {
    ++creases[a];
    ++creases[b];
  }
  for (int v = 0; v < static_cast<int>(mesh.points.size()); ++v) {
    if (faces[v] == 0) {
      isolated.elements.push_back(v);
      continue;
    }
    bool closed = false;
    // Where fans meet in a point alone, turning within one of them misses the others.
    if (connectivity.fan_size(start[v], closed) != faces[v]) pinched.elements.push_back(v);
    if (faces[v] > kMaxValence) crowded.elements.push_back(v);
    if (closed && faces[v] == 2 && creases[v] < 2) thin.elements.push_back(v);
    // Its two borders, a second time where they are tagged: that it is two or more is all that
    // counts.
    if (!closed) creases[v] += 2;
  }
  for (int v : mesh.corners) {
    if (faces[v] > 0 && creases[v] < 2) cone.elements.push_back(v);
  }
  for (const Finding* finding : {&pinched, &crowded, &isolated, &thin, &cone}) {
    report(*finding, problems);
  }
}

// Twice the area of faces that have none, over the square of their longest extent from a corner:
// what rounding leaves of points on one line.
constexpr double kNoFaceArea = 1e-14;

void check_shape(const MeshArrays& mesh, const Connectivity& connectivity,
                 std::vector<MeshProblem>& problems) {
  Finding loose{Severity::kWarning, ElementKind::kEdge, "is tagged a crease but belongs to no face",
                "are tagged creases but belong to no face", "The tag has no influence."};
  for (const auto& [a, b] : mesh.creases) {
    if (!connectivity.has_edge(a, b)) loose.elements.insert(loose.elements.end(), {a, b});
  }
  const auto flat = faces_without_area(mesh.points, mesh.face_sizes, mesh.face_vertices);
  if (flat) problems.push_back(*flat);
  report(loose, problems);
}

}  // namespace

std::optional<MeshProblem> faces_without_area(const std::vector<Eigen::Vector3d>& points,
                                              const std::vector<int>& face_sizes,
                                              const std::vector<int>& face_vertices) {
  Finding flat{Severity::kWarning, ElementKind::kFace, "has no area", "have no area",
               "Move the points apart, or delete the face."};
  const int* corners = face_vertices.data();
  for (std::size_t f = 0; f < face_sizes.size(); corners += face_sizes[f++]) {
    // Twice the vector area, and the scale against which it is nothing.
    Eigen::Vector3d area = Eigen::Vector3d::Zero();
    double scale = 0.0;
    // From a corner: products of coordinates far from the origin would cancel.
    const Eigen::Vector3d& origin = points[corners[0]];
    for (int k = 0; k < face_sizes[f]; ++k) {
      const Eigen::Vector3d a = points[corners[k]] - origin;
      const Eigen::Vector3d b = points[corners[(k + 1) % face_sizes[f]]] - origin;
      area += a.cross(b);
      scale = std::max(scale, a.squaredNorm());
    }
    if (area.norm() <= kNoFaceArea * scale) flat.elements.push_back(static_cast<int>(f));
  }
  std::vector<MeshProblem> problems;
  report(flat, problems);
  if (problems.empty()) return std::nullopt;
  return problems.front();
}

std::vector<MeshProblem> check_mesh(const MeshArrays& mesh) {
  std::vector<MeshProblem> problems;
  if (!check_arrays(mesh, problems)) return problems;
  check_points(mesh, problems);
  check_size(mesh, problems);
  if (check_repeats(mesh, problems)) {
    Connectivity connectivity(mesh);
    // A turn around a point needs edges with one twin at most.
    if (connectivity.pair_sides(problems)) check_fans(mesh, connectivity, problems);
    check_shape(mesh, connectivity, problems);
  }
  std::stable_partition(problems.begin(), problems.end(),
                        [](const MeshProblem& p) { return p.severity == Severity::kError; });
  return problems;
}

}  // namespace hull::mesh
