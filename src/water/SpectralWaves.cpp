#include "water/SpectralWaves.h"

#include <cmath>
#include <string>
#include <vector>

#include "core/ShaderData.h"
#include "core/Tau.h"
#include "gl/Bindings.h"

namespace limpid {

namespace {

constexpr int groupSize = 128;

/// As whole steps of 2^-`places`, low word first.
glm::uvec2 steps(double value, int places) {
    const auto whole = std::uint64_t(std::round(std::ldexp(value, places)));
    return {std::uint32_t(whole), std::uint32_t(whole >> 32)};
}

std::vector<gpu::Mode> modesOf(const Spectrum& spectrum) {
    std::vector<gpu::Mode> modes;
    for (int row = 0; row < spectrum.modes; ++row)
        for (int column = 0; column < spectrum.modes; ++column) {
            const std::complex<double>& h = spectrum.amplitudes[modes.size()];
            const double turns = Spectrum::frequency(glm::length(spectrum.wavenumber(column, row)));
            modes.push_back({{float(h.real()), float(h.imag())}, steps(turns / tau, 48)});
        }
    return modes;
}

std::vector<glm::vec2> turnsOf(int texels) {
    std::vector<glm::vec2> turns;
    for (int i = 0; i < texels / 2; ++i) {
        const double angle = tau * i / texels;
        turns.emplace_back(std::cos(angle), std::sin(angle));
    }
    return turns;
}

const std::string withTime[] = {"WITH_TIME"};

} // namespace

SpectralWaves::SpectralWaves(gl::Context& context)
    : _context(context), _rows({"water/spectrum.comp"}, withTime), _columns({"water/spectrum.comp"}) {}

void SpectralWaves::upload(SpectralTile& tile, const Spectrum& spectrum) {
    const int texels = finer * spectrum.modes;
    gl::Ledger& ledger = _context.ledger();
    const auto modes = modesOf(spectrum);
    const auto turns = turnsOf(texels);
    tile.modes = gl::Buffer(ledger, "spectrum", std::span<const gpu::Mode>(modes));
    tile.turns = gl::Buffer(ledger, "spectrum", std::span<const glm::vec2>(turns));
    tile.lines = gl::Buffer(ledger, "spectrum",
                            std::int64_t(spectrum.modes) * texels * std::int64_t(sizeof(glm::vec2)));
    tile.heights = gl::Texture(ledger, "spectrum", GL_R32F, glm::ivec2(texels));
    tile.heights.setFilter(GL_NEAREST, GL_REPEAT);
}

void SpectralWaves::update(SpectralTile& tile, const std::shared_ptr<const Spectrum>& spectrum, double time) {
    if (tile.spectrum != spectrum) {
        tile = {}; // freed before more is asked for
        upload(tile, *spectrum);
        tile.spectrum = spectrum;
    }
    if (tile.time == time) return;
    tile.time = time;
    const int texels = tile.heights.size().x;
    tile.modes.bindStorage(modesBuffer);
    tile.turns.bindStorage(turnsBuffer);
    tile.lines.bindStorage(spectrumLinesBuffer);
    tile.heights.bindImage(tileImage, GL_WRITE_ONLY);
    for (const gl::Program* pass : {&_rows, &_columns}) {
        pass->set(sideLocation, spectrum->modes);
        pass->set(texelsLocation, texels);
        if (pass == &_rows) {
            pass->set(timeLocation, steps(std::abs(time), 32));
            pass->set(backLocation, time < 0 ? 1 : 0);
        }
        const std::int64_t lines = pass == &_rows ? spectrum->modes : texels;
        pass->dispatch(lines * groupSize, groupSize);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
    }
}

} // namespace limpid
