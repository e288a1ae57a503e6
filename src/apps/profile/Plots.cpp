#include "apps/profile/Plots.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "apps/profile/Gnuplot.h"

namespace limpid::apps {

namespace {

using Results = std::vector<const ProfileResult*>;

/// Okabe and Ito's colours, which colour-blind readers tell apart.
constexpr const char* colors[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                  "#e69f00", "#56b4e9", "#000000"};

const char* colorOf(std::string_view method) {
    std::size_t index = 0;
    for (const Method known : allMethods())
        if (methodName(known) != method)
            ++index;
        else
            break;
    return colors[index % std::size(colors)];
}

/// What is measured of one scene and receiver.
struct Group {
    std::string scene, receiver, title;
    Results results;
};

std::vector<Group> groupsOf(const io::Profile& profile, const ProfileOutcome& outcome) {
    std::vector<Group> groups;
    std::set<std::string> scenes;
    for (const ProfileResult& result : outcome.results) {
        if (result.profile != profile.name) continue;
        scenes.insert(result.scene);
        auto own = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
            return group.scene == result.scene && group.receiver == result.receiver;
        });
        if (own == groups.end()) own = groups.insert(own, {result.scene, result.receiver, "", {}});
        own->results.push_back(&result);
    }
    for (Group& group : groups)
        group.title =
            scenes.size() > 1 ? fmt::format("{} in {}", group.receiver, group.scene) : group.receiver;
    return groups;
}

/// A name for each run of planes: the method, and what else there is more than one of.
class Naming {
  public:
    explicit Naming(const std::vector<Group>& groups) {
        std::set<std::string> fills;
        std::set<int> maps;
        std::set<std::pair<int, int>> grids;
        for (const Group& group : groups)
            for (const ProfileResult* result : group.results) {
                fills.insert(result->fill);
                maps.insert(result->mapSize);
                grids.insert({result->grid.x, result->grid.y});
            }
        _fills = fills.size() > 1;
        _maps = maps.size() > 1;
        _grids = grids.size() > 1;
    }
    std::string operator()(const ProfileResult& result) const {
        std::string name = result.method;
        if (_fills) name += ", " + result.fill;
        if (_maps) name += fmt::format(", map {}", result.mapSize);
        if (_grids) name += fmt::format(", grid {} x {}", result.grid.x, result.grid.y);
        return name;
    }

  private:
    bool _fills, _maps, _grids;
};

template <typename Value>
std::vector<Curve> curvesAgainstPlanes(const Group& group, const Naming& naming, Value&& value) {
    std::vector<Curve> curves;
    for (const ProfileResult* result : group.results) {
        const std::string name = naming(*result);
        auto own = std::find_if(curves.begin(), curves.end(),
                                [&](const Curve& curve) { return curve.title == name; });
        if (own == curves.end())
            own = curves.insert(
                own,
                {name, fmt::format("linespoints lc rgb '{}' lw 2 pt 7 ps 0.4", colorOf(result->method)), {}});
        own->points.emplace_back(result->planes, value(*result));
    }
    for (Curve& curve : curves)
        std::sort(curve.points.begin(), curve.points.end());
    return curves;
}

/// The thesis's columns of the group's receiver, as far as the planes are ours too; thin and dashed in the
/// method's colour.
void addPrinted(std::vector<Curve>& curves, const Group& group, const std::optional<io::PrintedTable>& table,
                double scale) {
    if (!table) return;
    int least = group.results.front()->planes, most = least;
    for (const ProfileResult* result : group.results)
        least = std::min(least, result->planes), most = std::max(most, result->planes);
    for (const io::PrintedTable::Column& column : table->columns) {
        if (column.receiver != group.receiver) continue;
        Curve& curve = curves.emplace_back();
        curve.title = fmt::format("thesis of 2006, {}", column.method);
        curve.style = fmt::format("lines dt (6,4) lw 1.5 lc rgb '{}'", colorOf(column.method));
        for (std::size_t i = 0; i < table->planes.size(); ++i)
            if (table->planes[i] >= least && table->planes[i] <= most)
                curve.points.emplace_back(table->planes[i], scale * column.values[i]);
    }
}

double peakMiB(const ProfileResult& result) {
    for (const auto& [kind, bytes] : result.bytes)
        if (kind == "peak") return double(bytes) / (1 << 20);
    return 0;
}

/// Planes drawn of the maps along the light; what side maps take is no matter of slicing.
double planesAlongLight(const ProfileResult& result) {
    double planes = 0;
    for (const MeasuredMap& map : result.maps)
        if (map.facing == 0) planes += map.planesDrawn;
    return planes;
}

bool planesVary(const std::vector<Group>& groups) {
    return std::any_of(groups.begin(), groups.end(), [](const Group& group) {
        return std::any_of(group.results.begin(), group.results.end(), [&](const ProfileResult* result) {
            return result->planes != group.results.front()->planes;
        });
    });
}

Plot timePlot(const io::Profile& profile, const std::vector<Group>& groups, const Naming& naming) {
    Plot plot{"time-planes",        "Time of the caustics against reference planes",
              "reference planes",   "caustics, median, ms",
              {"set yrange [0:*]"}, {}};
    for (const Group& group : groups) {
        Panel& panel = plot.panels.emplace_back(Panel{
            group.title,
            curvesAgainstPlanes(group, naming, [](const ProfileResult& r) { return r.caustics.median; })});
        addPrinted(panel.curves, group, profile.seconds, 1000);
    }
    return plot;
}

Plot memoryPlot(const std::vector<Group>& groups, const Naming& naming) {
    Plot plot{"memory-planes",      "GPU memory against reference planes",
              "reference planes",   "at most, MiB",
              {"set yrange [0:*]"}, {}};
    for (const Group& group : groups)
        plot.panels.push_back({group.title, curvesAgainstPlanes(group, naming, peakMiB)});
    return plot;
}

Plot planesPlot(const io::Profile& profile, const std::vector<Group>& groups, const Naming& naming) {
    Plot plot{"planes-drawn",       "Planes drawn against planes asked for",
              "reference planes",   "planes drawn",
              {"set yrange [0:*]"}, {}};
    for (const Group& group : groups) {
        Panel& panel = plot.panels.emplace_back(
            Panel{group.title, curvesAgainstPlanes(group, naming, planesAlongLight)});
        addPrinted(panel.curves, group, profile.actualPlanes, 1);
    }
    return plot;
}

/// The points that no other one of the method beats in both time and error, in the order of time.
std::vector<std::pair<double, double>> frontOf(std::vector<std::pair<double, double>> points) {
    std::sort(points.begin(), points.end());
    std::vector<std::pair<double, double>> front;
    for (const auto& point : points)
        if (front.empty() || point.second < front.back().second) front.push_back(point);
    return front;
}

Plot errorPlot(const std::vector<Group>& groups) {
    Plot plot{"error-time",
              "Error against time",
              "caustics, median, ms",
              "nMAE against the reference",
              {"set logscale xy", "set format y '%g'", "set key bottom left"},
              {}};
    for (const Group& group : groups) {
        Panel& panel = plot.panels.emplace_back(Panel{group.title, {}});
        std::vector<Curve> all;
        double slowest = 0, fastest = 1e300;
        std::optional<double> chance;
        for (const ProfileResult* result : group.results) {
            if (!result->error || !(result->error->nmae > 0)) continue; // no place on a logarithmic scale
            slowest = std::max(slowest, result->caustics.median);
            fastest = std::min(fastest, result->caustics.median);
            if (result->standardError) chance = std::max(chance.value_or(0), *result->standardError);
            auto own = std::find_if(all.begin(), all.end(),
                                    [&](const Curve& curve) { return curve.title == result->method; });
            if (own == all.end()) own = all.insert(own, {result->method, "", {}});
            own->points.emplace_back(result->caustics.median, result->error->nmae);
        }
        if (chance && *chance > 0)
            panel.curves.push_back({"what chance makes in the reference",
                                    "lines dt (2,3) lw 1.5 lc rgb '#888888'",
                                    {{fastest, *chance}, {slowest, *chance}}});
        for (Curve& curve : all) {
            const char* color = colorOf(curve.title);
            panel.curves.push_back({curve.title,
                                    fmt::format("linespoints lc rgb '{}' lw 2 pt 7 ps 0.7", color),
                                    frontOf(curve.points)});
            panel.curves.push_back({"", fmt::format("points lc rgb '{}' pt 6 ps 0.5", color), curve.points});
        }
    }
    return plot;
}

Plot histogramPlot(const std::vector<Group>& groups, const ProfileOutcome& outcome,
                   const std::string& profile) {
    Plot plot{"depth-histogram",
              "Lit texels by reference plane, from the top of the box down",
              "plane",
              "texels",
              {"set yrange [0:*]", "set key top right noreverse Right", "set boxwidth 0.8",
               "set offsets 1, 1, 0, 0"},
              {}};
    for (const Group& group : groups)
        for (const DepthHistogram& histogram : outcome.histograms) {
            if (histogram.profile != profile || histogram.scene != group.scene ||
                histogram.receiver != group.receiver)
                continue;
            Curve kept{"kept", "boxes fs solid 0.7 noborder lc rgb '#0072b2'", {}},
                dropped{"dropped", "points pt 2 ps 0.5 lc rgb '#d55e00'", {}};
            for (std::size_t i = 0; i < histogram.texels.size(); ++i)
                (histogram.texels[i] > 0 ? kept : dropped)
                    .points.emplace_back(double(i), histogram.texels[i]);
            plot.panels.push_back({fmt::format("{}: {} of {} planes kept", group.title, kept.points.size(),
                                               histogram.texels.size()),
                                   {kept, dropped}});
        }
    return plot;
}

bool hasCurve(const Plot& plot) {
    return std::any_of(plot.panels.begin(), plot.panels.end(), [](const Panel& panel) {
        return std::any_of(panel.curves.begin(), panel.curves.end(),
                           [](const Curve& curve) { return !curve.points.empty(); });
    });
}

} // namespace

void plotResults(const std::filesystem::path& folder, const io::Profile& profile,
                 const ProfileOutcome& outcome, const Machine& machine) {
    if (!hasGnuplot()) {
        fmt::print(stderr, "limpid: warning: expected gnuplot to draw plots with, found none on the path; "
                           "the figures are in results.json and results.csv\n");
        return;
    }
    const std::vector<Group> groups = groupsOf(profile, outcome);
    const Naming naming(groups);
    std::vector<Plot> plots{errorPlot(groups), histogramPlot(groups, outcome, profile.name)};
    if (planesVary(groups)) {
        plots.push_back(timePlot(profile, groups, naming));
        plots.push_back(memoryPlot(groups, naming));
        plots.push_back(planesPlot(profile, groups, naming));
    }
    for (Plot& plot : plots) {
        if (!hasCurve(plot)) continue;
        plot.name = fmt::format("{}.{}", profile.name, plot.name);
        plot.title += fmt::format(" ({}, {} cores)", machine.gpu, machine.cores);
        drawPlot(folder, plot);
    }
}

} // namespace limpid::apps
