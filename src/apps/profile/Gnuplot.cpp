#include "apps/profile/Gnuplot.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <stdexcept>

#include <fmt/format.h>
#include <sys/wait.h>

#include "apps/Common.h"
#include "io/Files.h"

namespace limpid::apps {

namespace {

constexpr int panelWidth = 480, panelHeight = 340, titleHeight = 40; // pixels

std::string quoted(const std::string& text) {
    std::string doubled;
    for (const char c : text)
        doubled.append(c == '\'' ? 2 : 1, c);
    return fmt::format("'{}'", doubled);
}

glm::ivec2 layoutOf(std::size_t panels) {
    const int columns = panels <= 3 ? std::max(int(panels), 1) : int(std::ceil(std::sqrt(double(panels))));
    return {columns, (int(panels) + columns - 1) / columns};
}

/// The points of every curve as gnuplot's data blocks, the panels' commands after them.
void addPanel(std::string& script, const Panel& panel, std::size_t number, bool legend) {
    std::string curves;
    for (std::size_t i = 0; i < panel.curves.size(); ++i) {
        const Curve& curve = panel.curves[i];
        if (curve.points.empty()) continue;
        const std::string block = fmt::format("$panel{}curve{}", number, i);
        script += block + " << end\n";
        for (const auto& [x, y] : curve.points)
            script += fmt::format("{:.8g} {:.8g}\n", x, y);
        script += "end\n";
        curves += fmt::format("{}{} using 1:2 with {} {}", curves.empty() ? "" : ", ", block, curve.style,
                              legend && !curve.title.empty() ? "title " + quoted(curve.title) : "notitle");
    }
    script += fmt::format("set title {} noenhanced\n", quoted(panel.title));
    if (!curves.empty())
        script += "plot " + curves + "\n";
    else
        script += "set multiplot next\n";
}

std::string scriptOf(const Plot& plot, const char* terminal, const std::filesystem::path& output) {
    const glm::ivec2 layout = layoutOf(plot.panels.size());
    std::string script =
        fmt::format("set terminal {} size {},{} font 'DejaVu Sans,9' noenhanced background 'white'\n"
                    "set output {}\nset encoding utf8\nset xlabel {}\nset ylabel {}\nset grid lt 1 lw 0.5 lc "
                    "rgb '#cccccc'\n"
                    "set key top left reverse Left samplen 2\nset tics nomirror\nset border 3\n",
                    terminal, layout.x * panelWidth, layout.y * panelHeight + titleHeight,
                    quoted(output.string()), quoted(plot.xLabel), quoted(plot.yLabel));
    for (const std::string& command : plot.commands)
        script += command + "\n";
    script += fmt::format("set multiplot layout {},{} title {} noenhanced\n", layout.y, layout.x,
                          quoted(plot.title));
    // A legend in each of few panels, in the first of many.
    for (std::size_t i = 0; i < plot.panels.size(); ++i)
        addPanel(script, plot.panels[i], i, plot.panels.size() <= 3 || i == 0);
    return script + "unset multiplot\nset output\n";
}

void runGnuplot(const std::string& script) {
    std::signal(SIGPIPE, SIG_IGN); // what gnuplot does not read shows in its status
    FILE* pipe = popen("gnuplot", "w");
    if (!pipe) throw std::runtime_error("cannot start gnuplot");
    std::fwrite(script.data(), 1, script.size(), pipe);
    const int status = pclose(pipe);
    if (status != 0)
        throw std::runtime_error(
            fmt::format("gnuplot ended with status {}", WIFEXITED(status) ? WEXITSTATUS(status) : -1));
}

} // namespace

bool hasGnuplot() {
    return onPath("gnuplot");
}

void drawPlot(const std::filesystem::path& folder, const Plot& plot) {
    for (const auto& [suffix, terminal] : {std::pair("png", "pngcairo"), std::pair("svg", "svg")})
        io::writeWhole(folder / fmt::format("{}.{}", plot.name, suffix),
                       [&, terminal = terminal](const std::filesystem::path& partial) {
                           runGnuplot(scriptOf(plot, terminal, partial));
                       });
}

} // namespace limpid::apps
