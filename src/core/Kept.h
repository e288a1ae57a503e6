#pragma once
#include <cstdint>
#include <optional>
#include <utility>

namespace limpid {

/// When something was made, counted by a Making; 0: it is not there.
using Stamp = std::uint64_t;

/// Gives out stamps, and says which of them still count.
class Making {
  public:
    Stamp next() { return ++_last; }
    /// What was made before counts no longer: it is made anew when it is next asked for.
    void startAnew() { _first = _last + 1; }
    bool counts(Stamp stamp) const { return stamp >= _first; }

  private:
    Stamp _last = 0, _first = 1;
};

/// What a product was made from, kept beside it, so that it is made again only if that has changed. `From` is
/// a plain value with ==; of what is a product itself it holds the stamp.
template <typename From>
class Kept {
  public:
    /// Calls `make` unless the product is there, made from an equal `from`. Returns whether it did. After a
    /// `make` that throws, the product counts as not there.
    template <typename Make>
    bool bring(Making& making, From from, Make&& make) {
        if (_stamp != 0 && making.counts(_stamp) && *_from == from) return false;
        forget();
        make();
        _from = std::move(from);
        _stamp = making.next();
        return true;
    }
    void forget() { _stamp = 0, _from.reset(); }
    Stamp stamp() const { return _stamp; }

  private:
    std::optional<From> _from;
    Stamp _stamp = 0;
};

} // namespace limpid
