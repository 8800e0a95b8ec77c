// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_from_bytes.h"

#include <algorithm>
#include <limits>

#include "test_meshes.h"

namespace hull::fuzz {
namespace {

using Faces = std::vector<std::vector<int>>;

constexpr std::size_t kMostFaces = 120;
constexpr int kMostEdits = 40;

mesh::MeshArrays nonsense(ByteReader& bytes) {
  mesh::MeshArrays mesh;
  for (int i = bytes.below(12); i > 0; --i) {
    mesh.points.push_back(bytes.point());
  }
  for (int i = bytes.below(12); i > 0; --i) mesh.face_sizes.push_back(bytes.byte() % 8 - 1);
  if (bytes.byte() % 16 == 0 && !mesh.face_sizes.empty()) {
    mesh.face_sizes.back() = std::numeric_limits<int>::max() - bytes.byte();
  }
  const auto vertex = [&] { return bytes.byte() % 14 - 1; };
  for (int i = bytes.below(60); i > 0; --i) mesh.face_vertices.push_back(vertex());
  for (int i = bytes.below(6); i > 0; --i) mesh.creases.push_back({vertex(), vertex()});
  for (int i = bytes.below(4); i > 0; --i) mesh.corners.push_back(vertex());
  return mesh;
}

mesh::MeshArrays sound_mesh(ByteReader& bytes) {
  const int kind = bytes.below(5);
  // High valences are slow under the sanitizers: draw them seldom.
  const int size = bytes.byte();
  const int n = 3 + (size < 240 ? size % 7 : size % 30);
  if (kind == 0) return testing::cube();
  if (kind == 1) return testing::grid(1 + size % 4, 1 + size / 4 % 4);
  if (kind == 2) return testing::fan(std::min(n, 16));
  return kind == 3 ? testing::prism(n) : testing::double_pyramid(n);
}

// Changes to the faces, kept as lists; afterwards they are arrays again.
class Editor {
 public:
  Editor(mesh::MeshArrays& mesh, ByteReader& bytes) : mesh_(mesh), bytes_(bytes) {
    std::size_t begin = 0;
    for (int size : mesh.face_sizes) {
      faces_.emplace_back(mesh.face_vertices.begin() + begin,
                          mesh.face_vertices.begin() + begin + size);
      begin += size;
    }
  }

  void edit() {
    for (int i = 0; i < kMostEdits && !bytes_.at_end(); ++i) {
      if (faces_.empty() || faces_.size() > kMostFaces) break;
      edit_once();
    }
    mesh_.face_sizes.clear();
    mesh_.face_vertices.clear();
    for (const auto& face : faces_) testing::add_face(mesh_, face);
  }

 private:
  int point_count() const { return static_cast<int>(mesh_.points.size()); }
  int any_point() { return bytes_.below(point_count()); }
  std::size_t any_face() { return bytes_.below(static_cast<int>(faces_.size())); }
  std::size_t any_corner(const std::vector<int>& face) {
    return bytes_.below(static_cast<int>(face.size()));
  }
  int new_point(const std::vector<int>& between) {
    Eigen::Vector3d sum = 0.1 * bytes_.point();
    for (int v : between) sum += mesh_.points[v] / static_cast<double>(between.size());
    mesh_.points.push_back(sum);
    return point_count() - 1;
  }
  void remove(std::size_t face) { faces_.erase(faces_.begin() + static_cast<long>(face)); }

  void edit_once() {
    const int what = bytes_.byte() % 26;
    const std::size_t f = any_face();
    // Later edits may have to do with faces broken by earlier ones.
    const bool usable =
        faces_[f].size() >= 3 && std::all_of(faces_[f].begin(), faces_[f].end(),
                                             [this](int v) { return v >= 0 && v < point_count(); });
    if (what < 12) {
      if (usable) tag_or_move(what, f);
    } else if (what < 20) {
      if (usable) reshape(what, f);
    } else {
      damage(what, f);
    }
  }

  void tag_or_move(int what, std::size_t f) {
    const std::vector<int>& face = faces_[f];
    const std::size_t i = any_corner(face);
    if (what < 5) {
      mesh_.creases.push_back({face[i], face[(i + 1) % face.size()]});
    } else if (what == 5) {
      for (std::size_t k = 0; k < face.size(); ++k) {
        mesh_.creases.push_back({face[k], face[(k + 1) % face.size()]});
      }
    } else if (what == 6) {
      mesh_.corners.push_back(face[i]);
    } else if (what == 7) {
      mesh_.round_border_corners = !mesh_.round_border_corners;
    } else if (what == 8) {
      mesh_.points[face[i]] = mesh_.points[any_point()];
    } else {
      for (double& x : mesh_.points[face[i]]) x = bytes_.number();
    }
  }

  void reshape(int what, std::size_t f) {
    const std::vector<int> face = faces_[f];
    const std::size_t n = face.size(), i = any_corner(face);
    if (what == 12) {
      remove(f);
    } else if (what == 13) {
      cut(f, i);
    } else if (what == 14) {
      const int centre = new_point(face);
      remove(f);
      for (std::size_t k = 0; k < n; ++k) faces_.push_back({face[k], face[(k + 1) % n], centre});
    } else if (what == 15) {
      std::vector<int> top;
      for (int v : face) top.push_back(new_point({v}));
      for (std::size_t k = 0; k < n; ++k) {
        faces_.push_back({face[k], face[(k + 1) % n], top[(k + 1) % n], top[k]});
      }
      faces_[f] = top;
    } else if (what == 16) {
      divide_edge(face[i], face[(i + 1) % n]);
    } else if (what == 17) {
      dissolve_edge(f, i);
    } else if (what == 18) {
      for (auto& other : faces_) std::reverse(other.begin(), other.end());
    } else {
      std::rotate(faces_[f].begin(), faces_[f].begin() + static_cast<long>(i), faces_[f].end());
      std::swap(faces_[f], faces_[any_face()]);
    }
  }

  // Joins two corners of the face that are not neighbours.
  void cut(std::size_t f, std::size_t i) {
    std::vector<int> face = faces_[f];
    if (face.size() < 4) return;
    std::rotate(face.begin(), face.begin() + static_cast<long>(i), face.end());
    const long j = 2 + bytes_.below(static_cast<int>(face.size()) - 3);
    faces_[f].assign(face.begin(), face.begin() + j + 1);
    faces_.emplace_back(face.begin() + j, face.end());
    faces_.back().push_back(face.front());
  }

  void divide_edge(int a, int b) {
    const int middle = new_point({a, b});
    for (auto& face : faces_) {
      for (std::size_t k = 0; k < face.size(); ++k) {
        const int p = face[k], q = face[(k + 1) % face.size()];
        if ((p == a && q == b) || (p == b && q == a)) {
          face.insert(face.begin() + static_cast<long>(k) + 1, middle);
          break;
        }
      }
    }
  }

  // Joins the face with its neighbour at side i.
  void dissolve_edge(std::size_t f, std::size_t i) {
    std::vector<int> face = faces_[f];
    std::rotate(face.begin(), face.begin() + static_cast<long>((i + 1) % face.size()), face.end());
    const int a = face.back(), b = face.front();
    for (std::size_t g = 0; g < faces_.size(); ++g) {
      std::vector<int> other = faces_[g];
      const auto at = std::find(other.begin(), other.end(), b);
      if (g == f || other.size() < 3 || at == other.end()) continue;
      std::rotate(other.begin(), at, other.end());
      if (other[1] != a) continue;
      face.insert(face.end(), other.begin() + 2, other.end());
      faces_[f] = face;
      remove(g);
      return;
    }
  }

  void damage(int what, std::size_t f) {
    if (what == 20) {
      std::reverse(faces_[f].begin(), faces_[f].end());
    } else if (what == 21) {
      const int from = any_point(), to = any_point();
      for (auto& face : faces_) std::replace(face.begin(), face.end(), from, to);
    } else if (what == 22) {
      if (!faces_[f].empty()) faces_[f][any_corner(faces_[f])] = bytes_.byte() - 2;
    } else if (what == 23) {
      faces_.push_back(faces_[f]);
    } else if (what == 24) {
      mesh_.points.push_back(bytes_.point());
    } else if (bytes_.byte() % 2) {
      mesh_.creases.push_back({any_point() - 1, any_point()});
    } else if (!faces_[f].empty()) {
      faces_[f].pop_back();
    }
  }

  mesh::MeshArrays& mesh_;
  ByteReader& bytes_;
  Faces faces_;
};

// A second body beside the first, sharing no point with it.
void append(mesh::MeshArrays& mesh, const mesh::MeshArrays& other) {
  const int offset = static_cast<int>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  mesh.face_sizes.insert(mesh.face_sizes.end(), other.face_sizes.begin(), other.face_sizes.end());
  for (int v : other.face_vertices) mesh.face_vertices.push_back(v + offset);
}

}  // namespace

Eigen::Vector3d ByteReader::point() {
  Eigen::Vector3d p;
  for (double& x : p) x = number();
  return p;
}

double ByteReader::number() {
  const int drawn = byte();
  if (drawn < 240) return (byte() - 128) / 64.0 + drawn / 4096.0;
  constexpr double kWild[] = {0.0,
                              -0.0,
                              1.0,
                              1e-320,
                              -1e-200,
                              1e-15,
                              1e9,
                              -1e9,
                              1.0000001e9,
                              1e300,
                              -1.7e308,
                              std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN(),
                              1e6,
                              1.0 + 1e-15,
                              -12345.678};
  return kWild[drawn - 240];
}

mesh::MeshArrays mesh_from_bytes(ByteReader& bytes) {
  const int kind = bytes.byte();
  if (kind % 8 == 0) return nonsense(bytes);
  mesh::MeshArrays mesh = sound_mesh(bytes);
  if (kind % 8 == 1) append(mesh, sound_mesh(bytes));
  Editor(mesh, bytes).edit();
  return mesh;
}

}  // namespace hull::fuzz
