#pragma once
#include <cstdio>
#include <string>

#include <fmt/format.h>
#include <sys/wait.h>

#include "Folders.h"

namespace limpid::test {

struct Result {
    int code = -1;
    std::string out; ///< stdout and stderr
};

/// Runs the program as a shell would.
inline Result run(const std::string& arguments, const std::string& environment = "") {
    const std::string command = fmt::format("{} {}/limpid {} 2>&1", environment, buildFolder(), arguments);
    Result result;
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return result;
    char buffer[4096];
    while (const std::size_t bytes = std::fread(buffer, 1, sizeof(buffer), pipe))
        result.out.append(buffer, bytes);
    result.code = WEXITSTATUS(pclose(pipe));
    return result;
}

} // namespace limpid::test
