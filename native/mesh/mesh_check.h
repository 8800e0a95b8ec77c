// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace hull::mesh {

// A control mesh as it comes from outside: nothing about it is known to be right.
struct MeshArrays {
  std::vector<Eigen::Vector3d> points;      // m
  std::vector<int> face_sizes;              // corners of each face
  std::vector<int> face_vertices;           // of all faces, one after the other, counter-clockwise
  std::vector<std::array<int, 2>> creases;  // pairs of vertices; borders need not be listed
  std::vector<int> corners;                 // vertices
  bool round_border_corners = false;        // border vertices of a single face are no corners
};

enum class Severity { kError, kWarning };
enum class ElementKind { kMesh, kVertex, kEdge, kFace };

// One thing wrong with a mesh, said to its designer.
struct MeshProblem {
  Severity severity;
  ElementKind kind;
  std::vector<int> elements;  // vertices or faces; for edges two vertices each
  std::string message;        // what is wrong, where, and the remedy
};

// Limits. Decomposing a local matrix costs the third power of the valence: two seconds for 128.
// Half-edges are counted by int on meshes subdivided three times, 64 for each of the control mesh.
inline constexpr int kMaxValence = 128;        // faces around a vertex, corners of a face
inline constexpr int kMaxHalfEdges = 1 << 24;  // corners of all faces
inline constexpr int kMaxPoints = 1 << 24;
inline constexpr double kMaxCoordinate = 1e9;  // m

// Everything wrong with the mesh, errors first. A mesh without errors is one manifold surface, or
// several, consistently oriented, possibly with border. Warnings: isolated points (they have no
// influence), faces without area, creases that no face has (ignored), corner tags that make a cone
// tip, smooth inner points between two faces. Elements of the same kind of problem are listed in
// one MeshProblem, which names the first few. After errors in sizes or indices nothing further is
// looked at.
std::vector<MeshProblem> check_mesh(const MeshArrays& mesh);

// The one of these warnings that depends on where the points are: that of faces without area.
std::optional<MeshProblem> faces_without_area(const std::vector<Eigen::Vector3d>& points,
                                              const std::vector<int>& face_sizes,
                                              const std::vector<int>& face_vertices);

}  // namespace hull::mesh
