// SPDX-License-Identifier: GPL-3.0-or-later
// Sections of random surfaces by random planes against those of a fine triangulation.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numeric>

#include "analysis/sections/sections.h"
#include "polylines.h"
#include "surface/sampling/tessellation.h"
#include "test_meshes.h"
#include "trials.h"

namespace hull::analysis {
namespace {

constexpr int kMeshes = testing::trials(100), kPlanes = 50;
constexpr double kChordTolerance = 1e-4;
// Where the plane meets the surface at a smaller angle (its sine), a triangulation can't tell where
// the section is; nor can it tell how branches hang together if that happens anywhere.
constexpr double kSafeAngle = 0.2;

struct Segment {
  Vector3d a, b;
  double sine;
};

// A triangulation, sliced plane by plane.
class Slicer {
 public:
  explicit Slicer(const surface::LimitSurface& surface)
      : grid_(surface::tessellate(surface, kDivisions)) {
    for (std::size_t q = 0; q < grid_.quads.size(); ++q) {
      const auto& c = grid_.quads[q];
      triangles_.push_back({c[0], c[1], c[2]});
      triangles_.push_back({c[0], c[2], c[3]});
    }
    find_feature_edges();
    // The facets' error, from the surface's points over the middles of quadrilaterals.
    const surface::Tessellation finer = surface::tessellate(surface, 2 * kDivisions);
    for (std::size_t q = 0; q < grid_.quads.size(); ++q) {
      const int cell = static_cast<int>(q) / (kDivisions * kDivisions);
      const int i = static_cast<int>(q) % kDivisions,
                j = static_cast<int>(q) / kDivisions % kDivisions;
      const int n = 2 * kDivisions;
      const Vector3d& middle =
          finer.points[finer.quads[static_cast<std::size_t>(cell * n * n + 2 * j * n + 2 * i)][2]];
      const auto& c = grid_.quads[q];
      for (const auto& [a, b] : {std::array<int, 2>{c[0], c[2]}, std::array<int, 2>{c[1], c[3]}}) {
        error_ = std::max(error_, (middle - 0.5 * (grid_.points[a] + grid_.points[b])).norm());
      }
    }
  }

  double error() const { return error_; }
  // Shorter curves, as around tips, are not resolved.
  double least_length() const { return 10.0 * error_ + 1e-6; }

  void slice(const Plane& plane) {
    segments_.clear();
    nodes_.clear();
    safe_ = true;
    std::vector<double> heights;
    for (const Vector3d& p : grid_.points) heights.push_back(plane.height(p));
    for (const auto& t : triangles_) add(t, heights, plane.normal);
    for (const auto& [a, b, border] : features_) {
      const double nearest = std::min(std::abs(heights[a]), std::abs(heights[b]));
      // A border's corner in the plane may part a branch or not.
      if (border && nearest < 1e-9) safe_ = false;
      if (nearest > 3.0 * error_) continue;
      const double length = (grid_.points[a] - grid_.points[b]).norm();
      if (std::abs(heights[a] - heights[b]) < kSafeAngle * length) safe_ = false;
    }
    count_loops();
  }
  const std::vector<Segment>& segments() const { return segments_; }
  bool safe() const { return safe_; }  // how branches hang together is certain
  int loops() const { return loops_; }
  int closed() const { return closed_; }

 private:
  static constexpr int kDivisions = 12;

  // Borders, and creases: there normals are not shared.
  void find_feature_edges() {
    std::map<std::array<int, 2>, std::vector<std::array<int, 2>>> normals;
    for (std::size_t q = 0; q < grid_.quads.size(); ++q) {
      for (std::size_t k = 0; k < 4; ++k) {
        int a = grid_.quads[q][k], b = grid_.quads[q][(k + 1) % 4];
        int m = grid_.corner_normals[q][k], n = grid_.corner_normals[q][(k + 1) % 4];
        if (a > b) {
          std::swap(a, b);
          std::swap(m, n);
        }
        normals[{a, b}].push_back({m, n});
      }
    }
    for (const auto& [ends, seen] : normals) {
      if (seen.size() == 1 || seen[0] != seen[1]) {
        features_.push_back({ends[0], ends[1], seen.size() == 1});
      }
    }
  }

  static std::array<int, 2> edge(const std::array<int, 3>& t, int k) {
    return {std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])};
  }

  void add(const std::array<int, 3>& t, const std::vector<double>& heights,
           const Vector3d& plane_normal) {
    const auto [low, high] = std::minmax({heights[t[0]], heights[t[1]], heights[t[2]]});
    if (low > 3.0 * error_ || high < -3.0 * error_) return;
    const Vector3d u = grid_.points[t[1]] - grid_.points[t[0]];
    const Vector3d v = grid_.points[t[2]] - grid_.points[t[0]];
    const Vector3d cross = u.cross(v);
    const Vector3d across = cross.cross(plane_normal);
    const double sine = cross.norm() > 0.0 ? across.norm() / cross.norm() : 0.0;
    // Nor what is there of an edge in the plane with both faces above it.
    const auto in_plane = [&](int i) { return std::abs(heights[i]) < 1e-9; };
    if (sine < kSafeAngle || std::count_if(t.begin(), t.end(), in_plane) > 1) safe_ = false;
    if (low >= 0.0 || high < 0.0) return;
    std::vector<int> ends;
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] = edge(t, k);
      if ((heights[a] < 0.0) == (heights[b] < 0.0)) continue;
      const auto [place, fresh] = nodes_.try_emplace({a, b}, static_cast<int>(nodes_.size()));
      ends.push_back(place->second);
      points_.resize(nodes_.size());
      const double s = heights[a] / (heights[a] - heights[b]);
      points_[static_cast<std::size_t>(place->second)] =
          grid_.points[a] + s * (grid_.points[b] - grid_.points[a]);
    }
    links_.resize(segments_.size());
    links_.push_back({ends[0], ends[1]});
    segments_.push_back({points_[static_cast<std::size_t>(ends[0])],
                         points_[static_cast<std::size_t>(ends[1])], sine});
  }

  void count_loops() {
    std::vector<int> parent(nodes_.size()), degree(nodes_.size(), 0);
    std::iota(parent.begin(), parent.end(), 0);
    const auto root = [&](int i) {
      while (parent[i] != i) i = parent[i] = parent[parent[i]];
      return i;
    };
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      for (const int end : links_[i]) ++degree[end];
      parent[root(links_[i][0])] = root(links_[i][1]);
    }
    struct Loop {
      double length = 0.0;
      bool closed = true;
    };
    std::map<int, Loop> loops;
    for (std::size_t i = 0; i < parent.size(); ++i) {
      Loop& loop = loops[root(static_cast<int>(i))];
      loop.closed = loop.closed && degree[i] == 2;
    }
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      loops[root(links_[i][0])].length += (segments_[i].b - segments_[i].a).norm();
    }
    loops_ = closed_ = 0;
    for (const auto& [unused, loop] : loops) {
      if (loop.length < least_length()) continue;
      ++loops_;
      closed_ += loop.closed;
    }
  }

  surface::Tessellation grid_;
  std::vector<std::array<int, 3>> triangles_;
  struct FeatureEdge {
    int a, b;
    bool border;
  };
  std::vector<FeatureEdge> features_;
  double error_ = 0.0;
  std::vector<Segment> segments_;
  std::map<std::array<int, 2>, int> nodes_;
  std::vector<Vector3d> points_;
  std::vector<std::array<int, 2>> links_;
  bool safe_ = true;
  int loops_ = 0, closed_ = 0;
};

class PlaneMaker {
 public:
  PlaneMaker(const surface::LimitSurface& surface, std::mt19937& random)
      : surface_(surface), random_(random) {}

  Plane draw(int kind) {
    const Vector3d p = surface_.position(cell(), unit(), unit());
    const int c = cell(), side = static_cast<int>(random_() % 4);
    const Vector3d a = corner(c, side), b = corner(c, side + 1);
    switch (kind % 5) {
      case 0:  // any
        return through(p, direction());
      case 1:  // through a vertex
        return through(a, direction());
      case 2:  // along a side, through its ends
        return through(a, Vector3d((b - a).cross(direction())));
      case 3:  // tangent
      {
        const int at = cell();
        const double u = unit(), v = unit();
        return through(surface_.position(at, u, v), surface_.normal(at, u, v));
      }
      default:  // across an axis, through a vertex
        return through(a, Vector3d::Unit(static_cast<int>(random_() % 3)));
    }
  }

 private:
  double unit() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
  int cell() { return static_cast<int>(random_() % static_cast<unsigned>(surface_.cell_count())); }
  Vector3d corner(int cell, int k) const {
    k %= 4;
    return surface_.position(cell, k == 1 || k == 2, k >= 2);
  }
  Vector3d direction() {
    std::normal_distribution<double> normal;
    Vector3d d;
    for (double& x : d) x = normal(random_);
    return d;
  }
  static Plane through(const Vector3d& p, const Vector3d& normal) {
    const Vector3d n = normal.norm() > 1e-9 ? Vector3d(normal.normalized()) : Vector3d::UnitZ();
    return {n, n.dot(p)};
  }

  const surface::LimitSurface& surface_;
  std::mt19937& random_;
};

void expect_on_plane_and_surface(const surface::LimitSurface& surface, const Plane& plane,
                                 const SectionCurve& curve) {
  const double tolerance = 1e-10 * surface.mesh().size();
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    ASSERT_LE(std::abs(plane.height(curve.points[i])), tolerance);
    const Vector3d there = surface.position(curve.cells[i], curve.uv[i].x(), curve.uv[i].y());
    ASSERT_LE((there - curve.points[i]).norm(), tolerance);
    ASSERT_NEAR(curve.tangents[i].norm(), 1.0, 1e-9);
    ASSERT_TRUE(std::isfinite(curve.curvatures[i]));
  }
}

double distance_to(const std::vector<SectionCurve>& curves, const Vector3d& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const SectionCurve& c : curves) {
    for (std::size_t i = 1; i < c.points.size(); ++i) {
      nearest = std::min(nearest, testing::distance(p, c.points[i - 1], c.points[i]));
    }
  }
  return nearest;
}

// Chords that are there twice, whichever way. Points may be, where branches meet, and so may the
// two chords of a loop that is narrower than they are exact.
int count_repeated(const std::vector<SectionCurve>& curves) {
  using Place = std::array<double, 3>;
  std::vector<std::array<Place, 2>> chords;
  const auto place = [](const SectionCurve& c, std::size_t i) {
    return Place{static_cast<double>(c.cells[i]), c.uv[i].x(), c.uv[i].y()};
  };
  for (const SectionCurve& c : curves) {
    if (c.closed && c.points.size() == 3) continue;
    for (std::size_t i = 1; i < c.points.size(); ++i) {
      chords.push_back({place(c, i - 1), place(c, i)});
      std::sort(chords.back().begin(), chords.back().end());
    }
  }
  std::sort(chords.begin(), chords.end());
  int repeated = 0;
  for (std::size_t i = 1; i < chords.size(); ++i) repeated += chords[i] == chords[i - 1];
  return repeated;
}

TEST(SectionsOfRandomSurfaces, AgreeWithTriangulations) {
  constexpr unsigned kSeed = 20250;
  std::mt19937 random(kSeed);
  int safe = 0;
  for (int trial = 0; trial < kMeshes; ++trial) {
    const surface::LimitSurface surface{mesh::ControlMesh(testing::random_mesh(random, 12))};
    Slicer slicer(surface);
    PlaneMaker maker(surface, random);
    std::vector<Plane> planes;
    for (int k = 0; k < kPlanes; ++k) planes.push_back(maker.draw(k));
    const auto all = sections(surface, planes, {kChordTolerance, {}});
    for (int k = 0; k < kPlanes; ++k) {
      SCOPED_TRACE(::testing::Message()
                   << "seed " << kSeed << ", mesh " << trial << ", plane " << k);
      const std::vector<SectionCurve>& curves = all[k];
      for (const SectionCurve& curve : curves) {
        ASSERT_NO_FATAL_FAILURE(expect_on_plane_and_surface(surface, planes[k], curve));
      }
      EXPECT_EQ(count_repeated(curves), 0);
      slicer.slice(planes[k]);
      const auto& segments = slicer.segments();
      const std::size_t step = std::max<std::size_t>(segments.size() / 40, 1);
      for (std::size_t i = 0; i < segments.size(); i += step) {
        const Segment& s = segments[i];
        if (s.sine < kSafeAngle || (s.b - s.a).norm() < 1e-9) continue;
        // Twice: the surface may be less steep than the facet.
        EXPECT_LE(distance_to(curves, 0.5 * (s.a + s.b)),
                  2.0 * slicer.error() / s.sine + kChordTolerance)
            << "missing";
      }
      if (!slicer.safe()) continue;
      ++safe;
      int loops = 0, closed = 0;
      for (const SectionCurve& curve : curves) {
        if (testing::length_of(curve) < slicer.least_length()) continue;
        ++loops;
        closed += curve.closed;
      }
      EXPECT_EQ(loops, slicer.loops());
      EXPECT_EQ(closed, slicer.closed());
      double length = 0.0;
      for (const Segment& s : segments) length += (s.b - s.a).norm();
      EXPECT_NEAR(testing::length_of(curves), length, 0.02 * length + 20.0 * slicer.error());
    }
  }
  EXPECT_GT(safe, kMeshes * kPlanes / 4);
  RecordProperty("safe", safe);
  std::printf("%d of %d planes compared by topology\n", safe, kMeshes * kPlanes);
}

}  // namespace
}  // namespace hull::analysis
