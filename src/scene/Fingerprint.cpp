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

void addImage(Hash& hash, const Mesh& mesh, int image) {
    if (image >= 0) hash.list(mesh.images[std::size_t(image)].rgba);
}

/// As far as it lets light through.
void addMaterial(Hash& hash, const Mesh& mesh, const Material& material) {
    if (!isTranslucent(material)) return;
    hash(material.alphaCutoff, material.baseColor.a, int(material.baseColorWrapS),
         int(material.baseColorWrapT));
    hash.list(mesh.uvs);
    hash.list(mesh.colors);
    addImage(hash, mesh, material.baseColorImage);
    if (material.transmission == 0) return;
    hash(material.transmission, material.baseColor, int(material.transmissionWrapS),
         int(material.transmissionWrapT));
    addImage(hash, mesh, material.transmissionImage);
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
        addMaterial(hash, mesh, material);
    }
}

void addLight(Hash& hash, const Light& light) {
    hash.add(light.name.data(), light.name.size());
    hash(int(light.type), light.direction, light.irradiance, light.angularDiameter, light.position,
         light.intensity);
    if (light.isSpot()) hash(light.innerCone, light.outerCone);
}

void addLooks(Hash& hash, const Material& m) {
    hash(m.baseColor, m.baseColorImage, int(m.baseColorWrapS), int(m.baseColorWrapT), m.baseColorNearest,
         int(m.alphaMode), m.alphaCutoff, m.normalImage, m.normalScale, int(m.normalWrapS),
         int(m.normalWrapT));
    hash(m.transmission, m.transmissionImage, int(m.transmissionWrapS), int(m.transmissionWrapT), m.emission,
         m.emissionImage, int(m.emissionWrapS), int(m.emissionWrapT));
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

std::uint64_t looksFingerprint(const Scene& scene) {
    Hash hash;
    for (const Receiver& receiver : scene.receivers) {
        const Mesh& mesh = *receiver.mesh;
        hash.list(mesh.normals);
        hash.list(mesh.uvs);
        hash.list(mesh.normalUvs);
        hash.list(mesh.colors);
        hash.list(mesh.parts);
        for (const Material& material : mesh.materials)
            addLooks(hash, material);
        for (const Image& image : mesh.images) {
            hash(image.width, image.height, image.srgb);
            hash.list(image.rgba);
        }
    }
    return hash.value();
}

} // namespace limpid
