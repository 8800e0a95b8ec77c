// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace hull::surface {

// Is told now and then how much of a long task is done, from 0 to 1, by the thread that does it.
// To end the task early, throw: the exception goes through to the caller, and nothing half-done
// stays.
using Progress = std::function<void(double share)>;

// Part of a task whose share goes from `begin` to `end`.
inline Progress part_of(const Progress& progress, double begin, double end) {
  if (!progress) return {};
  return [&progress, begin, end](double share) { progress(begin + share * (end - begin)); };
}

// REQUIRES: 0 <= done <= count.
inline void tell(const Progress& progress, double done, double count) {
  if (progress) progress(count > 0.0 ? done / count : 1.0);
}

}  // namespace hull::surface
