// A scene in, the light on its first receiver out: headless SCENE OUT.exr
#include <exception>
#include <iostream>

#include <limpid/Caustics.h>
#include <limpid/io/images/Images.h>
#include <limpid/io/toml/SceneFile.h>

int main(int count, char** words) try {
    if (count != 3) throw limpid::InputError("usage: headless SCENE.toml|MODEL.glb OUT.exr");
    limpid::Caustics caustics(limpid::Context::headless());
    caustics.set(limpid::io::loadScene(words[1]));
    caustics.update(0);

    const std::vector<limpid::LitMap> maps = caustics.maps();
    if (maps.empty()) throw limpid::InputError("maps: expected a receiver below the water, got none");
    for (const limpid::LitMap& map : maps)
        std::cout << caustics.scene().receivers[std::size_t(map.receiver)].name << " in "
                  << caustics.scene().lights[std::size_t(map.light)].name << ": " << map.size.x << " x "
                  << map.size.y << " texels of " << 1000 * map.texel << " mm\n";
    const glm::ivec2 size = maps[0].size;
    limpid::io::writeExr(words[2], size.x, size.y, {"R", "G", "B"}, caustics.irradiance(0)); // W/m²
} catch (const std::exception& error) {
    std::cerr << "headless: " << error.what() << '\n';
    return 1;
}
