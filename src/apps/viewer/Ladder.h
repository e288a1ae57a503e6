#pragma once
#include <cstddef>
#include <vector>

namespace limpid::viewer {

/// Chooses how much work a frame may take, from measured times: step 0 is all of it, each further step costs
/// about its share of that. Starts at the last step, where nothing is known yet.
class Ladder {
  public:
    /// `shares`: of the whole work, falling from 1.
    explicit Ladder(std::vector<double> shares) : _shares(std::move(shares)), _step(_shares.size() - 1) {}

    std::size_t step() const { return _step; }
    std::size_t last() const { return _shares.size() - 1; }

    /// The work of step `step` took `ms`; the next may take `target`: the finest step that is expected to.
    /// A step up must stay well below it, so that two steps do not take turns.
    void measured(std::size_t step, double ms, double target);

  private:
    std::vector<double> _shares;
    std::size_t _step;
};

} // namespace limpid::viewer
