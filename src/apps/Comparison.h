#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/ImageErrors.h"

namespace limpid::apps {

/// One of the things that are compared: a picture, or the map of a receiver and a light.
struct ComparedItem {
    std::string title;           ///< "floor in sun", or "picture"
    std::string receiver, light; ///< empty for a picture
    int facing = 0;
    glm::ivec2 size{0};
    ImagePair images; ///< the numbers that the figures are of
    ImageErrors errors;
    std::size_t unmatched = 0;           ///< pixels that are on the object in just one of the two
    std::optional<double> standardError; ///< nMAE that chance alone may make
};

struct Comparison {
    bool bakes = false;
    bool stored = false; ///< both are 8- or 16-bit pictures: figures but Luv and flux are of sRGB as stored
    std::vector<std::string> warnings;
    std::vector<ComparedItem> items;
    std::shared_ptr<const void> data; ///< what the items' images look into
};

/// Two baked folders or two pictures, `b` the truth. Pictures are compared where `mask` (a picture, may be
/// empty) is above 0 and where both of them are opaque to any degree. Throws InputError if they cannot be.
Comparison compare(const std::filesystem::path& a, const std::filesystem::path& b,
                   const std::filesystem::path& mask);

} // namespace limpid::apps
