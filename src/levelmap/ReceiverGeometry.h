#pragma once
#include <vector>

#include <glm/glm.hpp>

#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "scene/Scene.h"

namespace limpid {

/// A receiver on the GPU.
/// Vertex: float[3] position, m from the scene's origin; float[3] shading normal; float[2] uv; 32-bit
/// indices.
class ReceiverGeometry {
  public:
    ReceiverGeometry(gl::Context& context, const Receiver& receiver, const glm::dvec3& origin);

    /// Draws all triangles; the material is what shaders/include/receiver_fragment.glsl takes.
    /// `primitive` is GL_TRIANGLES, or GL_PATCHES for a program that tessellates.
    void draw(const gl::Program& program, GLenum primitive = GL_TRIANGLES) const;

    /// Whether its surface encloses a solid: closed, wound outwards as far as signs of scale can say, and
    /// without holes of cut-outs.
    bool closed() const { return _closed; }

  private:
    void uploadImages(gl::Ledger& ledger, const Mesh& mesh);
    gl::VertexArray _vertexArray;
    gl::Buffer _vertices, _indices;
    std::vector<gl::Texture> _images;
    gl::Texture _white;
    std::vector<MeshPart> _parts;
    std::vector<Material> _materials;
    bool _closed = false;
};

enum class Side { Below, Above };

/// The corners of what lies on one side of `level`: vertices, and where edges cross it. Empty if nothing
/// does.
std::vector<glm::dvec3> pointsOfSide(const Receiver& receiver, double level, Side side);

} // namespace limpid
