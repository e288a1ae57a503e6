#include "levelmap/HostTriangles.h"

#include <algorithm>
#include <cstring>
#include <numeric>

#include "core/ShaderData.h"
#include "gl/Bindings.h"
#include "gl/Program.h"
#include "gl/Reset.h"

namespace limpid {

namespace {

constexpr int groupSize = 64, word = 4, vertexBytes = word * gpu::vertexWords;

int cornersOf(const HostMesh& mesh) {
    return mesh.indexBuffer ? mesh.indexCount : mesh.vertexCount;
}

glm::mat4 matrixOf(const glm::dmat3& axes, const glm::dvec3& translation) {
    glm::dmat4 matrix(axes);
    matrix[3] = glm::dvec4(translation, 1);
    return glm::mat4(matrix);
}

void setLayout(const gl::Program& program, const Receiver& receiver, const glm::dvec3& origin) {
    const HostMesh& mesh = *receiver.host;
    const glm::dmat3 turn = glm::mat3_cast(receiver.rotation);
    const auto stretched = [&](const glm::dvec3& by) {
        return glm::dmat3(turn[0] * by.x, turn[1] * by.y, turn[2] * by.z);
    };
    program.set(toWorldLocation, matrixOf(stretched(receiver.scale), receiver.translation - origin));
    program.set(normalToWorldLocation, matrixOf(stretched(1.0 / receiver.scale), glm::dvec3(0)));
    program.set(vertexLayoutLocation, glm::ivec2(mesh.vertexOffset / word, mesh.vertexStride / word));
    program.set(offsetsLocation,
                glm::ivec2(mesh.positionOffset / word, mesh.normalOffset ? *mesh.normalOffset / word : -1));
    program.set(countsLocation, glm::ivec2(mesh.vertexCount, cornersOf(mesh)));
    program.set(indexLayoutLocation,
                glm::ivec2(mesh.indexOffset / word, mesh.indexBuffer ? mesh.indexBytes : 0));
}

std::vector<std::uint32_t> readIndices(const HostMesh& mesh) {
    std::vector<std::uint32_t> indices(std::size_t(cornersOf(mesh)));
    if (!mesh.indexBuffer) {
        std::iota(indices.begin(), indices.end(), 0u);
        return indices;
    }
    std::vector<std::byte> bytes(indices.size() * std::size_t(mesh.indexBytes));
    glGetNamedBufferSubData(mesh.indexBuffer, mesh.indexOffset, GLsizeiptr(bytes.size()), bytes.data());
    for (std::size_t i = 0; i < indices.size(); ++i)
        std::memcpy(&indices[i], &bytes[i * std::size_t(mesh.indexBytes)], std::size_t(mesh.indexBytes));
    for (std::uint32_t& index : indices)
        index = std::min(index, std::uint32_t(mesh.vertexCount - 1));
    return indices;
}

} // namespace

HostTriangles hostTriangles(gl::Context& context, const Receiver& receiver, const glm::dvec3& origin) {
    const HostMesh& mesh = *receiver.host;
    const gl::Program program({"levelmap/host_mesh.comp"});
    HostTriangles own;
    own.indexCount = cornersOf(mesh);
    own.vertices = gl::Buffer(context.ledger(), "meshes", std::int64_t(mesh.vertexCount) * vertexBytes);
    own.indices = gl::Buffer(context.ledger(), "meshes", std::int64_t(own.indexCount) * word);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT); // what the host's own passes wrote
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, hostVerticesBuffer, mesh.vertexBuffer);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, hostIndicesBuffer,
                     mesh.indexBuffer ? mesh.indexBuffer : mesh.vertexBuffer);
    own.vertices.bindStorage(verticesBuffer);
    own.indices.bindStorage(indicesBuffer);
    setLayout(program, receiver, origin);
    program.dispatch(std::max(mesh.vertexCount, own.indexCount), groupSize);
    glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT);
    for (const int binding : {hostVerticesBuffer, hostIndicesBuffer}) // the host's buffers may go
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, GLuint(binding), 0);
    return own;
}

Mesh readTriangles(const HostMesh& mesh) {
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    const std::size_t stride = std::size_t(mesh.vertexStride);
    std::vector<std::byte> bytes(stride * std::size_t(mesh.vertexCount - 1) +
                                 std::size_t(mesh.positionOffset) + 12);
    glGetNamedBufferSubData(mesh.vertexBuffer, mesh.vertexOffset, GLsizeiptr(bytes.size()), bytes.data());
    Mesh own;
    for (std::size_t i = 0; i < std::size_t(mesh.vertexCount); ++i) {
        glm::vec3 position;
        std::memcpy(&position, &bytes[i * stride + std::size_t(mesh.positionOffset)], sizeof(position));
        own.positions.emplace_back(position);
    }
    own.indices = readIndices(mesh);
    gl::requireContext();
    own.parts = {{0, std::uint32_t(own.indices.size()), 0}};
    own.materials.resize(1);
    return own;
}

} // namespace limpid
