// SPDX-License-Identifier: GPL-3.0-or-later
#include "resistance/michell_integral.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "test_meshes.h"

namespace hull::resistance {
namespace {

std::string words_of(const auto& query) {
  try {
    query();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

// The mesh's extents are those of its points as they were.
TEST(MichellIntegral, RefusesOnceItsBodyHasChanged) {
  surface::LimitSurface surface{mesh::ControlMesh(testing::cube())};
  analysis::HullBody body(surface, false);
  const analysis::BodyDerivatives derivatives(body);
  const MichellIntegral integral(body, {0.1, 0.0, 0.0, 0.0});
  const double speed = 0.5 * std::sqrt(kGravity * integral.length());
  ASSERT_GT(integral.resistance_to(speed, 1.5).resistance, 0.0);
  const auto all_refuse = [&](const char* why) {
    const auto refuses = [&](const auto& query) {
      const std::string words = words_of(query);
      EXPECT_EQ(words.find("Michell's integral is out of date: "), 0u) << words;
      EXPECT_NE(words.find(why), std::string::npos) << words;
    };
    refuses([&] { integral.length(); });
    refuses([&] { integral.resistance({speed}); });
    refuses([&] { integral.resistance({}); });
    refuses([&] { integral.resistance_to(speed, 1.5); });
    refuses([&] { integral.gradient(derivatives, speed); });
    refuses([&] { integral.gradient_to(derivatives, speed, 1.5); });
    refuses([&] { integral.amplitudes(speed, {0.1}); });
  };
  std::vector<Vector3d> points = surface.mesh().points();
  for (Vector3d& p : points) p.x() *= 2.0;
  surface.set_points(points);
  all_refuse("points were set");
  body.update();
  all_refuse("Make it anew");
  EXPECT_NEAR(MichellIntegral(body, {0.1, 0.0, 0.0, 0.0}).length(),
              2.0 * speed * speed / (0.25 * kGravity), 1e-12 * speed * speed);
}

// Neither its length nor its tolerances are those of points that the surface does not know.
TEST(MichellIntegral, IsThatOfTheSurface) {
  mesh::MeshArrays stray = testing::cube();
  stray.points.emplace_back(40.0, 7.0, -9.0);
  const auto resistance = [](const mesh::MeshArrays& mesh) {
    const surface::LimitSurface surface{mesh::ControlMesh(mesh)};
    const analysis::HullBody body(surface, false);
    const MichellIntegral integral(body, {0.1, 0.0, 0.0, 0.0});
    EXPECT_EQ(integral.length(), 2.0);
    return integral.resistance({2.0})[0].resistance;
  };
  EXPECT_EQ(resistance(stray), resistance(testing::cube()));
}

// However few waves are asked for: what is said to have been taken is what was, and the grid is
// fine enough for it, at low speeds too.
TEST(MichellIntegral, SaysWhichWavesItTook) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::cube())};
  const analysis::HullBody body(surface, false);
  const MichellIntegral integral(body, {0.1, 0.0, 0.0, 0.0});
  for (const double froude : {0.06, 0.08, 0.1, 0.2, 0.5}) {
    const double speed = froude * std::sqrt(kGravity * integral.length());
    const WaveResistance more = integral.resistance_to(speed, 24.0);
    for (const double shortest : {1.0001, 1.2, 1.5, 1.9, 8.0}) {
      const WaveResistance few = integral.resistance_to(speed, shortest);
      EXPECT_GT(few.shortest, 1.0);
      EXPECT_GT(few.error, 0.0) << froude << ", " << shortest;
      // A grid for the waves that were taken: the same integral.
      const WaveResistance same = integral.resistance_to(speed, few.shortest);
      EXPECT_EQ(same.shortest, few.shortest);
      EXPECT_NEAR(same.resistance, few.resistance, 1e-7 * same.resistance);
      // An error is a bound, where there is one.
      EXPECT_LE(more.resistance - few.resistance, few.error);
    }
  }
}

TEST(MichellIntegral, RefusesShortestWavesThatAreNone) {
  const surface::LimitSurface surface{mesh::ControlMesh(testing::cube())};
  const analysis::HullBody body(surface, false);
  const analysis::BodyDerivatives derivatives(body);
  const MichellIntegral integral(body, {0.1, 0.0, 0.0, 0.0});
  for (const double shortest : {0.5, 1.0, std::nan(""), 1e9}) {
    const auto refused = [&](const auto& query) {
      EXPECT_EQ(words_of(query).find("The shortest wave's λ must be"), 0u) << shortest;
    };
    refused([&] { integral.resistance_to(2.0, shortest); });
    refused([&] { integral.gradient_to(derivatives, 2.0, shortest); });
  }
}

TEST(MichellIntegral, HasDerivativesOfItsOwnBodyAlone) {
  surface::LimitSurface surface{mesh::ControlMesh(testing::cube())};
  const surface::LimitSurface other{mesh::ControlMesh(testing::prism(7))};
  const analysis::HullBody body(surface, false), twin(body, surface), another(other, false);
  const MichellIntegral integral(body, {0.1, 0.0, 0.0, 0.0});
  const double speed = 0.5 * std::sqrt(kGravity * integral.length());
  for (const analysis::HullBody* wrong : {&twin, &another}) {
    const analysis::BodyDerivatives derivatives(*wrong);
    EXPECT_NE(words_of([&] { integral.gradient_to(derivatives, speed, 1.5); }).find("another body"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace hull::resistance
