#include "lab/report_html.h"

#include "lab/comparison_table.h"
#include "lab/html.h"
#include "lab/names.h"
#include "lab/page/page_data.h"
#include "lab/text.h"
#include "lab/verdict.h"

#include <string>

namespace scatter::lab {

namespace {

// Of a page without its bundle, which has a style of its own.
constexpr const char* kPlainStyle =
    "body{font:16px/1.5 system-ui,sans-serif;max-width:1040px;margin:2em auto;padding:0 1em}"
    "td,th{padding:.25em .9em;text-align:right}td:first-child,th:first-child{text-align:left}"
    ".table{overflow-x:auto}figure img{width:100%}dd,code{overflow-wrap:anywhere}";

// Of pair switching: what decides about levels.
std::string describePairs(const SwitchingDef& switching) {
  const std::string each =
      "Each pair of objects has a level of its own, so that one neighbour can be met in full detail and "
      "another one coarsely. ";
  const BudgetDef& budget = switching.budget;
  if (switching.policy == Policy::kFinest) {
    return each + "Here everything is asked to stay at its finest level.";
  }
  if (switching.policy == Policy::kCoarsest) {
    return each + "Here everything is asked to be at its coarsest level: the lowest cost there is.";
  }
  if (budget.milliseconds > 0.0) {
    return each + "A governor takes detail away where a step would take more than " +
           readableNumber(budget.milliseconds) + " ms, where it is seen least.";
  }
  if (budget.units > 0.0) {
    return each + "A governor takes detail away where a step would cost more than " +
           readableNumber(budget.units) + " units of predicted work, where it is seen least.";
  }
  if (!budget.recorded.empty()) {
    return each + "A governor repeats the decisions of an earlier run.";
  }
  return each + "Nothing limits the cost of a step: pairs are in full detail unless a policy asks otherwise.";
}

// Where a world is cheaper although it never switches, this is why.
std::string describeCollision(const CollisionDef& collision) {
  if (collision.narrowphase != Narrowphase::kScatter) {
    return "All contacts are found by the engine's own algorithms. ";
  }
  return "Pairs of detailed objects have an algorithm of their own, which finds the contacts that the engine "
         "finds "
         "but skips the parts that cannot have come near each other since it last looked: what is saved in "
         "full "
         "detail is its doing, not that of switching. ";
}

std::string describe(const PhysicsDef& physics) {
  if (physics.world == WorldKind::kStandard) {
    return "The plain physics engine. Every object always collides in its full detail.";
  }
  const std::string same =
      "The same engine with switching. A detailed object has several nested collision shapes, a coarse one "
      "around "
      "finer ones, and may use a coarser one to save time. " +
      describeCollision(physics.collision);
  if (physics.switching.switching == Switching::kPair) {
    return same + describePairs(physics.switching);
  }
  switch (physics.switching.policy) {
    case Policy::kProximity:
      return same +
             "It asks for a coarser shape when others come near and for its full detail when it is alone "
             "again; it "
             "switches only when that moves nothing.";
    case Policy::kFinest:
      return same + "Here everything is asked to stay at its finest level.";
    case Policy::kCoarsest:
      return same + "Here everything is asked to be at its coarsest level: the lowest cost there is.";
    case Policy::kNone:
      return same + "Here only the scene itself asks for levels.";
  }
  return same;
}

std::string introduction(const Comparison& comparison) {
  const RunOptions& first = comparison.options.runs.front();
  const std::string about = first.summary.empty() ? std::string() : ": " + first.summary;
  std::string text =
      "<p>Scene <b>" + escaped(first.scene) + "</b>" + escaped(about) +
      "</p>\n<p>When many detailed objects meet at once, a physics engine has to test so many of their "
      "parts against each other that it cannot finish in time for the next picture: a collision "
      "overload. This page runs one scene in " +
      std::to_string(comparison.worlds.size()) + (comparison.worlds.size() == 1 ? " world" : " worlds") +
      ", from the same start and in the same fixed steps of 1/60 second, and compares what the physics "
      "cost.</p>\n<dl>\n";
  for (const RunOptions& run : comparison.options.runs) {
    text += element("dt", run.label) + element("dd", describe(run.physics));
  }
  return text + "</dl>\n";
}

std::string ratioCell(const ComparisonRow& row, std::size_t world) {
  if (row.extremes.empty() || row.extremes[world].empty()) {
    return row.ratios[world];
  }
  return row.ratios[world] + " (" + row.extremes[world] + ")";
}

std::string rowHtml(const ComparisonRow& row) {
  std::string text = "<tr><td>" + escaped(row.name) + "</td>";
  for (const std::string& value : row.values) {
    text += "<td>" + escaped(value) + "</td>";
  }
  for (std::size_t world = 0; world < row.ratios.size(); ++world) {
    text += "<td>" + escaped(ratioCell(row, world)) + "</td>";
  }
  return text + "</tr>\n";
}

// Why the table and the figures may have two peaks of one world.
std::string peakNote(const Comparison& comparison) {
  if (comparison.options.repeat == 1) {
    return {};
  }
  return " The table has the median of the repeats' peaks; the figures draw for each frame its median over "
         "the "
         "repeats, in which an interruption that hit one repeat is not seen, so that their peaks can be "
         "lower.";
}

std::string tableHtml(const Comparison& comparison) {
  std::string text = "<div class=\"table\">\n<table>\n<tr><th></th>";
  for (const ComparedWorld& world : comparison.worlds) {
    text += "<th>" + escaped(world.label()) + "</th>";
  }
  for (std::size_t i = 1; i < comparison.worlds.size(); ++i) {
    text +=
        "<th>" + escaped(comparison.worlds[i].label() + " / " + comparison.worlds.front().label()) + "</th>";
  }
  text += "</tr>\n";
  for (const ComparisonRow& row : comparisonRows(comparison)) {
    text += rowHtml(row);
  }
  text +=
      "</table>\n</div>\n<p>" +
      escaped(
          comparisonNote(comparison) +
          " CPU ms: processor time of the physics thread in a frame; wall ms also holds what other programs "
          "on the machine took from it. p99: 99 % of the frames took no longer." +
          peakNote(comparison)) +
      "</p>\n";
  for (const std::string& note : budgetNotes(comparison)) {
    text += element("p", note);
  }
  return text;
}

// The page draws the figure in the place of the picture, which stands beside it as a file.
std::string figureHtml(const Figure& figure, bool isDrawn) {
  const std::string name = escaped(figure.name);
  const std::string picture =
      "<img src=\"figures/" + name + ".svg\" alt=\"" + escaped(figure.title) + "\">\n";
  return "<figure id=\"" + name + "\">\n" + element("h3", figure.title) +
         (isDrawn ? "<noscript>" + picture + "</noscript>\n" : picture) + "<figcaption>" +
         escaped(figure.caption) + " For print: <a href=\"figures/" + name +
         ".svg\">SVG</a> <a href=\"figures/" + name + ".png\">PNG</a></figcaption>\n</figure>\n";
}

// Around the peak the page's own plots are looked at more closely.
bool isDetail(const Figure& figure) {
  return figure.name.ends_with("_peak");
}

std::string figuresHtml(const std::vector<Figure>& figures, bool isDrawn) {
  std::string text;
  for (const Figure& figure : figures) {
    if (!isDrawn || !isDetail(figure)) {
      text += figureHtml(figure, isDrawn);
    }
  }
  return text;
}

std::string fact(const std::string& name, const std::string& value) {
  return element("dt", name) + "<dd>" + escaped(value) + "</dd>\n";
}

std::string budgetOf(const SwitchingDef& switching) {
  if (switching.switching != Switching::kPair) {
    return {};
  }
  const BudgetDef& budget = switching.budget;
  std::string text = switching.credit ? ", credit to level " + std::to_string(switching.creditLevel)
                                      : std::string(", no credit");
  if (budget.milliseconds > 0.0) {
    text += ", governed to " + readableNumber(budget.milliseconds) + " ms";
  }
  if (budget.units > 0.0) {
    text += ", governed to " + readableNumber(budget.units) + " units";
  }
  if (!budget.recorded.empty()) {
    text += ", replay of " + std::to_string(budget.recorded.size()) + " steps";
  }
  return text;
}

std::string optionsOf(const RunOptions& run) {
  std::string text = nameOf(run.physics.world) + " world";
  if (run.physics.world == WorldKind::kHybrid) {
    text += ", switching " + nameOf(run.physics.switching.switching);
    text += ", policy " + nameOf(run.physics.switching.policy);
    for (const std::string& policy : run.physics.switching.policies) {
      text += ", policy " + policy;
    }
    text += budgetOf(run.physics.switching);
    text += run.physics.switching.safetyConditions ? "" : ", safety conditions off";
    text += ", collision " + nameOf(run.physics.collision.narrowphase);
    const float recycling = run.physics.collision.pairAlgorithm.recycling;
    if (recycling > 0.0F) text += ", contacts recycled within " + readableNumber(1000.0 * recycling) + " mm";
  }
  if (run.physics.threads > 1) text += ", " + std::to_string(run.physics.threads) + " threads";
  if (run.physics.contactsPerDirection > 0)
    text += ", " + std::to_string(run.physics.contactsPerDirection) + " contacts of each direction";
  return text + ", " + std::to_string(run.frames) + " frames, seed " + std::to_string(run.seed.value_or(1)) +
         ", budget " + readableNumber(run.budgetMs) + " ms, " + std::to_string(run.physics.solverIterations) +
         " iterations of the " + nameOf(run.physics.solver) + " solver, profiling " +
         (run.physics.profiling ? "on" : "off");
}

std::string conditions(const Comparison& comparison) {
  const Summary& summary = comparison.worlds.front().run().summary;
  const BuildInfo& build = summary.build;
  const MachineInfo& machine = summary.machine;
  std::string text = "<h2>How it was measured, and how to repeat it</h2>\n<dl>\n";
  if (!comparison.options.commandLine.empty()) {
    text += "<dt>Command</dt>\n<dd><code>" + escaped(comparison.options.commandLine) + "</code></dd>\n";
  }
  for (const RunOptions& run : comparison.options.runs) {
    text += fact("Options of the " + run.label + " world", optionsOf(run));
  }
  text += fact("Engine", summary.engine);
  text += fact("Build", "Scatter " + build.version + ", commit " + build.commit + ", " + build.compiler +
                            ", " + build.buildType + ", flags: " + build.flags);
  text += fact("Machine", machine.cpu + ", " + std::to_string(machine.cores) + " cores, " +
                              fixedNumber(static_cast<double>(machine.memoryBytes) / 1073741824.0, 1) +
                              " GiB of memory, " + machine.os);
  text +=
      fact("Repeats",
           std::to_string(comparison.options.repeat) +
               (comparison.options.repeat == 1
                    ? " of each world."
                    : " of each world, in alternating order; in worlds that no clock governs, the state of "
                      "every object was the same, bit for bit, in every frame of every repeat. Times in "
                      "the figures are the median of the repeats in each frame."));
  return text + "</dl>\n";
}

std::string dataLinks(const Comparison& comparison) {
  std::string text =
      "<h2>The data</h2>\n<p>Of each world's repeat with the median total CPU time:</p>\n<ul>\n";
  for (const ComparedWorld& world : comparison.worlds) {
    const std::string label = escaped(world.label());
    text += "<li>" + label + ": <a href=\"" + label + "/frames.csv\">frames.csv</a>, <a href=\"" + label +
            "/summary.json\">summary.json</a></li>\n";
  }
  return text + "<li>all ratios: <a href=\"comparison.json\">comparison.json</a></li>\n</ul>\n";
}

std::string licencesHtml(const PageBundle& bundle) {
  return "<h2>Licences</h2>\n<details>\n<summary>Of the libraries that this page holds</summary>\n<pre>" +
         escaped(std::string(bundle.licences)) + "</pre>\n</details>\n";
}

// Where the page puts what moves. Until then, and without scripts, the text is all there.
constexpr const char* kStage =
    "<div id=\"stage\"></div>\n<noscript><p>The moving picture and the plots need JavaScript; all figures "
    "and the "
    "table are there without it.</p></noscript>\n";
constexpr const char* kTrial = "<h2>Can you tell which is which?</h2>\n<div id=\"trial\"></div>\n";
constexpr const char* kLessPage =
    "<p>This report has no moving picture and no plots to zoom into, because the program that wrote it was "
    "built "
    "without its page, for which nodejs and npm are needed. The figures are files beside it, in the folder "
    "<code>figures</code>.</p>\n";

}  // namespace

std::string reportHtml(const Comparison& comparison, const std::vector<Figure>& figures,
                       const PageBundle& bundle) {
  const bool isDrawn = bundle.exists();
  const std::string style = isDrawn ? std::string(bundle.style) : kPlainStyle;
  std::string text =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n" +
      element("title", "Scatter: scene " + comparison.options.runs.front().scene) + "<style>" + style +
      "</style>\n</head>\n<body>\n" + element("h1", verdict(comparison)) +
      element("p", verdictDetails(comparison)) + (isDrawn ? kStage : kLessPage) + introduction(comparison) +
      "<h2>In numbers</h2>\n" + tableHtml(comparison) + "<h2>Frame by frame</h2>\n" +
      figuresHtml(figures, isDrawn);
  if (isDrawn && comparison.worlds.size() > 1) {
    text += kTrial;
  }
  text += conditions(comparison) + dataLinks(comparison);
  if (isDrawn) {
    text +=
        licencesHtml(bundle) + pageData(comparison) + "<script>" + std::string(bundle.script) + "</script>\n";
  }
  return text + "</body>\n</html>\n";
}

}  // namespace scatter::lab
