// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/splines/border_plate.h"

#include <algorithm>
#include <cmath>

namespace hull::network {
namespace {

constexpr double kLeastUp = 0.25;  // of unit normals along the mean one

// r⁵, its slope, and how that changes along a direction.
double radial5(const Vector2d& d) {
  const double square = d.squaredNorm();
  return square * square * std::sqrt(square);
}
Vector2d radial5_slope(const Vector2d& d) {
  const double square = d.squaredNorm();
  return 5.0 * square * std::sqrt(square) * d;
}
Vector2d radial5_bend(const Vector2d& d, const Vector2d& way) {
  const double r = d.norm();
  return 5.0 * r * r * r * way + 15.0 * r * d.dot(way) * d;
}
double radial3(const Vector2d& d) { return d.squaredNorm() * d.norm(); }
Vector2d radial3_slope(const Vector2d& d) { return 3.0 * d.norm() * d; }

using Polynomials = Eigen::Matrix<double, 6, 1>;

Polynomials polynomials(const Vector2d& p) {
  return Polynomials{1.0, p.x(), p.y(), p.x() * p.x(), p.x() * p.y(), p.y() * p.y()};
}
Polynomials polynomial_slopes(const Vector2d& p, const Vector2d& way) {
  return Polynomials{0.0,
                     way.x(),
                     way.y(),
                     2.0 * p.x() * way.x(),
                     p.y() * way.x() + p.x() * way.y(),
                     2.0 * p.y() * way.y()};
}

Vector2d centroid(const std::vector<Vector2d>& polygon) {
  Vector2d sum = Vector2d::Zero();
  double area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    // Triangles with the origin, by their signed areas: the polygon may be hollow.
    const double twice = cross(a, b);
    sum += twice / 3.0 * (a + b);
    area += twice;
  }
  return sum / area;
}

}  // namespace

std::optional<BorderPlate> BorderPlate::within(const std::vector<PlateSample>& border,
                                               bool has_normals) {
  BorderPlate plate;
  plate.has_normals_ = has_normals;
  Vector3d up = Vector3d::Zero();
  for (const PlateSample& sample : border) {
    plate.origin_ += sample.point / static_cast<double>(border.size());
    up += sample.normal;
  }
  up.normalize();
  for (const PlateSample& sample : border) {
    // The plate is a height over one plane: of a border that leans more it would be too steep.
    if (!(sample.normal.dot(up) > kLeastUp)) return std::nullopt;
  }
  plate.axes_.col(2) = up;
  // Any axes will do: kernel and polynomials are the same turned.
  plate.axes_.col(0) = up.unitOrthogonal();
  // Right-handed: in the plane the border runs counterclockwise, as it does seen from outside.
  plate.axes_.col(1) = up.cross(plate.axes_.col(0));
  double reach = 0.0;
  for (const PlateSample& s : border) reach = std::max(reach, (s.point - plate.origin_).norm());
  // Places are of about 1, so that fifth powers and polynomials are of one size.
  plate.scale_ = reach;
  std::vector<Vector2d> polygon;
  std::vector<double> wanted;
  for (const PlateSample& sample : border) {
    const Vector2d at = plate.place(sample.point);
    polygon.push_back(at);
    plate.sources_.push_back({at, Vector2d::Zero()});
    wanted.push_back(up.dot(sample.point - plate.origin_) / reach);
  }
  for (std::size_t i = 0; i < border.size() && has_normals; ++i) {
    if (!border[i].has_slope) continue;
    const Vector3d normal = plate.axes_.transpose() * border[i].normal;
    const Vector2d along = (plate.axes_.transpose() * border[i].along).head<2>();
    // Along the border slopes follow from the heights there.
    const Vector2d across = Vector2d(-along.y(), along.x()).normalized();
    plate.sources_.push_back({polygon[i], across});
    // The normal of a height h is along (-h_x, -h_y, 1).
    wanted.push_back(-across.dot(normal.head<2>()) / normal.z());
  }
  plate.centre_ = centroid(polygon);
  plate.solve(Eigen::Map<Eigen::VectorXd>(wanted.data(), std::ssize(wanted)));
  return plate;
}

void BorderPlate::solve(const Eigen::VectorXd& wanted) {
  const auto count = static_cast<Eigen::Index>(sources_.size());
  const Eigen::Index terms = polynomial_count();
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(count + terms, count + terms);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Source& one = sources_[static_cast<std::size_t>(i)];
    // A row is the height, or the slope across the border, of all sources at one place.
    const bool has_slope = !one.across.isZero(0.0);
    for (Eigen::Index k = 0; k < count; ++k) {
      const Source& other = sources_[static_cast<std::size_t>(k)];
      const Vector2d d = one.at - other.at;
      const bool is_slope = !other.across.isZero(0.0);
      // A source of a slope is the kernel differentiated by its own place: hence the minus signs,
      // which keep the matrix symmetric.
      all(i, k) = !has_normals_ ? radial3(d)
                  : has_slope   ? is_slope ? -one.across.dot(radial5_bend(d, other.across))
                                           : one.across.dot(radial5_slope(d))
                    : is_slope ? -other.across.dot(radial5_slope(d))
                                : radial5(d);
    }
    const Polynomials row = has_slope ? polynomial_slopes(one.at, one.across) : polynomials(one.at);
    all.block(i, count, 1, terms) = row.head(terms).transpose();
    all.block(count, i, terms, 1) = row.head(terms);
  }
  Eigen::VectorXd right = Eigen::VectorXd::Zero(count + terms);
  // The rest stays zero: weights of sources are orthogonal to the polynomials, so that these have
  // all that they can make up, and there is one solution.
  right.head(count) = wanted;
  // Indefinite, for nothing stands where polynomials meet polynomials: no Cholesky.
  weights_ = all.partialPivLu().solve(right);
}

Vector2d BorderPlate::place(const Vector3d& point) const {
  return (axes_.transpose() * (point - origin_)).head<2>() / scale_;
}

bool BorderPlate::is_gentle(const std::vector<Vector2d>& places) const {
  return std::ranges::all_of(places, [&](const Vector2d& place) {
    return at(place).normal().dot(axes_.col(2)) > kLeastUp;
  });
}

PatchPoint BorderPlate::at(const Vector2d& place) const {
  const auto count = static_cast<Eigen::Index>(sources_.size());
  const Eigen::Index terms = polynomial_count();
  const auto polynomial = weights_.tail(terms);
  double height = polynomials(place).head(terms).dot(polynomial);
  Vector2d slope(polynomial_slopes(place, {1.0, 0.0}).head(terms).dot(polynomial),
                 polynomial_slopes(place, {0.0, 1.0}).head(terms).dot(polynomial));
  for (Eigen::Index i = 0; i < count; ++i) {
    const Source& source = sources_[static_cast<std::size_t>(i)];
    const Vector2d d = place - source.at;
    const double weight = weights_[i];
    if (!has_normals_) {
      height += weight * radial3(d);
      slope += weight * radial3_slope(d);
    } else if (source.across.isZero(0.0)) {
      height += weight * radial5(d);
      slope += weight * radial5_slope(d);
    } else {
      // As in solve(): by the source's own place.
      height -= weight * source.across.dot(radial5_slope(d));
      slope -= weight * radial5_bend(d, source.across);
    }
  }
  const auto in_space = [&](double x, double y, double z) {
    return Vector3d(scale_ * (axes_ * Vector3d(x, y, z)));
  };
  return {origin_ + in_space(place.x(), place.y(), height), in_space(1.0, 0.0, slope.x()),
          in_space(0.0, 1.0, slope.y())};
}

}  // namespace hull::network
