// SPDX-License-Identifier: GPL-3.0-or-later
#include "conversion/patches/patch_rows.h"

namespace hull::conversion {

BSplinePatch with_rows_along_u(const BSplinePatch& patch,
                               const std::function<BSplineCurve(const BSplineCurve&)>& change) {
  BSplinePatch result = patch;
  for (int j = 0; j < patch.count_v; ++j) {
    BSplineCurve row{patch.degree_u, patch.knots_u, {}};
    for (int i = 0; i < patch.count_u; ++i) row.points.push_back(patch.control_point(i, j));
    row = change(row);
    // The first row tells how many points and which knots there are; the others come to the same.
    if (j == 0) {
      result.count_u = static_cast<int>(row.points.size());
      result.control_points.resize(row.points.size() * patch.count_v);
      result.knots_u = row.knots;
    }
    for (int i = 0; i < result.count_u; ++i) {
      result.control_points[i * patch.count_v + j] = row.points[i];
    }
  }
  return result;
}

BSplinePatch with_rows_along_v(const BSplinePatch& patch,
                               const std::function<BSplineCurve(const BSplineCurve&)>& change) {
  BSplinePatch result = patch;
  result.control_points.clear();
  for (int i = 0; i < patch.count_u; ++i) {
    const auto begin = patch.control_points.begin() + i * patch.count_v;
    const BSplineCurve row =
        change({patch.degree_v, patch.knots_v, {begin, begin + patch.count_v}});
    result.knots_v = row.knots;
    result.count_v = static_cast<int>(row.points.size());
    result.control_points.insert(result.control_points.end(), row.points.begin(), row.points.end());
  }
  return result;
}

}  // namespace hull::conversion
