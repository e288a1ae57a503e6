#include "io/images/HeightImages.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/Error.h"
#include "io/Files.h"
#include "io/images/Images.h"

namespace fs = std::filesystem;

namespace limpid::io {

namespace {

/// Beyond, squares and products overflow in single precision; the scene file's numbers end there too.
constexpr float highestValue = 1e12f;

/// A file name with the number of a frame in it.
struct Pattern {
    fs::path folder;
    std::string before, after;
    int digits = 1; ///< at least; zeros in front make up for the rest

    fs::path file(int number) const {
        return folder / fmt::format("{}{:0{}}{}", before, number, digits, after);
    }

    /// The number in a file's name; none if the name is not of the pattern.
    std::optional<int> numberOf(const std::string& name) const {
        int number = -1;
        if (name.size() <= before.size() + after.size() || !name.starts_with(before)) return {};
        std::from_chars(name.data() + before.size(), name.data() + name.size(), number);
        if (number < 0 || file(number).filename() != name) return {};
        return number;
    }
};

/// None for a file name without a %.
std::optional<Pattern> parsePattern(const fs::path& file) {
    const std::string name = file.filename().string();
    const std::size_t percent = name.find('%');
    if (percent == std::string::npos) return {};
    const std::size_t end = std::min(name.find('d', percent), name.size());
    const std::string digits = name.substr(percent + 1, end - percent - 1);
    const bool width = digits.size() == 2 && digits[0] == '0' && digits[1] >= '1' && digits[1] <= '9';
    if (end == name.size() || !(digits.empty() || width) || name.find('%', end) != std::string::npos)
        throw InputError(fmt::format("{}: expected one %04d for the frame's number, found another pattern",
                                     oneLine(file.string())));
    return Pattern{file.parent_path(), name.substr(0, percent), name.substr(end + 1),
                   width ? digits[1] - '0' : 1};
}

/// First and last number for which there is a file. Throws if there is none, or one between them is missing.
std::pair<int, int> numbersOf(const Pattern& pattern, const fs::path& file) {
    int first = std::numeric_limits<int>::max(), last = -1;
    std::error_code error;
    const fs::path folder = pattern.folder.empty() ? fs::path(".") : pattern.folder;
    for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error))
        if (const auto number = pattern.numberOf(entry->path().filename().string()))
            first = std::min(first, *number), last = std::max(last, *number);
    if (last < 0)
        throw InputError(fmt::format("{}: expected the files of a sequence, found none of that name",
                                     oneLine(file.string())));
    for (int number = first; number < last; ++number)
        requireFile(pattern.file(number));
    return {first, last};
}

class HeightImages final : public HeightSource {
  public:
    HeightImages(const fs::path& file, const glm::dvec2& fade)
        : _file(file), _pattern(parsePattern(file)), _fade(fade) {
        if (_pattern) {
            const auto [first, last] = numbersOf(*_pattern, file);
            _firstNumber = first;
            _count = last - first + 1;
        }
        _bounds = *frame(0);
    }

    int frameCount() const override { return _count; }
    const HeightBounds& bounds() const override { return _bounds; }
    double step() const override { return _step; }

    std::shared_ptr<const HeightField> frame(int index) override {
        if (_kept[1].first == index) std::swap(_kept[0], _kept[1]);
        if (_kept[0].first != index) {
            _kept[1] = {-1, {}}; // its memory is needed for the new one
            std::shared_ptr<const HeightField> field = load(index);
            _kept[1] = std::exchange(_kept[0], {index, std::move(field)});
        }
        return _kept[0].second;
    }

  private:
    std::shared_ptr<const HeightField> load(int index) {
        const fs::path file = _pattern ? _pattern->file(_firstNumber + index) : _file;
        Channel image = readFirstChannel(file, HeightField::minSide, HeightField::maxSide);
        const glm::ivec2 size(image.width, image.height), expected = _bounds.size;
        if (expected.x > 0 && size != expected)
            throw InputError(fmt::format("{}: expected {} x {} pixels as in the first frame, found {} x {}",
                                         oneLine(file.string()), expected.x, expected.y, size.x, size.y));
        if (index == 0) _step = 2 * image.step; // as the heights below
        for (std::size_t i = 0; i < image.data.size(); ++i)
            if (float& value = image.data[i]; !(std::abs(value) <= highestValue))
                throw InputError(fmt::format("{}: expected heights from -1e12 to 1e12, found {} in row {}, "
                                             "column {}",
                                             oneLine(file.string()), value, i / std::size_t(size.x),
                                             i % std::size_t(size.x)));
            else if (!image.floatingPoint)
                value = 2 * value - 1;
        return std::make_shared<const HeightField>(
            makeHeightField(size, std::move(image.data), _fade * glm::dvec2(size)));
    }

    fs::path _file;
    std::optional<Pattern> _pattern;
    glm::dvec2 _fade;
    int _firstNumber = 0;
    int _count = 1;
    HeightBounds _bounds;
    double _step = 0;
    /// The frames asked for last, the latest first.
    std::array<std::pair<int, std::shared_ptr<const HeightField>>, 2> _kept{{{-1, {}}, {-1, {}}}};
};

} // namespace

std::shared_ptr<HeightSource> openHeightImages(const fs::path& file, const glm::dvec2& fade) {
    return std::make_shared<HeightImages>(file, fade);
}

} // namespace limpid::io
