// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/topology/regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <set>

namespace hull::network {
namespace {

struct PlaneGraph {
  int node_count = 0;
  std::vector<NetworkEdge> edges;
  std::vector<std::vector<EdgeEnd>> around;
  // Each face by the ends from which its half-edges go, from the least one on.
  std::set<std::vector<std::pair<int, bool>>> faces;
};

using EndName = std::pair<int, bool>;

std::vector<EndName> from_least(std::vector<EndName> ring) {
  std::rotate(ring.begin(), std::ranges::min_element(ring), ring.end());
  return ring;
}

std::set<std::vector<EndName>> faces_of(const Shells& shells,
                                        const std::map<int, EndName>& end_of_half) {
  std::set<std::vector<EndName>> faces;
  for (int face : shells.faces().numbers()) {
    std::vector<EndName> ring;
    for (int half : shells.half_edges_of(shells.faces()[face].outer)) {
      ring.push_back(end_of_half.at(half));
    }
    faces.insert(from_least(ring));
  }
  return faces;
}

// Made by operators in any order; its numbers are shuffled.
PlaneGraph random_graph(std::mt19937& random, int edge_count) {
  Shells shells;
  shells.make_vertex_face_shell();
  const auto any = [&](const std::vector<int>& all) { return all[random() % all.size()]; };
  while (shells.edges().count() < edge_count) {
    const int half = any(shells.half_edges().numbers());
    if (random() % 2 == 0) {
      shells.make_edge_vertex(half, half);
    } else {
      shells.make_edge_face(half, any(shells.half_edges_of(shells.half_edges()[half].loop)));
    }
  }
  PlaneGraph graph;
  std::vector<int> numbers(static_cast<std::size_t>(edge_count));
  std::iota(numbers.begin(), numbers.end(), 0);
  std::ranges::shuffle(numbers, random);
  graph.node_count = shells.vertices().count();
  graph.edges.resize(numbers.size());
  graph.around.resize(static_cast<std::size_t>(graph.node_count));
  std::map<int, EndName> end_of_half;
  for (int edge : shells.edges().numbers()) {
    const int number = numbers[static_cast<std::size_t>(edge)];
    const bool is_turned = random() % 2 == 0;
    const int start = shells.edges()[edge].halves[is_turned],
              end = shells.edges()[edge].halves[!is_turned];
    end_of_half[start] = {number, true};
    end_of_half[end] = {number, false};
    graph.edges[static_cast<std::size_t>(number)] = {shells.half_edges()[start].vertex,
                                                     shells.half_edges()[end].vertex, number};
  }
  for (int vertex : shells.vertices().numbers()) {
    auto& ends = graph.around[static_cast<std::size_t>(vertex)];
    const int first = shells.vertices()[vertex].half_edge;
    int half = first;
    do {
      const auto [edge, is_start] = end_of_half.at(half);
      ends.push_back({edge, is_start});
      half = shells.clockwise(half);
    } while (half != first);
    std::ranges::reverse(ends);
    std::rotate(ends.begin(), ends.begin() + static_cast<long>(random() % ends.size()), ends.end());
  }
  graph.faces = faces_of(shells, end_of_half);
  return graph;
}

std::set<std::vector<EndName>> faces_of(const Regions& regions) {
  std::map<int, EndName> end_of_half;
  for (std::size_t edge = 0; edge < regions.half_of_edge.size(); ++edge) {
    const int half = regions.half_of_edge[edge];
    end_of_half[half] = {static_cast<int>(edge), true};
    end_of_half[regions.shells.mate(half)] = {static_cast<int>(edge), false};
  }
  return faces_of(regions.shells, end_of_half);
}

TEST(Regions, AreThoseOfTheGraphWhateverItsNumbers) {
  std::mt19937 random(20261124);
  for (int trial = 0; trial < 500; ++trial) {
    const PlaneGraph graph = random_graph(random, 1 + static_cast<int>(random() % 40));
    const Regions regions = regions_between(graph.node_count, graph.edges, graph.around);
    ASSERT_EQ(shells_fault(regions.shells), "");
    ASSERT_EQ(faces_of(regions), graph.faces) << "trial " << trial;
    for (std::size_t edge = 0; edge < graph.edges.size(); ++edge) {
      const int half = regions.half_of_edge[edge];
      const auto& vertices = regions.vertex_of_node;
      ASSERT_EQ(regions.shells.half_edges()[half].vertex,
                vertices[static_cast<std::size_t>(graph.edges[edge].from)]);
      ASSERT_EQ(regions.shells.end_of(half),
                vertices[static_cast<std::size_t>(graph.edges[edge].to)]);
    }
  }
}

// Two quadrilaterals side by side.
PlaneGraph two_regions() {
  PlaneGraph graph;
  graph.node_count = 6;
  graph.edges = {{0, 1, 0}, {1, 2, 0}, {3, 4, 1}, {4, 5, 1}, {0, 3, 2}, {1, 4, 3}, {2, 5, 4}};
  graph.around = {
      {{0, true}, {4, true}},  {{1, true}, {5, true}, {0, false}},  {{6, true}, {1, false}},
      {{2, true}, {4, false}}, {{3, true}, {2, false}, {5, false}}, {{3, false}, {6, false}}};
  return graph;
}

TEST(Regions, OfTwoQuadrilateralsAreThreeWithTheOuterOne) {
  const PlaneGraph graph = two_regions();
  const Regions regions = regions_between(graph.node_count, graph.edges, graph.around);
  EXPECT_EQ(regions.shells.faces().count(), 3);
  EXPECT_EQ(regions.shells.face_of(regions.half_of_edge[0]) ==
                regions.shells.face_of(regions.shells.mate(regions.half_of_edge[4])),
            true);
}

TEST(Regions, AnEdgeOutOfOrderIsNamed) {
  // On a torus only: each order around node 1 but that one and its turns.
  PlaneGraph graph = two_regions();
  graph.edges.push_back({0, 5, 7});
  graph.around[0] = {{0, true}, {7, true}, {4, true}};
  graph.around[5] = {{3, false}, {6, false}, {7, false}};
  try {
    regions_between(graph.node_count, graph.edges, graph.around);
    FAIL();
  } catch (const NetworkFault& fault) {
    EXPECT_EQ(fault.edges.size(), 1u);
    EXPECT_NE(std::string(fault.what()).find("wrong order"), std::string::npos);
  }
}

TEST(Regions, WhatIsApartIsNamed) {
  PlaneGraph graph = two_regions();
  graph.node_count = 8;
  graph.edges.push_back({6, 7, 9});
  graph.around.push_back({{7, true}});
  graph.around.push_back({{7, false}});
  try {
    regions_between(graph.node_count, graph.edges, graph.around);
    FAIL();
  } catch (const NetworkFault& fault) {
    EXPECT_EQ(fault.edges, std::vector<int>{7});
    EXPECT_STREQ(fault.what(), "Curve 9 is not connected with curve 0.");
  }
}

TEST(Regions, EndsThatAreMissingOrTwiceAreRefused) {
  PlaneGraph graph = two_regions();
  graph.around[2].pop_back();
  EXPECT_THROW(regions_between(6, graph.edges, graph.around), std::invalid_argument);
  graph = two_regions();
  graph.around[2].push_back({0, true});
  EXPECT_THROW(regions_between(6, graph.edges, graph.around), std::invalid_argument);
  EXPECT_THROW(regions_between(5, graph.edges, graph.around), std::invalid_argument);
  EXPECT_THROW(regions_between(0, {}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace hull::network
