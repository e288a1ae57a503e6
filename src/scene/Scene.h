#pragma once
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "core/Bounds.h"
#include "scene/HeightField.h"
#include "scene/Mesh.h"
#include "scene/Spectrum.h"

/// The scene as plain data: what a scene file says, with its defaults. SI units, Y up, right-handed, colours
/// linear RGB, angles in degrees. The names are those of the scene file.
namespace limpid {

struct Camera {
    std::optional<glm::dvec3> position; ///< m; none: framed from the receivers
    std::optional<glm::dvec3> target;   ///< m; none: framed from the receivers
    glm::dvec3 up{0, 1, 0};
    double verticalFov = 45; ///< degrees, (0, 180)
    double exposure = 0;     ///< stops

    bool operator==(const Camera&) const = default;
};

enum class WaveType { Cosine, Circular, Noise, HeightMap, Phillips };

/// As scene files have them, by WaveType.
inline constexpr std::string_view waveTypeNames[] = {"cosine", "circular", "noise", "heightmap", "phillips"};

/// Whether waves of a type are read from a texture: what makes their shape is not in the fields of Wave, and
/// a shader can bind a few only (maxHeightMaps).
constexpr bool isTexture(WaveType type) {
    return type == WaveType::HeightMap || type == WaveType::Phillips;
}

/// One term of the surface's height, m, at horizontal position xz and time t (see
/// shaders/optics/waves.glsl).
struct Wave {
    WaveType type = WaveType::Cosine;
    /// m; cosine and circular: half of crest to trough; noise: of the first octave; height map: for one unit
    /// of the image; phillips: root mean square of the height.
    double amplitude = 0.004;
    double wavelength = 0.2;                  ///< m, > 0; noise: the lattice cell of the first octave
    glm::dvec2 direction{1, 0};               ///< cosine: in xz, of any length > 0; phillips: wind, m/s
    glm::dvec2 center{0, 0};                  ///< circular, height map: x and z, m
    double speed = 0;                         ///< m/s
    double phase = 0;                         ///< degrees
    int octaves = 4;                          ///< noise: 1 to 12
    std::uint32_t seed = 0;                   ///< noise, phillips
    std::shared_ptr<HeightSource> heights;    ///< height map: its frames, in a loop
    glm::dvec2 size{1};                       ///< height map (0 outside), phillips: along x and z, m
    double fps = 30;                          ///< height map: frames a second, > 0
    int modes = 64;                           ///< phillips: a side of the spectrum, a power of two
    std::shared_ptr<const Spectrum> spectrum; ///< phillips (scene/Sea.h)

    bool operator==(const Wave&) const = default;
};

/// Height maps are textures, which a shader can bind a few of. Phillips waves become such.
inline constexpr int maxHeightMaps = 4;

struct Water {
    double level = 0;                 ///< y of the mean surface, m
    std::optional<glm::dvec2> center; ///< x and z, m; none: what the receivers can be lit from
    std::optional<glm::dvec2> size;   ///< m; none: what the receivers can be lit from
    glm::ivec2 grid{256, 256};        ///< quads
    double ior = 1.333;               ///< [1, 4]
    glm::dvec3 absorption{0};         ///< K, 1/m, >= 0
    glm::dvec3 scattering{0};         ///< 1/m, >= 0
    double anisotropy = 0.9;          ///< g of Henyey-Greenstein, (-1, 1)
    std::vector<Wave> waves;

    bool operator==(const Water&) const = default;
};

enum class LightType { Directional, Point };

/// As scene files have them: a spot is a point light.
inline constexpr std::string_view lightTypeNames[] = {"directional", "point", "spot"};

/// A spot is a point light with a cone: in a direction at an angle a to its axis it has
/// clamp((cos a - cos outer) / max(0.001, cos inner - cos outer), 0, 1)² of its intensity
/// (KHR_lights_punctual; shaders/optics/cone.glsl).
struct Light {
    std::string name = "light";
    LightType type = LightType::Directional;
    glm::dvec3 direction{0, -1, 0}; ///< directional: the way light travels; spot: its axis; of any length > 0
    glm::dvec3 irradiance{1, 1, 1}; ///< directional: W/m² on a plane facing it
    double angularDiameter = 0;     ///< directional: degrees, [0, 10]
    glm::dvec3 position{0, 1, 0};   ///< point: m
    glm::dvec3 intensity{1, 1, 1};  ///< point: W/sr; of a spot, along its axis
    double innerCone = 0;           ///< spot: degrees from the axis, [0, outerCone)
    double outerCone = 180;         ///< spot: degrees from the axis, (0, 90]; 180: no spot, shines all around

    bool isSpot() const { return type == LightType::Point && outerCone < 180; }
    bool operator==(const Light&) const = default;
};

struct HostMesh;

/// An object that caustics fall on. `mesh` is in its own space; translation · rotation · scale puts it into
/// the world.
struct Receiver {
    std::string name = "receiver";
    std::shared_ptr<const Mesh> mesh;
    std::shared_ptr<const HostMesh> host{}; ///< triangles of a host's, whose hull `mesh` is; mostly null
    glm::dvec3 translation{0};
    glm::dquat rotation{1, 0, 0, 0}; ///< unit
    glm::dvec3 scale{1};

    glm::dvec3 toWorld(const glm::dvec3& local) const { return translation + rotation * (scale * local); }
    bool operator==(const Receiver&) const = default; ///< a mesh equals itself alone
};

enum class Method { LevelMap, LevelMapSmart, ExactBeam, Volumetric, Stencil, PhotonSplat };
enum class Slicing { Automatic, Levels };
/// How the level map methods come to their light: planes drawn one after another, or beams walked in one
/// pass.
enum class Fill { Drawn, OnePass };
/// What a photon grid lies over: the water that lights a receiver, for each anew, or all water that beams
/// start from, as in the paper.
enum class PhotonGridOver { Receiver, Water };

/// As scene files have them, in the order of their enumerations.
inline constexpr std::string_view slicingNames[] = {"automatic", "levels"};
inline constexpr std::string_view fillNames[] = {"drawn", "one-pass"};
inline constexpr std::string_view photonGridOverNames[] = {"receiver", "water"};

struct CausticsSettings {
    Method method = Method::ExactBeam;
    int mapSize = 512;         ///< texels on the longer side of the box, [1, 16384]
    int planes = 50;           ///< reference planes of the whole box before slicing drops any, [1, 4096]
    Fill fill = Fill::OnePass; ///< of the level map methods; others have their own
    Slicing slicing = Slicing::Automatic;
    int depthLevels = 64;    ///< Slicing::Levels: intervals of the depth histogram, [1, 4096]
    double threshold = 0.01; ///< Slicing::Levels: acceptance threshold ε, of the box's height, (0, 1]
    // What a picture may save although it shows; 0: nothing. A bake is always whole.
    double texelsPerPixel = 0; ///< maps of receivers that are small on screen have about so many, [0, 64]
    double refresh = 0;        ///< caustics a second of the scene's time, at most, [0, 1000]
    // What follows is of photon splats, with the paper's settings.
    glm::ivec2 photonGrid{200, 200}; ///< cells, [1, 8192]
    PhotonGridOver photonGridOver = PhotonGridOver::Receiver;
    int photonSubdivision = 2;   ///< photons along a side of a cell, [1, 16]
    glm::dvec2 splatSize{5, 20}; ///< texels: at the most and at the least metres of water; >= 1, rising
    int filterTaps = 8;          ///< [0, 32]; 0: no filter
    double filterRadius = 2;     ///< texels, [0, 64]

    bool operator==(const CausticsSettings&) const = default;
};

enum class GodrayMethod { None, PhotonLines, ExactShafts, Tetrahedra };
enum class Phase { HenyeyGreenstein, Schlick };

/// Likewise.
inline constexpr std::string_view godrayMethodNames[] = {"none", "photon-lines", "exact-shafts",
                                                         "tetrahedra"};
inline constexpr std::string_view phaseNames[] = {"henyey-greenstein", "schlick"};

/// Light that the water scatters to a camera below the surface. Of photon lines, with the paper's settings.
struct GodraySettings {
    GodrayMethod method = GodrayMethod::ExactShafts; ///< none where the water scatters nothing
    Phase phase = Phase::HenyeyGreenstein;
    glm::ivec2 grid{100, 100}; ///< cells over the water, [1, 4096]
    int subdivision = 2;       ///< lines or rays along a side of a cell, [1, 16]
    double scale = 0.16;       ///< of the target's sides to the picture's, (0, 1]
    double lineWidth = 3;      ///< pixels of the target at least, [0.5, 256]
    int filterTaps = 8;        ///< [0, 32]; 0: no filter
    double filterRadius = 1.5; ///< pixels of the target, [0, 64]
    int planes = 32;           ///< layers of lit water down to the deepest receiver, [1, 1024]
    int steps = 96;            ///< along a view ray, [1, 4096]
    int subVolumes = 0;        ///< of an illumination volume, [0, 256]; 0: as many as the water asks for

    bool operator==(const GodraySettings&) const = default;
};

struct Scene {
    Camera camera;
    Water water;
    std::vector<Light> lights;
    std::vector<Receiver> receivers;
    glm::dvec3 skyRadiance{0.3, 0.4, 0.6};        ///< W/(m² sr)
    glm::dvec3 ambientRadiance{0.05, 0.05, 0.05}; ///< W/(m² sr)
    CausticsSettings caustics;
    GodraySettings godrays;

    bool operator==(const Scene&) const = default;
};

/// Every method there is (scene/MethodFacts.h).
std::span<const Method> allMethods();

/// The name that the scene file and `--method` use, and back; none for a name that no method has.
std::string_view methodName(Method method);
std::optional<Method> methodFromName(std::string_view name);

/// Likewise for `fill`.
std::span<const Fill> allFills();
std::string_view fillName(Fill fill);
std::optional<Fill> fillFromName(std::string_view name);
std::span<const GodrayMethod> allGodrayMethods();
std::string_view godrayMethodName(GodrayMethod method);

/// Bounds of the receivers in the world, m; empty without any.
Bounds worldBounds(const Receiver& receiver);
Bounds worldBounds(const Scene& scene);

/// Names of the receivers, joined by "+".
std::string receiverNames(const Scene& scene);

} // namespace limpid
