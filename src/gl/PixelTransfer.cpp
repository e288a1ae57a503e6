#include "gl/PixelTransfer.h"

namespace limpid::gl {

namespace {

struct Store {
    GLenum name;
    GLint tight;
};
constexpr Store stores[] = {
    {GL_PACK_SWAP_BYTES, 0},   {GL_PACK_LSB_FIRST, 0},     {GL_PACK_ROW_LENGTH, 0},
    {GL_PACK_IMAGE_HEIGHT, 0}, {GL_PACK_SKIP_ROWS, 0},     {GL_PACK_SKIP_PIXELS, 0},
    {GL_PACK_SKIP_IMAGES, 0},  {GL_PACK_ALIGNMENT, 1},     {GL_UNPACK_SWAP_BYTES, 0},
    {GL_UNPACK_LSB_FIRST, 0},  {GL_UNPACK_ROW_LENGTH, 0},  {GL_UNPACK_IMAGE_HEIGHT, 0},
    {GL_UNPACK_SKIP_ROWS, 0},  {GL_UNPACK_SKIP_PIXELS, 0}, {GL_UNPACK_SKIP_IMAGES, 0},
    {GL_UNPACK_ALIGNMENT, 1}};

} // namespace

PixelTransfer::PixelTransfer() {
    static_assert(std::size(stores) == std::tuple_size_v<decltype(_stores)>);
    for (std::size_t i = 0; i < _stores.size(); ++i) {
        glGetIntegerv(stores[i].name, &_stores[i]);
        glPixelStorei(stores[i].name, stores[i].tight);
    }
    glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &_packBuffer);
    glGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &_unpackBuffer);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

PixelTransfer::~PixelTransfer() {
    for (std::size_t i = 0; i < _stores.size(); ++i)
        glPixelStorei(stores[i].name, _stores[i]);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, GLuint(_packBuffer));
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, GLuint(_unpackBuffer));
}

} // namespace limpid::gl
