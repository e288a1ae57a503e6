#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <set>
#include <system_error>

#include <fmt/format.h>

#include "apps/Common.h"
#include "core/Error.h"
#include "io/Files.h"
#include "io/Staging.h"
#include "io/toml/TomlReader.h"

namespace {

int fail(int code, const char* what) {
    // Unlike fmt's, it does not throw where nobody listens.
    std::fprintf(stderr, "limpid: %s\n", limpid::io::legible(what).c_str());
    return code;
}

/// A full disk behind a redirection shows only at the end.
int flushed() {
    return std::cout.flush() && std::fflush(stdout) == 0 ? 0 : fail(2, "standard output: cannot write");
}

std::string commandNames(const CLI::App& app) {
    std::string names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        names += (names.empty() ? "" : ", ") + command->get_name();
    return names;
}

using Names = std::set<std::string, std::less<>>;

Names namesOf(const CLI::App& app) {
    Names names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        names.insert(command->get_name());
    return names;
}

/// Of the command that was given.
Names optionNames(const CLI::App& app) {
    Names names;
    for (const CLI::App* command : app.get_subcommands())
        for (const CLI::Option* option : command->get_options())
            for (const std::string& name : option->get_lnames())
                names.insert(fmt::format("--{}", name));
    return names;
}

int run(int argc, char** argv) {
    CLI::App app("Light through moving water: caustics on glTF receivers.", "limpid");
    app.require_subcommand(1);
    app.set_version_flag("--version", std::string("limpid ") + LIMPID_VERSION);
    app.footer(
        "Exit: 0 done, 1 a comparison failed, 2 wrong usage or bad input, 3 the graphics system failed.");
    limpid::apps::addRender(app);
    limpid::apps::addView(app);
    limpid::apps::addBake(app);
    limpid::apps::addCompare(app);
    limpid::apps::addProfile(app);
    limpid::apps::addInfo(app);
#ifdef LIMPID_WITH_REFERENCE
    limpid::apps::addReference(app);
#endif
    limpid::apps::addShell(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ExtrasError&) {
        std::string extra, option;
        for (const std::string& word : app.remaining(true)) {
            extra += (extra.empty() ? "" : " ") + word;
            if (option.empty() && word.starts_with("--")) option = word.substr(0, word.find('='));
        }
        return fail(2, fmt::format("expected one of the options in limpid --help, found \"{}\"{}", extra,
                                   limpid::io::suggestion(option, optionNames(app)))
                           .c_str());
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return app.exit(error), flushed();
        if (argc < 2) {
            fmt::print(stderr, "{}", app.help());
            return 2;
        }
        if (app.get_subcommands().empty())
            return fail(2,
                        fmt::format("expected a command ({}), found \"{}\"{} (see limpid --help)",
                                    commandNames(app), argv[1], limpid::io::suggestion(argv[1], namesOf(app)))
                            .c_str());
        return fail(2, fmt::format("{} (see limpid --help)", error.what()).c_str());
    }
    return flushed();
}

} // namespace

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN); // past a limit of file sizes: the write that fails tells
    try {
        limpid::io::removeStagingsOnSignals();
        return run(argc, argv);
    } catch (const limpid::apps::Exit& exit) {
        return exit.code;
    } catch (const limpid::InputError& error) {
        return fail(2, error.what());
    } catch (const limpid::GraphicsError& error) {
        return fail(3, error.what());
    } catch (const std::filesystem::filesystem_error& error) { // links in a circle, folders closed to looking
        return fail(2, fmt::format("{}: expected a name that leads to a file or folder, found {}",
                                   limpid::io::oneLine(error.path1().string()), error.code().message())
                           .c_str());
    } catch (const std::system_error& error) { // as fmt has it for standard output
        return fail(2, error.what());
    } catch (const std::bad_alloc&) {
        return fail(3, "out of memory");
    } catch (const std::exception& error) {
        return fail(3, error.what());
    }
}
