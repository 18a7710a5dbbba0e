#include "lab/figure_drawing.h"

#include <scatter/io/file.h>

#include "lab/gnuplot.h"

#include <system_error>

namespace scatter::lab {

Result<void> drawFigure(const FigureScript& figure, const std::filesystem::path& folder) {
  const std::filesystem::path script = folder / (figure.name + ".gnuplot");
  if (auto written = writeFile(script, gnuplotScript(figure)); !written) {
    return written;
  }
  // -d: whatever the user's own gnuplot settings are.
  if (auto drawn = runGnuplot({"-d", script.filename().string()}, folder); !drawn) {
    return drawn;
  }
  std::error_code error;
  for (const char* ending : {".svg", ".png"}) {
    const auto bytes = std::filesystem::file_size(folder / (figure.name + ending), error);
    if (error || bytes == 0) {
      return fail("gnuplot drew nothing into " + figure.name + ending +
                  "; see that the disk is not full and that gnuplot has its svg and pngcairo terminals");
    }
  }
  std::filesystem::remove(script, error);
  return {};
}

}  // namespace scatter::lab
