// A slow frame must not lose a click or a short drag.
#include "apps/viewer/Events.h"

#include <string>

#include <gtest/gtest.h>

namespace limpid::viewer {
namespace {

using Type = Event::Type;

/// The events of frame after frame, a letter each, frames parted by a bar.
std::string frames(EventQueue& queue) {
    std::string text;
    while (!queue.empty()) {
        if (!text.empty()) text += '|';
        queue.takeFrame([&](const Event& event) {
            if (event.type == Type::Button || event.type == Type::Key)
                text += event.action ? 'd' : 'u';
            else
                text += event.type == Type::Letter ? 'l' : event.type == Type::Wheel ? 'w' : 'm';
        });
    }
    return text;
}

TEST(EventQueue, keepsADragApart) {
    EventQueue queue;
    queue.push({Type::Move, {1, 1}});
    queue.push({Type::Button, {}, 0, 0, 1});
    for (int i = 0; i < 3; ++i)
        queue.push({Type::Move, {2.0 + i, 1}});
    queue.push({Type::Button, {}, 0, 0, 0});
    EXPECT_EQ(frames(queue), "m|d|mmm|u");
}

TEST(EventQueue, keepsKeysApartAndLettersWithThem) {
    EventQueue queue;
    for (int i = 0; i < 2; ++i) {
        queue.push({Type::Key, {}, 65, 0, 1});
        queue.push({Type::Letter, {}, 'a'});
        queue.push({Type::Key, {}, 65, 0, 0});
    }
    queue.push({Type::Wheel, {0, 1}});
    queue.push({Type::Wheel, {0, 1}});
    EXPECT_EQ(frames(queue), "dl|u|dl|uww");
}

} // namespace
} // namespace limpid::viewer
