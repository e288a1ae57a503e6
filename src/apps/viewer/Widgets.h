#pragma once
#include <string>

#include <glm/glm.hpp>
#include <imgui.h>

/// Fields of the panels for the scene's numbers. Each returns whether the user changed it.
namespace limpid::viewer::widgets {

/// What a number may be, and how much of it a pixel of a drag is.
struct Field {
    double speed = 0.01;
    double min = -1e12, max = 1e12;
    const char* format = "%.4g";
};

/// A tooltip for the field before.
void hint(const char* text);

bool number(const char* label, double& value, const Field& field, const char* tip = nullptr);
bool numbers(const char* label, double* values, int count, const Field& field, const char* tip = nullptr);
bool wholeNumber(const char* label, int& value, int min, int max, const char* tip = nullptr);
bool wholeNumbers(const char* label, glm::ivec2& values, int min, int max, const char* tip = nullptr);

template <int N>
bool vector(const char* label, glm::vec<N, double>& value, const Field& field, const char* tip = nullptr) {
    return numbers(label, &value[0], N, field, tip);
}

/// A section that opens and closes.
bool section(const char* label, bool open = false);

/// A line of a table of two columns, the right one aligned to the right.
void row(const std::string& left, const std::string& right);

} // namespace limpid::viewer::widgets
