#pragma once
#include <span>
#include <vector>

#include <epoxy/gl.h>
#include <glm/glm.hpp>

#include <limpid/Caustics.h>

/// The host's own side: meshes in its buffers, its shader, its camera under water.
class Pool {
  public:
    Pool();
    ~Pool();
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;

    /// The same for Limpid: a receiver for each object, under water with `waves`.
    limpid::Scene scene(const limpid::Wave& waves) const;
    /// Draws the objects in the light of `maps`.
    void draw(std::span<const limpid::LitMap> maps, glm::ivec2 size) const;

  private:
    struct Vertex {
        glm::vec3 position, normal; ///< m; unit
    };
    struct Object {
        const char* name;
        glm::vec3 translation, albedo;
        bool closed;
        std::vector<Vertex> vertices;
        std::vector<GLuint> indices;
        GLuint vertexBuffer = 0, indexBuffer = 0, vertexArray = 0;
    };
    static Object makeFloor();
    static Object makeKnot();
    static limpid::Receiver receiverOf(const Object& object);
    void upload(Object& object) const;

    std::vector<Object> _objects;
    GLuint _program = 0;
};
