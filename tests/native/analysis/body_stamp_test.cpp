// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/immersion/body_stamp.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "analysis/appendages/appendage.h"
#include "analysis/derivatives/form_numbers.h"
#include "natural_hull.h"
#include "test_meshes.h"

namespace hull::analysis {
namespace {

std::string refusal(const auto& query) {
  try {
    query();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(BodyStamp, IsOutOfDateOnceTheBodyHasChanged) {
  surface::LimitSurface surface{mesh::ControlMesh(testing::cube())};
  HullBody body(surface, false);
  const BodyStamp stamp(body);
  const auto asked = [&] { stamp.require_current("What was computed"); };
  body.update();  // of the same points
  EXPECT_TRUE(stamp.is_current());
  EXPECT_EQ(refusal(asked), "");

  surface.set_points(surface.mesh().points());
  EXPECT_FALSE(stamp.is_current());
  EXPECT_EQ(refusal(asked),
            "What was computed is out of date: the surface's points were set since. Call the "
            "body's update() and make it anew.");
  EXPECT_THROW(BodyStamp{body}, std::invalid_argument);

  body.update();
  EXPECT_FALSE(stamp.is_current());
  EXPECT_EQ(refusal(asked),
            "What was computed is out of date: the body was updated, or joined to others, since. "
            "Make it anew.");

  const BodyStamp anew(body);
  EXPECT_TRUE(anew.is_current());
  body.join({});
  EXPECT_FALSE(anew.is_current());
}

// Neither what is kept already, nor what would be computed only now.
TEST(FormNumbers, RefuseOnceTheirBodyHasChanged) {
  const testing::NaturalHull ship = testing::natural_ship();
  surface::LimitSurface surface{mesh::ControlMesh(ship.mesh)};
  std::vector<Vector3d> points = surface.mesh().points();
  HullBody body(surface, true);
  const BodyDerivatives derivatives(body);
  const auto make = [&] {
    return FormNumbers(derivatives, {3.7, 0.0, 0.0, 30.0}, {60.0, 12.0, 3.7});
  };
  FormNumbers asked = make(), fresh = make();
  const Gradient gradient = asked.gradient(FormNumber::kDisplacedVolume);
  const auto all_refuse = [&](const char* why) {
    for (FormNumbers* numbers : {&asked, &fresh}) {
      const auto refuses = [&](const auto& query) {
        const std::string words = refusal(query);
        EXPECT_EQ(words.find("The FormNumbers object is out of date: "), 0u) << words;
        EXPECT_NE(words.find(why), std::string::npos) << words;
      };
      for (int k = 0; k < static_cast<int>(FormNumber::kCount); ++k) {
        const auto number = static_cast<FormNumber>(k);
        refuses([&] { numbers->value(number); });
        refuses([&] { numbers->gradient(number); });
        refuses([&] { numbers->scaling(number, gradient); });
      }
      refuses([&] { numbers->section_area(30.0); });
      refuses([&] { numbers->section_area_gradient(30.0); });
      refuses([&] { numbers->section_area_scaling(30.0, gradient); });
    }
  };
  const double before = asked.value(FormNumber::kDisplacedVolume);
  for (Vector3d& p : points) p.y() *= 1.1;
  surface.set_points(points);
  all_refuse("points were set");
  EXPECT_THROW(make(), std::invalid_argument);
  body.update();
  all_refuse("Make it anew");
  EXPECT_NEAR(make().value(FormNumber::kDisplacedVolume), 1.1 * before, 1e-11 * before);
}

}  // namespace
}  // namespace hull::analysis
