#pragma once
#include <memory>
#include <vector>

#include "caustics/MapWork.h"
#include "engine/Frame.h"
#include "engine/Lights.h"

namespace limpid {

/// The maps of all receivers and lights. What is there, made from the same, is not made again.
class Maps {
  public:
    explicit Maps(gl::Context& context);
    ~Maps();

    /// One for each that is planned; those that were there before stay.
    void plan(const Scene& scene, const Plan& plan);
    /// Of as many texels as the scene says, whatever a picture showed of them.
    void makeWhole() {
        for (MapWork& map : _maps)
            map.halvings = 0;
    }
    /// Nothing stays on the GPU but which maps there are.
    void forget();

    const std::vector<MapWork>& all() const { return _maps; }
    std::vector<MapWork>& all() { return _maps; }

    /// Position, colour and normal (thesis 4.2.2), and what the method makes ready. Returns whether something
    /// was made.
    bool draw(const Frame& frame, const Lights& lights, MapWork& map);
    /// Irradiance on the receiver (4.5, eq. 4-18), once it is drawn. Returns whether it was made.
    bool fill(const Frame& frame, const Lights& lights, MapWork& map);
    /// levelmap/Coverage.h
    gl::Texture coverage(const Frame& frame, const Lights& lights, const MapWork& map);

  private:
    struct Passes;
    MapInputs inputsOf(const Frame& frame, const Lights& lights, const MapWork& map);
    void takeLight(const Frame& frame, const MapInputs& inputs, MapWork& map);
    void fillAll(const Frame& frame, const MapInputs& inputs, MapWork& map);

    std::unique_ptr<Passes> _passes;
    std::vector<MapWork> _maps;
};

/// Whether no light comes to a map.
bool isUnlit(const MapWork& map, const LightWork& light);

} // namespace limpid
