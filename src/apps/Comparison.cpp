#include "apps/Comparison.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/Error.h"
#include "io/Files.h"
#include "io/bake/BakeErrors.h"
#include "io/bake/BakedFolder.h"
#include "io/images/Images.h"

namespace fs = std::filesystem;

namespace limpid::apps {

namespace {

/// A picture as RGB. Grey is taken for three equal channels; alpha is what the object covers.
struct RgbPicture {
    glm::ivec2 size{0};
    bool floatingPoint = false;
    std::vector<float> stored, linear; ///< RGB
    std::vector<float> alpha;          ///< empty without
};

/// Where R, G, B and A are among the channels; alpha −1 without.
struct Layout {
    int rgb[3] = {0, 0, 0};
    int alpha = -1;
};

int find(const io::FloatImage& image, std::string_view name) {
    const auto at = std::find(image.channelNames.begin(), image.channelNames.end(), name);
    return at == image.channelNames.end() ? -1 : int(at - image.channelNames.begin());
}

Layout layoutOf(const io::FloatImage& image, const std::string& name) {
    Layout layout;
    const int r = find(image, "R"), g = find(image, "G"), b = find(image, "B");
    if (r >= 0 && g >= 0 && b >= 0)
        layout = {{r, g, b}, -1};
    else if (image.channels == 3)
        layout = {{0, 1, 2}, -1};
    else if (image.channels > 2)
        throw InputError(fmt::format("{}: expected channels R, G and B, found {}", name,
                                     io::oneLine(fmt::to_string(fmt::join(image.channelNames, ", ")))));
    layout.alpha = find(image, "A");
    return layout;
}

RgbPicture readPicture(const fs::path& file) {
    const io::FloatImage image = io::readImage(file);
    const Layout layout = layoutOf(image, io::oneLine(file.string()));
    RgbPicture picture{{image.width, image.height}, image.floatingPoint, {}, {}, {}};
    const std::size_t pixels = std::size_t(image.width) * std::size_t(image.height);
    picture.stored.resize(3 * pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
        const float* pixel = &image.data[i * std::size_t(image.channels)];
        for (std::size_t c = 0; c < 3; ++c)
            picture.stored[3 * i + c] = pixel[layout.rgb[c]];
        if (layout.alpha >= 0) picture.alpha.push_back(pixel[layout.alpha]);
    }
    picture.linear = picture.stored;
    if (!image.floatingPoint)
        std::transform(picture.stored.begin(), picture.stored.end(), picture.linear.begin(), linearFromSrgb);
    return picture;
}

void requireSize(const std::string& name, glm::ivec2 size, const std::string& other, glm::ivec2 expected) {
    if (size != expected)
        throw InputError(fmt::format("{}: expected {} x {} pixels as in {}, found {} x {}", name, expected.x,
                                     expected.y, other, size.x, size.y));
}

struct PicturePair {
    RgbPicture a, b;
    std::vector<float> mask; ///< empty: everywhere
};

/// Alphas, and the mask's first channel if there is a mask, brought to one.
std::size_t fillMask(PicturePair& pair, const fs::path& file, const std::string& nameA) {
    const std::size_t pixels = pair.a.stored.size() / 3;
    std::size_t unmatched = 0;
    const auto keep = [&](auto&& covered) {
        if (pair.mask.empty()) pair.mask.assign(pixels, 1);
        for (std::size_t i = 0; i < pixels; ++i)
            if (!covered(i)) pair.mask[i] = 0;
    };
    if (!file.empty()) {
        const io::Channel mask = io::readFirstChannel(file, 1, 1 << 16);
        requireSize(file.string(), {mask.width, mask.height}, nameA, pair.a.size);
        keep([&](std::size_t i) { return mask.data[i] > 0; });
    }
    const auto covers = [](const RgbPicture& picture, std::size_t i) {
        return picture.alpha.empty() || picture.alpha[i] > 0;
    };
    for (std::size_t i = 0; i < pixels; ++i)
        if ((pair.mask.empty() || pair.mask[i] > 0) && covers(pair.a, i) != covers(pair.b, i)) ++unmatched;
    if (!pair.a.alpha.empty() || !pair.b.alpha.empty())
        keep([&](std::size_t i) { return covers(pair.a, i) && covers(pair.b, i); });
    return unmatched;
}

Comparison comparePictures(const fs::path& a, const fs::path& b, const fs::path& mask) {
    const auto data = std::make_shared<PicturePair>();
    data->a = readPicture(a);
    data->b = readPicture(b);
    requireSize(io::oneLine(a.string()), data->a.size, io::oneLine(b.string()), data->b.size);
    Comparison comparison;
    comparison.data = data;
    comparison.stored = !data->a.floatingPoint && !data->b.floatingPoint;
    ComparedItem& item = comparison.items.emplace_back();
    item.title = "picture";
    item.size = data->b.size;
    item.unmatched = fillMask(*data, mask, io::oneLine(a.string()));
    const ImagePair linear{.a = data->a.linear, .b = data->b.linear, .mask = data->mask};
    item.images = linear;
    item.errors = imageErrors(linear);
    if (comparison.stored) {
        item.images.a = data->a.stored;
        item.images.b = data->b.stored;
        item.images.peak = 1;
        const ImageErrors ofLight = item.errors;
        item.errors = imageErrors(item.images);
        item.errors.luv = ofLight.luv;
        item.errors.fluxRatio = ofLight.fluxRatio;
    }
    return comparison;
}

struct BakePair {
    io::Bake a, b;
    std::vector<io::MapPair> maps;
};

Comparison compareBakes(const fs::path& a, const fs::path& b) {
    const auto data = std::make_shared<BakePair>();
    data->a = io::readBake(a);
    data->b = io::readBake(b);
    data->maps = io::pairMaps(data->a, data->b, io::oneLine(a.string()), io::oneLine(b.string()));
    Comparison comparison;
    comparison.bakes = true;
    comparison.data = data;
    if (data->a.time != data->b.time)
        comparison.warnings.push_back(fmt::format("{} is of {} s, {} of {} s", io::oneLine(a.string()),
                                                  data->a.time, io::oneLine(b.string()), data->b.time));
    for (const io::MapPair& pair : data->maps)
        comparison.items.push_back({io::mapTitle(*pair.b), pair.b->receiver, pair.b->light, pair.b->facing,
                                    pair.b->size, pair.images(), imageErrors(pair.images()), pair.unmatched,
                                    pair.b->standardError ? pair.b->standardError : pair.a->standardError});
    return comparison;
}

} // namespace

Comparison compare(const fs::path& a, const fs::path& b, const fs::path& mask) {
    const bool folderA = fs::is_directory(a), folderB = fs::is_directory(b);
    if (folderA != folderB)
        throw InputError(fmt::format("{}: expected a {} like {}, found {}", io::oneLine(b.string()),
                                     folderA ? "folder" : "picture", io::oneLine(a.string()),
                                     folderB         ? "a folder"
                                     : fs::exists(b) ? "a file"
                                                     : "nothing of that name"));
    if (folderA && !mask.empty())
        throw InputError("--mask: expected pictures to compare, found folders, which bring their own");
    Comparison comparison = folderA ? compareBakes(a, b) : comparePictures(a, b, mask);
    const auto something = [](const ComparedItem& item) { return item.errors.pixels > 0; };
    if (std::none_of(comparison.items.begin(), comparison.items.end(), something))
        throw InputError(fmt::format("{}: expected something in common with {}, found no pixel to compare",
                                     io::oneLine(a.string()), io::oneLine(b.string())));
    return comparison;
}

} // namespace limpid::apps
