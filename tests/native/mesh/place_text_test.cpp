// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/place_text.h"

#include <gtest/gtest.h>

namespace hull::mesh {
namespace {

TEST(PlaceText, HasItsDecimalsAndNoNegativeZero) {
  EXPECT_EQ(place_text({1.0, -2.5, 1234.5678}, 2), "(1.00, -2.50, 1234.57)");
  EXPECT_EQ(place_text({-0.0, -0.0049, -1e-17}, 2), "(0.00, 0.00, 0.00)");
  EXPECT_EQ(place_text({-0.0004, -0.0006, 0.0004}, 3), "(0.000, -0.001, 0.000)");
}

}  // namespace
}  // namespace hull::mesh
