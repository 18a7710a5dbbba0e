#include <scatter/lab/recorded_machine.h>

#include "lab/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace scatter {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class RecordedMachine : public testing::Test {
 protected:
  Result<std::vector<double>> read(const std::string& text) {
    std::ofstream(file) << text;
    return readMachine(file);
  }

  void expectRefusal(const std::string& text, const std::string& message) {
    const auto machine = read(text);
    ASSERT_FALSE(machine) << text;
    EXPECT_THAT(machine.error().message, HasSubstr(file.string())) << text;
    EXPECT_THAT(machine.error().message, HasSubstr(message)) << text;
  }

  test::TemporaryFolder folder;
  std::filesystem::path file = folder.path() / "machine.csv";
};

TEST_F(RecordedMachine, IsReadAsItIsGiven) {
  const auto machine = read("step,ms_per_unit\n1,0.001\n2,0.0025\n");
  ASSERT_TRUE(machine);
  EXPECT_THAT(*machine, ElementsAre(0.001, 0.0025));
}

TEST_F(RecordedMachine, IsThatOfARunWhereItHadSomethingToDo) {
  const auto machine = read("cost_units,physics_cpu_ms\n24,7\n25,1\n100,2\n0,3\n50,0.5\n");
  ASSERT_TRUE(machine);
  EXPECT_THAT(*machine, ElementsAre(1.0 / 25.0, 0.02, 0.01));
}

TEST(TimeOnMachine, HasAStepWhereThereAreUnits) {
  EXPECT_THAT(timeOnMachine({2.0, 0.0, 3.0, 4.0}, {10.0, 100.0}), ElementsAre(20.0, 0.0, 300.0, 40.0));
}

TEST_F(RecordedMachine, TellsNothingWithoutUnitsOrTime) {
  expectRefusal("frame\n1\n", "no column cost_units");
  expectRefusal("cost_units\n1\n", "no column physics_cpu_ms");
  expectRefusal("cost_units,physics_cpu_ms\n0,1\n0,2\n", "cost no units");
  expectRefusal("cost_units,physics_cpu_ms\n10,0\n", "takes no time");
  expectRefusal("ms_per_unit\n0.1\n-1\n", "takes no time");
  expectRefusal("ms_per_unit\n", "no frames");
  expectRefusal("ms_per_unit\nfast\n", "line 2");
  EXPECT_FALSE(readMachine(folder.path() / "none.csv"));
}

}  // namespace
}  // namespace scatter
