// Writes the project's own models, or those named: limpid-make-models DIR [NAME...]

#include "GlbWriter.h"
#include "Models.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

using namespace limpid::models;

namespace {

struct Entry {
    std::string name;
    std::function<Mesh()> make;
    Material material;
};

std::vector<Entry> allModels() {
    const Material ownColours{{1.0f, 1.0f, 1.0f}, 0.5f}; // the vertices have theirs
    return {
        {"teapot", [] { return teapot(10); }, {{0.78f, 0.70f, 0.58f}, 0.4f}}, // cream-glazed stoneware
        {"sphere", [] { return sphere(32, 32); }, {{0.76f, 0.75f, 0.72f}}},   // chalk
        {"box", box, {{0.53f, 0.34f, 0.19f}}},                                // oak
        {"cross", cross, {{0.60f, 0.29f, 0.20f}}},                            // terracotta
        {"fish", fish, {{0.84f, 0.36f, 0.08f}, 0.5f}},                        // goldfish
        {"dolphin", dolphin, {{0.33f, 0.40f, 0.47f}, 0.5f}},                  // blue-grey skin
        {"angle_fish", angleFish, ownColours},
        {"red_betta", redBetta, ownColours},
        {"siamese_tiger", siameseTiger, ownColours},
        {"barramundi", barramundi, ownColours},
        {"brown_trout", brownTrout, ownColours},
        {"lion_head", lionHead, ownColours},
        {"steel_head", steelHead, ownColours},
        {"bass", bass, ownColours},
        {"shark", shark, ownColours},
        {"leopard_shark", leopardShark, ownColours},
        {"sand_bar_shark", sandBarShark, ownColours},
        {"whale", whale, ownColours},
        {"manta", manta, ownColours},
        {"sun_fish", sunFish, ownColours},
        {"horse", horse, ownColours},
        {"hammer", hammer, ownColours},
        {"car", car, ownColours},
        {"chair", chair, ownColours},
        {"sink", sink, ownColours},
        {"sofa", sofa, ownColours},
        {"ufo", ufo, ownColours},
        {"plane", plane, ownColours},
        {"helicopter", helicopter, ownColours},
        {"camera", camera, ownColours},
        {"tank", tank, ownColours},
    };
}

void write(const std::filesystem::path& folder, const Entry& entry) {
    const Mesh mesh = finished(entry.make());
    writeGlb(folder / (entry.name + ".glb"), entry.name, mesh, entry.material);
    std::printf("%-14s %5zu triangles %5zu vertices\n", entry.name.c_str(), mesh.indices.size() / 3,
                mesh.positions.size());
}

void writeNamed(const std::filesystem::path& folder, const std::vector<std::string>& names) {
    const std::vector<Entry> models = allModels();
    std::filesystem::create_directories(folder);
    if (names.empty())
        for (const Entry& entry : models)
            write(folder, entry);
    for (const std::string& name : names) {
        const auto found = std::ranges::find(models, name, &Entry::name);
        if (found == models.end()) throw std::runtime_error("there is no model named " + name);
        write(folder, *found);
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fputs("usage: limpid-make-models DIR [NAME...]\n", stderr);
        return 2;
    }
    try {
        writeNamed(argv[1], {argv + 2, argv + argc});
    } catch (const std::exception& error) {
        std::fprintf(stderr, "limpid-make-models: %s\n", error.what());
        return 2;
    }
    return 0;
}
