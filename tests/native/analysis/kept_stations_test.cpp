// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stations/kept_stations.h"

#include <gtest/gtest.h>

#include <random>

#include "analysis/hydrostatics/hydrostatics.h"
#include "analysis/stations/largest_section.h"
#include "natural_hull.h"
#include "test_meshes.h"

namespace hull::analysis {
namespace {

constexpr unsigned kKeptStationsSeed = 1214;

void expect_equal(const SectionArea& a, const SectionArea& b) {
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.area, b.area);
  EXPECT_EQ(a.centroid, b.centroid);
  EXPECT_EQ(a.girth, b.girth);
  EXPECT_EQ(a.breadth, b.breadth);
  EXPECT_EQ(a.area_error, b.area_error);
}

// Port half of a hull with a transom, a flat in the plane of a station, at x = 0.
mesh::MeshArrays half_hull() {
  mesh::MeshArrays arrays = testing::grid(12, 6);
  for (auto& p : arrays.points) {
    const double along = p.x() / 12.0, up = p.y() / 6.0;
    p = {40.0 * along, 5.0 * std::pow(up, 0.6) * std::sqrt(1.0 - along * along), 6.0 * up * up};
  }
  return arrays;
}

// Whatever was asked for before, and whatever has moved: afloat otherwise, one station twice in a
// call, others in each call, another size of the mesh.
TEST(KeptStations, AreThoseOfANewCut) {
  for (const bool mirrored : {true, false}) {
    SCOPED_TRACE(::testing::Message() << "seed " << kKeptStationsSeed << " mirrored " << mirrored);
    std::mt19937 random(kKeptStationsSeed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    mesh::MeshArrays arrays = half_hull();
    surface::LimitSurface surface{mesh::ControlMesh(arrays)};
    HullBody body(surface, mirrored, Openings::kClosed, 1e-8);
    KeptStations kept(body);
    std::vector<double> stations;
    for (int i = 0; i <= 20; ++i) stations.push_back(2.0 * i);
    FloatingPosition afloat{3.0};
    for (int step = 0; step < 50; ++step) {
      std::vector<double> asked;
      for (const double x : stations) {
        if (unit(random) < 0.7) asked.push_back(x);
      }
      if (!asked.empty() && step % 3 == 0) asked.push_back(asked.front());
      const auto found = kept.section_areas(asked, water_plane(afloat));
      const auto wanted = section_areas(body, asked, afloat);
      ASSERT_EQ(found.size(), wanted.size());
      for (std::size_t i = 0; i < found.size(); ++i) {
        SCOPED_TRACE(::testing::Message() << "step " << step << ", x " << asked[i]);
        expect_equal(found[i], wanted[i]);
      }
      const Plane water = water_plane(afloat);
      const StationCutter cutter(body);
      expect_equal(largest_section(cutter, water, &kept), largest_section(cutter, water));
      if (step % 7 == 5) continue;  // nothing has moved
      if (step % 9 == 8) {
        afloat = {2.0 + 2.0 * unit(random), step % 2 ? 0.02 : 0.0, step > 30 ? 0.1 : 0.0};
      }
      const auto point = static_cast<std::size_t>(unit(random) * arrays.points.size());
      arrays.points[point] += Vector3d(unit(random) - 0.5, 0.3 * unit(random), unit(random) - 0.5);
      surface.set_points(arrays.points);
      body.update();
    }
  }
}

TEST(KeptStations, ForgetThoseOfBefore) {
  surface::LimitSurface surface{mesh::ControlMesh(half_hull())};
  const HullBody body(surface, true);
  KeptStations kept(body);
  for (int i = 0; i < 50; ++i) {
    std::vector<double> stations;
    for (int k = 0; k < 60; ++k) stations.push_back(0.01 * (60 * i + k));
    kept.section_areas(stations, {Vector3d::UnitZ(), 1.0});
    EXPECT_LE(kept.station_count(), 2060u);
  }
}

TEST(KeptStations, RefuseWhatSectionAreasRefuse) {
  surface::LimitSurface surface{mesh::ControlMesh(half_hull())};
  const HullBody body(surface, true);
  KeptStations kept(body);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(kept.section_areas({nan}, {Vector3d::UnitZ(), 1.0}), std::invalid_argument);
  EXPECT_EQ(kept.section_areas({}, {Vector3d::UnitZ(), 1.0}).size(), 0u);
}

TEST(KeptStations, AreOfOneBody) {
  const surface::LimitSurface box{mesh::ControlMesh(testing::creased_box(40.0, 8.0, 5.0))};
  const HullBody body(box, false), other(box, false);
  KeptStations kept(body);
  const Hydrostatics found = hydrostatics(body, {3.0}, {}, kSeaWaterDensity, &kept);
  expect_equal(found.largest_section, hydrostatics(body, {3.0}, {}).largest_section);
  EXPECT_GT(kept.station_count(), 9u);
  EXPECT_THROW(hydrostatics(other, {3.0}, {}, kSeaWaterDensity, &kept), std::invalid_argument);
}

}  // namespace
}  // namespace hull::analysis
