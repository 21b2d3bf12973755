#include "tamp/geometry/mesh_file.hpp"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cctype>
#include <filesystem>
#include <string_view>

#include "parser/files.hpp"

namespace praxis::tamp {

namespace {

constexpr std::uintmax_t kLargestFile = std::uintmax_t{256} << 20;
constexpr std::size_t kMostTriangles = 2'000'000;
constexpr std::array<std::string_view, 8> kFormats = {".stl", ".obj",  ".ply", ".off",
                                                      ".dae", ".gltf", ".glb", ".3ds"};

[[noreturn]] void refuse(const std::string& file, const std::string& why) {
    fail_unplaced("mesh " + file + ": " + why);
}

void require_readable(const std::string& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) refuse(file, "there is no such file");
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error || size > kLargestFile) refuse(file, "is larger than 256 MiB; simplify it");
    std::string extension = std::filesystem::path(file).extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (std::ranges::find(kFormats, extension) == kFormats.end()) {
        refuse(file, "is of an unknown format; convert it to .stl, .obj, .ply, .off, .dae, .gltf or .glb");
    }
}

void append(const aiMesh& part, const Vector3& scale, Mesh& mesh) {
    const std::size_t first = mesh.vertices.size();
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
        const aiVector3D& vertex = part.mVertices[i];
        const Vector3 scaled = Vector3(static_cast<double>(vertex.x), static_cast<double>(vertex.y),
                                       static_cast<double>(vertex.z))
                                   .cwiseProduct(scale);
        if (!scaled.allFinite()) refuse(mesh.name, "has a vertex that is not finite");
        mesh.vertices.push_back(scaled);
    }
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
        const aiFace& face = part.mFaces[i];
        if (face.mNumIndices != 3) continue;
        std::array<std::uint32_t, 3> triangle{};
        for (unsigned corner = 0; corner < 3; ++corner) {
            if (face.mIndices[corner] >= part.mNumVertices) refuse(mesh.name, "has an index out of range");
            triangle[corner] = static_cast<std::uint32_t>(first + face.mIndices[corner]);
        }
        mesh.triangles.push_back(triangle);
    }
    if (mesh.triangles.size() > kMostTriangles) {
        refuse(mesh.name, "has more than two million triangles; simplify it");
    }
}

}  // namespace

std::shared_ptr<const Mesh> read_mesh(const std::string& file, const Vector3& scale) {
    require_readable(file);
    if (!scale.allFinite()) refuse(file, "is scaled by a number that is not finite");
    Assimp::Importer importer;
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene =
        importer.ReadFile(file, aiProcess_Triangulate | aiProcess_JoinIdenticalVertices |
                                    aiProcess_PreTransformVertices | aiProcess_SortByPType);
    if (scene == nullptr) refuse(file, std::string("cannot be read: ") + importer.GetErrorString());
    Mesh mesh{.name = file};
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) append(*scene->mMeshes[i], scale, mesh);
    if (mesh.triangles.empty()) refuse(file, "has no triangles");
    return std::make_shared<const Mesh>(std::move(mesh));
}

}  // namespace praxis::tamp
