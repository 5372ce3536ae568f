// Replays a journal through the session's commands.
#include "editor/session/replay.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "editor/session/mesh_hash.h"
#include "editor/session/render_output.h"
#include "editor/session/session_mask.h"
#include "editor/session/text.h"
#include "editor/session/view_window.h"

namespace relievo {
namespace fs = std::filesystem;

namespace {

// Hashes first, then the values that the record started from: the scene file may say others by now.
void check_start(const Journal& journal, Session& session, bool force) {
    const JournalHeader& header = journal.header;
    const std::string where = journal.path.string() + ":1: ";
    const HeightMap& map = session.map();
    const auto require = [&](bool same, const std::string& key, const std::string& difference) {
        if (!same && !force)
            throw std::invalid_argument(where + key + ": " + difference +
                                        "; give the scene or map it was recorded on, or --force");
    };
    const auto size = [](int width, int height) {
        return std::to_string(width) + "x" + std::to_string(height);
    };
    if (header.map_width)
        require(map.width() == *header.map_width && map.height() == *header.map_height, "map_size",
                "recorded on a map of " + size(*header.map_width, *header.map_height) +
                    " texels, this one has " + size(map.width(), map.height()));
    if (header.mesh_hash) {
        const std::uint64_t mesh = mesh_hash(session.scene().objects.front().mesh);
        require(mesh == *header.mesh_hash, "mesh_hash",
                "recorded on mesh " + hash_text(*header.mesh_hash) + ", " +
                    session.scene().objects.front().mesh_path.string() + " is " + hash_text(mesh));
    }
    if (header.map_hash) {
        const std::uint64_t hash = map.hash();
        require(hash == *header.map_hash, "map_hash",
                "recorded on map " + hash_text(*header.map_hash) + ", this one is " + hash_text(hash));
    }
    if (header.colour_hash) {
        const std::string wanted = "recorded on colour map " + hash_text(*header.colour_hash) +
                                   (header.colour_map.empty() ? "" : " (" + header.colour_map.string() + ")");
        const ColourMap* colours = session.colours();
        const std::uint64_t hash = colours ? colours->hash() : 0;
        require(colours && hash == *header.colour_hash, "colour_hash",
                wanted + (colours ? ", this one is " + hash_text(hash) : ", this scene has none"));
    }
    if (header.mask_hash) {
        const std::uint64_t hash = session.mask_hash();
        require(hash == *header.mask_hash, "mask_hash",
                "recorded with mask " + hash_text(*header.mask_hash) +
                    (header.mask.empty() ? "" : " (" + header.mask.string() + ")") + ", this one is " + hash_text(hash));
    }
    const Displacement& displacement = session.scene().objects.front().displacement;
    if (header.amplitude && *header.amplitude != displacement.amplitude)
        session.set("amplitude", *header.amplitude);
    if (header.midlevel && *header.midlevel != displacement.midlevel)
        session.set("midlevel", *header.midlevel);
}

class Replayer {
  public:
    Replayer(const Journal& journal, Session& session, const ReplayOptions& options)
        : journal_(journal), session_(session), options_(options) {}

    ReplayReport run() {
        check_start(journal_, session_, options_.force);
        load_alphas();
        std::size_t dabs = 0;
        for (const JournalEntry& entry : journal_.entries)
            if (const auto* stroke = std::get_if<StrokeOp>(&entry.op)) dabs += stroke->dabs.size();
        dabs_per_trace_ = std::max<std::size_t>(1, (dabs + kLiveTraces - 1) / kLiveTraces);
        for (std::size_t i = 0; i < journal_.entries.size(); ++i) {
            if (options_.progress) options_.progress(i, journal_.entries.size());
            line_ = journal_.entries[i].line;
            std::visit(*this, journal_.entries[i].op);
        }
        if (options_.progress) options_.progress(journal_.entries.size(), journal_.entries.size());
        return std::move(report_);
    }

    void operator()(const StrokeOp& op) {
        const std::uint32_t faces = session_.surface().face_count();
        for (std::size_t i = 0; i < op.dabs.size(); ++i)
            if (op.dabs[i].face >= faces)
                fail("dabs[" + std::to_string(i) + "][1]: is " + std::to_string(op.dabs[i].face) +
                     ", the mesh has " + std::to_string(faces) + " faces, counted from 0");
        if (session_.procedural(0)) fail("stroke: the heights are procedural; a bake comes first");
        check_points("copies", op.copies, faces);
        check_points("sources", op.sources, faces);
        session_.brush() = op.brush;
        if (op.alpha) session_.set_alpha(alphas_.at(journal_.resolve(op.alpha->file)));
        if (!op.sources.empty())
            session_.set_clone_source(op.dabs.empty() ? FacePoint() : op.sources.front().front());
        try {
            session_.begin_stroke();
        } catch (const std::invalid_argument& error) {
            fail(error.what());
        }
        std::vector<FacePoint> copies(op.copies.size()), sources(op.sources.size());
        for (std::size_t k = 0; k < op.dabs.size(); ++k) {
            for (std::size_t i = 0; i < copies.size(); ++i) copies[i] = op.copies[i][k];
            for (std::size_t i = 0; i < sources.size(); ++i) sources[i] = op.sources[i][k];
            session_.dab(op.dabs[k], copies, sources);
            session_.show_edits();
            if (options_.live && report_.dab_times.size() % dabs_per_trace_ == 0) trace_around_dab();
            report_.dab_times.push_back(session_.times());
        }
        session_.end_stroke();
        ++report_.strokes;
        report_.dabs += op.dabs.size();
    }

    void operator()(const UndoOp&) {
        if (!session_.undo()) fail("undo: there is nothing to undo");
    }
    void operator()(const RedoOp&) {
        if (!session_.redo()) fail("redo: there is nothing to redo");
    }

    void operator()(const MaskOp& op) { session_.change_mask(op.command); }

    void operator()(const SetOp& op) {
        try {
            session_.set(op.key, op.value);
        } catch (const std::invalid_argument& error) {
            fail(error.what());
        }
    }

    void operator()(const BakeOp& op) {
        try {
            session_.bake(op.size);
        } catch (const std::invalid_argument& error) {
            fail(error.what());
        }
    }

    void operator()(const ColourMapOp& op) {
        try {
            session_.make_colours(op.bits);
        } catch (const std::invalid_argument& error) {
            fail(std::string("colour_map: ") + error.what());
        }
    }

    void operator()(const ExpectOp& op) {
        ++report_.expectations;
        const std::uint64_t got = session_.map().hash();
        if (got != op.map)
            report_.failures.push_back(where() + "expect: the map should be " + hash_text(op.map) +
                                       ", it is " + hash_text(got));
        if (op.colour) expect_colours("expect", *op.colour);
        if (op.mask) expect_mask("expect", *op.mask);
    }

    void operator()(const ExpectImageOp& op) {
        ++report_.expectations;
        const DisplayPicture wanted = read_display_picture(journal_.resolve(op.image));
        const DisplayPicture got =
            picture(op.spp, op.size ? op.size : ImageSize{wanted.width, wanted.height});
        const PictureDifference difference = compare_pictures(wanted, got);
        if (difference.rmse <= op.tolerance) return;
        const fs::path folder =
            options_.failed_pictures.empty() ? fs::temp_directory_path() : options_.failed_pictures;
        const fs::path kept = folder / (op.image.stem().string() + ".got.png");
        write_png(kept, got);
        report_.failures.push_back(
            where() + "expect_image: differs from " + op.image.string() + " by rmse " +
            number_text(difference.rmse) + ", more than " + number_text(op.tolerance) + " (most, " +
            number_text(difference.largest) + ", at pixel " + std::to_string(difference.worst_x) + "," +
            std::to_string(difference.worst_y) + "); the picture got is " + kept.string());
    }

    void operator()(const RenderOp& op) {
        const fs::path out = journal_.resolve(op.out);
        check_render_output(out, {});
        with_size(op.size, [&] {
            render_samples(session_.renderer(), spp(op.spp));
            write_render(session_.renderer(), out, {});
        });
    }

    void operator()(const SaveOp& op) {
        const fs::path path = journal_.resolve(op.path);
        const fs::path colour_path = op.colour_map.empty() ? fs::path() : journal_.resolve(op.colour_map);
        if (!op.map) {
            if (!colour_path.empty() && !session_.colours())
                fail("save: colour_map: there is no colour map to save");
            return session_.save(path, {colour_path});
        }
        const std::uint64_t got = session_.map().hash();
        const bool right_colours = !op.colour || expect_colours("save", *op.colour);
        const bool right_mask = !op.mask || expect_mask("save", *op.mask);
        const SaveWith with{colour_path, op.mask ? mask_path_beside(path) : fs::path()};
        if (got == *op.map) return right_colours && right_mask ? session_.confirm_saved(path, with) : void();
        ++report_.expectations;
        report_.failures.push_back(where() + "save: the map saved then was " + hash_text(*op.map) +
                                   ", it is " + hash_text(got));
    }

  private:
    bool expect_colours(const char* what, std::uint64_t wanted) {
        const ColourMap* colours = session_.colours();
        const std::string got = colours ? hash_text(colours->hash()) : "not there";
        if (got == hash_text(wanted)) return true;
        report_.failures.push_back(where() + what + ": the colour map should be " + hash_text(wanted) +
                                   ", it is " + got);
        return false;
    }

    bool expect_mask(const char* what, std::uint64_t wanted) {
        const std::uint64_t got = session_.mask_hash();
        if (got != wanted)
            report_.failures.push_back(where() + what + ": the mask should be " + hash_text(wanted) + ", it is " +
                                       hash_text(got));
        return got == wanted;
    }

    std::string where() const { return journal_.path.string() + ":" + std::to_string(line_) + ": "; }
    [[noreturn]] void fail(const std::string& what) const { throw std::invalid_argument(where() + what); }

    // All of them before the first operation: an image that is missing leaves nothing half done.
    void load_alphas() {
        for (const JournalEntry& entry : journal_.entries) {
            const auto* stroke = std::get_if<StrokeOp>(&entry.op);
            if (!stroke || !stroke->alpha) continue;
            line_ = entry.line;
            const fs::path path = journal_.resolve(stroke->alpha->file);
            std::shared_ptr<const Alpha>& alpha = alphas_[path];
            try {
                if (!alpha) alpha = load_alpha(path);
            } catch (const std::invalid_argument& error) {
                fail(error.what());
            }
            if (alpha->hash() != stroke->alpha->hash && !options_.force)
                fail("alpha '" + path.string() + "': the image has changed: recorded with " +
                     hash_text(stroke->alpha->hash) + ", it is " + hash_text(alpha->hash()) +
                     "; put the recorded image back, or give --force");
        }
    }

    void check_points(const std::string& key, const std::vector<std::vector<FacePoint>>& lists,
                      std::uint32_t faces) const {
        for (std::size_t i = 0; i < lists.size(); ++i)
            for (const FacePoint& point : lists[i])
                if (point.face >= faces)
                    fail(key + "[" + std::to_string(i) + "]: names face " + std::to_string(point.face) +
                         ", the mesh has " + std::to_string(faces) + " faces, counted from 0");
    }

    int spp(const std::optional<int>& given) const {
        return given ? *given : options_.spp > 0 ? options_.spp : session_.scene().image.spp;
    }

    void trace_around_dab() {
        const auto touched = session_.last_dab();
        const Renderer& renderer = session_.renderer();
        const auto centre = project(session_.scene().camera, session_.scene().origin, renderer.width(),
                                    renderer.height(), touched->centre);
        if (centre) session_.trace(window_around(*centre, kLiveWindow, renderer.width(), renderer.height()));
    }

    template <typename Draw>
    void with_size(const std::optional<ImageSize>& size, Draw draw) {
        Renderer& renderer = session_.renderer();
        const ImageSize before{renderer.width(), renderer.height()};
        const bool resized = size && *size != before;
        if (resized) renderer.resize(size->width, size->height);
        draw();
        if (resized) renderer.resize(before.width, before.height);
    }

    DisplayPicture picture(const std::optional<int>& samples, const std::optional<ImageSize>& size) {
        DisplayPicture result;
        with_size(size, [&] {
            render_samples(session_.renderer(), spp(samples));
            result = display_picture(session_.renderer());
        });
        return result;
    }

    const Journal& journal_;
    Session& session_;
    const ReplayOptions& options_;
    ReplayReport report_;
    std::map<fs::path, std::shared_ptr<const Alpha>> alphas_;
    std::size_t dabs_per_trace_ = 1;
    int line_ = 0;
};

}  // namespace

bool needs_renderer(const Journal& journal) {
    return std::any_of(journal.entries.begin(), journal.entries.end(), [](const JournalEntry& entry) {
        return std::holds_alternative<RenderOp>(entry.op) || std::holds_alternative<ExpectImageOp>(entry.op);
    });
}

ReplayReport replay(const Journal& journal, Session& session, const ReplayOptions& options) {
    return Replayer(journal, session, options).run();
}

std::vector<StageSummary> summarize(const std::vector<StageTimes>& times) {
    const std::pair<const char*, double StageTimes::*> stages[] = {{"edit", &StageTimes::edit_ms},
                                                                   {"upload", &StageTimes::upload_ms},
                                                                   {"bounds", &StageTimes::bounds_ms},
                                                                   {"refit", &StageTimes::refit_ms},
                                                                   {"trace", &StageTimes::trace_ms}};
    std::vector<StageSummary> summaries;
    for (const auto& [name, stage] : stages) {
        std::vector<double> values;
        for (const StageTimes& time : times)
            if (time.*stage > 0) values.push_back(time.*stage);
        std::sort(values.begin(), values.end());
        StageSummary summary{name, 0, 0, 0, values.size()};
        if (!values.empty()) {
            summary.median_ms = values[values.size() / 2];
            summary.p95_ms = values[(values.size() * 95) / 100];
            summary.max_ms = values.back();
        }
        summaries.push_back(summary);
    }
    return summaries;
}

}  // namespace relievo
