#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "viewer/palette.h"
#include "viewer/panels/panels.h"

namespace scatter::viewer {
namespace {

constexpr std::size_t kMostPairs = 12;

std::string nameOf(const World& world, BodyId body) {
  const WorldObject* object = world.find(body);
  return object != nullptr ? object->name() : "an object that is gone";
}

const char* stateOf(RequestState state) {
  switch (state) {
    case RequestState::kUntried:
      return "not tried yet";
    case RequestState::kBlocked:
      return "not safe";
    case RequestState::kAsleep:
      return "the bodies rest";
  }
  return "";
}

/// Why it waits.
std::string reasonOf(const World& world, const ObservedRequest& request) {
  std::string reason = stateOf(request.state);
  if (request.blockedBy != BodyId{}) reason += ": " + nameOf(world, request.blockedBy) + " is in the way";
  if (request.state == RequestState::kBlocked)
    reason += ", next try in " + std::to_string(request.retrySteps) + " steps";
  return reason;
}

void showRequest(const World& world, const ObservedRequest& request) {
  ImGui::TextWrapped("asks for level %d (%.*s), for %u steps: %s", request.target,
                     static_cast<int>(request.policy.size()), request.policy.data(), request.waitingSteps,
                     reasonOf(world, request).c_str());
}

void showVector(const char* name, const Vec3& vector, const char* unit) {
  ImGui::Text("%s %.2f, %.2f, %.2f %s", name, static_cast<double>(vector.x), static_cast<double>(vector.y),
              static_cast<double>(vector.z), unit);
}

void showBody(const WorldObject& object) {
  const BodyState state = object.state();
  ImGui::Text("mass %.4g kg%s", static_cast<double>(object.def().mass), state.asleep ? ", asleep" : "");
  showVector("position", state.pose.position, "m");
  showVector("velocity", state.linearVelocity, "m/s");
  showVector("spin", state.angularVelocity, "rad/s");
  ImGui::Text("in all %.2f m/s, %.2f rad/s", static_cast<double>(glm::length(state.linearVelocity)),
              static_cast<double>(glm::length(state.angularVelocity)));
}

void showPairs(const World& world, const Observation& observed, BodyId body) {
  static constexpr std::array<const char*, 3> kNearness{"apart", "near", "touching"};
  std::size_t count = 0;
  for (const ObservedPair& pair : observed.pairs) {
    if (pair.a != body && pair.b != body) continue;
    if (++count > kMostPairs) continue;
    std::string text = "- " + nameOf(world, pair.a == body ? pair.b : pair.a) + ": " +
                       kNearness[static_cast<std::size_t>(pair.nearness)];
    if (pair.level > 0)
      text += ", level " + std::to_string(pair.level) + " of " + std::to_string(pair.levelCount);
    if (pair.credited) text += ", on credit";
    if (pair.units >= kLeastCost) text += ", took " + std::to_string(std::lround(pair.units)) + " us";
    ImGui::TextUnformatted(text.c_str());
    if (pair.request) showRequest(world, *pair.request);
  }
  if (count > kMostPairs) ImGui::Text("and %zu more pairs", count - kMostPairs);
  if (count == 0) ImGui::TextUnformatted("near nothing");
}

void showWorld(const Pane& pane, BodyId body) {
  const World& world = pane.experiment().world();
  const WorldObject* object = world.find(body);
  if (object == nullptr) {
    ImGui::TextUnformatted("not in this world any more");
    return;
  }
  showBody(*object);
  const Observation& observed = pane.observed();
  for (const ObservedBody& one : observed.bodies) {
    if (one.body != body) continue;
    const int levels = world.physics().switching().levelCount(body);
    if (levels > 1) ImGui::Text("levels in use %d to %d of %d", one.coarsestLevel, one.finestLevel, levels);
    if (one.frozen) ImGui::TextUnformatted("frozen");
    if (one.request) showRequest(world, *one.request);
  }
  showPairs(world, observed, body);
}

}  // namespace

void showInspectorPanel(ViewerState& state, const Layout& layout) {
  const auto picked = state.hands.picked();
  if (!picked) return;
  const std::string title = nameOf(state.panes.front()->experiment().world(), *picked) + "###picked";
  if (beginPanel(title.c_str(), layout.inspector())) {
    ImGui::PushTextWrapPos(0.0F);
    for (const auto& pane : state.panes) {
      if (state.panes.size() > 1 &&
          !ImGui::CollapsingHeader(pane->label().c_str(), ImGuiTreeNodeFlags_DefaultOpen))
        continue;
      showWorld(*pane, *picked);
    }
    ImGui::PopTextWrapPos();
  }
  ImGui::End();
}

}  // namespace scatter::viewer
