#pragma once
#include <epoxy/gl.h>
#include <glm/glm.hpp>

#include <limpid/scene/HostWater.h>

/// The host's own waves, computed into a texture of heights.
class Water {
  public:
    Water();
    ~Water();
    Water(const Water&) = delete;
    Water& operator=(const Water&) = delete;

    void move(double seconds) const;
    /// For Limpid, which reads the texture at each update.
    const limpid::Wave& wave() const { return _wave; }

  private:
    GLuint _program = 0, _heights = 0;
    limpid::Wave _wave;
};
