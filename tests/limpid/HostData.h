#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/ErrorOf.h"
#include "core/Error.h"
#include "gl/Api.h"
#include "scene/HostMesh.h"
#include "scene/HostWater.h"

/// What a host has of its own: a texture of heights, a mesh in buffers.
namespace limpid::test {

inline constexpr glm::ivec2 texels(128, 96);
inline const glm::dvec2 center(0.3, -0.1), size(4, 3);

/// A texture of heights f(x, z), as a host may make it.
class HostTexture {
  public:
    HostTexture() {
        glCreateTextures(GL_TEXTURE_2D, 1, &_id);
        glTextureStorage2D(_id, 1, GL_R32F, texels.x, texels.y);
    }
    ~HostTexture() { glDeleteTextures(1, &_id); }
    HostTexture(const HostTexture&) = delete;
    HostTexture& operator=(const HostTexture&) = delete;

    template <typename F>
    void fill(F f) const {
        std::vector<float> heights;
        for (int z = 0; z < texels.y; ++z)
            for (int x = 0; x < texels.x; ++x) {
                const glm::dvec2 at = center + size * ((glm::dvec2(x, z) + 0.5) / glm::dvec2(texels) - 0.5);
                heights.push_back(float(f(at.x, at.y)));
            }
        glTextureSubImage2D(_id, 0, 0, 0, texels.x, texels.y, GL_RED, GL_FLOAT, heights.data());
    }
    HostWater water() const { return {_id, texels, center, size, 0.05, 0.5}; }

  private:
    GLuint _id = 0;
};

/// A mesh in buffers as a host may lay them out: 8 bytes in front, then normal, 4 bytes of its own, position.
class HostBuffers {
  public:
    HostBuffers(const Mesh& mesh, int indexBytes) {
        _mesh.vertexOffset = 8;
        _mesh.vertexStride = 28;
        _mesh.normalOffset = 0;
        _mesh.positionOffset = 16;
        _mesh.vertexCount = int(mesh.positions.size());
        std::vector<std::byte> vertices(8 + 28 * mesh.positions.size());
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const glm::vec3 position(mesh.positions[i]), normal = 3.0f * mesh.normals[i];
            std::memcpy(&vertices[8 + 28 * i], &normal, 12);
            std::memcpy(&vertices[8 + 28 * i + 16], &position, 12);
            _mesh.bounds.add(glm::dvec3(position));
        }
        _mesh.vertexBuffer = upload(_buffers[0], vertices);
        _mesh.indexBytes = indexBytes;
        _mesh.indexOffset = 4;
        _mesh.indexCount = int(mesh.indices.size());
        std::vector<std::byte> indices((4 + std::size_t(indexBytes) * mesh.indices.size() + 3) / 4 * 4);
        for (std::size_t i = 0; i < mesh.indices.size(); ++i) // little-endian
            std::memcpy(&indices[4 + std::size_t(indexBytes) * i], &mesh.indices[i], std::size_t(indexBytes));
        _mesh.indexBuffer = upload(_buffers[1], indices);
    }
    ~HostBuffers() { glDeleteBuffers(2, _buffers); }
    HostBuffers(const HostBuffers&) = delete;
    HostBuffers& operator=(const HostBuffers&) = delete;

    HostMesh& mesh() { return _mesh; }

  private:
    static GLuint upload(GLuint& buffer, const std::vector<std::byte>& bytes) {
        glCreateBuffers(1, &buffer);
        glNamedBufferStorage(buffer, GLsizeiptr(bytes.size()), bytes.data(), 0);
        return buffer;
    }
    GLuint _buffers[2] = {};
    HostMesh _mesh;
};

inline double meanDifference(const std::vector<float>& a, const std::vector<float>& b) {
    EXPECT_EQ(a.size(), b.size());
    double difference = 0, sum = 0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        difference += std::abs(double(a[i]) - double(b[i])), sum += double(b[i]);
    return difference / sum;
}

} // namespace limpid::test
