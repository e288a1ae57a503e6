#pragma once
#include <string>
#include <utility>
#include <vector>

#include "gl/Api.h"

namespace limpid::gl {

/// GPU time by pass, in the order in which passes first ran. Two time stamps a scope: llvmpipe's elapsed-time
/// query reports the time since boot for a scope that begins before anything was drawn. Whoever never asks
/// for the times pays for no more than a few thousand queries.
class PassTimers {
  public:
    PassTimers() = default;
    ~PassTimers();
    PassTimers(const PassTimers&) = delete;
    PassTimers& operator=(const PassTimers&) = delete;

    /// Times what is issued until the scope ends, and names it for graphics debuggers.
    class Scope {
      public:
        Scope(PassTimers& timers, const char* pass);
        ~Scope();
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

      private:
        PassTimers& _timers;
        GLuint _end;
    };

    /// Waits for the GPU; milliseconds by pass since the last call, summed over scopes of one name.
    std::vector<std::pair<std::string, double>> collect();

  private:
    struct Stamps {
        std::string pass;
        GLuint begin = 0, end = 0;
        bool open = true;
    };
    GLuint take();
    void read(std::size_t count);
    std::vector<Stamps> _pending;
    std::vector<std::pair<std::string, double>> _times; ///< ms of what was read since the last collect()
    std::vector<GLuint> _free;
};

} // namespace limpid::gl
