#include "text/nearest_name.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace scatter {
namespace {

const std::vector<std::string> kScenes{"armada", "duel", "fleet", "tower"};

TEST(NearestName, IsWhatMayHaveBeenMeant) {
  for (const auto& [name, meant] :
       {std::pair{"towr", "tower"}, std::pair{"dual", "duel"}, std::pair{"flete", "fleet"},
        std::pair{"tower", "tower"}, std::pair{"arm", "armada"}, std::pair{"powers", "tower"}})
    EXPECT_EQ(nearestName(name, kScenes), meant) << name;
}

TEST(NearestName, IsNoneOfWhatIsAnotherWord) {
  for (const char* name : {"", ".", "wall-12", "x", "/etc/passwd"})
    EXPECT_EQ(nearestName(name, kScenes), "") << name;
}

TEST(NearestName, IsNoneOfNone) {
  EXPECT_EQ(nearestName("tower", std::vector<std::string_view>{}), "");
}

// The time that a comparison takes grows with the product of the lengths.
TEST(NearestName, CutsWhatIsNoName) {
  EXPECT_EQ(nearestName(std::string(10'000'000, 't'), kScenes), "");
}

}  // namespace
}  // namespace scatter
