// SPDX-License-Identifier: GPL-3.0-or-later
#include "exchange/solids/trimmed_face.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2d_Curve.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "analysis/arithmetic/gauss.h"
#include "exchange/occt_geometry.h"

namespace hull::exchange {
namespace {

constexpr double kSmall = 1e-11;  // of the whole: what halving may change
constexpr int kMostHalvings = 24;
constexpr int kInner = 8, kOuter = 8;
constexpr int kSamples = 8;      // of a piece of a border, to find where it crosses spans
constexpr int kLeastPieces = 8;  // of a surface without spans, as a cylinder

struct Integrals {
  double area = 0.0, volume = 0.0;  // mm², mm³

  Integrals& add(const Integrals& other, double factor) {
    area += factor * other.area;
    volume += factor * other.volume;
    return *this;
  }
  double difference(const Integrals& other, const Integrals& whole) const {
    return std::max(std::abs(area - other.area) / whole.area,
                    std::abs(volume - other.volume) / whole.volume);
  }
};

template <class Adaptor>
std::vector<double> spans(int count, const Adaptor& fill) {
  TColStd_Array1OfReal places(1, count + 1);
  fill(places);
  std::vector<double> found(places.begin(), places.end());
  // Few spans, as the one of a cylinder, are divided until there are about eight.
  const int parts = std::max(1, (kLeastPieces + count - 1) / count);
  std::vector<double> finer{found.front()};
  for (std::size_t i = 0; i + 1 < found.size(); ++i) {
    for (int k = 1; k <= parts; ++k) {
      finer.push_back(found[i] + (found[i + 1] - found[i]) * k / parts);
    }
  }
  return finer;
}

// A border's line in (u, v).
struct BorderLine {
  Geom2dAdaptor_Curve curve;
  double begin, end;
  bool is_reversed;
};

class TrimmedFace {
 public:
  explicit TrimmedFace(const TopoDS_Face& face) : face_(face), surface_(face, Standard_True) {
    // Smooth without end within, as Gauss' rule needs it.
    us_ = spans(surface_.NbUIntervals(GeomAbs_CN),
                [&](TColStd_Array1OfReal& at) { surface_.UIntervals(at, GeomAbs_CN); });
    vs_ = spans(surface_.NbVIntervals(GeomAbs_CN),
                [&](TColStd_Array1OfReal& at) { surface_.VIntervals(at, GeomAbs_CN); });
    // Inner integrals go along the direction of fewer spans.
    along_ = us_.size() <= vs_.size() ? 0 : 1;
  }

  std::optional<conversion::SurfaceIntegrals> integrals() {
    std::vector<std::pair<BorderLine, std::vector<double>>> borders;
    for (TopExp_Explorer it(face_, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(it.Current());
      double begin = 0.0, end = 0.0;
      const Handle(Geom2d_Curve) line = BRep_Tool::CurveOnSurface(edge, face_, begin, end);
      if (line.IsNull()) return std::nullopt;
      BorderLine border{Geom2dAdaptor_Curve(line, begin, end), begin, end,
                        edge.Orientation() == TopAbs_REVERSED};
      std::vector<double> places = pieces_of(border);
      borders.emplace_back(std::move(border), std::move(places));
    }
    Integrals whole;
    std::vector<Integrals> first;
    for (const auto& [border, places] : borders) {
      for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        first.push_back(along(border, places[i], places[i + 1]));
        // By size, so that parts which cancel one another do not make the whole small, and the
        // tolerance with it.
        whole.area += std::abs(first.back().area);
        whole.volume += std::abs(first.back().volume);
      }
    }
    if (!(whole.area > 0.0)) return conversion::SurfaceIntegrals{};
    // It is divided by, and may be nothing, as of a plane through the origin.
    whole.volume = std::max(whole.volume, 1e-12 * std::pow(whole.area, 1.5));
    Integrals sum;
    std::size_t next = 0;
    for (const auto& [border, places] : borders) {
      for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        const Integrals own = refined(border, places[i], places[i + 1], first[next++], whole, 0);
        sum.add(own, border.is_reversed ? -1.0 : 1.0);
      }
    }
    // ∮ G dv runs round an area as ∫∫ ∂G/∂u du dv, and - ∮ G du as ∫∫ ∂G/∂v du dv.
    const double sense = along_ == 0 ? 1.0 : -1.0;
    return conversion::SurfaceIntegrals{sense * sum.area / std::pow(kMillimetresPerMetre, 2),
                                        sense * sum.volume / std::pow(kMillimetresPerMetre, 3)};
  }

 private:
  // Places on a border between which it crosses no span of the surface.
  std::vector<double> pieces_of(const BorderLine& border) const {
    TColStd_Array1OfReal own(1, border.curve.NbIntervals(GeomAbs_CN) + 1);
    border.curve.Intervals(own, GeomAbs_CN);
    std::vector<double> places(own.begin(), own.end());
    // What is added below is not to be gone through.
    const std::size_t count = places.size();
    for (std::size_t i = 0; i + 1 < count; ++i) {
      const double step = (places[i + 1] - places[i]) / kSamples;
      for (int k = 0; k < kSamples; ++k) {
        const double from = places[i] + k * step;
        add_crossings(border, from, from + step, 0, us_, places);
        add_crossings(border, from, from + step, 1, vs_, places);
      }
    }
    std::ranges::sort(places);
    const double least = 1e-12 * std::abs(border.end - border.begin);
    std::vector<double> apart;
    for (double place : places) {
      // Corners of spans are crossed in both directions, at one place but for rounding.
      if (apart.empty() || place - apart.back() > least) apart.push_back(place);
    }
    return apart;
  }

  static double coordinate(const BorderLine& border, double t, int axis) {
    const gp_Pnt2d p = border.curve.Value(t);
    return axis == 0 ? p.X() : p.Y();
  }

  static void add_crossings(const BorderLine& border, double from, double to, int axis,
                            const std::vector<double>& spans, std::vector<double>& places) {
    const double a = coordinate(border, from, axis), b = coordinate(border, to, axis);
    // A line that crosses a span and comes back within a sample is missed: then only the halving
    // takes longer.
    const auto low = std::ranges::upper_bound(spans, std::min(a, b));
    for (auto at = low; at != spans.end() && *at < std::max(a, b); ++at) {
      double below = from, above = to;
      // To the last bit of a double.
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (below + above);
        const bool is_before = (coordinate(border, middle, axis) < *at) == (a < b);
        (is_before ? below : above) = middle;
      }
      places.push_back(below);
    }
  }

  Integrals density(double u, double v) const {
    gp_Pnt p;
    gp_Vec du, dv;
    surface_.D1(u, v, p, du, dv);
    const gp_Vec normal = du.Crossed(dv);
    // The divergence theorem, with p / 3 as the field.
    return {normal.Magnitude(), gp_Vec(p.XYZ()).Dot(normal) / 3.0};
  }

  // From the first span to a point, along u or v.
  Integrals inner(const gp_Pnt2d& to) const {
    static const analysis::GaussRule rule = analysis::gauss_rule(kInner);
    const std::vector<double>& places = along_ == 0 ? us_ : vs_;
    const double end = along_ == 0 ? to.X() : to.Y();
    Integrals sum;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      const bool is_last = i + 2 == places.size();
      // The first span and the last one go on beyond the surface's range, where borders may lie by
      // rounding.
      if (places[i] >= end && i > 0) break;
      const double stop = is_last ? end : std::min(end, places[i + 1]), width = stop - places[i];
      for (int k = 0; k < kInner; ++k) {
        const double at = places[i] + width * rule.nodes[k];
        sum.add(along_ == 0 ? density(at, to.Y()) : density(to.X(), at), width * rule.weights[k]);
      }
    }
    return sum;
  }

  Integrals along(const BorderLine& border, double from, double to) const {
    static const analysis::GaussRule rule = analysis::gauss_rule(kOuter);
    Integrals sum;
    for (int k = 0; k < kOuter; ++k) {
      gp_Pnt2d p;
      gp_Vec2d slope;
      border.curve.D1(from + (to - from) * rule.nodes[k], p, slope);
      const double step = along_ == 0 ? slope.Y() : slope.X();
      // Along the inner direction nothing is swept, and the inner integral, which costs the most,
      // is spared.
      if (step != 0.0) sum.add(inner(p), (to - from) * rule.weights[k] * step);
    }
    return sum;
  }

  Integrals refined(const BorderLine& border, double from, double to, const Integrals& known,
                    const Integrals& whole, int depth) const {
    // A line along the inner direction: halving finds nothing either.
    if (known.area == 0.0 && known.volume == 0.0) return known;
    const double middle = 0.5 * (from + to);
    Integrals low = along(border, from, middle), high = along(border, middle, to);
    Integrals sum = low;
    sum.add(high, 1.0);
    // Compared as a part of the whole face: small pieces need not be exact in themselves.
    if (depth >= kMostHalvings || !(sum.difference(known, whole) > kSmall)) return sum;
    Integrals better = refined(border, from, middle, low, whole, depth + 1);
    return better.add(refined(border, middle, to, high, whole, depth + 1), 1.0);
  }

  TopoDS_Face face_;
  BRepAdaptor_Surface surface_;
  std::vector<double> us_, vs_;
  int along_;
};

}  // namespace

std::optional<conversion::SurfaceIntegrals> of_trimmed_face(const TopoDS_Face& face) {
  return TrimmedFace(TopoDS::Face(face.Oriented(TopAbs_FORWARD))).integrals();
}

}  // namespace hull::exchange
