#include <fmt/format.h>

#include "apps/Common.h"
#include "scene/Keys.h"

/// What a shell and `man` need to know of the commands, told by the commands themselves so that it stays
/// true.
namespace limpid::apps {

namespace {

std::vector<const CLI::App*> commandsOf(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

std::string longNames(const CLI::App& command) {
    std::string names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames())
            names += fmt::format("{}--{}", names.empty() ? "" : " ", name);
    return names;
}

template <typename Values, typename NameOf>
std::string words(const Values& values, NameOf&& nameOf) {
    std::string all;
    for (const auto& value : values)
        all += fmt::format("{}{}", all.empty() ? "" : " ", nameOf(value));
    return all;
}

/// What may come after an option.
std::string choices() {
    const std::pair<std::string, std::string> all[] = {
        {"--method | --compare", words(allMethods(), methodName)},
        {"--fill", words(allFills(), fillName)},
        {"--godrays", words(allGodrayMethods(), godrayMethodName)},
        {"--panel", "measure understand compare"}};
    std::string cases;
    for (const auto& [options, names] : all)
        cases += fmt::format("        {}) COMPREPLY=($(compgen -W \"{}\" -- \"$current\")); return ;;\n",
                             options, names);
    const std::string keys = words(sceneKeys(), [](const KeyFacts& key) { return key.path() + "="; });
    return cases + fmt::format("        --set) COMPREPLY=($(compgen -W \"{}\" -- \"$current\"))\n"
                               "            compopt -o nospace 2>/dev/null; return ;;\n",
                               keys);
}

/// For bash: commands first, then each command's options, what some of them take, and files.
std::string bashScript(const CLI::App& app) {
    std::string cases;
    for (const CLI::App* command : commandsOf(app))
        cases += fmt::format("        {}) words=\"{}\" ;;\n", command->get_name(), longNames(*command));
    return fmt::format(R"(_limpid() {{
    local current="${{COMP_WORDS[COMP_CWORD]}}" before="${{COMP_WORDS[COMP_CWORD-1]}}" words=""
    if [ "$COMP_CWORD" -eq 1 ]; then
        COMPREPLY=($(compgen -W "{} --help --version" -- "$current"))
        return
    fi
    case "$before" in
{}    esac
    case "${{COMP_WORDS[1]}}" in
{}    esac
    case "$current" in
        -*) COMPREPLY=($(compgen -W "$words" -- "$current")) ;;
        *) COMPREPLY=() ;;
    esac
}}
complete -o default -F _limpid limpid
)",
                       words(commandsOf(app), [](const CLI::App* c) { return c->get_name(); }), choices(),
                       cases);
}

/// As roff takes it: a hyphen is a minus, a dot or a quote at the beginning of a line is no command.
std::string roff(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n')) out += "\\&";
        out += c == '-' ? "\\-" : c == '\\' ? "\\e" : std::string(1, c);
    }
    return out;
}

std::string manPage(const CLI::App& app) {
    std::string page = fmt::format(".TH LIMPID 1 \"\" \"limpid {}\"\n.SH NAME\nlimpid \\- {}\n.SH SYNOPSIS\n"
                                   "\\fBlimpid\\fR COMMAND [OPTION]...\n.SH COMMANDS\n",
                                   LIMPID_VERSION, roff(app.get_description()));
    for (const CLI::App* command : commandsOf(app)) {
        page += fmt::format(".SS {}\n{}\n", command->get_name(), roff(command->get_description()));
        for (const CLI::Option* option : command->get_options())
            page += fmt::format(".TP\n\\fB{}\\fR\n{}\n", roff(option->get_name(true, true)),
                                roff(option->get_description()));
    }
    page += ".SH SCENE KEYS\nWhat a scene file or \\-\\-set may say, with its default.\n";
    for (const KeyFacts& key : sceneKeys())
        page += fmt::format(".TP\n\\fB{}\\fR\n{}\n.br\n{}\n", roff(key.path()), roff(key.standard),
                            roff(sentenceOf(key)));
    return page + fmt::format(".SH EXIT STATUS\n{}\n", roff(app.get_footer()));
}

} // namespace

void addShell(CLI::App& app) {
    auto* completion =
        app.add_subcommand("completion", "the script with which bash completes limpid's commands");
    completion->footer("Example: limpid completion > ~/.local/share/bash-completion/completions/limpid");
    completion->callback([&app] { fmt::print("{}", bashScript(app)); });
    auto* man = app.add_subcommand("man", "the manual page");
    man->footer("Example: limpid man | man -l -");
    man->callback([&app] { fmt::print("{}", manPage(app)); });
}

} // namespace limpid::apps
