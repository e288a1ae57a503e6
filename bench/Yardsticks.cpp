#include "Bench.h"

#include <cmath>
#include <stdexcept>

#include "gl/Bindings.h"
#include "gl/Program.h"

namespace limpid::bench {

namespace {

/// Triangles and texels of the well-known programs, and of our default.
const StageSize sizes[] = {{"floor", 256, 512, 1}, {"floor", 200, 1024, 1}, {"floor", 512, 1536, 1}};

constexpr int groupSize = 64;

/// W for 1 W/m², or throws: a yardstick that loses its light measures nothing. Waves carry a few beams past
/// the edges of the floor; the patch takes the sun's light on its flat area, whatever its waves.
void requireFlux(double flux, const Stage& stage, double expected) {
    if (!(flux > 0.95 * expected && flux < 1.01 * expected))
        throw std::runtime_error(fmt::format("{} quads: expected about {} W on the map, found {}",
                                             stage.size.quads, expected, flux));
}
double patchArea(const Stage& stage) {
    return stage.patch.size.x * stage.patch.size.y;
}

/// The whole of what the well-known WebGL programs do for their caustics, with the additive blending that
/// they lack: the mesh rasterised once where its corners' refracted rays meet one plane.
class RasterOnce {
  public:
    RasterOnce(Stage& stage, GLenum format)
        : _stage(stage), _program({"../bench/shaders/raster_once.vert", "../bench/shaders/raster_once.frag"}),
          _map(stage.context.ledger(), "yardstick", format, stage.map.frame.size) {
        _vertexArray.attribute(positionAttribute, stage.surface.mesh().positions, 4, 0, 16);
        _vertexArray.attribute(normalAttribute, stage.surface.mesh().normals, 4, 0, 16);
        _vertexArray.indices(stage.surface.mesh().indices);
        (*this)();
        double flux = 0;
        for (const float ratio : _map.readFloats(GL_RED, 1))
            flux += double(ratio) * stage.map.frame.texelArea();
        requireFlux(flux, stage, patchArea(stage));
    }

    void operator()() {
        const gl::Texture* const targets[] = {&_map};
        const gl::Framebuffer framebuffer("yardstick", targets);
        framebuffer.clearColor(glm::vec4(0));
        framebuffer.bind();
        _stage.beams.frame.bindUniform(lightFrameBlock);
        _stage.map.box.bindUniform(boxFrameBlock);
        _program.use();
        _vertexArray.bind();
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
        glDrawElements(GL_TRIANGLES, 3 * _stage.beams.triangleCount, GL_UNSIGNED_INT, nullptr);
        glDisable(GL_BLEND);
    }

  private:
    Stage& _stage;
    gl::Program _program;
    gl::Texture _map;
    gl::VertexArray _vertexArray;
};

/// The least that a pass over all beams can do: refract each at its corners and add its flux to one texel.
class OneAtomic {
  public:
    /// `traced`: refracted vertex by vertex by the engine's own pass, which is timed too; otherwise beam by
    /// beam.
    OneAtomic(Stage& stage, bool traced)
        : _stage(stage), _traced(traced),
          _program({traced ? "../bench/shaders/one_atomic_traced.comp" : "../bench/shaders/one_atomic.comp"}),
          _map(stage.context.ledger(), "yardstick",
               std::int64_t(stage.map.frame.size.x) * stage.map.frame.size.y * 4) {
        // All of the light on one texel would just fill it.
        const double unit = patchArea(stage) / 4294967295.0;
        _program.set(triangleCountLocation, stage.beams.triangleCount);
        _program.set(wattsPerStepLocation, float(unit));
        (*this)();
        double expected = 0, flux = 0;
        for (const float beam : stage.beams.flux.read<float>(std::size_t(stage.beams.triangleCount)))
            expected += double(beam);
        for (const std::uint32_t units : _map.read<std::uint32_t>(std::size_t(_map.bytes() / 4)))
            flux += units * unit;
        requireFlux(flux, stage, traced ? expected : patchArea(stage));
    }

    void operator()() {
        if (_traced) _stage.tracer.trace(_stage.beams, _stage.surface.mesh(), nullptr);
        _map.clearToZero();
        _stage.beams.frame.bindUniform(lightFrameBlock);
        _stage.map.box.bindUniform(boxFrameBlock);
        const WaterMesh& mesh = _stage.surface.mesh();
        mesh.indices.bindStorage(indicesBuffer);
        mesh.positions.bindStorage(positionsBuffer);
        mesh.normals.bindStorage(normalsBuffer);
        _stage.beams.origins.bindStorage(beamOriginsBuffer);
        _stage.beams.directions.bindStorage(beamDirectionsBuffer);
        _stage.beams.flux.bindStorage(beamFluxBuffer);
        _map.bindStorage(fluxSumsBuffer);
        _program.dispatch(_stage.beams.triangleCount, groupSize);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    }

  private:
    Stage& _stage;
    bool _traced;
    gl::Program _program;
    gl::Buffer _map;
};

} // namespace

void addYardsticks(Bench& bench) {
    for (const StageSize& size : sizes) {
        bench.add("yardstick_raster_once_grey", size, [](Stage& s) { return RasterOnce(s, GL_R32F); });
        bench.add("yardstick_raster_once_rgb", size, [](Stage& s) { return RasterOnce(s, GL_RGBA32F); });
        bench.add("yardstick_one_atomic", size, [](Stage& s) { return OneAtomic(s, false); });
        bench.add("yardstick_one_atomic_traced", size, [](Stage& s) { return OneAtomic(s, true); });
    }
}

} // namespace limpid::bench
