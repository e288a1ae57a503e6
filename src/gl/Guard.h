#pragma once
#include <optional>

#include "gl/Context.h"
#include "gl/HostState.h"

namespace limpid::gl {

/// Keeps a host's OpenGL state from our passes, and our passes from it: while one lives in a host's context,
/// passes find the state of a fresh context, and afterwards the host finds its own. Free in a context of our
/// own, where every pass leaves things as it found them, and inside of another guard.
///
/// Not kept, since OpenGL has no way to: samples and primitives that a host's query counts while we draw (end
/// it before), and a conditional render (likewise). What a host has bound must still exist when it ends.
class Guard {
  public:
    explicit Guard(Context& context) : _context(context) {
        if (_context.enter()) _host.emplace();
    }
    ~Guard() { _context.leave(); }
    Guard(const Guard&) = delete;
    Guard& operator=(const Guard&) = delete;

  private:
    Context& _context;
    std::optional<HostState> _host;
};

} // namespace limpid::gl
