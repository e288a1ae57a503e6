// A scene that a host fills is held to the table of keys, as a file's is.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/Error.h"
#include "limpid/SceneChecks.h"
#include "scene/Keys.h"
#include "scene/Shapes.h"

namespace limpid {
namespace {

bool isRefused(const Scene& scene) {
    try {
        requireScene(scene);
    } catch (const InputError&) {
        return true;
    }
    return false;
}

/// Sets every number of a member.
template <typename T>
void fill(T& value, double number) {
    if constexpr (std::is_arithmetic_v<T>) value = T(number);
}
template <int N, typename T>
void fill(glm::vec<N, T>& value, double number) {
    value = glm::vec<N, T>(T(number));
}
template <typename T>
void fill(std::optional<T>& value, double number) {
    fill(value.emplace(), number);
}

/// What breaks a range from below and above, and what is no number; of `whole` numbers, whole.
std::vector<double> wrongNumbers(const Range& range, bool whole) {
    std::vector<double> wrong;
    const double step = whole ? 1 : 1e-6;
    if (range.min > anyNumber.min) wrong.push_back(range.openMin ? range.min : range.min - step);
    if (range.max < anyNumber.max) wrong.push_back(range.openMax ? range.max : range.max + step);
    if (range.direction) wrong.push_back(0);
    if (!whole) wrong.push_back(std::nan("")), wrong.push_back(std::numeric_limits<double>::infinity());
    return wrong;
}

template <typename T>
constexpr bool isNumeric =
    !std::is_enum_v<T> && !std::is_same_v<T, std::uint32_t> && !std::is_same_v<T, glm::dquat>;

/// Every numeric member of `object`, which is part of `scene`, that counts. Returns how many.
template <typename S>
int refusesWrong(const Scene& scene, S& object, std::span<const Key<S>> keys) {
    int count = 0;
    EXPECT_FALSE(isRefused(scene));
    for (const Key<S>& key : keys) {
        if (!knows(object, key)) continue;
        std::visit(
            [&]<typename M>(M member) {
                if constexpr (!std::is_same_v<M, std::monostate>) {
                    using T = std::remove_cvref_t<decltype(object.*member)>;
                    if constexpr (isNumeric<T>) {
                        const T before = object.*member;
                        constexpr bool whole = std::is_same_v<T, int> || std::is_same_v<T, glm::ivec2>;
                        for (const double number : wrongNumbers(key.range(), whole)) {
                            fill(object.*member, number);
                            if (!knows(object, key)) continue; // no spot any more
                            EXPECT_TRUE(isRefused(scene)) << key.name << " = " << number;
                        }
                        object.*member = before;
                        ++count;
                    }
                }
            },
            key.member);
    }
    return count;
}

TEST(SceneChecksTest, refuseWhatTheTableDoes) {
    Scene scene;
    scene.receivers = {{.mesh = std::make_shared<const Mesh>(makePlane({2, 2}, glm::vec3(0.5f)))}};
    EXPECT_EQ(refusesWrong(scene, scene.camera, cameraKeys), 5);
    EXPECT_EQ(refusesWrong(scene, scene.water, waterKeys), 8);
    EXPECT_EQ(refusesWrong(scene, scene.receivers[0], receiverKeys), 2);
    EXPECT_EQ(refusesWrong(scene, scene, skyKeys) + refusesWrong(scene, scene, ambientKeys), 2);
    EXPECT_EQ(refusesWrong(scene, scene.caustics, causticsKeys), 11);
    EXPECT_EQ(refusesWrong(scene, scene.godrays, godrayKeys), 9);
    int waves = 0, lights = 0;
    for (const WaveType type : {WaveType::Cosine, WaveType::Circular, WaveType::Noise}) {
        scene.water.waves = {defaultWave(type)};
        waves += refusesWrong(scene, scene.water.waves[0], waveKeys);
    }
    for (std::size_t type = 0; type < std::size(lightTypeNames); ++type) {
        scene.lights = {defaultLight(type)};
        lights += refusesWrong(scene, scene.lights[0], lightKeys);
    }
    EXPECT_EQ(waves, 14);
    EXPECT_EQ(lights, 10);
}

template <typename S>
void expectOneRangeAMember(std::span<const Key<S>> keys) {
    for (const Key<S>& a : keys)
        for (const Key<S>& b : keys)
            if (&a != &b && a.member != Member<S>() && a.member == b.member) {
                EXPECT_EQ(a.range().text(), b.range().text()) << a.name << " and " << b.name;
                EXPECT_EQ(a.range().direction, b.range().direction) << a.name << " and " << b.name;
            }
}

TEST(SceneChecksTest, keysThatShareAMemberShareItsRange) {
    expectOneRangeAMember(waveKeys);
}

} // namespace
} // namespace limpid
