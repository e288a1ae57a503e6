#pragma once
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/Error.h"

namespace limpid::test {

/// A folder of its own for each test, gone with the test.
class TempFolder {
  public:
    TempFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "limpid-test-XXXXXX").string();
        if (!::mkdtemp(name.data())) throw std::runtime_error("cannot make " + name);
        _path = name;
    }

    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    ~TempFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(_path, ignored);
    }

    const std::filesystem::path& path() const { return _path; }

    /// Writes a file, folders on its way included, and gives its path.
    std::filesystem::path write(const std::string& name, std::string_view content) const {
        const std::filesystem::path file = _path / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << content;
        return file;
    }

  private:
    std::filesystem::path _path;
};

/// What the InputError says that `call` throws, the temporary folder's name left out; "no error" without one.
template <typename Call>
std::string errorOf(const TempFolder& folder, Call call) {
    std::string text = "no error";
    try {
        call();
    } catch (const InputError& error) {
        text = error.what();
    }
    const std::string prefix = folder.path().string() + "/";
    for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix))
        text.erase(at, prefix.size());
    return text;
}

} // namespace limpid::test
