#include "gl/Handles.h"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>

#include "core/Error.h"
#include "gl/PixelTransfer.h"
#include "gl/Reset.h"

namespace limpid::gl {

namespace {

int bytesPerTexel(GLenum format) {
    switch (format) {
    case GL_R8:
        return 1;
    case GL_RGBA8:
    case GL_SRGB8_ALPHA8:
    case GL_RG16:
    case GL_R32F:
    case GL_R32UI:
    case GL_DEPTH_COMPONENT32F:
        return 4;
    case GL_RG32F:
    case GL_RGBA16:
    case GL_RGBA16F:
    case GL_DEPTH32F_STENCIL8:
        return 8;
    case GL_RGBA32F:
        return 16;
    default:
        throw GraphicsError(
            fmt::format("texture format: expected one the ledger knows, found {:#x}", format));
    }
}

/// A driver reports out-of-memory as an error after the call; nothing else of the program's own calls can
/// fail. A constructor that throws has no destructor run, so what there is goes by `undo`.
template <typename Undo>
void checkAllocation(const std::string& kind, std::int64_t bytes, Undo undo) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) return;
    undo();
    requireContext();
    throw GraphicsError(
        fmt::format("{}: expected room for {} bytes on the GPU, found {}", kind, bytes,
                    error == GL_OUT_OF_MEMORY ? "out of memory" : fmt::format("GL error {:#x}", error)));
}

} // namespace

Buffer::Buffer(Ledger& ledger, std::string kind, std::int64_t bytes, const void* data)
    : _bytes(std::max<std::int64_t>(bytes, 16)), _kind(std::move(kind)), _ledger(&ledger) {
    assert(bytes >= 0);
    ledger.require(_kind, _bytes);
    glCreateBuffers(1, &_id);
    glNamedBufferStorage(_id, _bytes, _bytes == bytes ? data : nullptr, GL_DYNAMIC_STORAGE_BIT);
    glObjectLabel(GL_BUFFER, _id, -1, _kind.c_str());
    checkAllocation(_kind, _bytes, [this] { glDeleteBuffers(1, &_id); });
    if (data && _bytes != bytes && bytes > 0) write(0, bytes, data);
    _ledger->add(_kind, _bytes);
}

void Buffer::write(std::int64_t offset, std::int64_t bytes, const void* data) {
    assert(_id != 0 && offset >= 0 && offset + bytes <= _bytes);
    if (bytes > 0) glNamedBufferSubData(_id, offset, bytes, data);
}

void Buffer::clearToZero() {
    glClearNamedBufferData(_id, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
}

void Buffer::copy(const Buffer& from, std::int64_t offset, std::int64_t bytes) {
    assert(_id != 0 && offset + bytes <= from._bytes && bytes <= _bytes);
    glCopyNamedBufferSubData(from._id, _id, offset, 0, bytes);
}

void Buffer::readBytes(void* out, std::int64_t offset, std::int64_t bytes) const {
    assert(_id != 0 && offset >= 0 && offset + bytes <= _bytes);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    if (bytes > 0) glGetNamedBufferSubData(_id, offset, bytes, out);
    requireContext();
}

void Buffer::reset() {
    if (!_id) return;
    glDeleteBuffers(1, &_id);
    _ledger->remove(_kind, _bytes);
    _id = 0;
}

void Buffer::swap(Buffer& other) noexcept {
    std::swap(_id, other._id);
    std::swap(_bytes, other._bytes);
    std::swap(_kind, other._kind);
    std::swap(_ledger, other._ledger);
}

namespace {

int levelsOf(glm::ivec2 size, Mipmaps mipmaps) {
    int levels = 1;
    for (int side = std::max(size.x, size.y); mipmaps == Mipmaps::Full && side > 1; side /= 2)
        ++levels;
    return levels;
}

std::int64_t textureBytes(glm::ivec2 size, int levels, GLenum format) {
    std::int64_t texels = 0;
    for (int i = 0; i < levels; ++i)
        texels += std::int64_t(std::max(size.x >> i, 1)) * std::max(size.y >> i, 1);
    return texels * bytesPerTexel(format);
}

} // namespace

Texture::Texture(Ledger& ledger, std::string kind, GLenum internalFormat, glm::ivec2 size, Mipmaps mipmaps,
                 Layers layers)
    : _format(internalFormat), _size(size), _levels(levelsOf(size, mipmaps)), _layers(layers.count),
      _bytes(textureBytes(size, _levels, internalFormat) * std::max(_layers, 1)), _kind(std::move(kind)),
      _ledger(&ledger) {
    assert(size.x >= 1 && size.y >= 1);
    ledger.require(_kind, _bytes);
    glCreateTextures(_layers > 0 ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D, 1, &_id);
    if (_layers > 0)
        glTextureStorage3D(_id, _levels, internalFormat, size.x, size.y, _layers);
    else
        glTextureStorage2D(_id, _levels, internalFormat, size.x, size.y);
    setFilter(GL_NEAREST, GL_CLAMP_TO_EDGE);
    glObjectLabel(GL_TEXTURE, _id, -1, _kind.c_str());
    checkAllocation(_kind, _bytes, [this] { glDeleteTextures(1, &_id); });
    _ledger->add(_kind, _bytes);
}

void Texture::upload(GLenum format, GLenum type, const void* data) {
    const PixelTransfer transfer;
    glTextureSubImage2D(_id, 0, 0, 0, _size.x, _size.y, format, type, data);
    if (_levels > 1) glGenerateTextureMipmap(_id);
}

void Texture::setFilter(GLenum filter, GLenum wrap) {
    const GLenum smaller = _levels > 1 && filter == GL_LINEAR ? GL_LINEAR_MIPMAP_LINEAR : filter;
    glTextureParameteri(_id, GL_TEXTURE_MIN_FILTER, GLint(smaller));
    glTextureParameteri(_id, GL_TEXTURE_MAG_FILTER, GLint(filter));
    glTextureParameteri(_id, GL_TEXTURE_WRAP_S, GLint(wrap));
    glTextureParameteri(_id, GL_TEXTURE_WRAP_T, GLint(wrap));
}

template <typename T>
std::vector<T> Texture::read(GLenum format, GLenum type, int channels) const {
    assert(_id != 0 && channels >= 1 && channels <= 4);
    glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
    const PixelTransfer transfer;
    std::vector<T> out(std::size_t(_size.x) * std::size_t(_size.y) * std::size_t(std::max(_layers, 1)) *
                       std::size_t(channels));
    glGetTextureImage(_id, 0, format, type, GLsizei(out.size() * sizeof(T)), out.data());
    requireContext();
    return out;
}

std::vector<float> Texture::readFloats(GLenum format, int channels) const {
    return read<float>(format, GL_FLOAT, channels);
}

std::vector<std::uint8_t> Texture::readBytes(GLenum format, int channels) const {
    return read<std::uint8_t>(format, GL_UNSIGNED_BYTE, channels);
}

void Texture::reset() {
    if (!_id) return;
    glDeleteTextures(1, &_id);
    _ledger->remove(_kind, _bytes);
    _id = 0;
}

void Texture::swap(Texture& other) noexcept {
    std::swap(_id, other._id);
    std::swap(_format, other._format);
    std::swap(_size, other._size);
    std::swap(_levels, other._levels);
    std::swap(_layers, other._layers);
    std::swap(_bytes, other._bytes);
    std::swap(_kind, other._kind);
    std::swap(_ledger, other._ledger);
}

Framebuffer::Framebuffer(std::string label, std::span<const Texture* const> colors, const Texture* depth,
                         int layer, SeenBy next)
    : _next(next) {
    glCreateFramebuffers(1, &_id);
    glObjectLabel(GL_FRAMEBUFFER, _id, -1, label.c_str());
    std::vector<GLenum> attachments;
    for (const Texture* color : colors) {
        attachments.push_back(GLenum(GL_COLOR_ATTACHMENT0 + attachments.size()));
        if (color->layers() > 0)
            glNamedFramebufferTextureLayer(_id, attachments.back(), color->id(), 0, layer);
        else
            glNamedFramebufferTexture(_id, attachments.back(), color->id(), 0);
        _size = color->size();
    }
    if (depth) {
        const bool stencil = depth->internalFormat() == GL_DEPTH32F_STENCIL8;
        glNamedFramebufferTexture(_id, stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
                                  depth->id(), 0);
        _size = depth->size();
    }
    glNamedFramebufferDrawBuffers(_id, GLsizei(attachments.size()), attachments.data());
    const GLenum status = glCheckNamedFramebufferStatus(_id, GL_DRAW_FRAMEBUFFER);
    if (status == GL_FRAMEBUFFER_COMPLETE) return;
    requireContext();
    throw GraphicsError(
        fmt::format("{}: expected a complete framebuffer, found status {:#x}", label, status));
}

void Framebuffer::bind(glm::ivec2 corner, glm::ivec2 size) const {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, _id);
    glViewportIndexedf(0, float(corner.x), float(corner.y), float(size.x), float(size.y));
}

void Framebuffer::clearColor(const glm::vec4& value, int attachment) const {
    glClearNamedFramebufferfv(_id, GL_COLOR, attachment, &value.x);
}

void Framebuffer::clearDepth(float value) const {
    glClearNamedFramebufferfv(_id, GL_DEPTH, 0, &value);
}

void Framebuffer::clearDepthStencil(float depth, int stencil) const {
    glClearNamedFramebufferfi(_id, GL_DEPTH_STENCIL, 0, depth, stencil);
}

void VertexArray::attribute(GLuint index, const Buffer& buffer, int components, int offset, int stride) {
    glEnableVertexArrayAttrib(_id, index);
    glVertexArrayAttribFormat(_id, index, components, GL_FLOAT, GL_FALSE, GLuint(offset));
    glVertexArrayAttribBinding(_id, index, index);
    glVertexArrayVertexBuffer(_id, index, buffer.id(), 0, stride);
}

void VertexArray::shortAttribute(GLuint index, const Buffer& buffer, int offset, int stride) {
    glEnableVertexArrayAttrib(_id, index);
    glVertexArrayAttribFormat(_id, index, 4, GL_UNSIGNED_SHORT, GL_TRUE, GLuint(offset));
    glVertexArrayAttribBinding(_id, index, index);
    glVertexArrayVertexBuffer(_id, index, buffer.id(), 0, stride);
}

} // namespace limpid::gl
