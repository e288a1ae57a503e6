#pragma once
#include <chrono>
#include <string>

namespace limpid {

/// A line on stderr that says how far long work has come and how long the rest will take. Only on a terminal:
/// a pipe or a log gets nothing of it.
class Progress {
  public:
    /// `what` names the work, `total` its steps; `enabled` false keeps silent on a terminal too.
    Progress(std::string what, int total, bool enabled);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// `done` steps are done.
    void update(int done);

    /// What `update` shows: `frames 3/10, 1:05 left`. `seconds` have passed for `done` steps.
    static std::string text(const std::string& what, int done, int total, double seconds);

  private:
    std::string _what;
    int _total;
    bool _shown;
    std::chrono::steady_clock::time_point _start;
};

} // namespace limpid
