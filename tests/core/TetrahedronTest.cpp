#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/Optics.h"

namespace limpid {
namespace {

using shader::Corner;
using shader::Fan;

/// Two linear functions of the place stand for light.
glm::vec2 lightAt(const glm::dvec3& p) {
    return {3 + p.x - 2 * p.y + 0.5 * p.z, 1 - p.x + p.z};
}

Corner cornerAt(const glm::dvec3& p) {
    return {glm::vec3(p), lightAt(p)};
}

/// Points as the camera has them: right, up, ahead.
struct Solid {
    std::array<glm::dvec3, 4> corners;
    shader::Tetrahedron asShaders() const {
        return shader::tetrahedronOf(cornerAt(corners[0]), cornerAt(corners[1]), cornerAt(corners[2]),
                                     cornerAt(corners[3]));
    }
};

double volumeOf(const std::array<glm::dvec3, 4>& c) {
    return std::abs(glm::dot(c[1] - c[0], glm::cross(c[2] - c[0], c[3] - c[0]))) / 6;
}

/// w where the view ray through a place of the screen enters and leaves a convex solid with these faces, each
/// three points of it and one on its inner side.
std::optional<glm::dvec2> through(const glm::dvec2& at, const std::vector<std::array<glm::dvec3, 4>>& faces) {
    const glm::dvec3 way(at, 1);
    glm::dvec2 range(0, 1e9);
    for (const auto& [a, b, c, inner] : faces) {
        glm::dvec3 normal = glm::cross(b - a, c - a);
        if (glm::dot(normal, inner - a) < 0) normal = -normal;
        const double along = glm::dot(normal, way), w = glm::dot(normal, a) / along;
        if (along > 0)
            range.x = std::max(range.x, w);
        else
            range.y = std::min(range.y, w);
    }
    if (range.x >= range.y) return {};
    return range;
}

std::vector<std::array<glm::dvec3, 4>> facesOf(const Solid& s) {
    const auto& c = s.corners;
    return {{c[0], c[1], c[2], c[3]},
            {c[0], c[1], c[3], c[2]},
            {c[0], c[2], c[3], c[1]},
            {c[1], c[2], c[3], c[0]}};
}

/// What the pixel at a place of the screen is given of a fan: entering and leaving.
std::optional<std::pair<glm::dvec3, glm::dvec3>> drawnAt(const Fan& fan, const glm::dvec2& at) {
    const auto cross = [](const glm::dvec2& u, const glm::dvec2& v) { return u.x * v.y - u.y * v.x; };
    for (int i = 0; i < fan.sides; ++i) {
        const int k[3] = {0, 1 + i, 1 + (i + 1) % fan.sides};
        const glm::dvec2 a = fan.places[k[0]], b = glm::dvec2(fan.places[k[1]]) - a,
                         c = glm::dvec2(fan.places[k[2]]) - a, p = at - a;
        const double area = cross(b, c), u = cross(p, c) / area, v = cross(b, p) / area;
        if (!(u >= 0 && v >= 0 && u + v <= 1)) continue;
        const glm::dvec3 near(fan.entering[k[0]]),
            outline = u * glm::dvec3(fan.entering[k[1]]) + v * glm::dvec3(fan.entering[k[2]]);
        return std::pair((1 - u - v) * near + outline, (1 - u - v) * glm::dvec3(fan.leaving) + outline);
    }
    return {};
}

class TetrahedronTest : public testing::Test {
  protected:
    double within(double low, double high) { return std::uniform_real_distribution(low, high)(_random); }
    glm::dvec3 point(double nearest) { return {within(-1, 1), within(-1, 1), within(nearest, 3)}; }
    Solid solid(double nearest) {
        Solid s;
        do
            for (glm::dvec3& corner : s.corners)
                corner = point(nearest);
        while (volumeOf(s.corners) < 0.02);
        return s;
    }

  private:
    std::mt19937 _random{7};
};

// The picture's arithmetic has 24 bits; a place on the screen and 1 / w are taken once, subtracted and put
// together by quotients of areas, which are here at least a hundredth. So a few hundred roundings, of values
// that are below 10.
constexpr double rounding = 300 * 6e-8 * 10;

TEST_F(TetrahedronTest, isAsThickAsItIsInEveryPixel) {
    int sides[5] = {}, hit = 0;
    for (int i = 0; i < 400; ++i) {
        const Solid s = solid(1);
        const Fan fan = shader::fanOf(s.asShaders());
        ASSERT_TRUE(fan.sides == 3 || fan.sides == 4);
        ++sides[fan.sides];
        for (int k = 0; k < 60; ++k) {
            const glm::dvec2 at(within(-0.8, 0.8), within(-0.8, 0.8));
            const auto range = through(at, facesOf(s));
            const auto drawn = drawnAt(fan, at);
            // At the outline, rounding says whether a pixel is met; there is nothing to be seen there.
            const double thick = range ? range->y - range->x : 0;
            if (!drawn || !range) {
                EXPECT_LT(drawn ? 1 / drawn->second.x - 1 / drawn->first.x : thick, 0.01);
                continue;
            }
            ++hit;
            EXPECT_NEAR(1 / drawn->first.x, range->x, rounding);
            EXPECT_NEAR(1 / drawn->second.x, range->y, rounding);
            const glm::dvec2 enters(lightAt(range->x * glm::dvec3(at, 1))),
                leaves(lightAt(range->y * glm::dvec3(at, 1)));
            EXPECT_LT(glm::distance(glm::dvec2(drawn->first.y, drawn->first.z) / drawn->first.x, enters),
                      rounding);
            EXPECT_LT(glm::distance(glm::dvec2(drawn->second.y, drawn->second.z) / drawn->second.x, leaves),
                      rounding);
        }
    }
    EXPECT_GT(hit, 500);
    EXPECT_GT(sides[3], 50) << "case I";
    EXPECT_GT(sides[4], 50) << "case II";
}

// By 1 / w, which is what is linear on the screen; of something small that is the same as by metres.
TEST_F(TetrahedronTest, isThickestWhereItsTrianglesMeet) {
    for (int i = 0; i < 200; ++i) {
        const Solid s = solid(1);
        const Fan fan = shader::fanOf(s.asShaders());
        const double most = fan.entering[0].x - fan.leaving.x;
        EXPECT_GT(most, 0);
        for (int k = 0; k < 40; ++k) {
            const auto range = through({within(-0.8, 0.8), within(-0.8, 0.8)}, facesOf(s));
            if (range) {
                EXPECT_LE(1 / range->x - 1 / range->y, most + rounding);
            }
        }
        const auto here = through(fan.places[0], facesOf(s));
        ASSERT_TRUE(here);
        EXPECT_NEAR(1 / here->x - 1 / here->y, most, rounding);
    }
}

TEST_F(TetrahedronTest, threeOfThemAreAPrism) {
    for (int i = 0; i < 100; ++i) {
        // Level ends of one shape but of two sizes: no side is bent.
        const glm::dvec3 apex(within(-0.2, 0.2), 4, 2.5);
        std::array<glm::dvec3, 3> top, bottom;
        for (int k = 0; k < 3; ++k) {
            const double angle = 2.1 * k + within(0, 1);
            top[k] = glm::dvec3(0.5 * std::cos(angle), 0.5, 2 + 0.5 * std::sin(angle));
            bottom[k] = apex + (top[k] - apex) * 1.3;
        }
        const glm::dvec3 middle = (top[0] + top[1] + bottom[2]) / 3.0 * 0.9 + 0.1 * bottom[0];
        const std::vector<std::array<glm::dvec3, 4>> faces = {{top[0], top[1], top[2], middle},
                                                              {bottom[0], bottom[1], bottom[2], middle},
                                                              {top[0], top[1], bottom[0], top[2]},
                                                              {top[1], top[2], bottom[1], top[0]},
                                                              {top[2], top[0], bottom[2], top[1]}};
        for (int k = 0; k < 40; ++k) {
            const glm::dvec2 at(within(-0.4, 0.4), within(-0.4, 0.4));
            double sum = 0;
            for (int part = 0; part < 3; ++part) {
                const Fan fan = shader::fanOf(
                    shader::ofPrism(cornerAt(top[0]), cornerAt(top[1]), cornerAt(top[2]), cornerAt(bottom[0]),
                                    cornerAt(bottom[1]), cornerAt(bottom[2]), part));
                if (const auto drawn = drawnAt(fan, at)) sum += 1 / drawn->second.x - 1 / drawn->first.x;
            }
            const auto range = through(at, faces);
            EXPECT_NEAR(sum, range ? range->y - range->x : 0, 3 * rounding);
        }
    }
}

TEST_F(TetrahedronTest, isTheSameByItsFacesNextToTheCamera) {
    constexpr float near = 1e-3f;
    int hit = 0, around = 0, beside = 0;
    for (int i = 0; i < 1000; ++i) {
        const Solid s = solid(-1);
        const shader::Tetrahedron t = s.asShaders();
        if (!shader::isClose(t)) continue;
        const shader::Faces faces = shader::facesOf(t, near);
        beside += faces.low.x > faces.high.x || faces.low.y > faces.high.y;
        const glm::bvec4 before(
            glm::ivec4(faces.before[0], faces.before[1], faces.before[2], faces.before[3]));
        around += !glm::any(before);
        for (int k = 0; k < 40; ++k) {
            const glm::dvec2 at(within(-1, 1), within(-1, 1));
            glm::vec4 planes;
            for (int j = 0; j < 4; ++j)
                planes[j] = glm::dot(faces.planes[j], glm::vec3(at, 1));
            const glm::dvec2 range(shader::throughFaces(planes, before, near));
            auto truth = through(at, facesOf(s));
            if (truth && truth->y <= near) truth.reset();
            if (truth) truth->x = std::max(truth->x, double(near));
            // A plane is as well known as its corners, and by as much as the ray runs along it, less.
            if (!truth || truth->y - truth->x < 0.02) {
                EXPECT_LT(range.x > range.y ? 1 / range.y - 1 / range.x : 0, 0.03);
                continue;
            }
            ++hit;
            EXPECT_NEAR(1 / range.x, truth->x, rounding);
            EXPECT_NEAR(1 / range.y, truth->y, rounding);
            EXPECT_TRUE(glm::all(glm::lessThanEqual(faces.low, glm::vec2(at) + 1e-5f)));
            EXPECT_TRUE(glm::all(glm::greaterThanEqual(faces.high, glm::vec2(at) - 1e-5f)));
            for (const double w : {truth->x, truth->y})
                for (int c = 0; c < 2; ++c)
                    EXPECT_NEAR(faces.light[c] + w * glm::dot(faces.slopes[c], glm::vec3(at, 1)),
                                lightAt(w * glm::dvec3(at, 1))[c], rounding);
        }
    }
    EXPECT_GT(hit, 1000);
    EXPECT_GT(around, 10) << "the camera within";
    EXPECT_GT(beside, 3);
}

TEST_F(TetrahedronTest, thatIsFlatIsNotDrawn) {
    const Corner a = cornerAt({0, 0, 1}), b = cornerAt({1, 0, 1}), c = cornerAt({0, 1, 1});
    EXPECT_EQ(shader::fanOf(shader::tetrahedronOf(a, a, a, a)).sides, 0);
    EXPECT_EQ(shader::fanOf(shader::tetrahedronOf(a, b, cornerAt({2, 0, 1}), cornerAt({3, 0, 2}))).sides, 0);
    // A triangle has no thickness.
    const Fan fan = shader::fanOf(shader::tetrahedronOf(a, b, c, cornerAt({0.3, 0.3, 1})));
    EXPECT_EQ(fan.leaving.x, fan.entering[0].x);
}

/// ∫ e^-(c t) as straight lines between cuts have it, over what it is.
double heldBetweenCuts(double c, float metres, float perMetre, int count) {
    double sum = 0, before = 0;
    for (int i = 1; i <= count; ++i) {
        const double t = shader::cutDepth(float(i) / float(count), metres, perMetre);
        sum += 0.5 * (std::exp(-c * before) + std::exp(-c * t)) * (t - before);
        before = t;
    }
    return sum * c / (1 - std::exp(-c * metres));
}

TEST(ShaftCuts, areAsManyAsTheWaterAsksFor) {
    constexpr float most = 0.005f;
    for (const float metres : {0.1f, 1.0f, 3.0f, 60.0f})
        for (const float perMetre : {0.0f, 0.01f, 0.14f})
            for (const float thick : {0.14f, 0.5f, 2.0f}) {
                const int count = shader::cutsFor(metres, perMetre, thick, most);
                const double held = heldBetweenCuts(thick, metres, perMetre, count);
                // The count is a whole number, and the error's leading term by which it is chosen is not all
                // of it where one piece takes much of the light.
                EXPECT_LT(held, 1 + 1.15 * most) << metres << " " << perMetre << " " << thick;
                if (count > 3) {
                    EXPECT_GT(heldBetweenCuts(thick, metres, perMetre, count / 2), 1 + most);
                }
                EXPECT_GT(held, 1 - 1e-5);
            }
    EXPECT_EQ(shader::cutsFor(100, 0, 0, most), 1);
    EXPECT_GT(shader::cutsFor(20, 0.1f, 0.2f, most), shader::cutsFor(2, 0.1f, 0.2f, most));
}

TEST(ShaftCuts, areFoundAgain) {
    for (const float metres : {0.5f, 40.0f})
        for (const float perMetre : {0.0f, 0.2f})
            for (const float share : {0.0f, 0.2f, 0.7f, 1.0f}) {
                const float depth = shader::cutDepth(share, metres, perMetre);
                EXPECT_NEAR(shader::cutShare(depth, metres, perMetre), share, 1e-5);
                EXPECT_NEAR(shader::cutDepth(1, metres, perMetre), metres, 1e-4 * metres);
            }
}

} // namespace
} // namespace limpid
