#include "scene/Keys.h"
#include "scene/MethodFacts.h"
#include "scene/Spectrum.h"
#include "scene/WaterBodies.h"
#include "scene/WaterPresets.h"

/// The table. A row: name, what it takes, unit, what it says; then, for the few that need them, its default
/// and an example; after these the member, and when it counts. A new key is a row here.
namespace limpid {

namespace table {

constexpr Range fromTo(double min, double max) {
    return {.min = min, .max = max};
}
constexpr Range aboveUpTo(double min, double max) {
    return {.min = min, .max = max, .openMin = true};
}
constexpr Range between(double min, double max) {
    return {.min = min, .max = max, .openMin = true, .openMax = true};
}
constexpr Range list(int count, Range range) {
    range.count = count;
    return range;
}
constexpr Range whole(double min, double max) {
    return {.min = min, .max = max, .whole = true};
}
constexpr Range square(Range range) {
    range.square = true;
    return range;
}
constexpr Range seeds = fromTo(0, 0xFFFFFFFF);

constexpr auto methodNames = [] {
    std::array<std::string_view, std::size(methodFacts)> names;
    for (std::size_t i = 0; i < names.size(); ++i)
        names[i] = methodFacts[i].name;
    return names;
}();

constexpr Text name{"a name of 1 to 100 letters, digits, _, - and ., no dot in front"};

constexpr Key<Camera> cameras[] = {
    {{"position", anyNumber, "m", "where the camera is", "(framed from the receivers)"}, &Camera::position},
    {{"target", anyNumber, "m", "the point in the middle of the picture", "(framed from the receivers)"},
     &Camera::target},
    {{"up", anyDirection, "", "the direction that is upward in the picture"}, &Camera::up},
    {{"vertical_fov", between(0, 180), "degrees", "field of view, from bottom to top"}, &Camera::verticalFov},
    {{"exposure", fromTo(-64, 64), "stops", "exposure of tone-mapped pictures"}, &Camera::exposure},
};

constexpr Key<Water> waters[] = {
    {{"level", anyNumber, "m", "y of the mean surface"}, &Water::level},
    {{"center", anyNumber, "m", "x and z of the middle of the patch of waves and beams",
      "(covers what the receivers can be lit from)"},
     &Water::center},
    {{"size", positive, "m", "width and depth of the patch of waves and beams",
      "(covers what the receivers can be lit from)"},
     &Water::size},
    {{"grid", fromTo(1, 8192), "quads", "the patch's mesh, along x and z"}, &Water::grid},
    {{"ior", fromTo(1, 4), "", "index of refraction"}, &Water::ior},
    {{"type", Choice{waterBodies}, "",
      "absorption, scattering and anisotropy from published tables; explicit keys override it",
      "\"clearest\"", "\"coastal\""}},
    {{"absorption", nonNegative, "1/m", "absorption coefficient, RGB"}, &Water::absorption},
    {{"scattering", nonNegative, "1/m", "scattering coefficient, RGB"}, &Water::scattering},
    {{"anisotropy", between(-1, 1), "", "mean cosine of the scattering angle, g of Henyey-Greenstein"},
     &Water::anisotropy},
    {{"preset", Choice{waterPresets}, "", "waves for a pool, in place of [[water.wave]]", "(none)"}},
    {{"wave_scale", anyNumber, "", "factor on the amplitudes of all waves", "1", "0.5"}},
};

using enum WaveType;
template <WaveType... types>
constexpr bool of(const Wave& wave) {
    return ((wave.type == types) || ...);
}

constexpr Key<Wave> waves[] = {
    {{"type", Choice{waveTypeNames}, "", "shape of the wave; waves add up"}, &Wave::type},
    {{"amplitude", anyNumber, "m",
      "half of crest to trough; of noise, the first octave's; of phillips, the root mean square height; of "
      "a heightmap, the height of 1"},
     &Wave::amplitude},
    {{"wavelength", positive, "m", "crest to crest; of noise, the first octave's cell"},
     &Wave::wavelength,
     of<Cosine, Circular, Noise>},
    {{"speed", anyNumber, "m/s", "phase speed"}, &Wave::speed, of<Cosine, Circular, Noise>},
    {{"direction", anyDirection, "", "direction of travel, x and z"}, &Wave::direction, of<Cosine>},
    {{"center", anyNumber, "m", "x and z of the rings' middle"}, &Wave::center, of<Circular>},
    {{"phase", anyNumber, "degrees", "phase at time 0"}, &Wave::phase, of<Cosine, Circular>},
    {{"octaves", fromTo(1, 12), "", "octaves of Perlin noise, each half as long and high"},
     &Wave::octaves,
     of<Noise>},
    {{"wind", anyDirection, "m/s", "wind velocity, x and z"}, &Wave::direction, of<Phillips>},
    {{"size", square(positive), "m", "tile after which the waves repeat"}, &Wave::size, of<Phillips>},
    {{"modes", fromTo(Wind::minModes, Wind::maxModes), "", "waves along a side of the tile, a power of two"},
     &Wave::modes,
     of<Phillips>},
    {{"shortest", positive, "m", "shorter waves die away", "(four times the tile's longer side over modes)"},
     &Wave::wavelength,
     of<Phillips>},
    {{"seed", seeds, "", "seed of the random numbers"}, &Wave::seed, of<Noise, Phillips>},
    {{"image", Text{"the path of an image, or of a sequence with one %04d"}, "", "heights from -1 to 1",
      "(required)"},
     {},
     of<HeightMap>},
    {{"placement", list(4, anyNumber), "m", "x and z of the image's middle, its width and depth",
      "(required)", "[0, 0, 1.5, 2.5]"},
     {},
     of<HeightMap>},
    {{"fps", positive, "1/s", "frame rate of a sequence, which runs in a loop"}, &Wave::fps, of<HeightMap>},
    {{"fade", nonNegative, "m", "width of the border in which the heights fade to 0",
      "(a sixteenth of the shorter side)", "0.125"},
     {},
     of<HeightMap>},
};

constexpr bool isDirectional(const Light& light) {
    return light.type == LightType::Directional;
}
constexpr bool isPoint(const Light& light) {
    return light.type == LightType::Point;
}
bool isSpot(const Light& light) {
    return light.isSpot();
}
bool isDirected(const Light& light) {
    return isDirectional(light) || isSpot(light);
}

constexpr Key<Light> lights[] = {
    {{"name", name, "", "name in options and of files", "(light and its number)", "\"another\""}},
    {{"type", Choice{lightTypeNames}, "", "kind of light", "\"directional\""}},
    {{"position", anyNumber, "m", "where the light is", "(required)"}, &Light::position, isPoint},
    {{"intensity", nonNegative, "W/sr", "radiant intensity, RGB; of a spot, along its axis"},
     &Light::intensity,
     isPoint},
    {{"direction", anyDirection, "", "direction in which the light travels; of a spot, its axis"},
     &Light::direction,
     isDirected},
    {{"irradiance", nonNegative, "W/m²", "irradiance on a plane facing the light, RGB"},
     &Light::irradiance,
     isDirectional},
    {{"angular_diameter", fromTo(0, 10), "degrees", "angular diameter of the disc; the sun has 0.53"},
     &Light::angularDiameter,
     isDirectional},
    {{"inner_cone", nonNegative, "degrees",
      "angle from the axis up to which the spot is full; below outer_cone"},
     &Light::innerCone,
     isSpot},
    {{"outer_cone", aboveUpTo(0, 90), "degrees", "angle from the axis at which the spot ends"},
     &Light::outerCone,
     isSpot},
};

constexpr std::string_view oneShape = "(one of plane, sphere, box and gltf)";

constexpr Key<Receiver> receivers[] = {
    {{"name", name, "", "name in options and of files", "(receiver and its number)", "\"another\""}},
    {{"plane.size", list(2, positive), "m", "a plane facing up: along x and z", oneShape, "[1.5, 2.5]"}},
    {{"sphere.radius", positive, "m", "a sphere: its radius", oneShape, "0.375"}},
    {{"sphere.segments", whole(4, 1024), "", "a sphere: segments around it", "32", "24"}},
    {{"box.size", list(3, positive), "m", "a box: along x, y and z", oneShape, "[0.5, 0.75, 0.25]"}},
    {{"gltf", Text{"the path of a .glb or .gltf file"}, "", "a model", oneShape}},
    {{"without", Text{"a list of names or patterns, such as [\"Water*\"]"}, "",
      "nodes, meshes and materials to leave out of a model", "[]"}},
    {{"translation", anyNumber, "m", "where its origin is"}, &Receiver::translation},
    {{"rotation", anyDirection, "", "quaternion x, y, z, w"}, &Receiver::rotation},
    {{"scale", anyNumber, "", "factors along its own x, y and z, other than 0"}, &Receiver::scale},
    {{"albedo", list(3, nonNegative), "", "diffuse reflectance of a shape, RGB; a model brings its own",
      "[0.8, 0.8, 0.8]", "[0.4, 0.5, 0.6]"}},
};

constexpr Key<Scene> skies[] = {
    {{"radiance", nonNegative, "W/(m² sr)", "sky radiance, RGB, seen by reflection and through the surface"},
     &Scene::skyRadiance},
};
constexpr Key<Scene> ambients[] = {
    {{"radiance", nonNegative, "W/(m² sr)", "ambient light on all receivers, RGB"}, &Scene::ambientRadiance},
};

constexpr bool hasPlanes(const CausticsSettings& caustics) {
    return factsOf(caustics.method).planes;
}
constexpr bool hasFills(const CausticsSettings& caustics) {
    return factsOf(caustics.method).fills;
}
constexpr bool slices(const CausticsSettings& caustics) {
    return factsOf(caustics.method).slicing;
}
constexpr bool slicesLevels(const CausticsSettings& caustics) {
    return slices(caustics) && caustics.slicing == Slicing::Levels;
}
constexpr bool hasPhotons(const CausticsSettings& caustics) {
    return factsOf(caustics.method).photons;
}

constexpr Key<CausticsSettings> caustics[] = {
    {{"method", Choice{methodNames, " (the methods there are so far)"}, "", "how caustics are computed"},
     &CausticsSettings::method},
    {{"map_size", fromTo(1, 16384), "texels", "the longer side of a caustic map, at most"},
     &CausticsSettings::mapSize},
    {{"texels_per_pixel", fromTo(0, 64), "",
      "resolution of maps of receivers that are small in the picture; 0: as elsewhere"},
     &CausticsSettings::texelsPerPixel},
    {{"refresh", fromTo(0, 1000), "1/s", "caustics a second of the scene's time, at most; 0: one a picture"},
     &CausticsSettings::refresh},
    {{"planes", fromTo(1, 4096), "", "reference planes of a box, before slicing drops any"},
     &CausticsSettings::planes,
     hasPlanes},
    {{"fill", Choice{fillNames}, "",
      "how level-map methods accumulate light, by raster or in one compute pass"},
     &CausticsSettings::fill,
     hasFills},
    {{"slicing", Choice{slicingNames}, "",
      "which planes are drawn: by our histogram, or the thesis's levels"},
     &CausticsSettings::slicing,
     slices},
    {{"depth_levels", fromTo(1, 4096), "", "intervals of the depth histogram, with slicing = \"levels\""},
     &CausticsSettings::depthLevels,
     slicesLevels},
    {{"threshold", aboveUpTo(0, 1), "",
      "acceptance threshold over the box's height, with slicing = \"levels\""},
     &CausticsSettings::threshold,
     slicesLevels},
    {{"photon_grid", fromTo(1, 8192), "cells", "photon grid over the water"},
     &CausticsSettings::photonGrid,
     hasPhotons},
    {{"photon_grid_over", Choice{photonGridOverNames}, "",
      "extent of the photon grid: the water that lights a receiver, for each, or all water (paper)"},
     &CausticsSettings::photonGridOver,
     hasPhotons},
    {{"photon_subdivision", fromTo(1, 16), "", "photons along a side of a cell"},
     &CausticsSettings::photonSubdivision,
     hasPhotons},
    {{"splat_size", fromTo(1, 256), "texels", "splats under the most and the least water, the smaller first"},
     &CausticsSettings::splatSize,
     hasPhotons},
    {{"filter_taps", fromTo(0, 32), "", "taps of the blur; 0: no blur"},
     &CausticsSettings::filterTaps,
     hasPhotons},
    {{"filter_radius", fromTo(0, 64), "texels", "radius of the blur"},
     &CausticsSettings::filterRadius,
     hasPhotons},
};

using enum GodrayMethod;
template <GodrayMethod... methods>
constexpr bool by(const GodraySettings& godrays) {
    return ((godrays.method == methods) || ...);
}
constexpr bool areDrawn(const GodraySettings& godrays) {
    return godrays.method != None;
}

constexpr Key<GodraySettings> godrays[] = {
    {{"method", Choice{godrayMethodNames}, "", "how light scattered by the water is drawn, seen from below",
      "(\"exact-shafts\"; in a [godrays] without it \"none\")"},
     &GodraySettings::method},
    {{"phase", Choice{phaseNames}, "", "phase function"}, &GodraySettings::phase, areDrawn},
    {{"grid", fromTo(1, 4096), "cells", "grid over the water, along x and z"},
     &GodraySettings::grid,
     areDrawn},
    {{"subdivision", fromTo(1, 16), "", "lines, rays or volumes along a side of a cell"},
     &GodraySettings::subdivision,
     areDrawn},
    {{"planes", fromTo(1, 1024), "", "layers of lit water down to the deepest receiver"},
     &GodraySettings::planes,
     by<ExactShafts>},
    {{"steps", fromTo(1, 4096), "", "steps along a view ray"}, &GodraySettings::steps, by<ExactShafts>},
    {{"sub_volumes", fromTo(0, 256), "", "parts of an illumination volume; 0: as many as the water asks for"},
     &GodraySettings::subVolumes,
     by<Tetrahedra>},
    {{"scale", aboveUpTo(0, 1), "", "sides of the godrays' target over the picture's"},
     &GodraySettings::scale,
     areDrawn},
    {{"line_width", fromTo(0.5, 256), "pixels", "width of a line in the target, at least"},
     &GodraySettings::lineWidth,
     by<PhotonLines>},
    {{"filter_taps", fromTo(0, 32), "", "taps of the blur; 0: no blur"},
     &GodraySettings::filterTaps,
     areDrawn},
    {{"filter_radius", fromTo(0, 64), "pixels", "radius of the blur, in the target"},
     &GodraySettings::filterRadius,
     areDrawn},
};

} // namespace table

constinit const std::span<const Key<Camera>> cameraKeys = table::cameras;
constinit const std::span<const Key<Water>> waterKeys = table::waters;
constinit const std::span<const Key<Wave>> waveKeys = table::waves;
constinit const std::span<const Key<Light>> lightKeys = table::lights;
constinit const std::span<const Key<Receiver>> receiverKeys = table::receivers;
constinit const std::span<const Key<Scene>> skyKeys = table::skies;
constinit const std::span<const Key<Scene>> ambientKeys = table::ambients;
constinit const std::span<const Key<CausticsSettings>> causticsKeys = table::caustics;
constinit const std::span<const Key<GodraySettings>> godrayKeys = table::godrays;

} // namespace limpid
