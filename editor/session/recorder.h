// Where a session's operations are recorded: in the file that the user named, in the recovery journal, or
// both.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "brushes/alpha.h"
#include "editor/session/journal_writer.h"
#include "editor/session/recovery.h"

namespace relievo {

class Recorder {
  public:
    // `header.scene` is absolute. `journal` empty: no file of the user's. The recovery journal appears with
    // the first operation. Throws std::invalid_argument when `journal` cannot be started.
    Recorder(const JournalHeader& header, const std::filesystem::path& journal, bool recovery);
    ~Recorder();

    // A file that the recovery journal is to be replayed on; empty: there is none.
    struct StartFile {
        std::filesystem::path path;
        bool of_scene = true;  // else it must be kept; the scene's own is kept where that costs nothing
    };
    void set_start_files(const StartFile& map, const StartFile& colours, const StartFile& mask) {
        start_map_ = map;
        start_colours_ = colours;
        start_mask_ = mask;
    }

    // Never throws for trouble with files: error() tells, and the session goes on. Where the recovery journal cannot be
    // started (a full disk, say), that is tried again with every operation, and none of them is missing in it then.
    void record(const JournalOp& op);
    // Call before a stroke with this image is recorded.
    void keep_alpha(const Alpha& alpha);
    // Call before a save or an export replaces a file that the session started from.
    void keep_base(BaseFile which, const std::filesystem::path& file);
    // Call when that is done. What could not be kept is gone: error() goes on telling so, because strokes from here on
    // cannot be restored.
    void base_replaced(BaseFile which);
    void discard_recovery();
    std::string error() const;

  private:
    struct BaseTrouble {
        std::string text;   // empty: none
        bool gone = false;  // replaced since
    };

    // `work` on the recovery journal, which is started first where it is wanted and not there. `trouble` says why that
    // failed, and is empty where it did not.
    template <typename Work>
    void with_recovery(std::string& trouble, Work work);
    void open_recovery();
    static void keep_start(const std::filesystem::path& journal, BaseFile which, const StartFile& start);
    JournalOp with_kept_alpha(const JournalOp& op) const;
    JournalOp beside_journal(const JournalOp& op) const;

    JournalHeader header_;
    StartFile start_map_, start_colours_, start_mask_;
    std::map<std::uint64_t, std::filesystem::path> kept_alphas_;  // beside the recovery journal, by hash
    std::vector<JournalOp> waiting_;  // for the recovery journal to be started
    bool recovery_wanted_;
    std::unique_ptr<JournalWriter> journal_, recovery_;
    std::string trouble_, alpha_trouble_;
    std::map<BaseFile, BaseTrouble> base_trouble_;
};

}  // namespace relievo
