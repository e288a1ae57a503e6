#pragma once
#include <string>

#include "core/Error.h"

namespace limpid::test {

/// The error that a call throws about its input, or "no error".
template <typename Call>
std::string errorOf(const Call& call) {
    try {
        call();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

} // namespace limpid::test
