#include "scene/Fingerprint.h"

namespace limpid {

namespace {

void addWave(Hash& hash, const Wave& wave) {
    hash(int(wave.type), wave.amplitude, wave.wavelength, wave.direction, wave.center, wave.speed, wave.phase,
         wave.octaves, wave.seed, wave.size, wave.fps);
    if (wave.spectrum) {
        hash(wave.spectrum->tile);
        hash.list(wave.spectrum->amplitudes);
    }
    if (!wave.heights) return;
    // The first frame stands for a sequence.
    hash(wave.heights->frameCount(), wave.heights->bounds().size);
    hash.list(wave.heights->frame(0)->spline);
}

void addWater(Hash& hash, const Water& water) {
    hash(water.level, water.center.value_or(glm::dvec2(0)), water.size.value_or(glm::dvec2(0)), water.ior,
         water.absorption, water.scattering, water.anisotropy);
    for (const Wave& wave : water.waves)
        addWave(hash, wave);
}

void addReceiver(Hash& hash, const Receiver& receiver) {
    const glm::dquat& r = receiver.rotation;
    hash.add(receiver.name.data(), receiver.name.size());
    hash(receiver.translation, r.w, r.x, r.y, r.z, receiver.scale);
    const Mesh& mesh = *receiver.mesh;
    hash.list(mesh.positions);
    hash.list(mesh.indices);
    for (const MeshPart& part : mesh.parts) {
        const Material& material = mesh.materials[std::size_t(part.material)];
        hash(part.firstIndex, part.indexCount, int(material.alphaMode), material.doubleSided);
        if (material.alphaMode == AlphaMode::Opaque) continue;
        hash(material.alphaCutoff, material.baseColor.a, int(material.baseColorWrapS),
             int(material.baseColorWrapT));
        hash.list(mesh.uvs);
        hash.list(mesh.colors);
        if (material.baseColorImage >= 0) hash.list(mesh.images[std::size_t(material.baseColorImage)].rgba);
    }
}

void addLight(Hash& hash, const Light& light) {
    hash.add(light.name.data(), light.name.size());
    hash(int(light.type), light.direction, light.irradiance, light.angularDiameter, light.position,
         light.intensity);
    if (light.isSpot()) hash(light.innerCone, light.outerCone);
}

} // namespace

std::uint64_t lightFingerprint(const Scene& scene) {
    Hash hash;
    addWater(hash, scene.water);
    for (const Light& light : scene.lights)
        addLight(hash, light);
    for (const Receiver& receiver : scene.receivers)
        addReceiver(hash, receiver);
    return hash.value();
}

} // namespace limpid
