// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/cylinder_curves.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/arithmetic/bracketed_root.h"
#include "analysis/sections/arc_sampling.h"
#include "analysis/sections/cell_boxes.h"
#include "analysis/sections/section_curves.h"
#include "analysis/sections/section_spots.h"
#include "mesh/tolerances.h"
#include "production/developable/bernstein.h"

namespace hull::production {
namespace {

using analysis::ArcSample;
using analysis::SectionArc;
using analysis::SectionParts;
using surface::BezierPatch;
using surface::PatchPart;

constexpr double kTouchingCylinder = 1e-6;  // of the size: parts as small as this are not divided
constexpr int kMostCylinderParts = 20000;   // of one piece: of a curve of touching points

// The curve in a part of a piece, as a graph over u, or over v, by unit parameters of the part.
class GraphInPart {
 public:
  GraphInPart(const surface::SurfacePiece& piece, const CylinderFrame& frame,
              const BezierPatch& seen, const PatchPart& part, bool swapped)
      : piece_(piece), frame_(frame), seen_(seen), part_(part), swapped_(swapped) {}

  // Positive outside the cylinder, in square metres.
  double value(double t, double w) const {
    surface::SurfaceJet jet;
    const Vector2d at = local(t, w);
    surface::evaluate_first(seen_, at.x(), at.y(), jet);
    return jet.point.head<2>().squaredNorm() - frame_.radius() * frame_.radius();
  }
  // Of the graph at t: the place between w = 0 and 1; without a change of sign the end that is
  // nearer.
  ArcSample at(double t) const {
    const double low = value(t, 0.0), high = value(t, 1.0);
    if ((low > 0.0) == (high > 0.0)) return at(t, std::abs(low) <= std::abs(high) ? 0.0 : 1.0);
    const auto along = [&](double w) { return value(t, w); };
    return at(t, analysis::bracketed_root(along, 0.0, low, 1.0, high, 1e-16));
  }
  ArcSample at(double t, double w) const {
    const Vector2d own = local(t, w);
    surface::SurfaceJet jet;
    surface::evaluate_first(seen_, own.x(), own.y(), jet);
    const Vector3d& along = swapped_ ? jet.dv : jet.du;
    const Vector3d& aside = swapped_ ? jet.du : jet.dv;
    const Eigen::Vector2d out = jet.point.head<2>();
    const double slope = out.dot(aside.head<2>());
    // Implicit differentiation: along the curve the distance from the axis does not change.
    const double turn = slope != 0.0 ? -out.dot(along.head<2>()) / slope : 0.0;
    ArcSample sample;
    sample.d1 = frame_.unseen(along + turn * aside);
    sample.p.tangent = sample.d1.normalized();
    sample.p.cell = piece_.cell;
    // From the part to the piece, from the piece to the cell.
    sample.p.uv = {piece_.u + piece_.size * (part_.u + part_.du * own.x()),
                   piece_.v + piece_.size * (part_.v + part_.dv * own.y())};
    sample.p.point = frame_.origin() + frame_.unseen(jet.point);
    return sample;
  }

 private:
  Vector2d local(double t, double w) const { return swapped_ ? Vector2d(w, t) : Vector2d(t, w); }

  const surface::SurfacePiece& piece_;
  const CylinderFrame& frame_;
  const BezierPatch& seen_;
  const PatchPart& part_;
  bool swapped_;
};

class CylinderCutter {
 public:
  CylinderCutter(const surface::LimitSurface& surface, const Cylinder& cylinder,
                 double chord_tolerance, const std::string& name)
      : surface_(surface),
        frame_(cylinder),
        size_(surface.mesh().size()),
        chord_tolerance_(chord_tolerance),
        name_(name) {}

  SectionParts run() {
    const analysis::CellBoxes boxes(surface_);
    const auto descend = [&](const surface::CornerSquare& square) { return wants(square); };
    const auto take = [&](const surface::SurfacePiece& piece) { add_piece(piece); };
    for (int cell = 0; cell < surface_.cell_count(); ++cell) {
      // Seen along the axis the cell is within a box, and the cylinder a circle.
      Eigen::AlignedBox2d box;
      for (int k = 0; k < 2; ++k) {
        const Vector3d across = frame_.across(k);
        const double middle = across.dot(frame_.origin());
        box.min()[k] = boxes.least(cell, across) - middle;
        box.max()[k] = boxes.most(cell, across) - middle;
      }
      if (may_cut(box)) surface::for_each_piece(surface_, cell, descend, take);
    }
    return std::move(parts_);
  }

 private:
  bool may_cut(const Eigen::AlignedBox2d& box) const {
    const auto [least, most] = frame_.distances(box);
    const double slack = kZeroHeight * size_;
    return least <= frame_.radius() + slack && most >= frame_.radius() - slack;
  }

  bool wants(const surface::CornerSquare& square) {
    Eigen::AlignedBox2d box;
    for (const Vector3d& p : square.points()) box.extend(frame_.seen(p).head<2>());
    if (!may_cut(box)) return false;
    const double extent = square.extent();
    if (extent > kSmallestCorner * size_) return true;
    // A square at an irregular corner as small as that is a spot, where the curve's arcs end.
    const auto outside = [this](const Vector3d& p) {
      return frame_.seen(p).head<2>().norm() - frame_.radius();
    };
    parts_.spots.push_back(analysis::spot_of(surface_, square, extent, outside));
    return false;
  }

  void add_piece(const surface::SurfacePiece& piece) {
    left_ = kMostCylinderParts;
    divide(piece, frame_.seen(piece.points), {});
  }

  void divide(const surface::SurfacePiece& piece, const BezierPatch& seen, const PatchPart& part) {
    // A height h off the cylinder makes 2 r h in the squares of the distance.
    const CylinderField field(seen, frame_.radius(), 2.0 * frame_.radius() * kZeroHeight * size_);
    // Zero is inside, as sign_changes() has it, so that parts beside one another agree.
    if (field.lowest() > 0.0 || field.highest() <= 0.0) return;
    // Where the field rises strictly along an axis there is one point of the curve at most for each
    // value of the other one: a graph.
    for (const int axis : {1, 0}) {
      const auto [low, high] = field.slopes(axis);
      // At a grazing angle the place along the axis would not be certain.
      const double grazing = 1e-3 * std::max(std::abs(low), std::abs(high));
      if (low > grazing || high < -grazing) {
        return add_arcs(field, GraphInPart(piece, frame_, seen, part, axis == 0), axis, low > 0.0);
      }
    }
    if (--left_ < 0 || seen.box().diagonal().norm() < kTouchingCylinder * size_) refuse(seen);
    // Across the longer side, so that parts stay about square.
    const int axis = part.du >= part.dv ? 0 : 1;
    BezierPatch low, high;
    seen.split(axis, low, high);
    divide(piece, low, part.half(axis, 0));
    divide(piece, high, part.half(axis, 1));
  }

  // `rises`: outside is where the axis' parameter is greater.
  void add_arcs(const CylinderField& field, const GraphInPart& graph, int axis, bool rises) {
    struct Break {
      double t;
      int end;  // of the axis' parameter there, or -1
    };
    // The curve comes and goes where it passes a side across the graph: between two such places it
    // is there all along, or nowhere.
    std::vector<Break> breaks{{0.0, -1}};
    for (const int end : {0, 1}) {
      const auto side = field.side(axis, end);
      for (double t : sign_changes({side.begin(), side.end()})) breaks.push_back({t, end});
    }
    breaks.push_back({1.0, -1});
    std::stable_sort(breaks.begin(), breaks.end(),
                     [](const Break& a, const Break& b) { return a.t < b.t; });
    const auto sample = [&](const Break& at) {
      return at.end < 0 ? graph.at(at.t) : graph.at(at.t, at.end);
    };
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      const Break &a = breaks[i], &b = breaks[i + 1];
      const double middle = 0.5 * (a.t + b.t);
      if (!(a.t < middle && middle < b.t)) continue;
      if ((graph.value(middle, 0.0) > 0.0) == (graph.value(middle, 1.0) > 0.0)) continue;
      const int first = static_cast<int>(parts_.points.size());
      analysis::sample_arc(graph, a.t, sample(a), b.t, sample(b), chord_tolerance_, parts_.points);
      // The outside is to be left of the curve: v rises to the left of u, u to the right of v.
      if (rises == (axis == 0)) analysis::reverse_points(parts_.points, first);
      parts_.arcs.push_back(
          {first, static_cast<int>(parts_.points.size()), SectionArc::Sense::kDirected});
    }
  }

  [[noreturn]] void refuse(const BezierPatch& seen) const {
    const Vector3d p = frame_.origin() + frame_.unseen(seen.point(0));
    throw std::invalid_argument(
        "The cylinder of \"" + name_ + "\" touches the hull at (" + std::to_string(p.x()) + ", " +
        std::to_string(p.y()) + ", " + std::to_string(p.z()) +
        ") m, so that it is not certain where it cuts it: move it or change its radius.");
  }

  const surface::LimitSurface& surface_;
  CylinderFrame frame_;
  double size_, chord_tolerance_;
  const std::string& name_;
  SectionParts parts_;
  int left_ = 0;
};

}  // namespace

std::vector<analysis::SectionCurve> cylinder_curves(const surface::LimitSurface& surface,
                                                    const Cylinder& cylinder,
                                                    double chord_tolerance,
                                                    const std::string& name) {
  return analysis::section_curves(surface,
                                  CylinderCutter(surface, cylinder, chord_tolerance, name).run());
}

}  // namespace hull::production
