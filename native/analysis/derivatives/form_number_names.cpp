// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <stdexcept>

#include "analysis/derivatives/form_numbers.h"

namespace hull::analysis {

const std::vector<std::string>& form_number_names() {
  // In the order of FormNumber, whose values are their indices.
  static const std::vector<std::string> names{"displaced_volume",
                                              "displacement_t",
                                              "lcb",
                                              "lcb_percent",
                                              "tcb",
                                              "kb",
                                              "wetted_surface",
                                              "waterplane_area",
                                              "lcf",
                                              "lcf_percent",
                                              "tcf",
                                              "waterplane_inertia_transverse",
                                              "waterplane_inertia_longitudinal",
                                              "bm_transverse",
                                              "bm_longitudinal",
                                              "km_transverse",
                                              "km_longitudinal",
                                              "waterline_length",
                                              "waterline_beam",
                                              "immersed_length",
                                              "immersed_beam",
                                              "immersed_draft",
                                              "midship_section.area",
                                              "largest_section.area",
                                              "project.block",
                                              "project.prismatic",
                                              "project.midship",
                                              "project.waterplane",
                                              "project.vertical_prismatic",
                                              "immersed.block",
                                              "immersed.prismatic",
                                              "immersed.midship",
                                              "immersed.waterplane",
                                              "immersed.vertical_prismatic"};
  return names;
}

const char* name_of(FormNumber number) {
  return form_number_names()[static_cast<std::size_t>(number)].c_str();
}

FormNumber form_number_named(const std::string& name) {
  const std::vector<std::string>& names = form_number_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<FormNumber>(found - names.begin());
  std::string all;
  for (const std::string& known : names) all += (all.empty() ? "" : ", ") + known;
  throw std::invalid_argument("There is no number \"" + name + "\" of a hull's form; there are " +
                              all + ".");
}

}  // namespace hull::analysis
