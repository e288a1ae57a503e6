#pragma once
#include <cstdio>

#include "apps/Common.h"
#include "engine/Engine.h"
#include "gl/Context.h"

namespace limpid::apps {

/// Throws GraphicsError. Debug builds check every call.
gl::ContextOptions contextOptions(const CommonOptions& options);

/// The scene's warnings on stderr, unless quiet.
void printWarnings(const Engine& engine, const CommonOptions& options);

/// GPU time by pass, planes, GPU bytes by kind.
void printWork(Engine& engine, gl::Context& context, std::FILE* out = stdout);

} // namespace limpid::apps
