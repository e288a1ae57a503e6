#include "apps/profile/Machine.h"

#include <ctime>
#include <fstream>

#include <sched.h>

#include "Commit.h"

namespace limpid::apps {

namespace {

std::string cpuModel() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown";
}

int usableCores() {
    cpu_set_t set;
    return sched_getaffinity(0, sizeof(set), &set) == 0 ? CPU_COUNT(&set) : 0;
}

} // namespace

Machine thisMachine(const gl::DeviceInfo& info) {
    const std::string& version = info.version;
    return {cpuModel(), usableCores(), info.renderer, version, version.substr(0, version.find(' '))};
}

std::string builtCommit() {
    return LIMPID_COMMIT;
}

std::string dateNow() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    char text[32];
    return {text, std::strftime(text, sizeof(text), "%Y-%m-%dT%H:%M:%SZ", &utc)};
}

} // namespace limpid::apps
