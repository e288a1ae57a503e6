#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "gl/Api.h"
#include "gl/Ledger.h"

/// Owners of OpenGL objects: move-only, empty after a move, labelled with their kind, their bytes in the
/// ledger.
namespace limpid::gl {

/// Immutable-size storage on the GPU.
class Buffer {
  public:
    Buffer() = default;
    /// `data` may be null: the content is then undefined.
    Buffer(Ledger& ledger, std::string kind, std::int64_t bytes, const void* data = nullptr);
    template <typename T>
    Buffer(Ledger& ledger, std::string kind, std::span<const T> data)
        : Buffer(ledger, std::move(kind), std::int64_t(data.size_bytes()), data.data()) {}
    ~Buffer() { reset(); }
    Buffer(Buffer&& other) noexcept { swap(other); }
    Buffer& operator=(Buffer&& other) noexcept {
        Buffer moved(std::move(other));
        swap(moved);
        return *this;
    }

    GLuint id() const { return _id; }
    std::int64_t bytes() const { return _bytes; }
    void write(std::int64_t offset, std::int64_t bytes, const void* data);
    void clearToZero();
    /// Begins with `bytes` of another buffer, from `offset` on.
    void copy(const Buffer& from, std::int64_t offset, std::int64_t bytes);
    void bindStorage(GLuint binding) const { glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, _id); }
    void bindUniform(GLuint binding) const { glBindBufferBase(GL_UNIFORM_BUFFER, binding, _id); }

    /// Waits for the GPU and copies `count` elements, from element `first` on.
    template <typename T>
    std::vector<T> read(std::size_t count, std::size_t first = 0) const {
        std::vector<T> out(count);
        readBytes(out.data(), std::int64_t(first * sizeof(T)), std::int64_t(count * sizeof(T)));
        return out;
    }

  private:
    void readBytes(void* out, std::int64_t offset, std::int64_t bytes) const;
    void reset();
    void swap(Buffer& other) noexcept;
    GLuint _id = 0;
    std::int64_t _bytes = 0;
    std::string _kind;
    Ledger* _ledger = nullptr;
};

enum class Mipmaps { None, Full };
/// Of a texture array; none: a plain texture.
struct Layers {
    int count = 0;
};

/// A two-dimensional texture, or an array of such.
class Texture {
  public:
    Texture() = default;
    Texture(Ledger& ledger, std::string kind, GLenum internalFormat, glm::ivec2 size,
            Mipmaps mipmaps = Mipmaps::None)
        : Texture(ledger, std::move(kind), internalFormat, size, mipmaps, Layers{}) {}
    Texture(Ledger& ledger, std::string kind, GLenum internalFormat, glm::ivec2 size, Layers layers)
        : Texture(ledger, std::move(kind), internalFormat, size, Mipmaps::None, layers) {}
    ~Texture() { reset(); }
    Texture(Texture&& other) noexcept { swap(other); }
    Texture& operator=(Texture&& other) noexcept {
        Texture moved(std::move(other));
        swap(moved);
        return *this;
    }

    GLuint id() const { return _id; }
    glm::ivec2 size() const { return _size; }
    int levels() const { return _levels; }
    int layers() const { return _layers; }
    GLenum internalFormat() const { return _format; }
    void bind(GLuint unit) const { glBindTextureUnit(unit, _id); }
    void bindImage(GLuint unit, GLenum access, int level = 0) const {
        glBindImageTexture(unit, _id, level, GL_FALSE, 0, access, _format);
    }
    /// Fills the texture; its smaller levels follow.
    void upload(GLenum format, GLenum type, const void* data);
    void setFilter(GLenum filter, GLenum wrap);
    /// Waits for the GPU and returns width · height · channels floats, row 0 first, layer by layer; `format`
    /// says the channels.
    std::vector<float> readFloats(GLenum format, int channels) const;
    /// The same in bytes, [0, 1] as [0, 255].
    std::vector<std::uint8_t> readBytes(GLenum format, int channels) const;

  private:
    Texture(Ledger& ledger, std::string kind, GLenum internalFormat, glm::ivec2 size, Mipmaps mipmaps,
            Layers layers);
    template <typename T>
    std::vector<T> read(GLenum format, GLenum type, int channels) const;
    void reset();
    void swap(Texture& other) noexcept;
    GLuint _id = 0;
    GLenum _format = 0;
    glm::ivec2 _size{0};
    int _levels = 1;
    int _layers = 0;
    std::int64_t _bytes = 0;
    std::string _kind;
    Ledger* _ledger = nullptr;
};

/// The next reader of the targets. Software OpenGL runs compute programs while triangles are still being
/// filled, unless a barrier stands between, which the specification does not ask for.
enum class SeenBy { Compute, Draws };

/// Render targets; color attachment i is `colors[i]`, of an array its `layer`.
class Framebuffer {
  public:
    Framebuffer() = default;
    Framebuffer(std::string label, std::span<const Texture* const> colors, const Texture* depth = nullptr,
                int layer = 0, SeenBy next = SeenBy::Compute);
    ~Framebuffer() {
        if (!_id) return;
        glDeleteFramebuffers(1, &_id);
        if (_next == SeenBy::Compute) glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    }
    Framebuffer(Framebuffer&& other) noexcept
        : _id(std::exchange(other._id, 0)), _size(other._size), _next(other._next) {}
    Framebuffer& operator=(Framebuffer&& other) noexcept {
        std::swap(_id, other._id);
        std::swap(_size, other._size);
        std::swap(_next, other._next);
        return *this;
    }

    GLuint id() const { return _id; }
    /// Makes this the draw target, with a viewport over all of it or over a part.
    void bind() const { bind({0, 0}, _size); }
    void bind(glm::ivec2 corner, glm::ivec2 size) const;
    void clearColor(const glm::vec4& value, int attachment = 0) const;
    void clearDepth(float value) const;
    /// Of a depth buffer that has a stencil, GL_DEPTH32F_STENCIL8.
    void clearDepthStencil(float depth, int stencil) const;

  private:
    GLuint _id = 0;
    glm::ivec2 _size{0};
    SeenBy _next = SeenBy::Compute;
};

class VertexArray {
  public:
    VertexArray() { glCreateVertexArrays(1, &_id); }
    ~VertexArray() {
        if (_id) glDeleteVertexArrays(1, &_id);
    }
    VertexArray(VertexArray&& other) noexcept : _id(std::exchange(other._id, 0)) {}
    VertexArray& operator=(VertexArray&& other) noexcept {
        std::swap(_id, other._id);
        return *this;
    }

    GLuint id() const { return _id; }
    void bind() const { glBindVertexArray(_id); }
    /// Attribute `index` has `components` floats at `offset` in a vertex of `stride` bytes of `buffer`.
    void attribute(GLuint index, const Buffer& buffer, int components, int offset, int stride);
    /// Attribute `index` has four unsigned 16-bit integers, [0, 65535] read as [0, 1].
    void shortAttribute(GLuint index, const Buffer& buffer, int offset, int stride);
    void indices(const Buffer& buffer) { glVertexArrayElementBuffer(_id, buffer.id()); }

  private:
    GLuint _id = 0;
};

} // namespace limpid::gl
