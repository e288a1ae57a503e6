// tinygltf as Debian builds it, but seen by the fuzzer; its pictures are decoded by the library's stb.
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_INCLUDE_STB_IMAGE
#define TINYGLTF_NO_INCLUDE_STB_IMAGE_WRITE
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include <tiny_gltf.h>
