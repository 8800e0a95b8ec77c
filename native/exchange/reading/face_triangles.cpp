// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/reading/face_triangles.h"

#include <BRepAdaptor_Surface.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "exchange/occt_geometry.h"

namespace hull::exchange {
namespace {

constexpr int kMostCuts = 5;

class FinerTriangles {
 public:
  FinerTriangles(const TopoDS_Face& face, const Poly_Triangulation& mesh,
                 const TopLoc_Location& location, double chord)
      : surface_(face), chord_(chord) {
    const gp_Trsf& move = location.Transformation();
    for (int i = 1; i <= mesh.NbNodes(); ++i) {
      points_.push_back(mesh.Node(i).Transformed(move).XYZ());
      // In the surface's own (u, v), without the location, which the adaptor adds itself.
      if (mesh.HasUVNodes()) places_.push_back(mesh.UVNode(i).XY());
    }
    for (int i = 1; i <= mesh.NbTriangles(); ++i) {
      int a = 0, b = 0, c = 0;
      mesh.Triangle(i).Get(a, b, c);
      triangles_.push_back({a - 1, b - 1, c - 1});
    }
    // Without places in (u, v) nothing can be measured, and the triangles stay.
    for (int cut = 0; cut < kMostCuts && !places_.empty() && halve_sides(); ++cut) {
    }
  }

  CadFace face(bool is_reversed) const {
    CadFace result;
    for (const gp_XYZ& point : points_) result.points.push_back(in_metres(gp_Pnt(point)));
    result.triangles = triangles_;
    if (is_reversed) {
      for (auto& [a, b, c] : result.triangles) std::swap(b, c);
    }
    return result;
  }

 private:
  using Triangle = std::array<int, 3>;
  using Side = std::pair<int, int>;

  // The smaller number first: both triangles of a side find the same one.
  static Side side_of(const Triangle& t, int k) { return std::minmax(t[k], t[(k + 1) % 3]); }

  gp_XYZ on_surface(const gp_XY& uv) const { return surface_.Value(uv.X(), uv.Y()).XYZ(); }

  // Whether any was.
  bool halve_sides() {
    middles_.clear();
    // All are marked before any is divided: a side that is cut for one triangle is cut for its
    // neighbour too, and no gap opens.
    for (const Triangle& t : triangles_) mark(t);
    if (middles_.empty()) return false;
    std::vector<Triangle> finer;
    for (const Triangle& t : triangles_) divide(t, finer);
    triangles_ = std::move(finer);
    return true;
  }

  void mark(const Triangle& t) {
    const gp_XYZ middle = (points_[t[0]] + points_[t[1]] + points_[t[2]]) / 3.0;
    const gp_XY uv = (places_[t[0]] + places_[t[1]] + places_[t[2]]) / 3.0;
    const gp_XYZ normal = (points_[t[1]] - points_[t[0]]).Crossed(points_[t[2]] - points_[t[0]]);
    const double size = normal.Modulus();
    // The distance from the triangle's plane, times the length of its normal; without area there is
    // none.
    const bool is_off =
        size > 0.0 && std::abs((on_surface(uv) - middle).Dot(normal)) > chord_ * size;
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] = side_of(t, k);
      if (is_off || is_side_off(a, b)) middle_of(a, b);
    }
  }

  bool is_side_off(int a, int b) const {
    const gp_XYZ along = points_[b] - points_[a];
    const double length = along.Modulus();
    const gp_XYZ off = on_surface(0.5 * (places_[a] + places_[b])) - points_[a];
    // Likewise from the side's line.
    return length > chord_ && off.Crossed(along).Modulus() > chord_ * length;
  }

  int middle_of(int a, int b) {
    // On the surface, not on the chord: so points are added where the face is.
    const auto [found, is_new] = middles_.try_emplace({a, b}, static_cast<int>(points_.size()));
    if (is_new) {
      places_.push_back(0.5 * (places_[a] + places_[b]));
      points_.push_back(on_surface(places_.back()));
    }
    return found->second;
  }

  // With one, two or three sides halved: fans from a corner that has a halved side opposite, or one
  // in the middle.
  void divide(const Triangle& t, std::vector<Triangle>& out) const {
    std::array<int, 3> m{};
    int count = 0;
    for (int k = 0; k < 3; ++k) {
      const auto found = middles_.find(side_of(t, k));
      // The middle of the side from corner k to the next.
      m[k] = found == middles_.end() ? -1 : found->second;
      count += m[k] >= 0;
    }
    if (count == 3) {
      // Four with the same turn: three at the corners, one of the middles.
      out.insert(out.end(),
                 {{t[0], m[0], m[2]}, {m[0], t[1], m[1]}, {m[2], m[1], t[2]}, {m[0], m[1], m[2]}});
      return;
    }
    if (count == 0) {
      out.push_back(t);
      return;
    }
    // Turned so that side 0 is halved, and side 2 is not.
    int turn = 0;
    while (m[turn] < 0 || m[(turn + 2) % 3] >= 0) ++turn;
    const int a = t[turn], b = t[(turn + 1) % 3], c = t[(turn + 2) % 3];
    const int ab = m[turn], bc = m[(turn + 1) % 3];
    out.push_back({a, ab, c});
    if (bc < 0) {
      out.push_back({ab, b, c});
    } else {
      out.push_back({ab, b, bc});
      out.push_back({ab, bc, c});
    }
  }

  BRepAdaptor_Surface surface_;
  double chord_;
  std::vector<gp_XYZ> points_;
  std::vector<gp_XY> places_;
  std::vector<Triangle> triangles_;
  std::map<Side, int> middles_;  // points that sides are halved at
};

}  // namespace

CadFace face_triangles(const TopoDS_Face& face, const Poly_Triangulation& mesh,
                       const TopLoc_Location& location, double chord) {
  // Triangles lie as the surface has its normal; a face may be turned against that.
  return FinerTriangles(face, mesh, location, chord).face(face.Orientation() == TopAbs_REVERSED);
}

}  // namespace hull::exchange
