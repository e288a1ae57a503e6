#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace limpid::gl {

/// How many bytes of GPU memory each kind of object holds, as asked for from the driver (its own padding is
/// not known). A kind is what the profiler and the labels call it: "position map", "beams".
class Ledger {
  public:
    void add(std::string_view kind, std::int64_t bytes);
    void remove(std::string_view kind, std::int64_t bytes) { add(kind, -bytes); }

    /// How many bytes there may be at a time; 0: as many as the driver gives.
    void setLimit(std::int64_t bytes) { _limit = bytes; }
    /// To be asked before the driver is. Throws GraphicsError for bytes beyond the limit.
    void require(std::string_view kind, std::int64_t bytes) const;

    std::int64_t bytes(std::string_view kind) const;
    std::int64_t total() const { return _total; }
    /// The most at any one time since the last `resetPeak`.
    std::int64_t peak() const { return _peak; }
    void resetPeak() { _peak = _total; }
    const std::map<std::string, std::int64_t, std::less<>>& byKind() const { return _byKind; }

  private:
    std::map<std::string, std::int64_t, std::less<>> _byKind;
    std::int64_t _total = 0;
    std::int64_t _peak = 0;
    std::int64_t _limit = 0;
};

} // namespace limpid::gl
