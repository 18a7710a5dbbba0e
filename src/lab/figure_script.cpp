#include "lab/figure_script.h"

#include "lab/text.h"

#include <algorithm>

namespace scatter::lab {

namespace {

constexpr double kWidth = 1000.0;
constexpr double kLeft = 90.0;
constexpr double kRight = 276.0;
constexpr double kSecondAxis = 80.0;
constexpr double kTop = 78.0;
constexpr double kBetween = 72.0;
constexpr double kBottom = 62.0;

// Pictures of pixels are made larger, for screens with small ones.
constexpr double kPixelScale = 1.6;

double heightOf(const FigureScript& figure) {
  const auto panels = static_cast<double>(figure.panels.size());
  return kTop + panels * figure.panelHeight + (panels - 1.0) * kBetween + kBottom;
}

bool hasSecondAxis(const FigureScript& figure) {
  return std::any_of(figure.panels.begin(), figure.panels.end(),
                     [](const Panel& panel) { return !panel.y2Label.empty(); });
}

std::string terminals(const FigureScript& figure, bool vector) {
  const double scale = vector ? 1.0 : kPixelScale;
  const std::string size = fixedNumber(kWidth * scale, 0) + "," + fixedNumber(heightOf(figure) * scale, 0);
  if (vector) {
    // Only letters, digits and '_' are allowed in it.
    const std::string name = replaceAll(figure.name, "-", "_");
    return "set terminal svg size " + size + " noenhanced name " + quoted(name) +
           " background '#ffffff' font 'DejaVu Sans,Arial,sans-serif,14'\ntitleFont = ',18'\nset output " +
           quoted(figure.name + ".svg") + '\n';
  }
  const std::string times = fixedNumber(scale, 1);
  return "set terminal pngcairo size " + size +
         " noenhanced background '#ffffff' font 'DejaVu Sans,11' fontscale " + times + " linewidth " + times +
         " pointscale " + times + "\ntitleFont = ',14'\nset output " + quoted(figure.name + ".png") + '\n';
}

double rightOf(const FigureScript& figure) {
  return kWidth - kRight - (hasSecondAxis(figure) ? kSecondAxis : 0.0);
}

// At a fixed place, however wide the numbers beside the axis are.
std::string axisTitle(int tag, const std::string& text, double x, const std::string& color) {
  return "set label " + std::to_string(tag) + ' ' + quoted(text) + " at screen " +
         shortestNumber(x / kWidth) + ", graph 0.5 rotate by 90 center textcolor rgb " + quoted(color) + '\n';
}

std::string axisCommands(const FigureScript& figure, const Panel& panel, bool last) {
  std::string text =
      "set xrange [" + shortestNumber(figure.frames.first) + ":" + shortestNumber(figure.frames.last) + "]\n";
  text += "set yrange [" + shortestNumber(panel.yMin) + ":" + shortestNumber(panel.yMax) + "]\n";
  text += "set ytics nomirror textcolor rgb " + quoted(panel.yColor) + '\n';
  text += axisTitle(3, panel.yLabel, 20.0, panel.yColor);
  text += last ? "set xlabel " + quoted(figure.xLabel) + " offset 0,0.3\n" : std::string("unset xlabel\n");
  if (panel.y2Label.empty()) {
    return text + "unset y2tics\n";
  }
  text += "set y2range [0:" + shortestNumber(panel.y2Max) + "]\n";
  text += "set y2tics nomirror textcolor rgb " + quoted(panel.y2Color) + '\n';
  return text + axisTitle(4, panel.y2Label, rightOf(figure) + kSecondAxis - 8.0, panel.y2Color);
}

std::string panelCommands(const FigureScript& figure, std::size_t index) {
  const Panel& panel = figure.panels[index];
  const double height = heightOf(figure);
  const double top = kTop + static_cast<double>(index) * (figure.panelHeight + kBetween);
  const std::string topAt = shortestNumber(1.0 - top / height);
  std::string text = "set lmargin at screen " + shortestNumber(kLeft / kWidth) + "\nset rmargin at screen " +
                     shortestNumber(rightOf(figure) / kWidth) + "\nset tmargin at screen " + topAt +
                     "\nset bmargin at screen " + shortestNumber(1.0 - (top + figure.panelHeight) / height) +
                     '\n';
  text += "set key at screen " + shortestNumber((kWidth - kRight + 18.0) / kWidth) + ", screen " + topAt +
          " left top Left reverse vertical maxcols 1 maxrows 20 samplen 1.6 spacing 1.05\n";
  text += "unset label\n" + axisCommands(figure, panel, index + 1 == figure.panels.size());
  if (index == 0) {
    text += "set label 1 " + quoted(figure.title) + " at screen " + shortestNumber(kLeft / kWidth) +
            ", screen " + shortestNumber(1.0 - 24.0 / height) + " left font titleFont\n";
  }
  text += "set label 2 " + quoted(panel.title) + " at graph 0, graph 1 offset 0,0.8 left\n";
  for (const std::string& command : panel.extra) {
    text += command + '\n';
  }
  text += "plot ";
  for (std::size_t i = 0; i < panel.curves.size(); ++i) {
    const Curve& curve = panel.curves[i];
    text += (i == 0 ? "" : ", \\\n     ") + curve.plot + " with " + curve.style +
            (curve.title.empty() ? " notitle" : " title " + quoted(curve.title));
  }
  return text + '\n';
}

}  // namespace

std::string quoted(const std::string& text) {
  return '\'' + replaceAll(replaceAll(text, "\n", " "), "'", "''") + '\'';
}

std::string gnuplotScript(const FigureScript& figure) {
  std::string text;
  for (const bool vector : {true, false}) {
    text += "reset\nset encoding utf8\n" + terminals(figure, vector);
    text += std::string("set border ") + (hasSecondAxis(figure) ? "11" : "3") +
            " linecolor rgb '#555555'\nset tics out scale 0.6\nset xtics nomirror\n";
    text += "set grid ytics linetype 1 linecolor rgb '#e2e2e2' linewidth 0.8\nset grid noxtics\n";
    text += "set multiplot\n";
    for (std::size_t i = 0; i < figure.panels.size(); ++i) {
      text += panelCommands(figure, i);
    }
    text += "unset multiplot\nunset output\n";
  }
  return text;
}

}  // namespace scatter::lab
