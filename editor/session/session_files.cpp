// What a session saves and exports.
#include <algorithm>
#include <stdexcept>

#include "editor/session/session_state.h"

namespace relievo {

void Session::save(const fs::path& path, const SaveWith& with, const Advance& advance) {
    State& s = *state_;
    s.require_no_stroke();
    require_map("save");
    const MapFormat named = format_of(path);
    const bool both_exr = named == MapFormat::exr_float && s.file.format == MapFormat::exr_half;
    const MapFormat format = both_exr ? MapFormat::exr_half : named;
    constexpr double kHashed = 0.1;  // part of the time, about
    const SavedHashes hashes =
        run_beside(told_to(within(advance, 0, kHashed)), [&](const WorkPart& part) { return s.hashes_of(with, part); });
    const double share = (1 - kHashed) / std::max(1, !with.colours.empty() + !with.mask.empty() + with.map);
    const double before = with.colours.empty() ? kHashed : kHashed + share;
    const double rest = with.mask.empty() ? before : before + share;
    const auto write_the_rest = [&] {
        if (!with.colours.empty()) {
            if (!s.colours.there())
                throw std::invalid_argument(with.colours.string() + ": there is no colour map to save");
            check_colour_path(with.colours);
            s.replace_file(with.colours, [&] { s.colours.save(with.colours, within(advance, kHashed, before)); });
        }
        if (!with.mask.empty())
            s.replace_file(with.mask, [&] { save_mask(mask(), with.mask, within(advance, before, rest)); });
    };
    const auto write_all = [&] {
        write_the_rest();
        const MapOrigin* origin = format == s.file.format ? s.file.origin.get() : nullptr;
        save_map(s.file.map, path, format, s.file.range, origin, within(advance, rest, 1));
    };
    with.map ? s.replace_file(path, write_all) : write_the_rest();
    s.book_save(path, with, hashes);
}

// Of large maps that takes a while.
SavedHashes Session::State::hashes_of(const SaveWith& with, const WorkPart& part) const {
    SavedHashes hashes;
    part.at(0, 0.5);
    hashes.map = file.map.hash();
    part.at(0.5, 1);
    if (!with.colours.empty() && colours.there()) hashes.colours = colours.map().hash();
    if (!with.mask.empty()) hashes.mask = mask_hash();
    return hashes;
}

bool Session::State::is_in_its_file(const fs::path& map) const {
    std::error_code ignored;
    return starts_as_file && !height_steps.unsaved() && is_own_map(map) && fs::exists(map, ignored);
}

SaveWith Session::save_with(const fs::path& map) const {
    SaveWith with{colour_path_for(map), mask_path_for(map)};
    const bool more = !with.colours.empty() || !with.mask.empty();
    with.map = !more || !state_->is_in_its_file(map);
    return with;
}

bool Session::State::is_own_map(const fs::path& map) const {
    std::error_code ignored;
    return map_path && (fs::absolute(map).lexically_normal() == map_path->lexically_normal() ||
                        fs::equivalent(map, *map_path, ignored));
}

fs::path Session::colour_path_for(const fs::path& map) const {
    const State& s = *state_;
    if (!s.colours.there()) return {};
    const fs::path& file = s.colours.file();
    if (!s.is_own_map(map) || file.empty()) return s.colours.path_beside(map);
    return s.colour_steps.unsaved() ? file : fs::path();
}

fs::path Session::mask_path_for(const fs::path& map) const {
    const State& s = *state_;
    const fs::path beside = mask_path_beside(map);
    if (s.mask_steps.unsaved()) return beside;  // one that protects nothing leaves no file, and is saved then
    if (s.is_own_map(map)) return {};
    std::error_code ignored;
    return (mask() && protects_anything(*mask())) || fs::exists(beside, ignored) ? beside : fs::path();
}

void Session::export_map(const fs::path& path, MapFormat format, MapRange range, const Advance& advance) const {
    state_->require_no_stroke();
    require_map("export");
    if (format_of(path) != format && format != MapFormat::exr_half)
        throw std::invalid_argument(path.string() +
                                    ": the extension names another format than the one that was chosen");
    state_->replace_file(path, [&] { save_map(state_->file.map, path, format, range, nullptr, advance); });
}

void Session::export_colours(const fs::path& path, const Advance& advance) const {
    state_->require_no_stroke();
    if (!state_->colours.there()) throw std::invalid_argument("there is no colour map to export");
    state_->replace_file(path, [&] { state_->colours.save(path, advance); });
}

void Session::confirm_saved(const fs::path& path, const SaveWith& with) {
    state_->book_save(path, with, state_->hashes_of(with, {}));
}

void Session::State::book_save(const fs::path& path, const SaveWith& with, const SavedHashes& hashes) {
    map_path = fs::absolute(path);
    sculptor->mark_saved();
    SaveOp op{*map_path, hashes.map};
    if (!with.colours.empty() && colours.there()) {
        colours.set_file(fs::absolute(with.colours));
        colour_steps.mark_saved();
        op.colour_map = colours.file();
        op.colour = hashes.colours;
    }
    if (!with.mask.empty()) {
        mask_steps.mark_saved();
        op.mask = hashes.mask;
    }
    if (with.map) {
        height_steps.mark_saved();
        starts_as_file = true;
    }
    if (!height_steps.unsaved() && !colour_steps.unsaved() && !mask_steps.unsaved()) steps.mark_saved();
    recorder->record(op);
}

std::optional<fs::path> Session::colour_path() const {
    const fs::path& file = state_->colours.file();
    return file.empty() ? std::nullopt : std::optional(file);
}
std::optional<fs::path> Session::map_path() const {
    return state_->map_path;
}
void Session::discard_recovery() {
    state_->recorder->discard_recovery();
}
std::string Session::journal_error() const {
    return state_->recorder->error();
}

}  // namespace relievo
