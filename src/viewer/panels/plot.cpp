#include "viewer/panels/plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>
#include <utility>

#include "viewer/panels/plot_axis.h"

namespace scatter::viewer {
namespace {

constexpr ImU32 kBackground = IM_COL32(20, 24, 32, 200);
constexpr ImU32 kLimit = IM_COL32(255, 80, 80, 200);
constexpr ImU32 kMark = IM_COL32(130, 145, 165, 110);
constexpr ImU32 kMarkText = IM_COL32(150, 165, 185, 255);
constexpr ImU32 kPeak = IM_COL32(255, 255, 255, 230);
constexpr ImU32 kNow = IM_COL32(255, 255, 255, 150);

std::string withUnit(float value, const std::string& unit) {
  char text[48];
  if (unit.empty()) {
    std::snprintf(text, sizeof text, "%.0f", static_cast<double>(value));
  } else {
    std::snprintf(text, sizeof text, "%.2f %s", static_cast<double>(value), unit.c_str());
  }
  return text;
}

float valueAt(const PlotLine& line, std::size_t frame) {
  return frame < line.values.size() ? line.values[frame] : 0.0F;
}

PlotAxis axisOf(const PlotDef& plot) {
  std::vector<std::vector<float>> values;
  if (plot.stacked) {
    values.emplace_back(plot.time.values, 0.0F);
    for (const PlotLine& line : plot.lines) {
      for (std::size_t frame = 0; frame < line.values.size(); ++frame)
        values.front()[frame] += line.values[frame];
    }
  } else {
    for (const PlotLine& line : plot.lines) values.push_back(line.values);
  }
  return chooseAxis(values, plot.limit);
}

/// From values to pixels.
class Canvas {
 public:
  Canvas(const PlotDef& plot, const PlotAxis& axis, const ImVec2& corner, const ImVec2& size)
      : corner_(corner), size_(size), axis_(axis), frames_(plot.time.values) {}

  [[nodiscard]] ImVec2 at(std::size_t frame, float value) const {
    const float share = frames_ > 1 ? static_cast<float>(frame) / static_cast<float>(frames_ - 1) : 0.0F;
    return {corner_.x + share * size_.x, corner_.y + size_.y * (1.0F - axis_.shareOf(value))};
  }
  [[nodiscard]] std::size_t frameAt(float x) const {
    const float share = std::clamp((x - corner_.x) / size_.x, 0.0F, 1.0F);
    return frames_ > 0 ? static_cast<std::size_t>(std::lround(share * static_cast<float>(frames_ - 1))) : 0;
  }

  [[nodiscard]] const PlotAxis& axis() const { return axis_; }

 private:
  ImVec2 corner_;
  ImVec2 size_;
  PlotAxis axis_;
  std::size_t frames_;
};

/// A strip of two vertices a value: of quads, which share none, a window would have more than a list of them
/// can hold.
void drawLayer(const Canvas& canvas, std::span<const float> below, std::span<const float> above, ImU32 color,
               ImDrawList& draw) {
  if (below.size() < 2) return;
  const auto count = static_cast<int>(below.size());
  draw.PrimReserve(6 * (count - 1), 2 * count);
  const unsigned first = draw._VtxCurrentIdx;
  const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
  for (std::size_t i = 0; i < below.size(); ++i) {
    draw.PrimWriteVtx(canvas.at(i, below[i]), white, color);
    draw.PrimWriteVtx(canvas.at(i, above[i]), white, color);
  }
  for (int i = 0; i + 1 < count; ++i) {
    for (const int corner : {0, 1, 3, 0, 3, 2})
      draw.PrimWriteIdx(static_cast<ImDrawIdx>(first + static_cast<unsigned>(2 * i + corner)));
  }
}

void drawLayers(const PlotDef& plot, const Canvas& canvas, ImDrawList& draw) {
  std::vector<float> below(plot.time.values, 0.0F);
  for (const PlotLine& line : plot.lines) {
    std::vector<float> above = below;
    for (std::size_t frame = 0; frame < above.size(); ++frame) above[frame] += valueAt(line, frame);
    drawLayer(canvas, below, above, line.color, draw);
    below = std::move(above);
  }
}

void drawLines(const PlotDef& plot, const Canvas& canvas, float scale, ImDrawList& draw) {
  std::vector<ImVec2> points;
  for (const PlotLine& line : plot.lines) {
    points.clear();
    for (std::size_t frame = 0; frame < line.values.size(); ++frame)
      points.push_back(canvas.at(frame, line.values[frame]));
    draw.AddPolyline(points.data(), static_cast<int>(points.size()), line.color, ImDrawFlags_None,
                     1.5F * scale);
  }
}

/// As many of the axis' marks as there is room for, powers of ten first.
void drawMarks(const Canvas& canvas, ImDrawList& draw) {
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  const float line = ImGui::GetFontSize();
  std::vector<float> taken;
  for (const float mark : canvas.axis().marks()) {
    const float y = canvas.at(0, mark).y;
    const bool isFree =
        std::none_of(taken.begin(), taken.end(), [&](float other) { return std::abs(other - y) < line; });
    if (!isFree || y < low.y + 0.5F * line || y > high.y - 0.5F * line) continue;
    taken.push_back(y);
    char text[24];
    std::snprintf(text, sizeof text, "%g", static_cast<double>(mark));
    draw.AddText({low.x + 2.0F, y - 0.5F * line}, kMarkText, text);
    draw.AddLine({low.x + ImGui::CalcTextSize(text).x + 5.0F, y}, {high.x, y}, kMark);
  }
}

/// A small triangle and the number.
void markPeak(const PlotDef& plot, const Canvas& canvas, float scale, ImDrawList& draw) {
  const auto& values = plot.lines.front().values;
  const auto peak = std::max_element(values.begin(), values.end());
  if (peak == values.end() || !(*peak > 0.0F)) return;
  const ImVec2 at = canvas.at(static_cast<std::size_t>(peak - values.begin()), *peak);
  const ImVec2 half(4.0F * scale, 6.0F * scale);
  draw.AddTriangleFilled({at.x - half.x, at.y - half.y}, {at.x + half.x, at.y - half.y}, at, kPeak);
  const std::string text = withUnit(*peak, plot.unit);
  const float width = ImGui::CalcTextSize(text.c_str()).x;
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 high = ImGui::GetItemRectMax();
  const float gap = 2.0F * half.x;
  const float left = at.x + gap + width < high.x ? at.x + half.x + 2.0F : at.x - gap - width;
  draw.AddText({std::max(low.x, left), std::max(low.y + 1.0F, at.y - 1.4F * half.y)}, kPeak, text.c_str());
}

std::string nowText(const PlotLine& line, const PlotDef& plot) {
  return plot.time.now < line.values.size() ? withUnit(line.values[plot.time.now], plot.unit) : "-";
}

/// Which frames a value is of.
std::string whenText(const PlotTime& time, std::size_t value) {
  const std::uint64_t first = time.firstFrame + value * time.framesEach;
  if (time.framesEach == 1) return "frame " + std::to_string(first);
  return "the most of frames " + std::to_string(first) + " to " + std::to_string(first + time.framesEach - 1);
}

void drawLegend(const PlotDef& plot, bool logarithmic) {
  ImGui::Text("%s%s", plot.title.c_str(), logarithmic ? ", log scale" : "");
  for (const PlotLine& line : plot.lines) {
    ImGui::SameLine();
    const std::string text = line.name + (line.name.empty() ? "" : " ") + nowText(line, plot);
    if (ImGui::GetContentRegionAvail().x < ImGui::CalcTextSize(text.c_str()).x) ImGui::NewLine();
    ImGui::PushStyleColor(ImGuiCol_Text, line.color);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
  }
}

void showTip(const PlotDef& plot, const Canvas& canvas) {
  const std::size_t frame = canvas.frameAt(ImGui::GetIO().MousePos.x);
  ImGui::BeginTooltip();
  ImGui::TextUnformatted(whenText(plot.time, frame).c_str());
  for (const PlotLine& line : plot.lines) {
    const std::string value = withUnit(valueAt(line, frame), plot.unit);
    ImGui::TextUnformatted((line.name + (line.name.empty() ? "" : ": ") + value).c_str());
  }
  ImGui::EndTooltip();
}

}  // namespace

std::optional<std::size_t> drawPlot(const PlotDef& plot, float scale) {
  if (plot.time.values == 0) return std::nullopt;
  const PlotAxis axis = axisOf(plot);
  drawLegend(plot, axis.logarithmic);
  const ImVec2 size(std::max(40.0F, ImGui::GetContentRegionAvail().x), scale * plot.height);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton(plot.title.c_str(), size);
  const bool pointed = ImGui::IsItemHovered();
  const bool held = ImGui::IsItemActive();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const Canvas canvas(plot, axis, corner, size);
  draw.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, kBackground, 3.0F);
  draw.PushClipRect(corner, {corner.x + size.x, corner.y + size.y}, true);
  drawMarks(canvas, draw);
  plot.stacked ? drawLayers(plot, canvas, draw) : drawLines(plot, canvas, scale, draw);
  if (plot.limit > 0.0F) {
    const float y = canvas.at(0, plot.limit).y;
    draw.AddLine({corner.x, y}, {corner.x + size.x, y}, kLimit, scale);
  }
  if (!plot.stacked) markPeak(plot, canvas, scale, draw);
  const float x = canvas.at(plot.time.now, 0.0F).x;
  draw.AddLine({x, corner.y}, {x, corner.y + size.y}, kNow, scale);
  draw.PopClipRect();
  if (pointed) showTip(plot, canvas);
  return held ? std::optional(canvas.frameAt(ImGui::GetIO().MousePos.x)) : std::nullopt;
}

}  // namespace scatter::viewer
