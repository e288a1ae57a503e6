#include "scene/WaterNames.h"

#include <gtest/gtest.h>

namespace limpid {
namespace {

TEST(WaterNamesTest, KnowsWhatAuthorsCallWater) {
    for (const char* name : {"Water",
                             "water",
                             "WATER",
                             "Water.001",
                             "water_01",
                             "pool_water",
                             "PoolWater",
                             "poolwater",
                             "Swimming Pool Water",
                             "WaterPlane",
                             "waterplane",
                             "Water_Surface",
                             "water-surface-LOD0",
                             "SM_Water",
                             "M_Water",
                             "MI_Ocean_Water",
                             "Ocean",
                             "ocean_mesh",
                             "Sea",
                             "sea surface",
                             "SeaSurface",
                             "Surface of the sea",
                             "Seawater",
                             "LakeWater",
                             "Lake",
                             "River",
                             "water_volume",
                             "Clear Water Material",
                             "tank_water",
                             "Wasser",
                             "acqua",
                             "Agua",
                             "eau"})
        EXPECT_TRUE(namesWater(name)) << name;
}

TEST(WaterNamesTest, LeavesAloneWhatIsOnlyNearWater) {
    for (const char* name : {"",
                             "Cube",
                             "001",
                             "waterproof",
                             "watermelon",
                             "underwater_rock",
                             "Underwater",
                             "waterfall",
                             "water tank",
                             "WaterBottle",
                             "water_lily",
                             "water-wheel",
                             "watering can",
                             "Sea Floor",
                             "seafloor",
                             "seabed",
                             "Seal",
                             "seat",
                             "seaweed",
                             "sea_urchin",
                             "search",
                             "ocean liner",
                             "lakehouse",
                             "riverbed",
                             "river bank",
                             "Pool",
                             "pool floor",
                             "surface",
                             "Waves",
                             "Bateau",
                             "plateau",
                             "pond_plant",
                             "water pool tiles",
                             "freshwater fish"})
        EXPECT_FALSE(namesWater(name)) << name;
}

} // namespace
} // namespace limpid
