// Writes the project's own models: limpid-make-models DIR

#include "GlbWriter.h"
#include "Models.h"

#include <cstdio>
#include <exception>

using namespace limpid::models;

namespace {

struct Entry {
    const char* name;
    Mesh mesh;
    Material material;
};

void writeAll(const std::filesystem::path& folder) {
    const Entry entries[] = {
        {"teapot", teapot(8), {{0.78f, 0.70f, 0.58f}, 0.4f}}, // cream-glazed stoneware
        {"sphere", sphere(32, 32), {{0.76f, 0.75f, 0.72f}}},  // chalk
        {"box", box(), {{0.53f, 0.34f, 0.19f}}},              // oak
        {"cross", cross(), {{0.60f, 0.29f, 0.20f}}},          // terracotta
        {"fish", fish(), {{0.84f, 0.36f, 0.08f}, 0.5f}},      // goldfish
        {"dolphin", dolphin(), {{0.33f, 0.40f, 0.47f}, 0.5f}} // blue-grey skin
    };
    std::filesystem::create_directories(folder);
    for (const Entry& entry : entries) {
        const Mesh mesh = finished(entry.mesh);
        writeGlb(folder / (std::string{entry.name} + ".glb"), entry.name, mesh, entry.material);
        std::printf("%-8s %5zu triangles %5zu vertices\n", entry.name, mesh.indices.size() / 3,
                    mesh.positions.size());
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: limpid-make-models DIR\n", stderr);
        return 2;
    }
    try {
        writeAll(argv[1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "limpid-make-models: %s\n", error.what());
        return 2;
    }
    return 0;
}
