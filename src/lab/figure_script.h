#pragma once

#include "lab/figure_data.h"

#include <string>
#include <vector>

namespace scatter::lab {

/// One curve of a panel, from one world's data.
struct Curve {
  std::string plot;   ///< The world's file and columns, as gnuplot's plot command has them.
  std::string style;  ///< How it is drawn, after gnuplot's `with`.
  std::string title;  ///< In the legend; empty: none.
};

/// One set of axes in a figure.
struct Panel {
  std::string title;
  std::string yLabel;
  std::string yColor = "#222222";
  double yMin = 0.0;
  double yMax = 1.0;
  std::string y2Label{};  ///< Empty: no second axis.
  std::string y2Color = "#222222";
  double y2Max = 1.0;
  std::vector<Curve> curves{};
  std::vector<std::string> extra{};  ///< Further gnuplot commands, such as labels.
};

/// A figure: panels below each other with one horizontal axis, the legend of each to its right.
struct FigureScript {
  std::string name;
  std::string title;
  std::string caption;
  FrameRange frames;  ///< The horizontal axis.
  std::vector<Panel> panels;
  double panelHeight = 230.0;  ///< Pixels of the plot area.
  std::string xLabel = "frame (1/60 second of simulated time each)";
};

/// Okabe and Ito's colours, which colour-blind readers can tell apart ("Color Universal Design", 2008).
namespace color {
inline constexpr const char* kOrange = "#E69F00";
inline constexpr const char* kSkyBlue = "#56B4E9";
inline constexpr const char* kGreen = "#009E73";
inline constexpr const char* kYellow = "#F0E442";
inline constexpr const char* kBlue = "#0072B2";
inline constexpr const char* kVermillion = "#D55E00";
inline constexpr const char* kPurple = "#CC79A7";
inline constexpr const char* kBlack = "#000000";
inline constexpr const char* kDarkGrey = "#555555";
inline constexpr const char* kGrey = "#999999";
inline constexpr const char* kLightGrey = "#CCCCCC";
}  // namespace color

/// `text` as a gnuplot string that means just that text.
[[nodiscard]] std::string quoted(const std::string& text);

/// A gnuplot script that draws the figure twice in its folder, as NAME.svg and NAME.png.
[[nodiscard]] std::string gnuplotScript(const FigureScript& figure);

}  // namespace scatter::lab
