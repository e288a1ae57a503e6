#pragma once
#include <array>
#include <deque>

#include <glm/glm.hpp>

namespace limpid::viewer {

/// What mouse and keyboard did, in order.
struct Event {
    enum class Type { Move, Leave, Button, Wheel, Key, Letter } type = Type::Move;
    glm::dvec2 at{0}; ///< Move: pixels; Wheel: clicks
    int code = 0;     ///< Button, Key: GLFW's number; Letter: Unicode
    int scancode = 0, action = 0, modifiers = 0;
};

/// Gives a frame as many events as it can tell apart: a frame may take long, and whoever only looks at how
/// things stand at its end would miss a click or a short drag in between.
class EventQueue {
  public:
    void push(const Event& event) { _events.push_back(event); }
    bool empty() const { return _events.empty(); }

    /// Takes the next frame's: moves up to the next button, no button or key twice, no move after one.
    template <typename Use>
    void takeFrame(Use&& use) {
        for (Taken taken; !_events.empty() && taken.admits(_events.front()); _events.pop_front())
            use(_events.front());
    }

  private:
    /// What is in a frame already.
    class Taken {
      public:
        /// Whether `event` can still join; then it has.
        bool admits(const Event& event);

      private:
        bool _moved = false, _pressed = false;
    };
    std::deque<Event> _events;
};

} // namespace limpid::viewer
