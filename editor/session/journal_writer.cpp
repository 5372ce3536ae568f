// Appends operations to a journal file so that a killed program loses at most the stroke under way.
#include "editor/session/journal_writer.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <tuple>

namespace relievo {
namespace {

// One pwrite where the system allows it: a kill between two system calls cannot tear a line.
bool write_all(int file, const std::string& text, std::int64_t at) {
    std::size_t done = 0;
    while (done < text.size()) {
        const auto count =
            pwrite(file, text.data() + done, text.size() - done, at + static_cast<std::int64_t>(done));
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        done += static_cast<std::size_t>(count);
    }
    return true;
}

// All that `from` holds, up to `size` bytes, to `to`.
bool copy_all(int from, int to, std::int64_t size) {
    std::string part;
    for (std::int64_t at = 0; at < size; at += static_cast<std::int64_t>(part.size())) {
        part.resize(static_cast<std::size_t>(std::min<std::int64_t>(size - at, 1 << 20)));
        const auto count = pread(from, part.data(), part.size(), at);
        if (count <= 0) return false;
        part.resize(static_cast<std::size_t>(count));
        if (!write_all(to, part, at)) return false;
    }
    return true;
}

}  // namespace

JournalWriter::JournalWriter(const std::filesystem::path& path, const JournalHeader& header) : path_(path) {
    const std::string line = format_header(header) + "\n";
    file_ = open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
    if (file_ < 0)
        throw std::invalid_argument(
            path.string() + ": cannot start a journal here: " +
            (errno == EEXIST ? "the file exists; name a new one, or move it away" : std::strerror(errno)));
    flock(file_, LOCK_EX | LOCK_NB);
    if (!write_all(file_, line, 0) || fdatasync(file_) != 0) {
        const std::string reason = std::strerror(errno);
        close(file_);
        unlink(path.c_str());
        throw std::invalid_argument(path.string() + ": cannot write the journal: " + reason);
    }
    good_end_ = static_cast<std::int64_t>(line.size());
}

JournalWriter::~JournalWriter() {
    if (!pending_.empty()) write_pending();
    close(file_);
}

// The lines of a deleted file are still there until it is closed. False, and nothing is changed, where they cannot be
// written again.
bool JournalWriter::replace_deleted() {
    struct stat now {};
    if (fstat(file_, &now) != 0 || now.st_nlink > 0) return true;
    const int fresh = open(path_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
    if (fresh < 0) return false;
    flock(fresh, LOCK_EX | LOCK_NB);
    if (!copy_all(file_, fresh, good_end_) || fdatasync(fresh) != 0) {
        const int reason = errno;
        close(fresh);
        unlink(path_.c_str());
        errno = reason;
        return false;
    }
    close(file_);
    file_ = fresh;
    return true;
}

void JournalWriter::append(const JournalOp& op) {
    std::string line = format_op(op);
    const auto* set = std::get_if<SetOp>(&op);
    if (set && set->key == last_set_key_ && pending_.empty()) {
        // Written over the old line, padded to its length: at every moment the file holds one or the other.
        const auto old_size = static_cast<std::size_t>(good_end_ - last_start_ - 1);
        line.resize(std::max(line.size(), old_size), ' ');
        line += "\n";
        if (replace_deleted() && write_all(file_, line, last_start_)) {
            good_end_ = last_start_ + static_cast<std::int64_t>(line.size());
            return;
        }
        good_end_ = last_start_;
        last_set_key_.clear();
        pending_ = line;
        write_pending();
        return;
    }
    pending_ += line + "\n";
    const std::int64_t start = good_end_;
    const bool single = pending_.size() == line.size() + 1;
    if (!write_pending()) return;
    last_start_ = start;
    last_set_key_ = set && single ? set->key : std::string();
    if (!set) fdatasync(file_);
}

bool JournalWriter::write_pending() {
    if (replace_deleted() && write_all(file_, pending_, good_end_)) {
        good_end_ += static_cast<std::int64_t>(pending_.size());
        pending_.clear();
        error_.clear();
        return true;
    }
    error_ = path_.string() + ": cannot write the journal: " + std::strerror(errno) +
             "; strokes since then are not recorded yet";
    std::ignore = ftruncate(file_, good_end_);  // no torn line may stand before the next whole one
    return false;
}

}  // namespace relievo
