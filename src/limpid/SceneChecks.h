#pragma once
#include <string>

#include "scene/Scene.h"

namespace limpid {

/// Throws InputError (place, expected, got) for a scene that breaks what scene/Scene.h and scene/Mesh.h say
/// of it. A scene from a file has passed the same by its parser.
void requireScene(const Scene& scene);
/// Likewise for one mesh; `place` stands before the errors.
void requireMesh(const Mesh& mesh, const std::string& place);
/// Throws an InputError of this form.
[[noreturn]] void failCheck(const std::string& place, const std::string& expected, const std::string& got);

} // namespace limpid
