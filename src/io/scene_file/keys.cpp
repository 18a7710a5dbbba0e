#include "io/scene_file/keys.h"

#include <algorithm>
#include <cassert>

namespace scatter::io {
namespace {

constexpr double kFar = 1e6;        // metres
constexpr double kSmallest = 1e-3;  // metres
constexpr double kLargest = 1e5;
constexpr double kFastest = 1e5;      // m/s, and m/s²
constexpr double kFastestTurn = 1e4;  // rad/s
constexpr double kFullTurn = 360.0;   // degrees
constexpr double kMostFrames = 1e6;

using Keys = std::vector<SceneKey>;

SceneKey textKey(std::string_view name, std::string_view standard, std::string_view meaning) {
  return {name, "text", "", standard, meaning};
}

SceneKey flagKey(std::string_view name, std::string_view standard, std::string_view meaning,
                 std::string_view of = {}) {
  return {name, "true or false", "", standard, meaning, 1, -1, of};
}

/// A point of the world, or a distance along its axes.
SceneKey pointKey(std::string_view name, std::string_view standard, std::string_view meaning,
                  std::string_view of = {}) {
  return {name, "[x, y, z]", "m", standard, meaning, -kFar, kFar, of};
}

SceneKey directionKey(std::string_view name, std::string_view standard, std::string_view meaning,
                      std::string_view of = {}) {
  return {name, "[x, y, z]", "", standard, meaning, -kFar, kFar, of};
}

/// A length that must be given and is not zero.
SceneKey lengthKey(std::string_view name, double most, std::string_view meaning, std::string_view of = {}) {
  return {name, "number", "m", "required", meaning, kSmallest, most, of};
}

SceneSection roundSection(std::string_view name, std::string_view title, std::string_view meaning,
                          std::string_view length) {
  return {name, title, meaning, {lengthKey("radius", kLargest, ""), lengthKey("length", kLargest, length)}};
}

Keys surfaceKeys(std::string_view friction, std::string_view restitution, std::string_view rest) {
  return {
      {"friction", "number", "", friction, "Where two bodies touch, the product of theirs counts.", 0, 100},
      {"rolling_friction", "number", "m", rest, "Slows rolling.", 0, 100},
      {"spinning_friction", "number", "m", rest, "Slows turning on the spot.", 0, 100},
      {"restitution", "number", "", restitution, "0 no bounce, 1 full bounce; products count.", 0, 1},
      {"linear_damping", "number", "1/s", rest, "Share of the velocity that is lost in a second.", 0, 1},
      {"angular_damping", "number", "1/s", rest, "Share of the spin that is lost in a second.", 0, 1}};
}

SceneSection scene() {
  return {
      "scene",
      "[scene]",
      "The world. There is no key for the time step: a frame is always 1/60 s.",
      {textKey("summary", "\"\"", "One line for `scatter list`."),
       {"frames", "whole number", "1/60 s", "600", "How long the scene's story takes.", 1, kMostFrames},
       {"seed", "whole number", "", "1", "Of the random numbers; `--seed` overrides it.", 0, 9e15},
       {"gravity", "[x, y, z]", "m/s²", "[0, 0, 0]", "y points up.", -kFastest, kFastest},
       {"solver_iterations", "whole number", "", "10", "Of the constraint solver in each step.", 1, 1000}}};
}

SceneSection material() {
  Keys keys{textKey("name", "required", "For `material` in `[[object]]`.")};
  const Keys surface = surfaceKeys("that of the model, or 0.5", "that of the model, or 0", "0");
  keys.insert(keys.end(), surface.begin(), surface.end());
  return {"material", "[[material]]", "What surfaces and the air do to a body.", std::move(keys)};
}

SceneSection field() {
  return {
      "field",
      "[[field]]",
      "An acceleration of all dynamic bodies whose `in_fields` is true. Bodies that sleep are left alone.",
      {textKey("name", "none", "For events."),
       textKey("kind", "\"point\"",
               "`\"point\"`: toward `center`, within `radius`, with the same strength everywhere; "
               "`\"uniform\"`: along `direction` everywhere."),
       {"acceleration", "number", "m/s²", "required", "Negative: the other way.", -kFastest, kFastest},
       pointKey("center", "[0, 0, 0]", "", "point"),
       lengthKey("radius", kFar, "Outside of it there is no field.", "point"),
       directionKey("direction", "required", "Of any length but zero.", "uniform"),
       flagKey("on", "true", "Whether it acts from the start.")}};
}

SceneSection region() {
  return {"region",
          "[[region]]",
          "Where objects with `in` are placed at random, so that the bounding spheres of all bodies in the "
          "region are clear of one another. It grows by 5 % whenever 100 places in a row were taken.",
          {textKey("name", "required", "For `in`."),
           textKey("kind", "required",
                   "`\"shell\"`: between two radii, all directions and all distances being equally likely; "
                   "`\"ball\"` and `\"box\"`: evenly over the volume."),
           pointKey("center", "[0, 0, 0]", ""),
           {"inner", "number", "m", "required", "Inner radius.", 0, kFar, "shell"},
           lengthKey("outer", kFar, "Outer radius, no less than `inner`.", "shell"),
           lengthKey("radius", kFar, "", "ball"),
           {"size", "[x, y, z]", "m", "required", "Whole lengths of the sides.", kSmallest, kFar, "box"},
           {"clearance", "number", "m", "0", "Least distance of bounding spheres.", 0, kLargest}}};
}

Keys objectShapeKeys() {
  return {
      textKey(
          "name", "required",
          "Letters, digits, `-`, `_` and `.`. If there are several bodies, they are called NAME-1, NAME-2 …"),
      textKey(
          "model", "one of these",
          "A model of the library, such as `\"hunter\"`, or a model file relative to the scene file, such as "
          "`\"../models/mug.dae\"`."),
      {"levels", "whole number", "", "all of them",
       "With `model`: how many of its levels, from the finest on.", 1, 100},
      {"box", "[x, y, z]", "m", "one of these", "Whole lengths of the sides.", kSmallest, kLargest},
      {"sphere", "number or [least, most]", "m", "one of these",
       "The radius; of two, each body's is drawn evenly between them.", kSmallest, kLargest},
      {"capsule", "table", "", "one of these", "See `capsule`."},
      {"cylinder", "table", "", "one of these", "See `cylinder`."},
      {"hull", "list of [x, y, z]", "m", "one of these",
       "The convex hull of 4 to 256 points, with a collision margin around it that the engine sets.",
       -kLargest, kLargest},
      directionKey("plane", "one of these",
                   "A static half-space: its outward normal. Its surface goes through the object's place."),
      textKey(
          "mesh", "one of these",
          "A static surface of triangles: an obj, stl, ply, fbx, dae, gltf or glb file, or another one that "
          "Assimp reads, relative to the scene file, such as `\"bowl.obj\"`."),
      {"terrain", "table", "", "one of these", "A static rolling ground; see `terrain`."}};
}

Keys objectBodyKeys() {
  return {textKey("motion", R"("dynamic"; of a plane, mesh or terrain "static")",
                  R"(`"dynamic"`, `"static"` (never moves) or `"kinematic"` (pushes, is never pushed).)"),
          {"mass", "number", "kg", "that of the model, or 1", "", 1e-6, 1e12},
          {"density", "number", "kg/m³", "none", "Instead of `mass`; of the volume of the finest level.",
           1e-3, 1e6},
          textKey("material", "none", "The name of a `[[material]]`; keys given here take precedence.")};
}

Keys objectGroupKeys() {
  return {textKey("group", "\"default\"",
                  "A name for events, and for `collides_with` and `ignores`; at most 32 groups."),
          {"collides_with", "list of texts", "", "all groups", "Groups; both bodies must agree."},
          {"ignores", "list of texts", "", "[]", "Groups that are taken out again."},
          flagKey("may_rest", "true", "Whether it falls asleep when it hardly moves."),
          flagKey("in_fields", "true", "Whether fields act on it."),
          flagKey("sensor", "false", "Reports contacts, but neither pushes nor is pushed.")};
}

Keys objectPlaceKeys() {
  return {
      pointKey("at", "[0, 0, 0]", "A single body there."),
      {"list", "list of [x, y, z]", "m", "none", "Instead of `at`: a body at each of these.", -kFar, kFar},
      {"grid", "table", "", "none", "Instead of `at`: bodies on a grid; see `grid`."},
      {"stack", "table", "", "none", "Instead of `at`: bodies above one another; see `stack`."},
      textKey("in", "none", "Instead of `at`: `count` bodies at random in the `[[region]]`."),
      {"count", "whole number", "", "1", "How many bodies `in` a region.", 1, 20000},
      {"orientation", "text or table", "", "none",
       R"(`"random"`, `"upright"` (turned at random about the y axis), or a table; see `orientation`.)"},
      {"velocity", "[x, y, z] or table", "m/s", "[0, 0, 0]", "At the start; see `velocity`.", -kFastest,
       kFastest},
      {"spin", "[x, y, z] or table", "rad/s", "[0, 0, 0]",
       "Angular velocity at the start, world axes; see `spin`.", -kFastestTurn, kFastestTurn},
      {"gibs", "list of texts", "", "the parts of the finest level",
       "Models that take the body's place when it breaks, in its frame."}};
}

SceneSection object() {
  Keys keys = objectShapeKeys();
  const Keys unset = surfaceKeys("that of the material", "that of the material", "that of the material");
  for (const Keys& more : {objectBodyKeys(), unset, objectGroupKeys(), objectPlaceKeys()}) {
    keys.insert(keys.end(), more.begin(), more.end());
  }
  return {"object", "[[object]]",
          "One body, or several that are alike. Bodies are made in the file's order. The random numbers of a "
          "body are drawn in this order: size, place, orientation, velocity, spin.",
          std::move(keys)};
}

SceneSection terrain() {
  return {"object.terrain",
          "terrain = { … }",
          "Smooth noise over a rectangle whose middle is the object's place; its lowest point is at that "
          "height. The same numbers give the same surface.",
          {{"size", "[x, z]", "m", "required", "Whole lengths of the sides.", kSmallest, kLargest},
           {"cells", "[nx, nz]", "", "required",
            "Whole numbers, 250 000 cells at most. A cell is two triangles.", 1, 1000},
           {"relief", "number", "m", "required", "From the lowest point to the highest.", 0, kLargest},
           {"roughness", "number", "", "0.5",
            "Each wave that is half as long is so much as high; 0: only the longest, three of them a side.",
            0, 1},
           {"seed", "whole number", "", "1", "Of the surface alone; `--seed` does not change it.", 0, 9e15},
           textKey("kind", "\"mesh\"",
                   R"(`"mesh"`: a triangle mesh; `"height_field"`: the same surface as a height field.)")}};
}

std::vector<SceneSection> objectTables() {
  return {
      roundSection("object.capsule", "capsule = { … }", "A cylinder with round ends, along the y axis.",
                   "Of the part between the ends."),
      roundSection("object.cylinder", "cylinder = { … }", "Along the y axis.", ""),
      terrain(),
      {"object.grid",
       "grid = { … }",
       "Rows along x, made into layers along z, made into a block along y.",
       {{"count", "[nx, ny, nz]", "", "required", "Whole numbers.", 1, 20000},
        pointKey("spacing", "required", "From one body to the next."),
        pointKey("center", "[0, 0, 0]", "The middle of the grid.")}},
      {"object.stack",
       "stack = { … }",
       "Bodies above one another; not for planes, meshes, terrains, random orientations and random sizes.",
       {{"count", "whole number", "", "required", "", 1, 20000},
        pointKey("base", "[0, 0, 0]", "The middle of the lowest one's underside."),
        {"gap", "number", "m", "0", "Between two bodies' bounds.", -kLargest, kLargest}}},
      {"object.orientation",
       "orientation = { … }",
       "Either `axis` and `angle`, or `quaternion`.",
       {directionKey("axis", "none", "Of any length but zero."),
        {"angle", "number", "degrees", "none", "About the axis.", -kFullTurn, kFullTurn},
        {"quaternion", "[w, x, y, z]", "", "none", "Of any length but zero.", -kFar, kFar}}},
      {"object.velocity",
       "velocity = { … }",
       "`random` alone, `toward` and `speed`, or `away` and `rate`.",
       {{"random", "number", "m/s", "none", "Evenly over a ball of this radius.", 0, kFastest},
        pointKey("toward", "none", "A point."),
        {"speed", "number", "m/s", "none", "Toward the point.", -kFastest, kFastest},
        pointKey("away", "none", "A point."),
        {"rate", "number", "1/s", "none", "Times the distance from the point.", -1000, 1000}}},
      {"object.spin",
       "spin = { … }",
       "",
       {{"random", "number", "rad/s", "required", "Evenly over a ball of this radius.", 0, kFastestTurn}}}};
}

SceneSection joint() {
  return {"joint",
          "[[joint]]",
          "Holds two bodies together, or one and the world. Goes with its bodies.",
          {textKey("kind", "required",
                   "`\"point\"`: a point stays on a point; `\"hinge\"`: turns about `axis`; `\"slider\"`: "
                   "moves along `axis`; `\"fixed\"`; `\"six_dof\"`: within the limits below."),
           textKey("a", "required", "The name of a body."),
           textKey("b", "the world", "The name of another body; one of the two must be dynamic."),
           pointKey("at", "[0, 0, 0]", "Where the joint is in the world at the start."),
           directionKey("axis", "required", "In the world at the start.", "hinge slider"),
           {"lower", "number", "degrees (hinge), m (slider)", "none",
            "With `upper`: how far `b` may turn or move against `a`; a hinge from -180 to 180.", -kFar, kFar,
            "hinge slider"},
           {"upper", "number", "degrees (hinge), m (slider)", "none", "", -kFar, kFar, "hinge slider"},
           pointKey("linear_lower", "[0, 0, 0]", "A lower limit above the upper one: free.", "six_dof"),
           pointKey("linear_upper", "[0, 0, 0]", "", "six_dof"),
           {"angular_lower", "[x, y, z]", "degrees", "[0, 0, 0]",
            "Turns about x, then y, then z; y from -90 to 90. A lower limit above the upper one: free.",
            -kFullTurn, kFullTurn, "six_dof"},
           {"angular_upper", "[x, y, z]", "degrees", "[0, 0, 0]", "", -kFullTurn, kFullTurn, "six_dof"},
           flagKey("collide", "false", "Whether the two bodies still collide.")}};
}

SceneSection event() {
  return {
      "event",
      "[[event]]",
      "What happens at a point in time, before the step of that frame. Bodies that are no longer there are "
      "passed over, and so are those that are not dynamic, except by `\"remove\"` and `\"break\"`.",
      {textKey(
           "do", "required",
           "`\"throw\"`: sets the velocity; `\"knock\"`: an impulse at the centre of mass; `\"break\"`: puts "
           "pieces in the body's place, with its momentum; `\"remove\"`; `\"field\"`: switches a field, and "
           "wakes all bodies when it comes on."),
       {"frame", "whole number", "1/60 s", "this or `seconds`", "0 is the first.", 0, kMostFrames},
       {"seconds", "number", "s", "this or `frame`", "The nearest frame is taken.", 0, 16666},
       {"target", "text or list of texts", "", "required", "Names of objects, of groups or of single bodies.",
        1, -1, "throw knock break remove"},
       {"velocity", "[x, y, z]", "m/s", "this or `toward`", "", -kFastest, kFastest, "throw"},
       {"toward", "[x, y, z] or text", "m", "this or `velocity`", "A point, or a body by its name.", -kFar,
        kFar, "throw"},
       {"speed", "number", "m/s", "with `toward` or instead of `impulse`",
        "Toward the point or body; of a knock, the change of speed.", -kFastest, kFastest, "throw knock"},
       {"spin", "[x, y, z]", "rad/s", "as it is", "", -kFastestTurn, kFastestTurn, "throw"},
       directionKey("direction", "required", "Of any length but zero.", "knock"),
       {"impulse", "number", "N s", "this or `speed`", "", -1e12, 1e12, "knock"},
       flagKey("body_frame", "false", "Whether the direction turns with the body.", "knock"),
       {"burst", "number", "1/s", "0", "How fast the pieces fly apart, times their distance from the middle.",
        0, 1000, "break"},
       {"shrink", "number", "", "1",
        "Size of each piece, of that of its part: parts that overlap push each other away.", 0.1, 1, "break"},
       {"field", "text", "", "required", "The name of a `[[field]]`.", 1, -1, "field"},
       flagKey("on", "required", "", "field")}};
}

std::vector<SceneSection> makeSections() {
  std::vector<SceneSection> sections{
      {"file",
       "the file",
       "",
       {{"scene", "table", "", "none", "The world."},
        {"material", "list of tables", "", "none", "Surfaces."},
        {"field", "list of tables", "", "none", "Accelerations."},
        {"region", "list of tables", "", "none", "Where bodies are placed at random."},
        {"object", "list of tables", "", "none", "Bodies."},
        {"joint", "list of tables", "", "none", "What holds bodies together."},
        {"event", "list of tables", "", "none", "What happens when."}}},
      scene(),
      material(),
      field(),
      region(),
      object()};
  for (SceneSection& table : objectTables()) sections.push_back(std::move(table));
  sections.push_back(joint());
  sections.push_back(event());
  return sections;
}

}  // namespace

const SceneKey* SceneSection::find(std::string_view key) const {
  const auto found =
      std::find_if(keys.begin(), keys.end(), [key](const SceneKey& k) { return k.name == key; });
  return found == keys.end() ? nullptr : &*found;
}

const std::vector<SceneSection>& sceneSections() {
  static const std::vector<SceneSection> sections = makeSections();
  return sections;
}

const SceneSection& sceneSection(std::string_view name) {
  const auto& sections = sceneSections();
  const auto found = std::find_if(sections.begin(), sections.end(),
                                  [name](const SceneSection& section) { return section.name == name; });
  assert(found != sections.end());
  return *found;
}

bool hasWord(std::string_view words, std::string_view word) {
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(' '), words.size());
    if (words.substr(0, end) == word) return true;
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return false;
}

}  // namespace scatter::io
