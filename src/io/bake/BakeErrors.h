#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/ImageErrors.h"
#include "io/bake/BakedFolder.h"

namespace limpid::io {

/// The two baked maps of one receiver and light, ready to be compared: texels that both see, areas from the
/// truth's normals. Luv takes irradiance as a camera would that exposes for the receiver: the truth's mean is
/// shown as a grey of 18 %.
struct MapPair {
    const BakedMap* a = nullptr;
    const BakedMap* b = nullptr; ///< the truth
    std::vector<float> mask;     ///< 1 where both see the receiver
    std::vector<float> area;     ///< m² of the receiver's surface in a texel
    std::size_t unmatched = 0;   ///< texels that just one of the two sees
    double white = 1;            ///< W/m²

    ImagePair images() const { return {a->irradiance, b->irradiance, mask, area, 0, white}; }
};

/// Texels that the maps of one model may lie apart: a file quantized to 11 bits moves them by 0.03.
inline constexpr double mostApart = 0.05;

/// Pairs the maps by receiver, light and facing, in the order of `b`. `nameA`, `nameB` name the two in
/// errors. Throws InputError where one of them lacks a map of the other's, or sizes or texel frames differ by
/// more than `mostApart`. The pairs point into `a` and `b`.
std::vector<MapPair> pairMaps(const Bake& a, const Bake& b, const std::string& nameA,
                              const std::string& nameB);

/// The figures over the texels of all maps together. Throws as pairMaps does.
ImageErrors bakeErrors(const Bake& a, const Bake& b, const std::string& nameA, const std::string& nameB);

/// The nMAE over the texels of all maps together that chance alone may make, where `truth` knows it of each
/// map.
std::optional<double> standardError(const Bake& truth);

/// "floor in sun", with its facing if it has one.
std::string mapTitle(const BakedMap& map);

} // namespace limpid::io
