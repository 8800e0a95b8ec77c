// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/control_mesh.h"

#include <pybind11/stl.h>

#include "bindings/arrays.h"
#include "mesh/centre_plane.h"

namespace hull::bindings {
namespace {

mesh::MeshArrays arrays_from(const DoubleArray& points, const py::object& face_sizes,
                             const py::object& face_vertices,
                             const std::optional<py::object>& creases,
                             const std::optional<py::object>& corners, bool round_border_corners) {
  mesh::MeshArrays arrays;
  arrays.points = points_from(points, "points");
  arrays.face_sizes = integers_from(face_sizes, "face_sizes");
  arrays.face_vertices = integers_from(face_vertices, "face_vertices");
  if (creases) arrays.creases = pairs_from(*creases, "creases");
  if (corners) arrays.corners = integers_from(*corners, "corners");
  arrays.round_border_corners = round_border_corners;
  return arrays;
}

const char* name_of(mesh::ElementKind kind) {
  switch (kind) {
    case mesh::ElementKind::kVertex:
      return "vertex";
    case mesh::ElementKind::kEdge:
      return "edge";
    case mesh::ElementKind::kFace:
      return "face";
    default:
      return "mesh";
  }
}

py::array elements_of(const mesh::MeshProblem& problem) {
  if (problem.kind != mesh::ElementKind::kEdge) return to_array(problem.elements);
  std::vector<std::array<int, 2>> pairs;
  for (std::size_t i = 0; i + 1 < problem.elements.size(); i += 2) {
    pairs.push_back({problem.elements[i], problem.elements[i + 1]});
  }
  return to_array(pairs);
}

std::vector<std::array<int, 2>> edges_where(const mesh::Topology& t, bool border) {
  std::vector<std::array<int, 2>> edges;
  for (int h = 0; h < t.half_edge_count(); ++h) {
    const bool wanted = border ? t.twin(h) < 0 : t.is_crease(h);
    // One of both half-edges, so that an edge comes once.
    if (wanted && t.is_edge_front(h)) edges.push_back({t.origin(h), t.origin(t.next(h))});
  }
  return edges;
}

std::vector<int> face_counts(const mesh::Topology& t) {
  std::vector<int> counts(t.vertex_count(), 0);
  for (int h = 0; h < t.half_edge_count(); ++h) ++counts[t.origin(h)];
  return counts;
}

std::vector<int> face_sizes(const mesh::Topology& t) {
  std::vector<int> sizes(t.face_count());
  for (int f = 0; f < t.face_count(); ++f) sizes[f] = t.face_size(f);
  return sizes;
}

std::vector<int> face_vertices(const mesh::Topology& t) {
  std::vector<int> vertices(t.half_edge_count());
  for (int h = 0; h < t.half_edge_count(); ++h) vertices[h] = t.origin(h);
  return vertices;
}

std::vector<int> kinds(const mesh::Topology& t) {
  std::vector<int> values(t.vertex_count());
  for (int v = 0; v < t.vertex_count(); ++v) values[v] = static_cast<int>(t.kind(v));
  return values;
}

}  // namespace

void bind_control_mesh(py::module_& module) {
  py::class_<mesh::MeshProblem>(module, "MeshProblem", "One thing wrong with a mesh.")
      .def_property_readonly(
          "severity",
          [](const mesh::MeshProblem& p) {
            return p.severity == mesh::Severity::kError ? "error" : "warning";
          },
          "\"error\": the mesh has no surface; \"warning\": it has, but look at it.")
      .def_property_readonly(
          "kind", [](const mesh::MeshProblem& p) { return name_of(p.kind); },
          "What is listed: \"vertex\", \"edge\", \"face\", or \"mesh\" for the whole.")
      .def_property_readonly("elements", elements_of,
                             "(k,) vertices or faces, or (k, 2) the vertices of edges.")
      .def_readonly("message", &mesh::MeshProblem::message, "What is wrong, where, and the remedy.")
      .def("__repr__",
           [](const mesh::MeshProblem& p) { return "<MeshProblem: " + p.message + ">"; });

  module.def(
      "check_mesh",
      [](const DoubleArray& points, const py::object& sizes, const py::object& vertices,
         const std::optional<py::object>& creases, const std::optional<py::object>& corners,
         bool round_border_corners) {
        return mesh::check_mesh(
            arrays_from(points, sizes, vertices, creases, corners, round_border_corners));
      },
      py::arg("points"), py::arg("face_sizes"), py::arg("face_vertices"),
      py::arg("creases") = py::none(), py::arg("corners") = py::none(),
      py::arg("round_border_corners") = false,
      "Everything wrong with a control mesh, errors first, as a list of MeshProblem. The arguments "
      "are those of ControlMesh.");

  py::class_<mesh::ControlMesh>(
      module, "ControlMesh",
      "A valid control mesh with its creases and corners. Immutable, but that of a surface, "
      "LimitSurface.mesh, follows its set_points().")
      .def(py::init([](const DoubleArray& points, const py::object& sizes,
                       const py::object& vertices, const std::optional<py::object>& creases,
                       const std::optional<py::object>& corners, bool round_border_corners) {
             return mesh::ControlMesh(
                 arrays_from(points, sizes, vertices, creases, corners, round_border_corners));
           }),
           py::arg("points"), py::arg("face_sizes"), py::arg("face_vertices"),
           py::arg("creases") = py::none(), py::arg("corners") = py::none(),
           py::arg("round_border_corners") = false,
           "points: (n, 3), m, x forward, y to port, z up. face_sizes: (f,) corners of each face. "
           "face_vertices: (sum of face_sizes,) their points, counter-clockwise seen from the "
           "water. creases: (m, 2) pairs of points; borders are creases without being listed. "
           "corners: (k,) points. round_border_corners: border points of a single face are no "
           "corners.\n\nRaises ValueError naming the element and the remedy.")
      .def(
          "with_points",
          [](const mesh::ControlMesh& mesh, const DoubleArray& points) {
            return mesh.with_points(points_from(points, "points"));
          },
          py::arg("points"), "The same mesh with its points, (n, 3) in m, elsewhere.")
      .def_property_readonly(
          "points", [](const mesh::ControlMesh& mesh) { return to_array(mesh.points()); },
          "(n, 3), m.")
      .def_property_readonly("vertex_count",
                             [](const mesh::ControlMesh& m) { return m.topology().vertex_count(); })
      .def_property_readonly("edge_count",
                             [](const mesh::ControlMesh& m) { return m.topology().edge_count(); })
      .def_property_readonly("face_count",
                             [](const mesh::ControlMesh& m) { return m.topology().face_count(); })
      .def_property_readonly(
          "face_sizes",
          [](const mesh::ControlMesh& m) { return to_array(face_sizes(m.topology())); },
          "(f,) corners of each face.")
      .def_property_readonly(
          "face_vertices",
          [](const mesh::ControlMesh& m) { return to_array(face_vertices(m.topology())); },
          "(sum of face_sizes,).")
      .def_property_readonly(
          "creases",
          [](const mesh::ControlMesh& m) { return to_array(edges_where(m.topology(), false)); },
          "(m, 2) crease edges, borders included.")
      .def_property_readonly(
          "border_edges",
          [](const mesh::ControlMesh& m) { return to_array(edges_where(m.topology(), true)); },
          "(b, 2).")
      .def_property_readonly(
          "vertex_valences",
          [](const mesh::ControlMesh& m) { return to_array(face_counts(m.topology())); },
          "(n,) faces around each point.")
      .def_property_readonly(
          "vertex_kinds", [](const mesh::ControlMesh& m) { return to_array(kinds(m.topology())); },
          "(n,) 0 smooth, 1 dart, 2 crease, 3 corner, 4 cone tip.")
      .def_property_readonly(
          "irregular_vertices",
          [](const mesh::ControlMesh& m) { return to_array(m.irregular_vertices()); },
          "(k,) points where the surface is not everywhere a bicubic B-spline.")
      .def(
          "with_centre_line",
          [](const mesh::ControlMesh& m) {
            return m.with_points(mesh::points_with_centre_line(m));
          },
          "The same mesh with its centre line in the centre plane exactly: both ends of border "
          "edges whose ends are within tolerances.ON_CENTRE_PLANE of the size of it.")
      .def_property_readonly(
          "near_centre_line",
          [](const mesh::ControlMesh& m) { return to_array(mesh::vertices_near_centre_line(m)); },
          "(k,) points of border edges that run along the centre plane, but further off than that "
          "and within tolerances.NEAR_CENTRE_PLANE: probably meant to be on it.")
      .def_property_readonly("size", &mesh::ControlMesh::size,
                             "Diagonal of the bounding box of the points of faces, m.")
      .def_property_readonly(
          "greatest_extent", [](const mesh::ControlMesh& m) { return m.box().sizes().maxCoeff(); },
          "The longest side of that box, along x, y or z, m.")
      .def_property_readonly(
          "warnings", [](const mesh::ControlMesh& m) { return m.warnings(); },
          "List of MeshProblem.");
}

}  // namespace hull::bindings
