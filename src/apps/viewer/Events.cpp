#include "apps/viewer/Events.h"

namespace limpid::viewer {

bool EventQueue::Taken::admits(const Event& event) {
    switch (event.type) {
    case Event::Type::Move:
    case Event::Type::Leave:
        if (_pressed) return false;
        _moved = true;
        return true;
    case Event::Type::Button:
    case Event::Type::Key:
        if (_moved || _pressed) return false;
        _pressed = true;
        return true;
    case Event::Type::Wheel:
    case Event::Type::Letter: // follows its key
        return true;
    }
    return true;
}

} // namespace limpid::viewer
