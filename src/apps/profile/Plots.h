#pragma once
#include <filesystem>

#include "apps/profile/Machine.h"
#include "apps/profile/Run.h"

namespace limpid::apps {

/// Draws what the profile's results show, into `folder`, as PNG and SVG named after the profile: time, memory
/// and planes drawn against planes, where those vary; error against time, where there are errors; texels by
/// plane. Without gnuplot a line on stderr says so.
void plotResults(const std::filesystem::path& folder, const io::Profile& profile,
                 const ProfileOutcome& outcome, const Machine& machine);

} // namespace limpid::apps
