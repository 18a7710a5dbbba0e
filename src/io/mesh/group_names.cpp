#include "io/mesh/group_names.h"

#include <algorithm>

namespace scatter::io {

void GroupNames::add(MeshGroupKind kind, const std::string& name, std::size_t first, std::size_t last) {
  if (name.empty() || first >= last) return;
  const auto [place, isNew] = places_.try_emplace({kind, name}, groups_.size());
  if (isNew) groups_.push_back({kind, name, {}});
  std::vector<std::array<std::uint32_t, 2>>& runs = groups_[place->second].runs;
  // A node's run holds those of the nodes under it that have its name.
  auto begin = static_cast<std::uint32_t>(first);
  auto end = static_cast<std::uint32_t>(last);
  while (!runs.empty() && runs.back()[1] >= begin) {
    begin = std::min(begin, runs.back()[0]);
    end = std::max(end, runs.back()[1]);
    runs.pop_back();
  }
  runs.push_back({begin, end});
}

std::vector<MeshGroup> GroupNames::take() {
  return std::move(groups_);
}

}  // namespace scatter::io
