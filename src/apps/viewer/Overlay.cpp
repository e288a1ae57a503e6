#include "apps/viewer/Overlay.h"

namespace limpid::viewer {

Overlay::Overlay(const Scene& scene, const Area& picture)
    : _projection(scene.camera, scene.water, glm::dvec2(picture.size)), _corner(picture.corner) {
    const glm::vec2 from(picture.corner), to(picture.corner + picture.size);
    ImGui::GetBackgroundDrawList()->PushClipRect(ImVec2(from.x, from.y), ImVec2(to.x, to.y));
}

Overlay::~Overlay() {
    ImGui::GetBackgroundDrawList()->PopClipRect();
}

void Overlay::line(const glm::dvec3& from, const glm::dvec3& to, ImU32 color) const {
    curve([&](double t) { return glm::mix(from, to, t); }, 12, color, 1.5f);
}

std::optional<std::pair<ImVec2, ImVec2>> Overlay::curve(const std::function<glm::dvec3(double)>& point,
                                                        int pieces, ImU32 color, float width) const {
    std::optional<glm::dvec2> last;
    std::optional<std::pair<ImVec2, ImVec2>> piece;
    for (int i = 0; i <= pieces; ++i) {
        auto pixel = _projection.pixel(point(double(i) / pieces));
        // A point next to the camera is shown endlessly far away.
        if (pixel && glm::length(*pixel) > 1e5) pixel.reset();
        if (pixel) *pixel += _corner;
        piece.reset();
        if (last && pixel) {
            piece = {ImVec2(float(last->x), float(last->y)), ImVec2(float(pixel->x), float(pixel->y))};
            ImGui::GetBackgroundDrawList()->AddLine(piece->first, piece->second, color, width);
        }
        last = pixel;
    }
    return piece;
}

} // namespace limpid::viewer
