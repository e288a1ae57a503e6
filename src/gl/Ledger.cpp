#include "gl/Ledger.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/Error.h"

namespace limpid::gl {

void Ledger::add(std::string_view kind, std::int64_t bytes) {
    auto entry = _byKind.find(kind);
    if (entry == _byKind.end()) entry = _byKind.emplace(kind, 0).first;
    entry->second += bytes;
    if (entry->second == 0) _byKind.erase(entry);
    _total += bytes;
    _peak = std::max(_peak, _total);
}

void Ledger::require(std::string_view kind, std::int64_t bytes) const {
    if (_limit > 0 && bytes > _limit - _total)
        throw GraphicsError(fmt::format(
            "{}: expected room for {} bytes on the GPU, found {} of the {} that are allowed (--gpu-memory)",
            kind, bytes, std::max<std::int64_t>(_limit - _total, 0), _limit));
}

std::int64_t Ledger::bytes(std::string_view kind) const {
    const auto entry = _byKind.find(kind);
    return entry == _byKind.end() ? 0 : entry->second;
}

} // namespace limpid::gl
