#include "limpid/Context.h"

#include <fmt/format.h>

#include "core/Error.h"
#include "gl/Context.h"
#include "gl/CurrentContext.h"

namespace limpid {

namespace {

gl::ContextOptions optionsOf(const ContextOptions& options) {
    if (options.memory < 0)
        throw InputError(fmt::format("ContextOptions::memory: expected bytes >= 0, got {}", options.memory));
    return {options.device, options.memory, options.debug, options.onMessage};
}

} // namespace

Context::Context(std::shared_ptr<gl::Context> context)
    : _context(std::move(context)), _handle(gl::currentHandle()) {}

Context Context::current(const ContextOptions& options) {
    return Context(std::make_shared<gl::Context>(gl::Context::Current{}, optionsOf(options)));
}

Context Context::headless(const ContextOptions& options) {
    return Context(std::make_shared<gl::Context>(optionsOf(options)));
}

const std::string& Context::renderer() const {
    return _context->info().renderer;
}

std::int64_t Context::bytes() const {
    return _context->ledger().total();
}

} // namespace limpid
