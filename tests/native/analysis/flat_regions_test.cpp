// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/fairness/flat_regions.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "test_meshes.h"

// The sanitizers have operators of their own, which look at what is allocated.
#if !defined(HULL_SANITIZED)

namespace {

std::atomic<std::size_t> allocated_bytes{0};

}  // namespace

// Of this program's own: they count what is asked for. Written into their callers, free() would
// seem to be given what another's new had made.
[[gnu::noinline]] void* operator new(std::size_t size) {
  allocated_bytes += size;
  if (void* const memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace hull::analysis {
namespace {

// A folded strip of triangles, each a flat region of its own.
mesh::MeshArrays facets(int count) {
  mesh::MeshArrays arrays;
  for (int i = 0; i < count + 2; ++i) {
    arrays.points.emplace_back(i, 10.0 * (i % 2), i * i % 7);
    if (i > 0) arrays.creases.push_back({i - 1, i});
  }
  for (int i = 0; i < count; ++i) {
    testing::add_face(
        arrays, i % 2 ? std::vector<int>{i + 1, i, i + 2} : std::vector<int>{i, i + 1, i + 2});
  }
  return arrays;
}

TEST(FlatRegions, ManyTakeNoMoreEachThanFew) {
  const auto bytes_of = [](int count) {
    const surface::LimitSurface surface{mesh::ControlMesh(facets(count))};
    const std::size_t before = allocated_bytes;
    EXPECT_EQ(flat_regions(surface, {}, 1e-9).size(), static_cast<std::size_t>(count));
    return static_cast<double>(allocated_bytes - before);
  };
  // In proportion, but for steps in which arrays grow.
  EXPECT_LT(bytes_of(2000), 5.0 * bytes_of(500));
}

}  // namespace
}  // namespace hull::analysis

#endif
