#pragma once
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <fcntl.h>
#include <unistd.h>

namespace limpid::fuzz {

/// A file in a folder of its own, in memory where the system has a place for that. Stays behind when the
/// fuzzer is killed.
class FuzzFile {
  public:
    explicit FuzzFile(const char* name) {
        const bool shared = std::filesystem::is_directory("/dev/shm");
        std::string folder = shared ? "/dev/shm/limpid-fuzz-XXXXXX" : "/tmp/limpid-fuzz-XXXXXX";
        if (!::mkdtemp(folder.data())) std::abort();
        _path = std::filesystem::path(folder) / name;
        _file = ::open(_path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
        if (_file < 0) std::abort();
    }
    ~FuzzFile() {
        ::close(_file);
        std::error_code ignored;
        std::filesystem::remove_all(_path.parent_path(), ignored);
    }
    FuzzFile(const FuzzFile&) = delete;
    FuzzFile& operator=(const FuzzFile&) = delete;

    const std::filesystem::path& write(const std::uint8_t* data, std::size_t size) {
        if (::pwrite(_file, data, size, 0) != ssize_t(size) || ::ftruncate(_file, off_t(size)) != 0)
            std::abort();
        return _path;
    }

  private:
    std::filesystem::path _path;
    int _file = -1;
};

} // namespace limpid::fuzz
