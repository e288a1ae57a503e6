#pragma once
#include <concepts>
#include <variant>

#include "caustics/ExactBeamMethod.h"
#include "caustics/LevelMapMethod.h"
#include "caustics/PhotonSplatMethod.h"
#include "caustics/StencilMethod.h"
#include "caustics/VolumetricMethod.h"

namespace limpid {

/// How light comes to a map. A method says which names it goes by; draws the level map, or what stands for
/// it; makes ready what does not move with the water; and fills the caustic map, its textures of the level
/// map's frame. `free` gives back what it does not need until the next map.
template <typename M>
concept CausticMethod = std::constructible_from<M, gl::Context&> &&
    requires(M method, MapWork& map, const MapInputs& inputs, const WaterMesh& water) {
    { M::does(Method{}) } -> std::same_as<bool>;
    method.draw(map, inputs);
    method.prepare(map, inputs);
    method.fill(map, inputs, water);
    method.free();
};

template <CausticMethod... Ms>
using CausticMethodsOf = std::variant<Ms...>;

/// Every method there is; what they differ in is in scene/MethodFacts.h.
using CausticMethods =
    CausticMethodsOf<LevelMapMethod, ExactBeamMethod, VolumetricMethod, StencilMethod, PhotonSplatMethod>;

} // namespace limpid
