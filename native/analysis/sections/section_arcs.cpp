// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/sections/section_arcs.h"

#include <Eigen/Geometry>
#include <cmath>

#include "analysis/sections/arc_sampling.h"
#include "analysis/sections/arc_square.h"

namespace hull::analysis {
namespace {

// A place on a piece, and the jets there.
struct Place {
  double u, v;
  surface::SurfaceJet jet;
  HeightJet g;
};

class PieceArcs {
 public:
  PieceArcs(const surface::SurfacePiece& piece, const HeightNet& height, const Plane& plane,
            double chord_tolerance, double zero, SectionParts& parts)
      : piece_(piece),
        height_(height),
        normal_(plane.normal),
        chord_tolerance_(chord_tolerance),
        zero_(zero),
        parts_(parts) {}

  void add_simple(const NetSquare& square, bool swapped);
  void add_tangled(const NetSquare& square);

  SectionPoint point(double u, double v) const {
    Place place;
    return point(u, v, place);
  }
  SectionPoint point(double u, double v, Place& place) const {
    place.u = u;
    place.v = v;
    surface::evaluate_bicubic(piece_.points, u, v, 2, place.jet);
    // What is left of a height that was divided has slopes of its own.
    if (height_.divided) {
      place.g = height_jet(height_.net, u, v);
    } else {
      const surface::SurfaceJet& jet = place.jet;
      place.g = {normal_.dot(jet.du), normal_.dot(jet.dv), normal_.dot(jet.duu),
                 normal_.dot(jet.duv), normal_.dot(jet.dvv)};
    }
    SectionPoint p;
    p.point = place.jet.point;
    p.cell = piece_.cell;
    p.uv = {piece_.u + piece_.size * u, piece_.v + piece_.size * v};
    set_course(place.jet, place.g, normal_, p);
    return p;
  }

 private:
  void close_arc(std::size_t first);

  const surface::SurfacePiece& piece_;
  const HeightNet& height_;
  const Vector3d& normal_;
  double chord_tolerance_, zero_;
  SectionParts& parts_;
};

// The zeros of a simple square as a curve over its u (after the exchange, if swapped).
class ZeroCurve {
 public:
  ZeroCurve(const PieceArcs& piece, const NetSquare& square, bool swapped)
      : piece_(piece), square_(square), swapped_(swapped) {}

  ArcSample at(double t) const {
    const Column column(square_.net, BernsteinBasis(t));
    return at(t, monotonic_root(column.c));
  }
  ArcSample at(double t, double across) const {
    const double u = square_.u + square_.size * (swapped_ ? across : t);
    const double v = square_.v + square_.size * (swapped_ ? t : across);
    Place place;
    ArcSample sample{piece_.point(u, v, place), Vector3d::Zero()};
    // Of the function that is implied by g = 0: dv/du = -g_u / g_v.
    const auto slope = [](double along, double over) { return over != 0.0 ? -along / over : 0.0; };
    sample.d1 =
        square_.size * (swapped_ ? place.jet.dv + slope(place.g.v, place.g.u) * place.jet.du
                                 : place.jet.du + slope(place.g.u, place.g.v) * place.jet.dv);
    return sample;
  }

 private:
  const PieceArcs& piece_;
  const NetSquare& square_;
  bool swapped_;
};

// Where zeros enter or leave a simple square.
struct ArcEnd {
  double t, across;  // across < 0: inside, to be found
  bool operator<(const ArcEnd& other) const { return t < other.t; }
  bool operator==(const ArcEnd& other) const { return t == other.t; }
};
using Ends = SmallList<ArcEnd, 8>;

Ends ends_of(const BezierNet& net) {
  Ends ends;
  for (const double across : {0.0, 1.0}) {
    const double* row = net.data() + (across > 0.0 ? 12 : 0);
    // Coefficients of one sign: no root has to be looked for.
    if (row[0] >= 0.0 && row[1] >= 0.0 && row[2] >= 0.0 && row[3] >= 0.0) continue;
    if (row[0] < 0.0 && row[1] < 0.0 && row[2] < 0.0 && row[3] < 0.0) continue;
    for (const double t : sign_changes({row[0], row[1], row[2], row[3]})) {
      ends.insert({t, across});
    }
  }
  if (ends.empty() || ends.front().t > 0.0) ends.insert({0.0, -1.0});
  if (ends[ends.size() - 1].t < 1.0) ends.insert({1.0, -1.0});
  return ends;
}

void PieceArcs::add_simple(const NetSquare& square, bool swapped) {
  const BezierNet& net = square.net;
  const ZeroCurve curve(*this, square, swapped);
  const auto at_end = [&](const ArcEnd& end) {
    // On a side the place is known: a root found anew would be off it by rounding.
    return end.across < 0.0 ? curve.at(end.t) : curve.at(end.t, end.across);
  };
  const Ends ends = ends_of(net);
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const double middle = 0.5 * (ends[k].t + ends[k + 1].t);
    const Column column(net, BernsteinBasis(middle));
    // Between two ends there is a zero for all t or for none.
    if ((column.c[0] < 0.0) == (column.c[3] < 0.0)) continue;
    const std::size_t first = parts_.points.size();
    sample_arc(curve, ends[k].t, at_end(ends[k]), ends[k + 1].t, at_end(ends[k + 1]),
               chord_tolerance_, parts_.points);
    // What is above is to be on the left. Along rising u that is where v is larger, along rising v
    // where u is smaller.
    const bool rises = column.c[3] > column.c[0];
    // Its tangents already are those of the right direction.
    if (rises == swapped) {
      std::reverse(parts_.points.begin() + static_cast<std::ptrdiff_t>(first), parts_.points.end());
    }
    close_arc(first);
  }
}

void PieceArcs::add_tangled(const NetSquare& square) {
  const SideCrossings crossings = side_crossings(square.net);
  for (const auto& [enters, leaves] : pair_crossings(square.net, crossings)) {
    const std::size_t first = parts_.points.size();
    for (const int i : {enters, leaves}) {
      parts_.points.push_back(
          point(square.u + square.size * crossings[i].u, square.v + square.size * crossings[i].v));
    }
    close_arc(first);
  }
}

// Where the course is not defined, that of the chord is taken. What only nicks the corner of a
// square is no arc.
void PieceArcs::close_arc(std::size_t first) {
  std::vector<SectionPoint>& points = parts_.points;
  const std::size_t last = points.size();
  const double nick = 10.0 * zero_;
  if (last - first == 2 && (points[first].point - points[first + 1].point).norm() < nick) {
    points.resize(first);
    return;
  }
  for (std::size_t i = first; i < last; ++i) {
    if (!points[i].tangent.isZero(0.0)) continue;
    const Vector3d chord = i + 1 < last ? Vector3d(points[i + 1].point - points[i].point)
                                        : Vector3d(points[i].point - points[i - 1].point);
    if (chord.norm() > 0.0) points[i].tangent = chord.normalized();
  }
  parts_.arcs.push_back(
      {static_cast<int>(first), static_cast<int>(last), SectionArc::Sense::kDirected, false});
}

}  // namespace

void set_course(const surface::SurfaceJet& jet, const HeightJet& g, const Vector3d& plane_normal,
                SectionPoint& p) {
  const double steepness = g.u * g.u + g.v * g.v;
  if (steepness == 0.0) return;
  const double wu = g.v, wv = -g.u;
  // It is in the plane but for what was taken for rounding.
  const Vector3d along = wu * jet.du + wv * jet.dv;
  const Vector3d d1 = along - plane_normal.dot(along) * plane_normal;
  const double speed = d1.norm();
  if (!(speed > 1e-12 * std::sqrt(steepness) * (jet.du.norm() + jet.dv.norm()))) return;
  p.tangent = d1 / speed;
  // The second derivative of (u, v) along the gradient keeps g at zero.
  const double bend = -(g.uu * wu * wu + 2.0 * g.uv * wu * wv + g.vv * wv * wv) / steepness;
  const Vector3d d2 = wu * wu * jet.duu + 2.0 * wu * wv * jet.duv + wv * wv * jet.dvv +
                      bend * (g.u * jet.du + g.v * jet.dv);
  p.curvature = plane_normal.dot(d1.cross(d2)) / (speed * speed * speed);
}

void add_section_arcs(const surface::SurfacePiece& piece, const HeightNet& height,
                      const Plane& plane, double chord_tolerance, double zero, NetCut& cut,
                      SectionParts& parts) {
  cut.divide(height.net);
  PieceArcs arcs(piece, height, plane, chord_tolerance, zero, parts);
  for (const NetCut::Part& part : cut.parts) {
    if (part.shape == NetCut::Shape::kTangled) {
      arcs.add_tangled(part.square);
    } else {
      arcs.add_simple(part.square, part.shape == NetCut::Shape::kSimpleSwapped);
    }
  }
}

}  // namespace hull::analysis
