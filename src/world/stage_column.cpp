#include <scatter/world/step_report.h>

#include <cassert>

namespace scatter {

std::string_view stageColumn(Stage stage) {
  static constexpr std::array<std::string_view, kStageCount> kColumns{
      "update_aabbs_ms",
      "predict_motion_ms",
      "collision_detection_ms",
      "islands_ms",
      "noncontact_constraints_ms",
      "contact_constraints_ms",
      "integrate_ms",
      "vehicles_ms",
      "activation_ms",
      "plan_ms",
  };
  const auto index = static_cast<std::size_t>(stage);
  assert(index < kStageCount);
  return kColumns[index];
}

}  // namespace scatter
