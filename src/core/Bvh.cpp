#include "core/Bvh.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace limpid {

namespace {

constexpr std::size_t mostInLeaf = 4;
constexpr int binCount = 12;
/// Of the heuristic: what visiting a node costs beside a test of one item.
constexpr float nodeCost = 1;

struct Bin {
    Box3f box;
    std::size_t count = 0;
};

/// Where to cut: bins below `bin` of `axis` go left; axis < 0: nowhere.
struct Cut {
    int axis = -1;
    int bin = 0;
    float cost = 1e30f;
};

class Builder {
  public:
    Builder(std::span<const Box3f> boxes, Bvh& bvh) : _boxes(boxes), _bvh(bvh) {
        _bvh.order.resize(boxes.size());
        std::iota(_bvh.order.begin(), _bvh.order.end(), 0u);
        if (!boxes.empty()) build(0, boxes.size());
    }

  private:
    glm::vec3 middle(std::uint32_t item) const { return 0.5f * (_boxes[item].low + _boxes[item].high); }

    void build(std::size_t first, std::size_t end) {
        Box3f box, middles;
        for (std::size_t i = first; i < end; ++i) {
            box.add(_boxes[_bvh.order[i]]);
            middles.add(middle(_bvh.order[i]));
        }
        const std::size_t node = _bvh.nodes.size();
        _bvh.nodes.push_back({box.low, 0, box.high, 0});
        const std::size_t split = splitOf(first, end, box, middles);
        if (split == end) {
            _bvh.nodes[node].items = std::int32_t(8 * first + (end - first));
        } else {
            build(first, split);
            build(split, end);
        }
        _bvh.nodes[node].next = std::int32_t(_bvh.nodes.size());
    }

    /// Where the second half begins; `end` for a leaf.
    std::size_t splitOf(std::size_t first, std::size_t end, const Box3f& box, const Box3f& middles) {
        const std::size_t count = end - first;
        if (count == 1) return end;
        const Cut cut = bestCut(first, end, box, middles);
        if (count <= mostInLeaf && cut.cost >= float(count)) return end;
        const auto order = _bvh.order.begin();
        const auto begin = order + std::ptrdiff_t(first), stop = order + std::ptrdiff_t(end);
        if (cut.axis >= 0) {
            const auto at = std::partition(
                begin, stop, [&](std::uint32_t i) { return binOf(i, cut.axis, middles) < cut.bin; });
            if (at != begin && at != stop) return std::size_t(at - order);
        }
        // All in one place: any halves will do.
        return first + count / 2;
    }

    int binOf(std::uint32_t item, int axis, const Box3f& middles) const {
        const float size = middles.high[axis] - middles.low[axis];
        return std::clamp(int(float(binCount) * (middle(item)[axis] - middles.low[axis]) / size), 0,
                          binCount - 1);
    }

    Cut bestCut(std::size_t first, std::size_t end, const Box3f& box, const Box3f& middles) const {
        Cut best;
        const float whole = std::max(box.halfArea(), 1e-30f);
        for (int axis = 0; axis < 3; ++axis) {
            if (!(middles.high[axis] > middles.low[axis])) continue;
            std::array<Bin, binCount> bins;
            for (std::size_t i = first; i < end; ++i) {
                Bin& bin = bins[std::size_t(binOf(_bvh.order[i], axis, middles))];
                bin.box.add(_boxes[_bvh.order[i]]);
                ++bin.count;
            }
            improve(best, bins, axis, whole);
        }
        return best;
    }

    static void improve(Cut& best, const std::array<Bin, binCount>& bins, int axis, float whole) {
        std::array<float, binCount> right{};
        Bin from;
        for (std::size_t i = binCount - 1; i > 0; --i) {
            from.box.add(bins[i].box);
            from.count += bins[i].count;
            right[i] = from.count ? float(from.count) * from.box.halfArea() : 0;
        }
        from = {};
        for (std::size_t i = 1; i < binCount; ++i) {
            from.box.add(bins[i - 1].box);
            from.count += bins[i - 1].count;
            const float left = from.count ? float(from.count) * from.box.halfArea() : 0;
            const float cost = nodeCost + (left + right[i]) / whole;
            if (cost < best.cost) best = {axis, int(i), cost};
        }
    }

    std::span<const Box3f> _boxes;
    Bvh& _bvh;
};

} // namespace

float Box3f::halfArea() const {
    const glm::vec3 size = glm::max(high - low, glm::vec3(0));
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

Bvh buildBvh(std::span<const Box3f> boxes) {
    Bvh bvh;
    Builder(boxes, bvh);
    return bvh;
}

} // namespace limpid
