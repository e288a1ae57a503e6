#pragma once
#include <array>
#include <optional>
#include <utility>
#include <variant>

namespace limpid {

/// The alternatives of a variant, each made when it is first asked for, and then kept.
template <typename Variant>
class OneOf;

template <typename... Kinds>
class OneOf<std::variant<Kinds...>> {
  public:
    using Variant = std::variant<Kinds...>;

    /// The first alternative that `does(choice)`, made from `args`. There must be one.
    template <typename Choice, typename... Args>
    Variant& get(Choice choice, Args&... args) {
        std::optional<Variant>* found = nullptr;
        std::size_t index = 0;
        const auto look = [&]<typename Kind>(std::in_place_type_t<Kind> kind) {
            std::optional<Variant>& made = _made[index++];
            if (found || !Kind::does(choice)) return;
            if (!made) made.emplace(kind, args...);
            found = &made;
        };
        (look(std::in_place_type<Kinds>), ...);
        return **found;
    }
    /// Calls `use` for each that is there.
    template <typename Use>
    void forEach(Use&& use) {
        for (std::optional<Variant>& made : _made)
            if (made) std::visit(use, *made);
    }

  private:
    std::array<std::optional<Variant>, sizeof...(Kinds)> _made;
};

} // namespace limpid
