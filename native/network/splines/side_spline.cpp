// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/splines/side_spline.h"

namespace hull::network {

EdgeSplines edge_splines(const NetworkFrame& frame, double tolerance) {
  EdgeSplines splines;
  for (std::size_t e = 0; e < frame.shapes.size(); ++e) {
    const EdgeShape& shape = frame.shapes[e];
    splines.fitted.push_back(
        fitted_spline([&](double u) { return shape.evaluate(u, 1); }, tolerance));
    // But for rounding they are there: now all splines at a node have its place bit for bit.
    auto& points = splines.fitted.back().curve.points;
    points.front() = frame.joined.nodes[static_cast<std::size_t>(frame.joined.edges[e].from)];
    points.back() = frame.joined.nodes[static_cast<std::size_t>(frame.joined.edges[e].to)];
  }
  return splines;
}

Vector3d EdgeSplines::place(const NetworkFrame& frame, int edge, double t) const {
  const auto at = static_cast<std::size_t>(edge);
  const CurveEdge& ends = frame.joined.edges[at];
  if (t <= 0.0) return frame.joined.nodes[static_cast<std::size_t>(ends.from)];
  if (t >= 1.0) return frame.joined.nodes[static_cast<std::size_t>(ends.to)];
  return fitted[at].curve.position(t);
}

SideSpline::SideSpline(std::shared_ptr<const NetworkFrame> frame, const EdgeSplines& splines,
                       const RegionSide& side)
    : frame_(std::move(frame)), parts_(*frame_, side) {
  std::vector<BSplineCurve> parts;
  for (const RegionEdge& edge : side) {
    const BSplineCurve& curve = splines.fitted[static_cast<std::size_t>(edge.edge)].curve;
    parts.push_back(edge.is_along ? curve : curve.reversed());
  }
  curve_ = strung_together(parts, parts_.ends());
}

Vector3d SideSpline::normal(double t) const {
  const auto [edge, parameter] = parts_.at(t);
  const auto& fields = edge.is_along ? frame_->normals.left : frame_->normals.right;
  const Vector3d field = fields[static_cast<std::size_t>(edge.edge)].at(parameter).normal;
  // Of the spline, which is off the curve's by what the fit leaves: patches have the spline as
  // border.
  const Vector3d tangent = Vector3d(spline_jet(curve_, t).row(1)).normalized();
  return (field - field.dot(tangent) * tangent).normalized();
}

}  // namespace hull::network
