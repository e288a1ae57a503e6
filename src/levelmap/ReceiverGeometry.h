#pragma once
#include <vector>

#include <glm/glm.hpp>

#include "gl/Context.h"
#include "gl/Handles.h"
#include "gl/Program.h"
#include "scene/Scene.h"

namespace limpid {

/// A receiver on the GPU.
/// Vertex: float[3] position, m from the scene's origin; float[3] shading normal; float[2] uv of the base
/// colour, float[2] of normal maps; uint16[4] linear colour; 32-bit indices.
class ReceiverGeometry {
  public:
    ReceiverGeometry(gl::Context& context, const Receiver& receiver, const glm::dvec3& origin);

    /// The same mesh at another place: only what that decides is written anew. Not for a host's.
    void place(const Receiver& receiver, const glm::dvec3& origin);

    /// Draws all triangles; the material is what shaders/levelmap/receiver_fragment.glsl takes.
    /// `primitive` is GL_TRIANGLES, or GL_PATCHES for a program that tessellates.
    /// What lets more than half of the light through counts as a hole, else as solid.
    void draw(const gl::Program& program, GLenum primitive = GL_TRIANGLES) const;
    /// Draws what maps show (scene/Mesh.h, shownAlpha).
    void drawShown(const gl::Program& program) const;
    /// The same with what shaders/levelmap/opacity.frag takes besides.
    void drawTranslucence(const gl::Program& program) const;
    /// Without what lets something show through.
    void drawSolid(const gl::Program& program, GLenum primitive = GL_TRIANGLES) const;
    /// One part, with nothing taken for a hole; `program` has the uniform of its transmission.
    void drawPart(std::size_t part, const gl::Program& program, GLenum primitive = GL_TRIANGLES) const;

    /// A part of a material that is blended or transmissive.
    struct BlendedPart {
        std::size_t part;
        glm::vec3 center; ///< of its bounds, m from the scene's origin
    };
    const std::vector<BlendedPart>& blendedParts() const { return _blendedParts; }

    /// Whether some of it takes a part of the light and lets the rest through.
    bool translucent() const { return !_blendedParts.empty(); }

  private:
    void uploadMesh(gl::Ledger& ledger, const Receiver& receiver, const glm::dvec3& origin);
    void findBlendedParts(const Receiver& receiver, const glm::dvec3& origin);
    void takeHostMesh(gl::Context& context, const Receiver& receiver, const glm::dvec3& origin);
    void uploadImages(gl::Ledger& ledger, const Mesh& mesh);
    void drawPart(std::size_t part, const gl::Program& program, GLenum primitive, float cutoff) const;
    /// `prepare`: before each part.
    template <typename Prepare>
    void drawShown(const gl::Program& program, const Prepare& prepare) const;
    gl::VertexArray _vertexArray;
    gl::Buffer _vertices, _indices;
    std::vector<gl::Texture> _images;
    gl::Texture _white;
    std::vector<MeshPart> _parts;
    std::vector<Material> _materials;
    std::vector<BlendedPart> _blendedParts;
    bool _partlyBlended = false;
};

} // namespace limpid
