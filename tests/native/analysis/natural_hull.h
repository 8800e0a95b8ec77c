// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "analysis/arithmetic/gauss.h"
#include "test_meshes.h"

namespace hull::testing {

// A uniform cubic spline through its border control points, without curvature there: what the
// surface does across its borders.
class NaturalSpline {
 public:
  NaturalSpline(std::vector<double> controls, double length)
      : c_(std::move(controls)), step_(length / (c_.size() - 1)) {}

  int spans() const { return static_cast<int>(c_.size()) - 1; }
  double length() const { return step_ * spans(); }
  double operator()(double x) const { return sum(x, surface::cubic_basis); }
  double slope(double x) const { return sum(x, surface::cubic_basis_d1) / step_; }

  // Of a function that is a polynomial of degree 15 between the knots.
  double integral(const std::function<double(double)>& f, double to) const {
    const analysis::GaussRule rule = analysis::gauss_rule(8);
    double total = 0.0;
    for (int k = 0; k < spans(); ++k) {
      const double begin = k * step_, end = std::min(to, begin + step_);
      if (end <= begin) break;
      for (int i = 0; i < 8; ++i) {
        total += (end - begin) * rule.weights[i] * f(begin + (end - begin) * rule.nodes[i]);
      }
    }
    return total;
  }

 private:
  double control(int i) const {
    const int last = spans();
    if (i < 0) return 2.0 * c_[0] - c_[1];
    if (i > last) return 2.0 * c_[last] - c_[last - 1];
    return c_[i];
  }
  template <class F>
  double sum(double x, const F& basis) const {
    const int k = std::min(spans() - 1, std::max(0, static_cast<int>(std::floor(x / step_))));
    const surface::Basis b = basis(x / step_ - k);
    double total = 0.0;
    for (int i = 0; i < 4; ++i) total += b[i] * control(k - 1 + i);
    return total;
  }

  std::vector<double> c_;
  double step_;
};

// The half hull y = along(x) upwards(z), an exact bicubic B-spline surface: particulars have closed
// forms. Its ends and its keel are in the centre plane where the splines are zero.
struct NaturalHull {
  NaturalSpline along, upwards;
  mesh::MeshArrays mesh;

  NaturalHull(const std::vector<double>& breadths, double length,
              const std::vector<double>& fullness, double depth)
      : along(breadths, length), upwards(fullness, depth) {
    const int m = upwards.spans(), n = along.spans();
    mesh = grid(m, n);
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= m; ++i) {
        mesh.points[j * (m + 1) + i] = {length * j / n, breadths[j] * fullness[i], depth * i / m};
      }
    }
  }

  // The same with its starboard side, as one mesh with a crease along stem, keel and stern.
  mesh::MeshArrays whole() const {
    mesh::MeshArrays both = mesh;
    const int rows = upwards.spans() + 1, columns = along.spans() + 1;
    std::vector<int> image(mesh.points.size());
    for (int j = 0; j < columns; ++j) {
      for (int i = 0; i < rows; ++i) {
        const int p = j * rows + i;
        if (i == 0 || j == 0 || j == columns - 1) {
          image[p] = p;
          continue;
        }
        image[p] = static_cast<int>(both.points.size());
        both.points.emplace_back(mesh.points[p].x(), -mesh.points[p].y(), mesh.points[p].z());
      }
    }
    std::size_t begin = 0;
    for (int size : mesh.face_sizes) {
      std::vector<int> corners;
      for (int k = size - 1; k >= 0; --k) corners.push_back(image[mesh.face_vertices[begin + k]]);
      add_face(both, corners);
      begin += size;
    }
    for (int j = 0; j + 1 < columns; ++j) both.creases.push_back({j * rows, (j + 1) * rows});
    for (int i = 0; i + 1 < rows; ++i) {
      both.creases.push_back({i, i + 1});
      both.creases.push_back({(columns - 1) * rows + i, (columns - 1) * rows + i + 1});
    }
    both.corners = {0, (columns - 1) * rows};
    return both;
  }
};

// A ship-like one: 60 m long, 12 m wide, 6 m deep.
inline NaturalHull natural_ship() {
  return {
      {0.0, 2.0, 4.5, 5.8, 6.2, 6.0, 5.1, 3.4, 1.5, 0.0}, 60.0, {0.0, 0.7, 0.95, 1.0, 1.05}, 6.0};
}

}  // namespace hull::testing
