// SPDX-License-Identifier: Apache-2.0
// Meshes from files, by assimp, and from heights.
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <map>
#include <stdexcept>

#include "horopter/error.hpp"
#include "horopter/image.hpp"
#include "horopter/surface.hpp"

namespace horopter {

using Eigen::Vector3d;

TriangleMesh read_mesh(const std::filesystem::path& path, double unit_mm) {
  const std::string expected = "a mesh (PLY, STL or OBJ)";
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  if (extension != ".ply" && extension != ".stl" && extension != ".obj") {
    throw FileError(path.string(), "", "a file named '" + extension + "'", expected);
  }
  const auto bytes = read_file(path, expected);
  Assimp::Importer importer;
  const aiScene* scene =
      importer.ReadFileFromMemory(bytes.data(), bytes.size(), aiProcess_Triangulate, extension.c_str() + 1);
  if (scene == nullptr) throw FileError(path.string(), "", importer.GetErrorString(), expected);
  if ((scene->mFlags & AI_SCENE_FLAGS_INCOMPLETE) != 0 || scene->mNumMeshes == 0) {
    throw FileError(path.string(), "", "no complete mesh", expected);
  }
  TriangleMesh result;
  std::map<std::array<float, 3>, std::uint32_t> places;  // STL repeats each vertex in each triangle
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const aiMesh& mesh = *scene->mMeshes[m];
    std::vector<std::uint32_t> index;
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D& at = mesh.mVertices[v];
      // + 0 makes −0 and 0 one place.
      const auto [place, is_new] = places.try_emplace({at.x + 0.0F, at.y + 0.0F, at.z + 0.0F},
                                                      static_cast<std::uint32_t>(result.vertices_mm.size()));
      if (is_new) result.vertices_mm.emplace_back(unit_mm * Vector3d(at.x, at.y, at.z));
      index.push_back(place->second);
    }
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3)
        throw FileError(path.string(), fmt::format("face {}", f), "a point or a line", "triangles");
      result.triangles.push_back({index.at(face.mIndices[0]), index.at(face.mIndices[1]), index.at(face.mIndices[2])});
    }
  }
  return result;
}

TriangleMesh height_field(const Vector3d& origin_mm, const Eigen::Vector2d& step_mm,
                          const std::vector<std::vector<double>>& heights_mm) {
  if (!(step_mm.cwiseAbs().minCoeff() > 0)) throw std::invalid_argument("the steps of a height field are not 0");
  if (heights_mm.size() < 2 || heights_mm[0].size() < 2) {
    throw std::invalid_argument("a height field has 2 or more rows of 2 or more heights");
  }
  TriangleMesh mesh;
  const std::size_t columns = heights_mm[0].size();
  for (std::size_t row = 0; row < heights_mm.size(); ++row) {
    if (heights_mm[row].size() != columns) throw std::invalid_argument("rows of a height field have one length");
    for (std::size_t column = 0; column < columns; ++column) {
      mesh.vertices_mm.emplace_back(origin_mm + Vector3d(static_cast<double>(column) * step_mm.x(),
                                                         static_cast<double>(row) * step_mm.y(),
                                                         heights_mm[row][column]));
    }
  }
  for (std::size_t row = 0; row + 1 < heights_mm.size(); ++row) {
    for (std::size_t column = 0; column + 1 < columns; ++column) {
      const auto at = static_cast<std::uint32_t>(row * columns + column);
      const auto below = static_cast<std::uint32_t>(at + columns);
      mesh.triangles.push_back({at, at + 1, below + 1});
      mesh.triangles.push_back({at, below + 1, below});
    }
  }
  mesh.open = true;
  return mesh;
}

}  // namespace horopter
