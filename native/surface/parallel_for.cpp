// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/parallel_for.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace hull::surface {

void parallel_for(std::size_t count, int threads,
                  const std::function<void(std::size_t, std::size_t)>& work, std::size_t grain) {
  // Asked once: it reads a file of the system's each time.
  static const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  if (threads <= 0) threads = processors;
  grain = std::max<std::size_t>(grain, 1);
  // None has less to do than a grain, which is to outweigh starting its thread.
  const std::size_t workers = std::min<std::size_t>(threads, count / grain);
  if (workers < 2) {
    if (count > 0) work(0, count);
    return;
  }
  // Several ranges a thread, so that one that is slow, or held up, does not keep the others
  // waiting.
  const std::size_t step = std::max(grain, count / (8 * workers) + 1);
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto run = [&] {
    try {
      for (std::size_t begin = next.fetch_add(step); begin < count; begin = next.fetch_add(step)) {
        work(begin, std::min(begin + step, count));
      }
    } catch (...) {
      const std::lock_guard lock(failure_mutex);
      if (!failure) failure = std::current_exception();
      // Nobody begins another range.
      next = count;
    }
  };
  {
    // Their destructors join: all have ended before the exception is looked at.
    std::vector<std::jthread> helpers;
    for (std::size_t i = 1; i < workers; ++i) helpers.emplace_back(run);
    run();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace hull::surface
