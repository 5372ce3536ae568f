// Where a session's operations are recorded: in the file that the user named, in the recovery journal, or
// both.
#include "editor/session/recorder.h"

#include <exception>

namespace relievo {
namespace fs = std::filesystem;

Recorder::Recorder(const JournalHeader& header, const fs::path& journal, bool recovery)
    : header_(header), recovery_wanted_(recovery) {
    if (journal.empty()) return;
    JournalHeader relative = header;
    const fs::path folder = fs::absolute(journal).parent_path();
    for (fs::path* written : {&relative.scene, &relative.colour_map, &relative.mask})
        if (fs::path path = written->lexically_relative(folder); !path.empty()) *written = path;
    journal_ = std::make_unique<JournalWriter>(journal, relative);
}

Recorder::~Recorder() = default;

void Recorder::record(const JournalOp& op) {
    if (journal_) journal_->append(beside_journal(op));
    if (!recovery_wanted_) return;
    waiting_.push_back(op);
    with_recovery(trouble_, [&] {
        for (const JournalOp& due : waiting_) recovery_->append(with_kept_alpha(due));
        waiting_.clear();
    });
}

void Recorder::keep_alpha(const Alpha& alpha) {
    with_recovery(alpha_trouble_,
                  [&] { kept_alphas_[alpha.hash()] = relievo::keep_alpha(recovery_->path(), alpha); });
}

// Where the image could not be kept, the journal names the user's own file.
JournalOp Recorder::with_kept_alpha(const JournalOp& op) const {
    const auto* stroke = std::get_if<StrokeOp>(&op);
    const auto kept = stroke && stroke->alpha ? kept_alphas_.find(stroke->alpha->hash) : kept_alphas_.end();
    if (kept == kept_alphas_.end()) return op;
    StrokeOp moved = *stroke;
    moved.alpha->file = kept->second;
    return moved;
}

// An image named from the journal's folder, so that both can move together.
JournalOp Recorder::beside_journal(const JournalOp& op) const {
    const auto* stroke = std::get_if<StrokeOp>(&op);
    if (!stroke || !stroke->alpha) return op;
    StrokeOp moved = *stroke;
    const fs::path folder = fs::absolute(journal_->path()).parent_path();
    if (fs::path file = moved.alpha->file.lexically_relative(folder); !file.empty()) moved.alpha->file = file;
    return moved;
}

void Recorder::keep_base(BaseFile which, const fs::path& file) {
    BaseTrouble& base = base_trouble_[which];
    if (!base.gone) with_recovery(base.text, [&] { relievo::keep_base(recovery_->path(), which, file); });
}

void Recorder::base_replaced(BaseFile which) {
    BaseTrouble& base = base_trouble_[which];
    base.gone = !base.text.empty();
}

template <typename Work>
void Recorder::with_recovery(std::string& trouble, Work work) {
    if (!recovery_wanted_) return;
    try {
        if (!recovery_) open_recovery();
        work();
        trouble.clear();
    } catch (const std::exception& error) {
        trouble = error.what();
    }
}

// Another window, or another program, may replace the scene's own file while the session goes on.
void Recorder::keep_start(const fs::path& journal, BaseFile which, const StartFile& start) {
    if (start.path.empty()) return;
    if (start.of_scene)
        link_base(journal, which, start.path);
    else
        relievo::keep_base(journal, which, start.path);
}

// A journal without the files that it must be replayed on would restore something else: there is none, then.
void Recorder::open_recovery() {
    auto fresh = std::make_unique<JournalWriter>(new_recovery_journal(header_.scene), header_);
    try {
        keep_start(fresh->path(), BaseFile::map, start_map_);
        keep_start(fresh->path(), BaseFile::colours, start_colours_);
        keep_start(fresh->path(), BaseFile::mask, start_mask_);
    } catch (...) {
        remove_recovery(fresh->path());
        throw;
    }
    recovery_ = std::move(fresh);
}

void Recorder::discard_recovery() {
    recovery_wanted_ = false;
    waiting_.clear();
    if (!recovery_) return;
    const fs::path path = recovery_->path();
    recovery_.reset();
    remove_recovery(path);
}

std::string Recorder::error() const {
    if (journal_ && !journal_->error().empty()) return journal_->error();
    if (recovery_ && !recovery_->error().empty()) return recovery_->error();
    for (const auto& [which, base] : base_trouble_)
        if (!base.text.empty()) return base.text;
    return trouble_.empty() ? alpha_trouble_ : trouble_;
}

}  // namespace relievo
