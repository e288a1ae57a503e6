// `limpid reference` as a program of its own, linked without OpenGL: that it links is the test.
#include <cstdio>

#include "apps/Common.h"

int main(int argc, char** argv) try {
    CLI::App app("Ground truth alone.", "reference-alone");
    limpid::apps::addReference(app);
    app.parse(argc, argv);
    return 0;
} catch (const CLI::ParseError& error) {
    return error.get_exit_code();
} catch (const std::exception& error) {
    std::fprintf(stderr, "reference-alone: %s\n", error.what());
    return 2;
}
