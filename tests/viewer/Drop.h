#pragma once
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <string>
#include <thread>

#include <xcb/xcb.h>

#include "viewer/Display.h"

/// Files dropped onto a window by the protocol that file managers speak (freedesktop.org, "Drag-and-Drop
/// Protocol for the X Window System", version 5).
namespace limpid::test {

class Drop {
  public:
    explicit Drop(const std::string& display) : _connection(xcb_connect(display.c_str(), nullptr)) {
        const xcb_screen_t* screen = xcb_setup_roots_iterator(xcb_get_setup(_connection)).data;
        _source = xcb_generate_id(_connection);
        xcb_create_window(_connection, 0, _source, screen->root, 0, 0, 1, 1, 0, XCB_WINDOW_CLASS_INPUT_ONLY,
                          XCB_COPY_FROM_PARENT, 0, nullptr);
        _target = awareChild(screen->root);
    }
    ~Drop() { xcb_disconnect(_connection); }
    Drop(const Drop&) = delete;
    Drop& operator=(const Drop&) = delete;

    /// Returns whether the first window that takes drops has taken this one.
    bool file(const std::string& path) {
        if (_target == 0) return false;
        xcb_set_selection_owner(_connection, _source, atom("XdndSelection"), XCB_CURRENT_TIME);
        tell("XdndEnter", {{0, 5u << 24, atom("text/uri-list")}});
        tell("XdndPosition", {{0, 0, 200u << 16 | 200u, XCB_CURRENT_TIME, atom("XdndActionCopy")}});
        tell("XdndDrop", {{0, 0, XCB_CURRENT_TIME}});
        return answers("file://" + path + "\r\n");
    }

  private:
    xcb_atom_t atom(const std::string& name) {
        const auto cookie = xcb_intern_atom(_connection, 0, std::uint16_t(name.size()), name.c_str());
        return owned(xcb_intern_atom_reply(_connection, cookie, nullptr))->atom;
    }

    xcb_window_t awareChild(xcb_window_t root) {
        const auto tree =
            owned(xcb_query_tree_reply(_connection, xcb_query_tree(_connection, root), nullptr));
        const xcb_window_t* children = xcb_query_tree_children(tree.get());
        for (int i = 0; i < xcb_query_tree_children_length(tree.get()); ++i) {
            const auto cookie =
                xcb_get_property(_connection, 0, children[i], atom("XdndAware"), XCB_ATOM_ATOM, 0, 1);
            if (owned(xcb_get_property_reply(_connection, cookie, nullptr))->type == XCB_ATOM_ATOM)
                return children[i];
        }
        return 0;
    }

    struct Words {
        std::uint32_t word[5] = {};
    };
    void tell(const std::string& what, Words words) {
        words.word[0] = _source;
        xcb_client_message_event_t event{};
        event.response_type = XCB_CLIENT_MESSAGE;
        event.format = 32;
        event.window = _target;
        event.type = atom(what);
        std::copy(std::begin(words.word), std::end(words.word), event.data.data32);
        xcb_send_event(_connection, 0, _target, 0, reinterpret_cast<const char*>(&event));
        xcb_flush(_connection);
    }

    /// Gives the names when asked for them, until the drop is said to be finished.
    bool answers(const std::string& names) {
        const xcb_atom_t finished = atom("XdndFinished");
        for (const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(120);
             std::chrono::steady_clock::now() < end;
             std::this_thread::sleep_for(std::chrono::milliseconds(10)))
            while (const auto event = owned(xcb_poll_for_event(_connection))) {
                const int type = event->response_type & 0x7f;
                if (type == XCB_SELECTION_REQUEST)
                    give(*reinterpret_cast<const xcb_selection_request_event_t*>(event.get()), names);
                if (type == XCB_CLIENT_MESSAGE &&
                    reinterpret_cast<const xcb_client_message_event_t*>(event.get())->type == finished)
                    return true;
            }
        return false;
    }

    void give(const xcb_selection_request_event_t& request, const std::string& names) {
        xcb_change_property(_connection, XCB_PROP_MODE_REPLACE, request.requestor, request.property,
                            request.target, 8, std::uint32_t(names.size()), names.data());
        xcb_selection_notify_event_t event{};
        event.response_type = XCB_SELECTION_NOTIFY;
        event.time = request.time;
        event.requestor = request.requestor;
        event.selection = request.selection;
        event.target = request.target;
        event.property = request.property;
        xcb_send_event(_connection, 0, request.requestor, 0, reinterpret_cast<const char*>(&event));
        xcb_flush(_connection);
    }

    xcb_connection_t* _connection;
    xcb_window_t _source = 0, _target = 0;
};

} // namespace limpid::test
