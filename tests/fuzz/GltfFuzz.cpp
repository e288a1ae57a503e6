// Any bytes as a .glb or .gltf file: they load as a model that holds together, or are an InputError of one
// line.
#include <cmath>

#include "FuzzFile.h"
#include "Require.h"
#include "core/Error.h"
#include "io/gltf/Gltf.h"

namespace limpid {
namespace {

void checkModel(const Model& model) {
    const Mesh& mesh = model.mesh;
    const std::size_t vertices = mesh.positions.size();
    fuzz::require(!mesh.indices.empty() && mesh.indices.size() % 3 == 0);
    fuzz::require(mesh.normals.size() == vertices && mesh.uvs.size() == vertices);
    fuzz::require(mesh.colors.empty() || mesh.colors.size() == vertices);
    fuzz::require(mesh.normalUvs.empty() || mesh.normalUvs.size() == vertices);
    for (const std::uint32_t index : mesh.indices)
        fuzz::require(index < vertices);
    for (std::size_t i = 0; i < vertices; ++i) {
        const glm::dvec3 p = mesh.positions[i];
        fuzz::require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
        const glm::vec3 n = mesh.normals[i];
        fuzz::require(std::abs(glm::dot(n, n) - 1) < 1e-3f);
    }
    for (const MeshPart& part : mesh.parts)
        fuzz::require(part.firstIndex + std::size_t(part.indexCount) <= mesh.indices.size() &&
                      part.material < int(mesh.materials.size()));
    for (const Material& material : mesh.materials) {
        fuzz::require(material.transmission >= 0 && material.transmission <= 1);
        for (int c = 0; c < 3; ++c)
            fuzz::require(material.emission[c] >= 0 && std::isfinite(material.emission[c]));
        for (const int image : {material.baseColorImage, material.normalImage, material.transmissionImage,
                                material.emissionImage})
            fuzz::require(image < int(mesh.images.size()));
    }
    std::size_t vertex = 0;
    for (const MeshNode& node : mesh.nodes) {
        fuzz::require(node.firstVertex == vertex);
        vertex += node.vertexCount;
    }
    fuzz::require(vertex == vertices);
    for (const std::string& notice : mesh.notices)
        fuzz::requireOneLine(notice);
}

} // namespace
} // namespace limpid

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static limpid::fuzz::FuzzFile file("model.gltf");
    try {
        limpid::checkModel(limpid::io::loadModel(file.write(data, size)));
    } catch (const limpid::InputError& error) {
        limpid::fuzz::requireOneLine(error.what());
    }
    return 0;
}
