#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "docs/page.h"

namespace scatter::test {
namespace {

namespace fs = std::filesystem;

const fs::path& root() {
  static const fs::path path(SCATTER_SOURCE_DIR);
  return path;
}

// Of this project's extensions of Bullet, and files of pages: `btHybridHull`, `pairs/pair_step`.
std::set<std::string> wordsLike(const std::string& text, const std::string& pattern) {
  const std::regex word(pattern);
  std::set<std::string> words;
  for (std::sregex_iterator each(text.begin(), text.end(), word); each != std::sregex_iterator(); ++each) {
    words.insert((*each)[1]);
  }
  return words;
}

std::set<std::string> namesInSources() {
  std::set<std::string> names;
  for (const char* folder : {"src", "include", "tests", "bench", "apps"}) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root() / folder)) {
      if (!entry.is_regular_file()) continue;
      std::ifstream stream(entry.path());
      const std::string text{std::istreambuf_iterator<char>(stream), {}};
      const auto more = wordsLike(text + entry.path().stem().string(), "\\b(btHybrid\\w+)");
      names.insert(more.begin(), more.end());
    }
  }
  return names;
}

std::vector<std::string> allPages() {
  std::vector<std::string> pages{"README.md"};
  for (const fs::directory_entry& entry : fs::directory_iterator(root() / "docs")) {
    if (entry.path().extension() == ".md") pages.push_back("docs/" + entry.path().filename().string());
  }
  return pages;
}

// Of `folder/file` that a table's first column has, whatever is behind the name.
bool isInSources(const std::string& name) {
  const fs::path path = root() / "src" / name;
  if (!fs::exists(path.parent_path())) return false;
  for (const fs::directory_entry& entry : fs::directory_iterator(path.parent_path())) {
    if (entry.path().filename().string().starts_with(path.filename().string())) return true;
  }
  return false;
}

TEST(PageNames, OfClassesAreThoseOfTheSources) {
  const std::set<std::string> known = namesInSources();
  std::vector<std::string> unknown;
  for (const std::string& page : allPages()) {
    for (const std::string& name : wordsLike(readPage(page), "\\b(btHybrid\\w+)")) {
      if (!known.contains(name)) unknown.push_back(page + ": " + name);
    }
  }
  EXPECT_GT(known.size(), 100U);
  EXPECT_THAT(unknown, testing::IsEmpty());
}

TEST(PageNames, OfFilesInTheTableOfPairSwitchingAreThere) {
  std::vector<std::string> unknown;
  for (const auto& row : tableBelow(readPage("docs/architecture.md"), "Pair switching")) {
    for (const std::string& name : wordsLike(row.front(), "`([a-z]+/[a-z_]+)[`*]")) {
      if (!isInSources(name)) unknown.push_back(name);
    }
  }
  EXPECT_THAT(unknown, testing::IsEmpty());
}

}  // namespace
}  // namespace scatter::test
