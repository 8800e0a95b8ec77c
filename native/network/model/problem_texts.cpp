// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/model/problem_texts.h"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <set>

namespace hull::network {
namespace {

using ProblemKind = NetworkProblem::Kind;

std::string listed(const std::vector<int>& curves, const std::vector<std::string>& names) {
  std::string all;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const char* before = i == 0 ? "" : i + 1 == curves.size() ? " and " : ", ";
    all += before + names[static_cast<std::size_t>(curves[i])];
  }
  return all;
}

std::string degrees_text(double angle) {
  char text[40];
  std::snprintf(text, sizeof text, "%.2f°", angle * 180.0 / std::numbers::pi);
  return text;
}

}  // namespace

std::vector<NetworkProblem> points_off_plane(const CurveDefinition& definition, int curve,
                                             double tolerance) {
  std::vector<NetworkProblem> off;
  if (!definition.plane) return off;
  // A plane without a normal is told with the curve's shape.
  const double length = definition.plane->normal.norm();
  for (std::size_t i = 0; i < definition.points.size() && length > 0.0; ++i) {
    const Vector3d& point = definition.points[i];
    const double distance =
        std::abs(definition.plane->normal.dot(point) - definition.plane->distance) / length;
    if (!(distance > tolerance)) continue;
    off.push_back({ProblemKind::kOffPlane,
                   "Point " + std::to_string(i) + " of curve " + definition.name + ", at " +
                       place_text(point) + ", is " + length_text(distance) +
                       " off the curve's plane: move it there, or let the curve be free.",
                   {curve},
                   {point}});
  }
  return off;
}

NetworkProblem wrong_order(const JoinedCurves& joined, const std::vector<EdgeShape>& shapes,
                           const std::vector<std::string>& names, const std::vector<int>& edges) {
  NetworkProblem problem{ProblemKind::kWrongOrder, "", {}, {}};
  std::set<int> curves;
  for (int edge : edges) {
    curves.insert(joined.edges[static_cast<std::size_t>(edge)].curve);
    // The middle: at its nodes an edge is not to be told from others.
    problem.places.emplace_back(shapes[static_cast<std::size_t>(edge)].evaluate(0.5, 0).row(0));
  }
  problem.curves.assign(curves.begin(), curves.end());
  problem.what =
      "Curve " + listed(problem.curves, names) + " passes beneath others near " +
      place_text(problem.places.front()) +
      ": the curves around it do not lie on one surface in any order. Remove it, or join "
      "it to those that it crosses.";
  return problem;
}

NetworkProblem halt(int curve, const Vector3d& place, const std::vector<std::string>& names) {
  return {ProblemKind::kHalt,
          "Curve " + names[static_cast<std::size_t>(curve)] + " turns back near " +
              place_text(place) +
              ", so that it has no direction there: move a point, or make one a knuckle.",
          {curve},
          {place}};
}

NetworkProblem short_edge(int curve, const Vector3d& from, const Vector3d& to, double length,
                          const std::vector<std::string>& names) {
  return {ProblemKind::kShortEdge,
          "Curve " + names[static_cast<std::size_t>(curve)] +
              " meets others, or has a knuckle, at " + place_text(from) + " and again " +
              length_text(length) + " further, at " + place_text(to) +
              ": bring the curves there to one point, or have them joined within a larger "
              "tolerance.",
          {curve},
          {from, to}};
}

NetworkProblem no_tangent_plane(const Vector3d& place, double deviation, std::vector<int> curves,
                                const std::vector<std::string>& names) {
  const std::string what =
      "At " + place_text(place) + " the tangents of " + listed(curves, names) + " are up to " +
      degrees_text(deviation) +
      " off a common plane, and no knuckle along one of them explains it: bring the tangents into "
      "a plane, or make a curve there a knuckle.";
  return {ProblemKind::kNoTangentPlane, what, std::move(curves), {place}};
}

NetworkProblem wrong_sides(const std::vector<Vector3d>& corners, std::vector<int> curves,
                           const std::vector<std::string>& names) {
  const bool is_many = corners.size() > 2;
  const std::string what =
      "The region between " + listed(curves, names) + ", with a corner at " +
      place_text(corners.front()) + ", has " + std::to_string(corners.size()) +
      (is_many ? " sides, and ten are the most: divide it by a curve."
               : " side, and two are the least: end a curve within it, or divide it.");
  return {is_many ? ProblemKind::kManySides : ProblemKind::kFewSides, what, std::move(curves),
          corners};
}

NetworkProblem tee(const Vector3d& place, int ending, int passing,
                   const std::vector<std::string>& names) {
  return {
      ProblemKind::kTee,
      "Curve " + names[static_cast<std::size_t>(ending)] + " ends at " + place_text(place) +
          " on " + names[static_cast<std::size_t>(passing)] +
          ", beyond which it does not go on: the surface there is led by the other curves only. "
          "Where that shows, lengthen it.",
      {ending, passing},
      {place}};
}

}  // namespace hull::network
