#pragma once
#include <concepts>
#include <variant>

#include "godrays/ExactShafts.h"
#include "godrays/PhotonLines.h"
#include "godrays/Tetrahedra.h"

namespace limpid {

/// How light in the water is drawn: which name it goes by, and a pass that adds to a target.
template <typename M>
concept GodrayKind = std::constructible_from<M, gl::Context&> &&
    requires(M method, GodrayTarget& target, const GodrayInputs& inputs) {
    { M::does(GodrayMethod{}) } -> std::same_as<bool>;
    method.draw(target, inputs);
};

template <GodrayKind... Ms>
using GodrayMethodsOf = std::variant<Ms...>;

/// Every one there is.
using GodrayMethods = GodrayMethodsOf<PhotonLines, ExactShafts, Tetrahedra>;

} // namespace limpid
