#include "levelmap/ReferencePlanes.h"

#include <algorithm>
#include <cmath>

#include "core/Optics.h"

namespace limpid {

std::vector<ReferencePlane> uniformPlanes(double height, int count) {
    std::vector<ReferencePlane> planes;
    for (int i = 0; i < count; ++i)
        planes.push_back({i, optics::planeDepth(height, count, i)});
    return planes;
}

std::vector<ReferencePlane> occupiedPlanes(double height, std::span<const std::uint32_t> histogram) {
    auto planes = uniformPlanes(height, int(histogram.size()));
    std::erase_if(planes,
                  [&](const ReferencePlane& plane) { return histogram[std::size_t(plane.index)] == 0; });
    return planes;
}

std::vector<SubBox> subBoxes(double height, std::span<const std::uint32_t> histogram, double threshold) {
    std::vector<SubBox> boxes;
    const double levels = double(histogram.size());
    int planes = 0;
    for (std::size_t first = 0; first < histogram.size();) {
        if (histogram[first] == 0) {
            ++first;
            continue;
        }
        std::size_t end = first;
        while (end < histogram.size() && histogram[end] != 0)
            ++end;
        const double heightRatio = double(end - first) / levels;
        // The slack keeps 0.1 / (2 · 0.05) at one plane.
        const int count = std::max(1, int(std::ceil(heightRatio / (2 * threshold) - 1e-9)));
        boxes.push_back({float(height * double(first) / levels), float(height * heightRatio), planes, count});
        planes += count;
        first = end;
    }
    return boxes;
}

std::vector<ReferencePlane> planesOf(std::span<const SubBox> boxes) {
    std::vector<ReferencePlane> planes;
    for (const SubBox& box : boxes)
        for (int i = 0; i < box.planeCount; ++i)
            planes.push_back(
                {box.firstPlane + i, box.top + optics::planeDepth(box.height, box.planeCount, i)});
    return planes;
}

} // namespace limpid
