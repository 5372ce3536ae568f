// Appends operations to a journal file so that a killed program loses at most the stroke under way.
#pragma once

#include <filesystem>
#include <string>

#include "editor/session/journal.h"

namespace relievo {

// Holds an exclusive lock on its file while it lives: recovery.h tells by it whether the writer is still at
// work.
class JournalWriter {
  public:
    // Creates `path` with the header line. Throws std::invalid_argument when the file exists or cannot be
    // written: a journal is never overwritten.
    JournalWriter(const std::filesystem::path& path, const JournalHeader& header);
    ~JournalWriter();
    JournalWriter(const JournalWriter&) = delete;
    JournalWriter& operator=(const JournalWriter&) = delete;

    // Writes the line and, but for `set`, waits until the disk has it. A `set` of the key that the last line
    // set takes that line's place: dragging a slider leaves one line. Never throws for a full disk: the line
    // is kept and written with the next one; error() says so meanwhile. A file that was deleted is written anew, whole.
    void append(const JournalOp& op);

    const std::filesystem::path& path() const { return path_; }
    const std::string& error() const { return error_; }  // empty: everything is on disk

  private:
    bool write_pending();
    bool replace_deleted();

    std::filesystem::path path_;
    int file_ = -1;
    std::int64_t good_end_ = 0;    // bytes of whole lines on disk
    std::int64_t last_start_ = 0;  // where the last whole line begins
    std::string last_set_key_;     // of the last whole line; empty when it sets nothing
    std::string pending_;          // whole lines that the disk has not taken yet
    std::string error_;
};

}  // namespace relievo
