#pragma once

#include <scatter/lab/comparison.h>
#include <scatter/lab/contact_check.h>

#include <functional>
#include <string>
#include <vector>

namespace scatter {

struct SceneContacts {
  std::string scene;
  std::uint64_t frames = 0;
  ContactCheck check;
};

/// Runs each scene once and keeps how its contacts compared with the engine's; `runs` have
/// CollisionDef::verifyEvery set. Fails as runScene does.
[[nodiscard]] Result<std::vector<SceneContacts>> surveyContacts(
    const std::vector<RunOptions>& runs, const std::function<void(const CompareProgress&)>& progress = {});

/// The sums over the scenes, without the list of the first missed.
[[nodiscard]] ContactCheck totalOf(const std::vector<SceneContacts>& scenes);

/// One line a scene and one for all; ends with a new line.
[[nodiscard]] std::string formatContacts(const std::vector<SceneContacts>& scenes);
[[nodiscard]] std::string contactsCsv(const std::vector<SceneContacts>& scenes);

/// A line for each of the first missed contacts; ends with a new line unless there are none.
[[nodiscard]] std::string formatMisses(const ContactCheck& check);

}  // namespace scatter
