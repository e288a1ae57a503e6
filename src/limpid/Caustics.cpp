#include "limpid/Caustics.h"

#include <cmath>

#include <fmt/format.h>

#include "engine/Engine.h"
#include "engine/Readback.h"
#include "gl/Api.h"
#include "gl/CurrentContext.h"
#include "gl/Guard.h"
#include "limpid/HostChecks.h"
#include "limpid/SceneChecks.h"

namespace limpid {

struct Caustics::Impl {
    Impl(std::shared_ptr<gl::Context> shared, const void* which)
        : context(std::move(shared)), handle(which), engine(*context) {}

    std::shared_ptr<gl::Context> context;
    const void* handle; ///< of the context
    Engine engine;
    bool isSet = false, isUpdated = false;
};

namespace {

/// `expected`: the handle of a context.
void requireContext(const void* expected) {
    const void* const current = gl::currentHandle();
    if (!current) throw GraphicsError("OpenGL: expected a context that is current on this thread, got none");
    if (current != expected)
        throw GraphicsError(
            fmt::format("OpenGL: expected context {} to be current, got {}", expected, current));
}

void requireTime(double seconds) {
    if (!std::isfinite(seconds))
        throw InputError(fmt::format("seconds: expected a finite number, got {}", seconds));
}

/// `call` came without what it needs to come after.
void requireCall(bool there, const char* call, const char* expected) {
    if (!there) throw InputError(fmt::format("{}: expected {}, got no such call", call, expected));
}

LitMap litMap(const Engine& engine, const MapWork& maps) {
    TexelFrame frame = maps.level.frame;
    frame.box.corner -= engine.origin();
    LitMap lit;
    lit.receiver = maps.plan.receiver;
    lit.light = maps.plan.light;
    lit.size = frame.size;
    lit.texel = frame.texel;
    lit.depth = frame.box.extent.z;
    lit.irradiance = maps.caustics.irradiance.id();
    lit.position = maps.level.position.id();
    lit.normal = maps.level.normal.id();
    lit.worldToTexture = glm::mat4(frame.worldToTexture());
    lit.origin = engine.origin();
    return lit;
}

} // namespace

Caustics::Caustics(const Context& context) {
    requireContext(context._handle);
    const gl::Guard guard(*context._context);
    _impl = std::make_unique<Impl>(context._context, context._handle);
}

Caustics::~Caustics() = default;
Caustics::Caustics(Caustics&&) noexcept = default;
Caustics& Caustics::operator=(Caustics&&) noexcept = default;

void Caustics::set(Scene scene) {
    requireContext(_impl->handle);
    requireScene(scene);
    requireHostTextures(scene.water);
    requireHostBuffers(scene.receivers);
    _impl->engine.set(std::move(scene));
    _impl->isSet = true;
    _impl->isUpdated = false;
}

const Scene& Caustics::scene() const {
    return _impl->engine.scene();
}

void Caustics::update(double seconds) {
    requireContext(_impl->handle);
    requireCall(_impl->isSet, "update", "set() before it");
    requireTime(seconds);
    requireHostTextures(_impl->engine.scene().water);
    _impl->isUpdated = false;
    _impl->engine.freePicture(); // a host that draws by itself has use for the memory
    _impl->engine.updateCaustics(seconds);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT); // a host may sample at once
    _impl->isUpdated = true;
}

std::vector<LitMap> Caustics::maps() const {
    requireCall(_impl->isUpdated, "maps", "update() since the last set() or render()");
    std::vector<LitMap> lit;
    for (const MapWork& maps : _impl->engine.maps())
        lit.push_back(litMap(_impl->engine, maps));
    return lit;
}

std::vector<float> Caustics::irradiance(int map) const {
    requireContext(_impl->handle);
    requireCall(_impl->isUpdated, "irradiance", "update() since the last set() or render()");
    const int count = int(_impl->engine.maps().size());
    if (map < 0 || map >= count)
        throw InputError(fmt::format("irradiance: expected a map from 0 to {}, got {}", count - 1, map));
    const gl::Guard guard(*_impl->context);
    return readMaps(_impl->engine.maps()[std::size_t(map)], _impl->engine.origin()).irradiance;
}

Picture Caustics::render(double seconds, glm::ivec2 size) {
    requireContext(_impl->handle);
    requireCall(_impl->isSet, "render", "set() before it");
    requireTime(seconds);
    requireHostTextures(_impl->engine.scene().water);
    const int most = Engine::largestPicture(*_impl->context);
    if (std::min(size.x, size.y) < 1 || std::max(size.x, size.y) > most)
        throw InputError(
            fmt::format("size: expected 1 to {} pixels a side, got {} x {}", most, size.x, size.y));
    _impl->isUpdated = false;
    return _impl->engine.render(seconds, size);
}

} // namespace limpid
