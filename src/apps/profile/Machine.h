#pragma once
#include <string>

#include "gl/Context.h"

namespace limpid::apps {

/// What figures were measured on.
struct Machine {
    std::string cpu; ///< model, "unknown" where the system does not say
    int cores = 0;   ///< that this process may run on
    std::string gpu, driver;
    std::string gl; ///< "4.5"
};

Machine thisMachine(const gl::DeviceInfo& info);

/// The commit that the program was built from, with "-dirty" if files were changed after it; "unknown"
/// outside of a repository.
std::string builtCommit();

/// Now, as 2026-01-31T12:00:00Z.
std::string dateNow();

} // namespace limpid::apps
