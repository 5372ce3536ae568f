// Crash recovery: every windowed session journals into the user's state folder; the next start finds what a
// killed program left there.
#include "editor/session/recovery.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>

#include "editor/session/user_folders.h"

namespace relievo {
namespace fs = std::filesystem;

namespace {

constexpr const char* kJournalExtension = ".jsonl";

// Kept files keep their extension (it names their format): NAME.base.png, NAME.colour.png and NAME.mask.png beside
// NAME.jsonl.
fs::path base_stem(const fs::path& journal, BaseFile which) {
    fs::path stem = journal;
    switch (which) {
        case BaseFile::map: return stem.replace_extension(".base");
        case BaseFile::colours: return stem.replace_extension(".colour");
        default: return stem.replace_extension(".mask");
    }
}

fs::path base_path(const fs::path& journal, BaseFile which, const fs::path& kept) {
    return base_stem(journal, which).concat(kept.extension().string());
}

// NAME.alpha-HASH.exr beside NAME.jsonl.
std::string alpha_prefix(const fs::path& journal) {
    return journal.stem().string() + ".alpha-";
}

// A writer holds a lock on its journal until its process ends, however it ends.
bool writer_lives(const fs::path& journal) {
    const int file = open(journal.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return true;  // not ours to judge
    const bool locked = flock(file, LOCK_EX | LOCK_NB) != 0;
    close(file);
    return locked;
}

std::optional<AbandonedJournal> read_abandoned(const fs::path& path) {
    if (writer_lives(path)) return std::nullopt;
    try {
        const Journal journal = read_journal(path);
        AbandonedJournal found{path,
                               journal.resolve(journal.header.scene),
                               base_of(path, BaseFile::map),
                               base_of(path, BaseFile::colours),
                               base_of(path, BaseFile::mask),
                               0,
                               fs::last_write_time(path)};
        if (found.base_mask.empty() && !journal.header.mask.empty()) found.base_mask = journal.resolve(journal.header.mask);
        for (const JournalEntry& entry : journal.entries) {
            if (std::holds_alternative<SaveOp>(entry.op)) found.edits = 0;
            found.edits += std::holds_alternative<StrokeOp>(entry.op) || std::holds_alternative<MaskOp>(entry.op) ||
                           std::holds_alternative<BakeOp>(entry.op) ||
                           std::holds_alternative<UndoOp>(entry.op) ||
                           std::holds_alternative<RedoOp>(entry.op);
        }
        if (found.edits == 0) {  // killed with nothing unsaved: there is nothing to offer
            remove_recovery(path);
            return std::nullopt;
        }
        return found;
    } catch (const std::exception&) {
        return std::nullopt;  // a damaged journal must not keep the program from starting
    }
}

}  // namespace

fs::path recovery_folder() {
    return state_folder();
}

fs::path new_recovery_journal(const fs::path& scene) {
    const fs::path folder = recovery_folder();
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        throw std::invalid_argument(folder.string() + ": cannot create the folder: " + error.message());
    const std::string stem = scene.stem().string() + "-" + std::to_string(getpid()) + "-";
    for (int count = 0;; ++count) {
        fs::path path = folder / (stem + std::to_string(count) + kJournalExtension);
        if (!fs::exists(path)) return path;
    }
}

std::vector<AbandonedJournal> find_abandoned_journals() {
    std::vector<AbandonedJournal> found;
    std::error_code error;
    for (const auto& file : fs::directory_iterator(recovery_folder(), error)) {
        if (file.path().extension() != kJournalExtension) continue;
        if (auto journal = read_abandoned(file.path())) found.push_back(std::move(*journal));
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.when > b.when; });
    return found;
}

void remove_recovery(const fs::path& journal) {
    std::error_code ignored;
    std::vector<fs::path> images;
    for (const auto& file : fs::directory_iterator(journal.parent_path(), ignored))
        if (file.path().filename().string().starts_with(alpha_prefix(journal))) images.push_back(file.path());
    for (const fs::path& image : images) fs::remove(image, ignored);
    for (const BaseFile which : {BaseFile::map, BaseFile::colours, BaseFile::mask})
        if (const fs::path base = base_of(journal, which); !base.empty()) fs::remove(base, ignored);
    fs::remove(journal, ignored);
}

bool link_base(const fs::path& journal, BaseFile which, const fs::path& kept) {
    if (!base_of(journal, which).empty()) return true;
    std::error_code error;
    const fs::path file = fs::canonical(kept, error);  // a link to a symbolic link would keep nothing
    if (!error) fs::create_hard_link(file, base_path(journal, which, kept), error);
    return !error;
}

void keep_base(const fs::path& journal, BaseFile which, const fs::path& kept) {
    if (link_base(journal, which, kept)) return;
    const fs::path base = base_path(journal, which, kept);
    std::error_code error;
    // Copied under another name first: a kill in between must not leave half a map that passes for the base.
    const fs::path partial = fs::path(base).concat(".part");
    fs::copy_file(kept, partial, fs::copy_options::overwrite_existing, error);
    if (!error) fs::rename(partial, base, error);
    if (!error) return;
    std::error_code ignored;
    fs::remove(partial, ignored);  // the journal needs the room that is left on a full disk
    throw std::runtime_error(base.string() + ": cannot keep the map for crash recovery: " + error.message());
}

fs::path keep_alpha(const fs::path& journal, const Alpha& alpha) {
    const fs::path kept = journal.parent_path() / (alpha_prefix(journal) + hash_text(alpha.hash()) + ".exr");
    if (!fs::exists(kept)) save_alpha(alpha, kept);
    return kept;
}

fs::path base_of(const fs::path& journal, BaseFile which) {
    const fs::path stem = base_stem(journal, which);
    for (const char* extension : {".png", ".tif", ".tiff", ".exr", ".PNG", ".TIF", ".TIFF", ".EXR"}) {
        const fs::path base = fs::path(stem).concat(extension);
        if (fs::exists(base)) return base;
    }
    return {};
}

}  // namespace relievo
