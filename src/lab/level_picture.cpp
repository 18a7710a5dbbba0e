#include "lab/level_picture.h"

#include <scatter/io/file.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <string_view>
#include <utility>

#include "lab/gnuplot.h"
#include "lab/level_view.h"
#include "lab/scratch_folder.h"
#include "lab/text.h"

namespace scatter::lab {

namespace fs = std::filesystem;

namespace {

constexpr int kPanelWidth = 460;
constexpr int kLeastPanelHeight = 160;
constexpr int kMostPanelHeight = 420;
constexpr int kCaptionHeight = 66;
constexpr int kTitleHeight = 44;

/// As a gnuplot string that says just this.
std::string quoted(const std::string& text) {
  std::string plain;
  for (const char c : text) plain += static_cast<unsigned char>(c) < 0x20 && c != '\n' ? ' ' : c;
  // Double quotes, because only they know line breaks.
  plain = replaceAll(replaceAll(plain, "\\", "\\\\"), "\"", "\\\"");
  return "\"" + replaceAll(plain, "\n", "\\n") + "\"";
}

/// Up to four panels stand in a row.
std::pair<int, int> columnsAndRows(int panels) {
  const int rows = (panels + 3) / 4;
  return {(panels + rows - 1) / rows, rows};
}

/// Of the whole picture.
int heightOf(int rows, int panelHeight) {
  return kTitleHeight + rows * (panelHeight + kCaptionHeight);
}

std::string panelScript(const LevelPicture& picture, int columns, int rows, int panelHeight) {
  std::string script;
  const int height = heightOf(rows, panelHeight);
  const double titleShare = static_cast<double>(kTitleHeight) / height;
  for (std::size_t i = 0; i < picture.captions.size(); ++i) {
    const int column = static_cast<int>(i) % columns;
    const int row = static_cast<int>(i) / columns;
    const double rowShare = (1.0 - titleShare) / rows;
    const double top = 1.0 - titleShare - row * rowShare;
    const double bottom = top - rowShare * panelHeight / (panelHeight + kCaptionHeight);
    const auto edges =
        std::array{static_cast<double>(column) / columns, (column + 1.0) / columns, bottom, top};
    script += "set lmargin at screen " + fixedNumber(edges[0], 6) + "; set rmargin at screen " +
              fixedNumber(edges[1], 6) + "\nset bmargin at screen " + fixedNumber(edges[2], 6) +
              "; set tmargin at screen " + fixedNumber(edges[3], 6) + "\n";
    script += "unset label\nset label " + quoted(picture.captions[i]) + " noenhanced center at screen " +
              fixedNumber(0.5 * (edges[0] + edges[1]), 6) + ", screen " +
              fixedNumber(bottom - 20.0 / height, 6) + "\n";
    script += "plot 'panel" + std::to_string(i) + ".rgb' binary array=(" + std::to_string(kPanelWidth) + "," +
              std::to_string(panelHeight) + ") flipy format='%uchar' with rgbimage notitle\n";
  }
  return script;
}

std::string scriptOf(const LevelPicture& picture, int panelHeight, bool isSvg) {
  const auto [columns, rows] = columnsAndRows(static_cast<int>(picture.captions.size()));
  const int width = columns * kPanelWidth;
  const std::string size = std::to_string(width) + "," + std::to_string(heightOf(rows, panelHeight));
  std::string script =
      isSvg ? "set terminal svg size " + size + " dynamic font 'sans-serif,14' background 'white'\n"
            : "set terminal pngcairo size " + size + " font 'Sans,13' background 'white'\n";
  script += "set encoding utf8\nset output 'picture'\nset multiplot title " + quoted(picture.title) +
            " noenhanced\n";
  script += "unset border\nunset tics\nunset key\n";
  script += "set xrange [0:" + std::to_string(kPanelWidth) +
            "]\nset yrange [0:" + std::to_string(panelHeight) + "]\n";
  return script + panelScript(picture, columns, rows, panelHeight) + "unset multiplot\nunset output\n";
}

Result<void> writePanels(const LevelPicture& picture, const LevelView& view, const fs::path& folder) {
  std::size_t panel = 0;
  const auto write = [&](const std::string& pixels) {
    return writeFile(folder / ("panel" + std::to_string(panel++) + ".rgb"), pixels);
  };
  if (!picture.mesh->triangles.empty()) {
    if (auto written = write(view.render(*picture.mesh)); !written) return written;
  }
  for (int i = 1; i <= picture.levels->count(); ++i) {
    if (auto written = write(view.render(picture.levels->level(i))); !written) return written;
  }
  assert(panel == picture.captions.size());
  return {};
}

}  // namespace

Result<void> drawLevels(const LevelPicture& picture, const fs::path& file) {
  const bool isSvg = file.extension() == ".svg";
  if (!isSvg && file.extension() != ".png") {
    return fail(file.string() + ": is no picture by its extension; give it .png or .svg");
  }
  const ScratchFolder scratch("scatter-picture");
  if (scratch.path().empty()) return fail("cannot make a folder in " + fs::temp_directory_path().string());
  const LevelView view(picture.levels->coarsest(), kPanelWidth, kLeastPanelHeight, kMostPanelHeight);
  if (auto written = writePanels(picture, view, scratch.path()); !written) return written;
  if (auto written = writeFile(scratch.path() / "script", scriptOf(picture, view.height(), isSvg)); !written)
    return written;
  if (auto drawn = runGnuplot({"-d", "script"}, scratch.path()); !drawn) return drawn;
  return readFile(scratch.path() / "picture").and_then([&](const std::string& bytes) {
    return writeFile(file, bytes);
  });
}

}  // namespace scatter::lab
