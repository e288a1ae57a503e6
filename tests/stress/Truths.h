#pragma once
#include <numbers>

#include "core/Optics.h"
#include "stress/StressFixture.h"

/// Scenes whose light is known, or known not to change, small enough for every method in a moment.
namespace limpid::stress {

struct Truth {
    const char* name;
    const char* what;                      ///< the figure is an nMAE against
    double mostExactBeam, most, mostSplat; ///< of the figure: of exact beams, photon splats, and all between
    double (*figure)(Engine&, Method);

    double mostOf(Method method) const {
        return method == Method::ExactBeam ? mostExactBeam : method == Method::PhotonSplat ? mostSplat : most;
    }
};

/// A floor 1 m below the water, and a sun this far from vertical.
inline Scene floorScene(double degrees, Method method) {
    Scene scene;
    scene.receivers = {scenes::floorAt(-1)};
    scene.lights = {scenes::sunAt(degrees)};
    scene.water.grid = {64, 64};
    scene.caustics.mapSize = 64;
    scene.caustics.planes = 8;
    scene.caustics.photonGrid = {64, 64}; // two photons a texel along each side
    scene.caustics.method = method;
    return scene;
}

/// The same with a ball, waves and a point light.
inline Scene richScene(Method method) {
    Scene scene = floorScene(30, method);
    scene.receivers.push_back(scenes::shape("ball", makeSphere(0.3, glm::vec3(0.8f)), {0.1, -0.5, 0.2}));
    scene.water.waves = {scenes::cosine(0.01, 0.5, {1, 0.4})};
    Light pointLight;
    pointLight.type = LightType::Point;
    pointLight.position = {0.5, 0.6, 0.2};
    scene.lights.push_back(pointLight);
    return scene;
}

class Bakes : public StressTest {
  public:
    static Baked of(Engine& engine, const Scene& scene) { return bake(engine, scene); }
    static double difference(const Baked& a, const Baked& b) { return nmae(a, b); }
    static Scene moved(const Scene& scene, double scale, const glm::dvec3& shift = {}) {
        return transformed(scene, scale, shift);
    }
    /// Mean error of the texels that see something, by channel, over what each of them should have.
    static double fromConstant(const Baked& baked, const glm::dvec3& expected) {
        double difference = 0, sum = 0;
        for (const MapData& map : baked.maps)
            for (std::size_t i = 0; i < map.normalDotAxis.size(); ++i)
                for (std::size_t c = 0; c < 3 && map.normalDotAxis[i] > 0; ++c) {
                    difference += std::abs(double(map.irradiance[3 * i + c]) - expected[int(c)]);
                    sum += expected[int(c)];
                }
        return sum > 0 ? difference / sum : difference;
    }
};

inline double flatWater(Engine& engine, Method method, double degrees, const glm::dvec3& absorption) {
    Scene scene = floorScene(degrees, method);
    scene.water.absorption = absorption;
    const double cosine = std::cos(glm::radians(degrees));
    const double below = std::cos(std::asin(std::sin(glm::radians(degrees)) / scene.water.ior));
    const glm::dvec3 expected = cosine * optics::fresnelTransmittance(cosine, 1 / scene.water.ior) *
                                optics::extinction(absorption, 1 / below);
    return Bakes::fromConstant(Bakes::of(engine, scene), expected);
}

inline double withoutRefraction(Engine& engine, Method method) {
    Scene scene = floorScene(30, method);
    scene.water.ior = 1;
    scene.water.waves = {scenes::cosine(0.02, 0.4, {1, 0.2})};
    return Bakes::fromConstant(Bakes::of(engine, scene), glm::dvec3(std::cos(glm::radians(30.0))));
}

inline double movedScene(Engine& engine, Method method, double scale, const glm::dvec3& shift) {
    const Scene scene = richScene(method);
    const Baked here = Bakes::of(engine, scene);
    Baked there = Bakes::of(engine, Bakes::moved(scene, scale, shift));
    // A point light's light thins out with the square of the distance; its intensity was made up for that.
    return Bakes::difference(there, here);
}

/// Waves, floor and sun are even about the middle, and so are the water's triangles: each texel has the light
/// of the one across.
inline double halfTurn(Engine& engine, Method method) {
    Scene scene = floorScene(0, method);
    Wave ring = scenes::cosine(0.01, 0.5, {1, 0});
    ring.type = WaveType::Circular;
    scene.water.waves = {ring, scenes::cosine(0.005, 0.4, {1, 0.3})};
    const Baked baked = Bakes::of(engine, scene);
    Baked turned = baked;
    auto& light = turned.maps.at(0).irradiance;
    for (std::size_t i = 0; i < light.size() / 3; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            light[3 * i + c] = baked.maps[0].irradiance[light.size() - 3 - 3 * i + c];
    return Bakes::difference(turned, baked);
}

/// The share of its light that a lens does not bring to the four texels at the map's middle.
inline double besideFocus(Engine& engine, Method method) {
    Scene scene = floorScene(0, method);
    Wave lens = scenes::cosine(0.02, 0.5, {1, 0});
    lens.type = WaveType::Circular;
    scene.water.waves = {lens};
    scene.water.center = glm::dvec2(0);
    scene.water.size = glm::dvec2(0.02);
    scene.receivers = {scenes::floorAt(-1.27)};
    const MapData map = Bakes::of(engine, scene).maps.at(0);
    double all = 0, middle = 0;
    for (int y = 0; y < map.size.y; ++y)
        for (int x = 0; x < map.size.x; ++x) {
            const double light = map.irradiance[3 * std::size_t(y * map.size.x + x)];
            all += light;
            const bool inside =
                std::abs(2 * x + 1 - map.size.x) <= 1 && std::abs(2 * y + 1 - map.size.y) <= 1;
            if (inside) middle += light;
        }
    return all > 0 ? 1 - middle / all : 1;
}

inline std::span<const Truth> allTruths() {
    static constexpr Truth truths[] = {
        {"flat water, sun above", "the closed form", 1e-5, 1e-5, 0.03,
         [](Engine& e, Method m) { return flatWater(e, m, 0, {}); }},
        {"flat water, sun at 60°", "the closed form", 1e-5, 1e-5, 0.03,
         [](Engine& e, Method m) { return flatWater(e, m, 60, {}); }},
        {"flat water that absorbs, sun at 40°", "the closed form", 1e-5, 1e-5, 0.03,
         [](Engine& e, Method m) {
             return flatWater(e, m, 40, {2, 0.5, 0.1});
         }},
        {"waves that do not refract (IOR 1)", "cos θ", 1e-5, 1e-5, 0.03, withoutRefraction},
        {"a lens onto four texels", "their having all light", 1e-4, 1, 1, besideFocus},
        {"turned by half", "itself", 1e-4, 1e-4, 0.03, halfTurn},
        {"10⁻⁴ times as large", "the scene in metres", 1e-4, 1e-4, 1e-4,
         [](Engine& e, Method m) { return movedScene(e, m, 1e-4, {}); }},
        {"10⁵ times as large", "the scene in metres", 1e-4, 1e-4, 1e-4,
         [](Engine& e, Method m) { return movedScene(e, m, 1e5, {}); }},
        {"10⁶ m away", "the scene at the origin", 1e-4, 1e-4, 1e-4,
         [](Engine& e, Method m) {
             return movedScene(e, m, 1, {1e6, 0, -1e6});
         }},
    };
    return truths;
}

} // namespace limpid::stress
