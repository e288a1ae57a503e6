#include "scene/MethodFacts.h"

#include <set>

#include <gtest/gtest.h>

namespace limpid {
namespace {

TEST(MethodFacts, nameEachMethodOnce) {
    std::set<std::string_view> names;
    for (const Method method : allMethods()) {
        EXPECT_EQ(factsOf(method).method, method);
        EXPECT_EQ(methodFromName(methodName(method)), method);
        names.insert(methodName(method));
    }
    EXPECT_EQ(names.size(), std::size(methodFacts));
    EXPECT_EQ(methodFromName("magic"), std::nullopt);
}

TEST(MethodFacts, fillIsTheMethodsOwnUnlessItHasBoth) {
    for (const MethodFacts& facts : methodFacts)
        for (const Fill asked : allFills())
            EXPECT_EQ(fillOf(facts.method, asked), facts.fills ? asked : facts.fill) << facts.name;
    CausticsSettings settings;
    settings.method = Method::LevelMap;
    settings.fill = Fill::OnePass;
    EXPECT_TRUE(sumsBeams(settings));
    settings.fill = Fill::Drawn;
    EXPECT_FALSE(sumsBeams(settings)) << "planes are drawn";
    settings.method = Method::ExactBeam;
    EXPECT_TRUE(sumsBeams(settings)) << "it has no other way";
}

TEST(MethodFacts, agreeWithOneAnother) {
    for (const MethodFacts& facts : methodFacts) {
        EXPECT_TRUE(facts.planes || (!facts.slicing && !facts.fills && !facts.sliceImages)) << facts.name;
        EXPECT_FALSE(facts.photons && facts.sumsBeams) << facts.name;
        EXPECT_FALSE(facts.tangentPlanes && facts.planes) << facts.name;
    }
}

} // namespace
} // namespace limpid
