// Assimp behind a small door: only the two formats, only from memory.
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>

#include "core/cloud/triangle_mesh.h"

namespace gripscan {
namespace {

void append(const aiMesh& part, TriangleMesh& mesh) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
        const aiVector3D& v = part.mVertices[i];
        mesh.vertices.emplace_back(v.x, v.y, v.z);
    }
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
        const aiFace& face = part.mFaces[i];
        if (face.mNumIndices != 3) continue;  // points and lines have no surface
        const unsigned* corner = face.mIndices;
        if (std::max({corner[0], corner[1], corner[2]}) >= part.mNumVertices) continue;
        mesh.triangles.push_back({first + corner[0], first + corner[1], first + corner[2]});
    }
}

/// Assimp's messages may span lines.
std::string one_line(std::string text) {
    for (char& c : text) {
        if (c == '\n' || c == '\r') c = ' ';
    }
    return text;
}

}  // namespace

Result<TriangleMesh> decode_mesh(std::string_view bytes, const std::string& format) {
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFileFromMemory(
        bytes.data(), bytes.size(), aiProcess_Triangulate | aiProcess_SortByPType, format.c_str());
    if (scene == nullptr) {
        return input_error("this is no usable {} mesh: {}", format,
                           one_line(importer.GetErrorString()));
    }
    TriangleMesh mesh;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) append(*scene->mMeshes[i], mesh);
    if (mesh.triangles.empty()) return input_error("the {} mesh has no triangles", format);
    return mesh;
}

}  // namespace gripscan
