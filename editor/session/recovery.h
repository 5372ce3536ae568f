// Crash recovery: every windowed session journals into the user's state folder; the next start finds what a
// killed program left there.
#pragma once

#include <filesystem>
#include <vector>

#include "brushes/alpha.h"
#include "editor/session/journal.h"

namespace relievo {

// The user's state folder (user_folders.h). Not created.
std::filesystem::path recovery_folder();

// A new file name in recovery_folder(), which it creates. Unique to this process and call.
std::filesystem::path new_recovery_journal(const std::filesystem::path& scene);

// A session that ended without being saved or discarded, and whose process is gone.
struct AbandonedJournal {
    std::filesystem::path journal;
    std::filesystem::path scene;  // absolute
    std::filesystem::path
        base_map;           // the map as it was when the session began; empty: as the scene says
    std::filesystem::path base_colours;  // the colour map, likewise
    std::filesystem::path base_mask;     // likewise; empty: none
    std::size_t edits = 0;  // strokes, undos and the like since the last save
    std::filesystem::file_time_type when;  // of the last line
};

// Newest first. Journals whose process still lives or that cannot be read are left out; those of a process
// that died with nothing unsaved are deleted.
std::vector<AbandonedJournal> find_abandoned_journals();

// Keeps a stamp's image beside the journal, so that recovery needs no file that may be gone or another by
// then. Once for each image. Returns the path of what is kept. Throws std::invalid_argument when it cannot be
// written.
std::filesystem::path keep_alpha(const std::filesystem::path& journal, const Alpha& alpha);

// Deletes a recovery journal and what was kept with it, after it was restored or declined.
void remove_recovery(const std::filesystem::path& journal);

enum class BaseFile { map, colours, mask };

// Keeps the bytes of `file` beside the journal before a save replaces them: by a hard link where the file
// system allows it, else by a copy. Does nothing when a base is kept already. Throws std::runtime_error when
// neither works.
void keep_base(const std::filesystem::path& journal, BaseFile which, const std::filesystem::path& file);

// The same where it costs nothing, by a hard link; false where that cannot be made. Programs that replace a file leave
// what is linked as it was.
bool link_base(const std::filesystem::path& journal, BaseFile which, const std::filesystem::path& file);

// The kept file; empty when there is none.
std::filesystem::path base_of(const std::filesystem::path& journal, BaseFile which);

}  // namespace relievo
