// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/caps/caps.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "conversion/caps/cap_maker.h"
#include "conversion/caps/centre_plane.h"
#include "conversion/patches/mirror.h"
#include "mesh/tolerances.h"

namespace hull::conversion {
namespace {

Vector3d mirrored(const Vector3d& point, double y) {
  return {point.x(), 2.0 * y - point.y(), point.z()};
}

// Whether all control points of a loop are in one plane, whose normal is then known well enough.
bool is_plane(const BorderChain& loop, double tolerance) {
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  std::vector<Vector3d> points;
  for (const BorderStep& step : loop) {
    points.insert(points.end(), step.curve.points.begin(), step.curve.points.end());
  }
  Vector3d centre = Vector3d::Zero();
  for (const Vector3d& point : points) centre += point / static_cast<double>(points.size());
  for (const Vector3d& point : points) {
    moments += (point - centre) * (point - centre).transpose();
  }
  // The direction of the least moment.
  const Vector3d normal =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments).eigenvectors().col(0);
  return std::ranges::all_of(points, [&](const Vector3d& point) {
    return std::abs(normal.dot(point - centre)) <= tolerance;
  });
}

// Mirror images within a loop; `edges` has fewer than the loop if it is not symmetric.
FarSide find_images(const BorderChain& loop, double tolerance) {
  Eigen::AlignedBox3d box;
  for (const BorderStep& step : loop) {
    for (const Vector3d& point : step.curve.points) box.extend(point);
  }
  FarSide far;
  far.is_plane = false;
  // Control points of a symmetric border are symmetric, and so is the box around them.
  far.y = box.center().y();
  const auto near = [&](const Vector3d& a, const Vector3d& b) {
    return (mirrored(a, far.y) - b).norm() <= tolerance;
  };
  for (const BorderStep& step : loop) {
    BSplineCurve image = step.curve.reversed();
    for (Vector3d& point : image.points) point = mirrored(point, far.y);
    for (const BorderStep& other : loop) {
      // Ends first, as curves are sampled. An image runs the other way along the border, and an
      // edge may be its own.
      if (!near(step.curve.points.front(), other.curve.points.back()) ||
          !near(step.curve.points.back(), other.curve.points.front()) ||
          gap_between(image, other.curve) > tolerance) {
        continue;
      }
      far.edges[step.edge] = other.edge;
      far.vertices[step.from] = other.to;
      far.vertices[step.to] = other.from;
      break;
    }
  }
  return far;
}

class Closer {
 public:
  explicit Closer(const PatchSet& set)
      : set_(set), uses_(set), maker_(set, uses_), size_(set.size()) {}

  // Edges that are their own mirror images, and not athwart: the closing lacks what is there.
  const std::vector<int>& crossing() const { return crossing_; }

  Closing close() {
    std::vector<BorderChain> loops;
    for (const auto& loop : border_loops(uses_, set_.edge_count)) {
      BorderChain& chain = loops.emplace_back();
      for (const EdgeUse& use : loop) chain.push_back(maker_.step(use));
    }
    find_half(loops);
    for (const BorderChain& loop : loops) {
      if (!is_half_ || !close_to_centre_plane(loop)) close_alone(loop);
    }
    if (is_half_) {
      for (const DirectedEdge& edge : maker_.in_plane()) in_plane_.push_back(-edge);
      close_centre_plane(maker_, in_plane_, is_port_half_);
    }
    return maker_.take();
  }

 private:
  void find_half(const std::vector<BorderChain>& loops) {
    double low = 0.0, high = 0.0;
    for (const BSplinePatch& patch : set_.patches) {
      for (int k = 0; k < 4; ++k) {
        const double y = patch.control_points[patch.side_index(k, 0)].y();
        low = std::min(low, y);
        high = std::max(high, y);
      }
    }
    is_port_half_ = high > -low;
    // A set without borders in the plane is no half hull, even on one side: a rudder beside it,
    // say.
    const bool one_side = std::min(-low, high) <= kOnCentrePlane * size_;
    is_half_ = one_side && std::ranges::any_of(loops, [&](const BorderChain& loop) {
                 return std::ranges::any_of(loop, [&](const BorderStep& step) {
                   return lies_in_centre_plane(step.curve, size_);
                 });
               });
  }

  // Splits a loop at the centre plane and closes the parts; false if it does not come there.
  bool close_to_centre_plane(BorderChain loop) {
    const auto is_there = [&](const BorderStep& step) {
      return std::abs(step.curve.points.front().y()) <= maker_.tolerance();
    };
    const auto first = std::ranges::find_if(loop, is_there);
    if (first == loop.end()) return false;
    std::rotate(loop.begin(), first, loop.end());
    // One for all chains of the border, which so share the vertices that are made in the plane.
    FarSide far;
    BorderChain chain;
    for (const BorderStep& step : loop) {
      // A chain ends wherever the border touches the plane, also if it leaves it again at once.
      if (!chain.empty() && is_there(step)) close_chain(chain, far);
      if (lies_in_centre_plane(step.curve, size_)) {
        // Reversed, as the face in the plane is on its other side.
        in_plane_.push_back({step.edge, true});
      } else {
        chain.push_back(step);
      }
    }
    if (!chain.empty()) close_chain(chain, far);
    return true;
  }

  void close_chain(BorderChain& chain, FarSide& far) {
    maker_.close(chain, far, {}, {});
    chain.clear();
  }

  void close_alone(const BorderChain& loop) {
    if (is_plane(loop, maker_.tolerance())) {
      EdgePath path;
      // A face runs along its border against the patch beyond.
      for (auto step = loop.rbegin(); step != loop.rend(); ++step) {
        path.push_back({step->edge, true});
      }
      return maker_.add_plane(std::move(path));
    }
    FarSide far = find_images(loop, maker_.tolerance());
    if (far.edges.size() < loop.size()) refuse(loop);
    const std::size_t before = crossing_.size();
    for (const BorderStep& step : loop) {
      if (far.edges.at(step.edge) == step.edge && !maker_.is_athwart(step)) {
        crossing_.push_back(step.edge);
      }
    }
    if (crossing_.size() == before) close_symmetric(loop, far);
  }

  // One chain for each part of the loop on the side y > far.y.
  void close_symmetric(BorderChain loop, FarSide& far) {
    const auto is_on_side = [&](const BorderStep& step) {
      return far.edges.at(step.edge) != step.edge && step.curve.position(0.5).y() > far.y;
    };
    // At a vertex that is its own image, on the plane of symmetry, or before an edge that leads
    // across.
    const auto ends_here = [&](const BorderStep& step, const BorderStep& next) {
      return far.vertices.at(step.to) == step.to || !is_on_side(next);
    };
    // The loop may begin in the middle of a chain.
    const auto starts = [&](std::size_t i) {
      const BorderStep& last = loop[(i + loop.size() - 1) % loop.size()];
      return is_on_side(loop[i]) && (!is_on_side(last) || ends_here(last, loop[i]));
    };
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (!starts(i)) continue;
      const auto at = [&](std::size_t j) -> const BorderStep& { return loop[j % loop.size()]; };
      BorderChain chain{at(i)};
      std::size_t j = i + 1;
      while (!ends_here(chain.back(), at(j))) chain.push_back(at(j++));
      // Edges that are their own images lead across, seen from the chain's ends.
      EdgePath start, end;
      const BorderStep& before = at(i + loop.size() - 1);
      if (far.edges.at(before.edge) == before.edge) start = {{before.edge, true}};
      if (far.edges.at(at(j).edge) == at(j).edge) end = {{at(j).edge, false}};
      maker_.close(chain, far, start, end);
    }
  }

  [[noreturn]] void refuse(const BorderChain& loop) const {
    Eigen::AlignedBox3d box;
    for (const BorderStep& step : loop) {
      for (const Vector3d& point : step.curve.points) box.extend(point);
    }
    const int cell = set_.patches[uses_.of(loop.front().edge)[0].patch].cell;
    throw PlaceError(
        "no solid: the opening around " + place_text(box.center()) + ", with a border at cell " +
            std::to_string(cell) +
            ", is neither flat nor symmetric; close it with faces, make its border flat, or export "
            "without closing",
        loop.front().curve.position(0.5));
  }

  const PatchSet& set_;
  EdgeUses uses_;
  CapMaker maker_;
  double size_;
  bool is_half_ = false, is_port_half_ = true;
  EdgePath in_plane_;
  std::vector<int> crossing_;
};

// Divides a border edge in its middle.
void divide(PatchSet& set, const EdgeUse& use) {
  PatchSide& side = set.sides[use.patch][use.side];
  const auto first = side.begin() + use.part;
  // The middle by its parameter: an edge that is its own image at equal parameters crosses there.
  SideEdge second = *first;
  first->end = second.begin = 0.5 * (first->begin + first->end);
  first->to = second.from = set.vertex_count++;
  second.edge = set.edge_count++;
  side.insert(first + 1, second);
}

}  // namespace

Closing closing_of(PatchSet& set) {
  Closer closer(set);
  Closing closing = closer.close();
  if (closer.crossing().empty()) return closing;
  // One at a time, because the places of others on the same side change.
  for (int edge : closer.crossing()) divide(set, EdgeUses(set).of(edge)[0]);
  // Numbers have changed: all is looked at anew.
  return Closer(set).close();
}

}  // namespace hull::conversion
