// POSIX calls for an atomic replacement.
#include "brushes/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace relievo {
namespace fs = std::filesystem;
namespace {

class Descriptor {
  public:
    explicit Descriptor(int fd) : fd_(fd) {}
    ~Descriptor() {
        if (fd_ >= 0) ::close(fd_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int get() const { return fd_; }
    bool close() { return ::close(std::exchange(fd_, -1)) == 0; }

  private:
    int fd_;
};

class RemoveOnFailure {
  public:
    explicit RemoveOnFailure(const fs::path& path) : path_(path) {}
    ~RemoveOnFailure() {
        if (!done_) ::unlink(path_.c_str());
    }
    RemoveOnFailure(const RemoveOnFailure&) = delete;
    RemoveOnFailure& operator=(const RemoveOnFailure&) = delete;
    void done() { done_ = true; }

  private:
    const fs::path& path_;
    bool done_ = false;
};

[[noreturn]] void fail_write(const fs::path& path, const std::string& what) {
    throw std::invalid_argument("cannot write '" + path.string() + "': " + what);
}

[[noreturn]] void fail_errno(const fs::path& path, int error) {
    fail_write(path, std::generic_category().message(error));
}

// Where a link leads, existing or not; links are followed as often as the system would.
fs::path link_target(fs::path path) {
    std::error_code error;
    for (int depth = 0; depth < 40 && fs::is_symlink(path, error); ++depth) {
        const fs::path next = fs::read_symlink(path, error);
        path = next.is_absolute() ? next : path.parent_path() / next;
    }
    return path;
}

void write_all(const fs::path& path, int fd, std::span<const std::byte> content) {
    while (!content.empty()) {
        const ssize_t written = ::write(fd, content.data(), content.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) fail_errno(path, written < 0 ? errno : EIO);
        content = content.subspan(static_cast<std::size_t>(written));
    }
}

// Block by block where someone wants to know how far it is: the memory of the system takes a whole map at once, and then
// the file's sync would wait for the disk, for how long nobody knows.
void write_telling(const fs::path& path, int fd, std::span<const std::byte> content, const Advance& advance) {
    if (!advance) return write_all(path, fd, content);
    constexpr std::size_t kBlock = std::size_t{8} << 20;
    for (std::size_t at = 0; at < content.size(); at += kBlock) {
        tell(advance, static_cast<double>(at) / static_cast<double>(content.size()), not_written(path.string()));
        const auto block = content.subspan(at, std::min(kBlock, content.size() - at));
        write_all(path, fd, block);
        // Only for the progress, where the file system can: what it leaves is the sync's, and so are errors.
        ::sync_file_range(fd, static_cast<off64_t>(at), static_cast<off64_t>(block.size()),
                          SYNC_FILE_RANGE_WRITE | SYNC_FILE_RANGE_WAIT_AFTER);
    }
}

void sync_folder(const fs::path& path, const fs::path& folder) {
    const Descriptor fd(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    // Some file systems cannot sync folders (EINVAL); there is nothing better to do on them.
    if (fd.get() < 0 || (::fsync(fd.get()) != 0 && errno != EINVAL)) fail_errno(path, errno);
}

// To a file that has none, in the manner of mkstemp: `name` ends in XXXXXX. False where that cannot be done, and `name`
// is as it was.
bool give_name(const Descriptor& fd, std::string& name) {
    constexpr int kTries = 100;
    const std::string file = "/proc/self/fd/" + std::to_string(fd.get()), start = name.substr(0, name.size() - 6);
    for (int number = 0; number < kTries; ++number) {
        const std::string free = start + std::to_string(::getpid()) + "-" + std::to_string(number);
        if (::linkat(AT_FDCWD, file.c_str(), AT_FDCWD, free.c_str(), AT_SYMLINK_FOLLOW) == 0) {
            name = free;
            return true;
        }
        if (errno != EEXIST) return false;
    }
    return false;
}

// Beside the target, whole and synced, under a name of its own.
fs::path write_beside(const fs::path& path, const fs::path& target, const fs::path& folder, mode_t mode,
                      std::span<const std::byte> content, const Advance& advance) {
    const auto fill = [&](const Descriptor& fd) {
        if (::fchmod(fd.get(), mode) != 0) fail_errno(path, errno);
        write_telling(path, fd.get(), content, advance);
        if (::fsync(fd.get()) != 0) fail_errno(path, errno);
    };
    std::string name = (folder / ".").string() + target.filename().string() + ".XXXXXX";
    // What has no name yet goes with the program, however that ends. Not every file system knows such files.
    if (const Descriptor fd(::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600)); fd.get() >= 0) {
        fill(fd);
        if (give_name(fd, name)) return name;
    }
    Descriptor fd(::mkostemp(name.data(), O_CLOEXEC));
    if (fd.get() < 0) fail_errno(path, errno);
    const fs::path temporary = name;
    RemoveOnFailure guard(temporary);
    fill(fd);
    if (!fd.close()) fail_errno(path, errno);
    guard.done();
    return temporary;
}

}  // namespace

void write_file_atomically(const fs::path& path, std::span<const std::byte> content, const Advance& advance) {
    const fs::path target = link_target(path);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    struct stat old {};
    const bool replaces = ::stat(target.c_str(), &old) == 0;
    if (replaces && S_ISDIR(old.st_mode)) fail_write(path, "it is a folder; a file name is needed");
    if (replaces && !S_ISREG(old.st_mode)) fail_write(path, "it is no regular file");
    if (replaces && ::faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0) fail_errno(path, errno);

    const mode_t mask = ::umask(0);
    ::umask(mask);
    const fs::path temporary =
        write_beside(path, target, folder, replaces ? old.st_mode & 07777 : 0666 & ~mask, content, advance);
    RemoveOnFailure guard(temporary);
    if (::rename(temporary.c_str(), target.c_str()) != 0) fail_errno(path, errno);
    guard.done();
    sync_folder(path, folder);
}

}  // namespace relievo
