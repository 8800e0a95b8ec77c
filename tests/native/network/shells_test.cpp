// SPDX-License-Identifier: GPL-3.0-or-later
#include "network/topology/shells.h"

#include <gtest/gtest.h>

#include <random>

namespace hull::network {
namespace {

using Operator = void (*)(Shells&, std::mt19937&);

int any_of(const std::vector<int>& numbers, std::mt19937& random) {
  if (numbers.empty()) return -1;
  return numbers[std::uniform_int_distribution<std::size_t>(0, numbers.size() - 1)(random)];
}

int any_half_edge(const Shells& shells, std::mt19937& random) {
  return any_of(shells.half_edges().numbers(), random);
}

// Those for which there is something in most states, with arguments that are right half of the
// time and more.
const Operator kMakers[] = {
    [](Shells& s, std::mt19937&) { s.make_vertex_face_shell(); },
    [](Shells& s, std::mt19937& random) {
      const int first = any_half_edge(s, random);
      int last = first;
      const bool is_strut = random() % 2 == 0 || s.half_edges().at(first).edge < 0;
      for (unsigned step = random() % 4; !is_strut && step > 0; --step) last = s.clockwise(last);
      s.make_edge_vertex(first, last);
    },
    [](Shells& s, std::mt19937& random) {
      const int first = any_half_edge(s, random);
      const int loop = s.half_edges().at(first).loop;
      s.make_edge_face(first, any_of(s.half_edges_of(loop), random));
    },
    [](Shells& s, std::mt19937& random) { s.kill_edge_make_loop(any_half_edge(s, random)); },
    [](Shells& s, std::mt19937& random) {
      const std::vector<int> faces = s.faces().numbers();
      s.kill_face_make_loop_hole(any_of(faces, random), any_of(faces, random));
    },
};

const Operator kKillers[] = {
    [](Shells& s, std::mt19937& random) {
      s.kill_vertex_face_shell(any_of(s.shells().numbers(), random));
    },
    [](Shells& s, std::mt19937& random) { s.kill_edge_vertex(any_half_edge(s, random)); },
    [](Shells& s, std::mt19937& random) { s.kill_edge_face(any_half_edge(s, random)); },
    [](Shells& s, std::mt19937& random) {
      const int loop = any_of(s.loops().numbers(), random);
      const Face& face = s.faces()[s.loops().at(loop).face];
      const int other = face.inner.empty() ? loop : any_of(face.inner, random);
      s.make_edge_kill_loop(any_of(s.half_edges_of(loop), random),
                            any_of(s.half_edges_of(other), random));
    },
    [](Shells& s, std::mt19937& random) {
      s.make_face_kill_loop_hole(any_of(s.loops().numbers(), random));
    },
};

std::string text_of(const ElementCounts& c) {
  std::string text;
  for (int n : {c.vertices, c.edges, c.faces, c.inner_loops, c.shells, c.holes}) {
    text += std::to_string(n) + " ";
  }
  return text;
}

TEST(Shells, RandomSequencesOfOperatorsKeepTheInvariant) {
  std::mt19937 random(20261124);
  int done[2][5] = {};
  for (int round = 0; round < 20; ++round) {
    Shells shells;
    shells.make_vertex_face_shell();
    for (int step = 0; step < 1000; ++step) {
      const bool is_large = shells.edges().count() > 60;
      const bool kills = random() % 10 < (is_large ? 7u : 3u);
      const std::size_t which = random() % 5;
      const std::string before = text_of(shells.counts());
      try {
        (kills ? kKillers : kMakers)[which](shells, random);
        ++done[kills][which];
      } catch (const std::invalid_argument&) {
        ASSERT_EQ(text_of(shells.counts()), before);
      }
      ASSERT_EQ(shells_fault(shells), "") << "round " << round << ", step " << step << ", operator "
                                          << which << (kills ? " of killers" : " of makers");
    }
  }
  int sum = 0;
  for (const auto& kind : done) {
    for (int count : kind) {
      EXPECT_GT(count, 100);
      sum += count;
    }
  }
  EXPECT_GE(sum, 10000);
}

// A square's sides as edges; the half-edges inside and outside of the first.
Shells::NewEdge make_ring(Shells& shells, int count) {
  const int start = shells.make_vertex_face_shell().half_edge;
  Shells::NewEdge edge{start, start, -1, -1};
  int at = start;
  for (int i = 1; i < count; ++i) {
    edge = shells.make_edge_vertex(at, at);
    at = edge.mate;
  }
  return shells.make_edge_face(at, start);
}

TEST(Shells, APrismHasTheCountsOfOne) {
  for (int n : {1, 2, 3, 4, 7}) {
    Shells shells;
    const Shells::NewEdge closing = make_ring(shells, n);
    const int base = shells.half_edges()[closing.mate].loop;
    std::vector<int> up;
    for (int half : shells.half_edges_of(base))
      up.push_back(shells.make_edge_vertex(half, half).mate);
    // The first side's top is where the last one ends: what began there is of the first side.
    int start = -1;
    for (int i = 0; i < n; ++i) {
      const int end = i + 1 < n ? up[static_cast<std::size_t>(i + 1)] : start;
      const int first = up[static_cast<std::size_t>(i)];
      const int half = shells.make_edge_face(first, end < 0 ? first : end).half;
      if (i == 0) start = half;
    }
    ASSERT_EQ(shells_fault(shells), "");
    EXPECT_EQ(text_of(shells.counts()), text_of({2 * n, 3 * n, n + 2, 0, 1, 0}));
  }
}

TEST(Shells, ATorusIsASphereWithTwoFacesJoined) {
  Shells shells;
  const int loop = shells.half_edges()[make_ring(shells, 4).half].loop;
  const int other = shells.half_edges()[shells.mate(shells.loops()[loop].first)].loop;
  shells.kill_face_make_loop_hole(shells.loops()[loop].face, shells.loops()[other].face);
  EXPECT_EQ(shells.counts().holes, 1);
  EXPECT_EQ(shells_fault(shells), "");
  shells.make_face_kill_loop_hole(other);
  EXPECT_EQ(shells.counts().holes, 0);
  EXPECT_EQ(shells_fault(shells), "");
}

TEST(Shells, TwoShellsAreJoinedAndSeparated) {
  Shells shells;
  make_ring(shells, 3);
  const int face = shells.faces().numbers().front();
  const Shells::NewEdge closing = make_ring(shells, 5);
  const int loop = shells.half_edges()[closing.half].loop;
  shells.kill_face_make_loop_hole(face, shells.loops()[loop].face);
  EXPECT_EQ(shells.counts().shells, 1);
  EXPECT_EQ(shells_fault(shells), "");
  shells.make_face_kill_loop_hole(loop);
  EXPECT_EQ(shells.counts().shells, 2);
  EXPECT_EQ(shells.counts().holes, 0);
  EXPECT_EQ(shells_fault(shells), "");
}

TEST(Shells, WhatIsNotThereOrNotAsItMustBeIsNamed) {
  Shells shells;
  const Shells::NewEdge edge = make_ring(shells, 3);
  const auto message = [](const auto& call) -> std::string {
    try {
      call();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(message([&] { shells.make_edge_vertex(77, 77); }), "There is no half-edge 77.");
  EXPECT_EQ(message([&] { shells.make_edge_face(edge.half, edge.mate); }),
            "Half-edges " + std::to_string(edge.half) + " and " + std::to_string(edge.mate) +
                " are of two loops.");
  EXPECT_NE(message([&] { shells.kill_vertex_face_shell(0); }), "");
  EXPECT_NE(message([&] { shells.kill_edge_make_loop(edge.half); }), "");
  EXPECT_NE(message([&] { shells.make_face_kill_loop_hole(0); }), "");
  EXPECT_NE(message([&] { shells.kill_face_make_loop_hole(0, 0); }), "");
  EXPECT_EQ(shells_fault(shells), "");
}

}  // namespace
}  // namespace hull::network
