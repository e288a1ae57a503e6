#pragma once
#include <string>
#include <vector>

#include "apps/profile/Machine.h"
#include "apps/profile/Run.h"

namespace limpid::apps {

/// `results.json`, as the profile's users read it.
std::string resultsJson(const std::vector<io::Profile>& profiles, const ProfileOutcome& outcome,
                        const Machine& machine);

/// `results.csv`: one line a combination; a column for each pass and each kind of memory that any of them
/// has.
std::string resultsCsv(const ProfileOutcome& outcome);

/// A table for the terminal.
void printResults(const ProfileOutcome& outcome, const Machine& machine);

} // namespace limpid::apps
