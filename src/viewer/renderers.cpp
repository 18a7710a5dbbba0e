#include "viewer/renderers.h"

namespace scatter::viewer {

namespace {

struct Maker {
  const char* name;
  Result<std::unique_ptr<Renderer>> (*make)(const WindowDef&);
};

constexpr Maker kMakers[] = {
    {"irrlicht", makeIrrlichtRenderer},
#ifdef SCATTER_HAS_OGRE
    {"ogre", makeOgreRenderer},
#endif
    {"null", makeNullRenderer},
};

}  // namespace

std::vector<std::string> rendererNames() {
  std::vector<std::string> names;
  for (const Maker& maker : kMakers) names.emplace_back(maker.name);
  return names;
}

Result<std::unique_ptr<Renderer>> makeRenderer(const std::string& name, const WindowDef& window) {
  std::string known;
  for (const Maker& maker : kMakers) {
    if (name == maker.name) return maker.make(window);
    known += (known.empty() ? "" : ", ") + std::string(maker.name);
  }
  return fail("no renderer is called " + name + "; there are " + known);
}

}  // namespace scatter::viewer
