#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

/// Plots, drawn by gnuplot as a program of its own.
namespace limpid::apps {

struct Curve {
    std::string title; ///< in the legend; empty for none
    std::string style; ///< gnuplot's, after `with`
    std::vector<std::pair<double, double>> points;
};

struct Panel {
    std::string title;
    std::vector<Curve> curves;
};

/// Panels of one kind side by side.
struct Plot {
    std::string name;  ///< of the file, without suffix
    std::string title; ///< of the whole
    std::string xLabel, yLabel;
    std::vector<std::string> commands; ///< gnuplot's, before the panels: scales, ranges
    std::vector<Panel> panels;
};

/// Whether there is a gnuplot on the path.
bool hasGnuplot();

/// Writes NAME.png and NAME.svg into `folder`. Throws InputError if gnuplot fails.
void drawPlot(const std::filesystem::path& folder, const Plot& plot);

} // namespace limpid::apps
