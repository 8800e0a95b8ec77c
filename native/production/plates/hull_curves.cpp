// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/plates/hull_curves.h"

#include <cmath>
#include <stdexcept>

#include "production/plates/girth_point.h"
#include "surface/creases/knuckle_angle.h"
#include "surface/queries/ray_hits.h"

namespace hull::production {
namespace {

constexpr int kDeepestSample = 12;

// Samples of a rule that may give no place, as runs of places. Where they begin and end is found by
// halving, to rounding.
class Sampler {
 public:
  using Place = std::optional<CellPlace>;
  using Rule = std::function<Place(double)>;

  Sampler(const surface::LimitSurface& surface, const Rule& rule, double tolerance)
      : surface_(surface), rule_(rule), tolerance_(tolerance) {}

  std::vector<std::vector<CellPlace>> run(const std::vector<double>& parameters) {
    Place last;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      Place next = rule_(parameters[i]);
      if (i > 0 && last && next) between(parameters[i - 1], *last, parameters[i], *next, 0);
      if (i > 0 && last && !next) end(parameters[i - 1], *last, parameters[i]);
      if (i > 0 && !last && next) begin(parameters[i], *next, parameters[i - 1]);
      if (next && !last && i == 0) runs_.push_back({*next});
      last = next;
    }
    return std::move(runs_);
  }

 private:
  Vector3d point(const CellPlace& p) const { return surface_.position(p.cell, p.u, p.v); }

  // Halved until the middle lies on the chord; where the rule has no middle the chord is all there
  // is.
  void between(double a, const CellPlace& at_a, double b, const CellPlace& at_b, int depth) {
    const double m = 0.5 * (a + b);
    const Place middle = depth < kDeepestSample ? rule_(m) : std::nullopt;
    if (middle) {
      const Vector3d p = point(at_a), chord = point(at_b) - p, r = point(*middle) - p;
      const double off = chord.norm() > 0.0 ? r.cross(chord).norm() / chord.norm() : r.norm();
      if (off > 0.5 * tolerance_) {
        between(a, at_a, m, *middle, depth + 1);
        between(m, *middle, b, at_b, depth + 1);
        return;
      }
      runs_.back().push_back(*middle);
    }
    runs_.back().push_back(at_b);
  }

  // The last place on the way from a, where there is one, to b, where there is none.
  std::pair<double, CellPlace> last_place(double a, CellPlace place, double b) const {
    for (int i = 0; i < 60 && a != b; ++i) {
      const double m = 0.5 * (a + b);
      if (m == a || m == b) break;  // no number between them
      if (const Place there = rule_(m)) {
        a = m;
        place = *there;
      } else {
        b = m;
      }
    }
    return {a, place};
  }

  void end(double a, const CellPlace& at_a, double b) {
    const auto [m, place] = last_place(a, at_a, b);
    between(a, at_a, m, place, 0);
  }

  void begin(double b, const CellPlace& at_b, double a) {
    const auto [m, place] = last_place(b, at_b, a);
    // Sought backwards from where the rule has places: there the run begins.
    runs_.push_back({place});
    between(m, place, b, at_b, 0);
  }

  const surface::LimitSurface& surface_;
  const Rule& rule_;
  double tolerance_;
  std::vector<std::vector<CellPlace>> runs_;
};

Vector3d unit(const Vector3d& v, const char* name) {
  if (!v.allFinite() || v.norm() == 0.0) {
    throw std::invalid_argument(std::string(name) + " must be a direction, not (0, 0, 0).");
  }
  return v.normalized();
}

// Whether the surface lies in the planes of a normal there, as a transom does: no section tells a
// way along it.
bool is_across(const surface::LimitSurface& surface, const CellPlace& at, const Vector3d& normal) {
  // Of second order in the angle: 1.4e-6 rad.
  constexpr double kWithinRounding = 1e-12;  // of the cosine
  return std::abs(surface.normal(at.cell, at.u, at.v).dot(normal)) > 1.0 - kWithinRounding;
}

}  // namespace

HullCurves::HullCurves(const surface::LimitSurface& surface, double chord_tolerance)
    : stamp_(surface), chord_tolerance_(chord_tolerance), tree_(surface) {
  if (!(chord_tolerance > 0.0 && std::isfinite(chord_tolerance))) {
    throw std::invalid_argument("The chord tolerance of curves must be a length above 0 m.");
  }
}

std::vector<SurfaceCurve> HullCurves::followed(const std::vector<analysis::SectionCurve>& sections,
                                               const std::string& name) const {
  std::vector<SurfaceCurve> curves;
  for (const auto& section : sections) {
    std::vector<CellPlace> places;
    for (std::size_t i = 0; i < section.points.size(); ++i) {
      places.push_back({section.cells[i], section.uv[i].x(), section.uv[i].y()});
    }
    curves.push_back(joined(surface(), tree_, places, name));
  }
  return curves;
}

std::vector<SurfaceCurve> HullCurves::in_plane(const analysis::Plane& plane,
                                               const std::string& name) const {
  auto curves = followed(analysis::section(surface(), plane, chord_tolerance_), name);
  if (curves.empty()) {
    throw std::invalid_argument("The plane of \"" + name + "\" does not meet the hull.");
  }
  return curves;
}

std::vector<SurfaceCurve> HullCurves::on_cylinder(const Cylinder& cylinder,
                                                  const std::string& name) const {
  if (!(cylinder.radius > 0.0 && std::isfinite(cylinder.radius))) {
    throw std::invalid_argument("The radius of \"" + name + "\" must be a length above 0 m.");
  }
  if (!cylinder.point.allFinite()) {
    throw std::invalid_argument("The point on the axis of \"" + name + "\" is not finite.");
  }
  const Cylinder whole{cylinder.point, unit(cylinder.direction, "direction"), cylinder.radius};
  auto curves = followed(cylinder_curves(surface(), whole, chord_tolerance_, name), name);
  if (curves.empty()) {
    throw std::invalid_argument("The cylinder of \"" + name + "\" does not meet the hull.");
  }
  return curves;
}

std::vector<SurfaceCurve> HullCurves::sampled(const Rule& rule,
                                              const std::vector<double>& parameters,
                                              const std::string& name) const {
  std::vector<SurfaceCurve> curves;
  for (const auto& places : Sampler(surface(), rule, chord_tolerance_).run(parameters)) {
    SurfaceCurve curve = joined(surface(), tree_, places, name);
    if (!curve.empty()) curves.push_back(std::move(curve));
  }
  return curves;
}

std::vector<SurfaceCurve> HullCurves::at_girth(const SurfaceCurve& base, double girth,
                                               const Vector3d& towards, const Vector3d& across,
                                               const std::string& name) const {
  if (!(girth > 0.0 && std::isfinite(girth))) {
    throw std::invalid_argument("The girth of \"" + name + "\" must be a length above 0 m.");
  }
  const Vector3d normal = unit(across, "across"), side = unit(towards, "towards");
  const surface::LimitSurface& surface = this->surface();
  require_on(surface, base);
  std::vector<double> parameters;
  double run = 0.0;
  // How far the base goes across the planes: within one of them all of it would have the same
  // section.
  for (std::size_t k = 0; k < base.points.size(); ++k) {
    parameters.push_back(static_cast<double>(k));
    if (k > 0) run += std::abs(normal.dot(base.points[k] - base.points[k - 1]));
  }
  if (base.empty() || run <= 1e-6 * tree_.size()) {
    throw std::invalid_argument("The curve \"" + base.name +
                                "\" runs in the planes in which the girth of \"" + name +
                                "\" is measured: give another direction across them.");
  }
  const Rule rule = [&](double t) -> Place {
    // The last parameter is the end of the last step.
    const auto k = std::min(static_cast<std::size_t>(t), base.steps.size() - 1);
    const CurveStep& step = base.steps[k];
    const Eigen::Vector2d uv = step.from + (t - static_cast<double>(k)) * (step.to - step.from);
    const Place place = girth_point(surface, {step.cell, uv.x(), uv.y()}, normal, side, girth,
                                    0.1 * chord_tolerance_);
    return place && is_across(surface, *place, normal) ? std::nullopt : place;
  };
  std::vector<SurfaceCurve> curves = sampled(rule, parameters, name);
  if (curves.empty()) {
    throw std::invalid_argument("The hull does not reach " + std::to_string(girth) + " m from \"" +
                                base.name + "\" anywhere: \"" + name + "\" is off the hull.");
  }
  return curves;
}

std::vector<SurfaceCurve> HullCurves::along_rays(
    const std::vector<Vector3d>& points, const std::string& name,
    const std::function<Vector3d(const Vector3d&)>& origin,
    const std::function<Vector3d(const Vector3d&)>& way) const {
  if (points.size() < 2) {
    throw std::invalid_argument("The line of \"" + name + "\" must have two points or more.");
  }
  const Rule rule = [&](double t) -> Place {
    const auto k = std::min(static_cast<std::size_t>(t), points.size() - 2);
    const Vector3d p = points[k] + (t - static_cast<double>(k)) * (points[k + 1] - points[k]);
    const auto hit = surface::first_ray_hit(tree_, {origin(p), way(p)});
    if (!hit) return std::nullopt;
    return CellPlace{hit->cell, hit->u, hit->v};
  };
  // Enough samples that no cell is passed unseen.
  std::vector<double> parameters;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    const double length = (points[k + 1] - points[k]).norm();
    // Bounded before it is a whole number, which may not hold it; what is no number is one part.
    const int parts =
        static_cast<int>(std::min(std::max(1.0, 200.0 * length / tree_.size()), 400.0));
    for (int i = 0; i < parts; ++i) {
      parameters.push_back(static_cast<double>(k) + static_cast<double>(i) / parts);
    }
  }
  parameters.push_back(static_cast<double>(points.size() - 1));
  std::vector<SurfaceCurve> curves = sampled(rule, parameters, name);
  if (curves.empty()) {
    throw std::invalid_argument("The line of \"" + name +
                                "\" misses the hull: no ray from it meets it.");
  }
  return curves;
}

std::vector<SurfaceCurve> HullCurves::projected(const std::vector<Vector3d>& points,
                                                const Vector3d& direction,
                                                const std::string& name) const {
  const Vector3d along = unit(direction, "direction");
  return along_rays(
      points, name, [](const Vector3d& p) { return p; },
      [along](const Vector3d&) { return along; });
}

std::vector<SurfaceCurve> HullCurves::projected_from(const std::vector<Vector3d>& points,
                                                     const Vector3d& centre,
                                                     const std::string& name) const {
  return along_rays(
      points, name, [centre](const Vector3d&) { return centre; },
      [centre](const Vector3d& p) { return unit(p - centre, "a point less the centre"); });
}

SurfaceCurve HullCurves::along(const surface::CreaseCurve& crease, const std::string& name) const {
  std::vector<CellPlace> places;
  // Cells begin at the ends and at the middles of control edges.
  for (int i = 0; i <= 2 * crease.edge_count(); ++i) places.push_back(crease.left(0.5 * i));
  return joined(surface(), tree_, places, name);
}

std::vector<SurfaceCurve> HullCurves::borders() const {
  std::vector<SurfaceCurve> curves;
  for (const surface::CreaseCurve& crease : surface::crease_curves(surface())) {
    if (crease.kind() == surface::CreaseKind::kBorder) curves.push_back(along(crease, "border"));
  }
  return curves;
}

std::vector<SurfaceCurve> HullCurves::knuckles(double least_angle) const {
  if (!(least_angle >= 0.0 && std::isfinite(least_angle))) {
    throw std::invalid_argument("The least angle of knuckles must be an angle, 0 or more.");
  }
  std::vector<SurfaceCurve> curves;
  for (const surface::CreaseCurve& crease : surface::crease_curves(surface())) {
    if (crease.kind() == surface::CreaseKind::kBorder) continue;
    double largest = 0.0;
    for (int i = 0; i < 4 * crease.edge_count(); ++i) {
      // Off the edges' ends, where there may be no normal.
      const double angle = surface::knuckle_angle(surface(), crease, 0.25 * i + 0.125);
      if (std::isfinite(angle)) largest = std::max(largest, std::abs(angle));
    }
    if (largest > least_angle) curves.push_back(along(crease, "knuckle"));
  }
  return curves;
}

}  // namespace hull::production
