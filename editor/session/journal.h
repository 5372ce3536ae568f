// The journal: JSON Lines, one header and then one operation a line (DESIGN.md section 6). It is the record
// of a session, a headless test script, and the crash-recovery log in one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "brushes/brush.h"

namespace relievo {

// Every key but the version is optional in a file that a person or a generator wrote; what is absent is not
// checked.
struct JournalHeader {
    std::string version;                        // of the program that wrote it
    std::filesystem::path scene;                // as written: relative to the journal's folder, or absolute
    std::optional<std::uint64_t> mesh_hash;     // of the edited object's base mesh (mesh_hash.h)
    std::optional<std::uint64_t> map_hash;      // HeightMap::hash() before the first operation
    std::optional<int> map_width, map_height;   // texels
    std::optional<double> midlevel, amplitude;  // before the first operation
    std::optional<std::uint64_t> undo_budget;   // bytes: replay must drop the same steps
    std::filesystem::path colour_map;           // that the session started from, as `scene`; empty: none
    std::optional<std::uint64_t> colour_hash;   // ColourMap::hash() of it
    std::filesystem::path mask;                 // likewise
    std::optional<std::uint64_t> mask_hash;     // HeightMap::hash() of it
    bool operator==(const JournalHeader&) const = default;
};

// A number, a word (the method's name) or a vector (a colour, a position, a camera).
using SetValue = std::variant<double, std::string, std::vector<double>>;

struct ImageSize {
    int width = 0, height = 0;  // pixels
    bool operator==(const ImageSize&) const = default;
};

enum class MaskCommand : std::uint8_t { clear, invert, blur };

// The image of a stroke of the stamp tool.
struct AlphaRef {
    std::filesystem::path file;  // relative to the journal's folder, or absolute
    std::uint64_t hash = 0;      // Alpha::hash()
    bool operator==(const AlphaRef&) const = default;
};

struct StrokeOp {
    Brush brush;
    std::vector<Dab> dabs;
    // Of each copy by symmetry (symmetry_copies() but the first), where it put each dab.
    std::vector<std::vector<FacePoint>> copies = {};
    std::optional<AlphaRef> alpha = std::nullopt;  // of stamp
    // Of clone: where it took each dab's relief from, for the hand and then for each copy.
    std::vector<std::vector<FacePoint>> sources = {};
    bool operator==(const StrokeOp&) const = default;
};
struct UndoOp {
    bool operator==(const UndoOp&) const = default;
};
struct RedoOp {
    bool operator==(const RedoOp&) const = default;
};
struct MaskOp {
    MaskCommand command = MaskCommand::clear;
    bool operator==(const MaskOp&) const = default;
};
struct SetOp {
    std::string key;  // settings.h
    SetValue value;
    bool operator==(const SetOp&) const = default;
};
// The procedural heights became a map of this size, which strokes go on from.
struct BakeOp {
    ImageSize size;
    bool operator==(const BakeOp&) const = default;
};
// A colour map of the displacement map's size, filled with the material's albedo, for strokes to paint.
struct ColourMapOp {
    int bits = 8;
    bool operator==(const ColourMapOp&) const = default;
};
struct ExpectOp {  // the map's hash at this point, the mask's and the colour map's
    std::uint64_t map = 0;
    std::optional<std::uint64_t> mask = std::nullopt;
    std::optional<std::uint64_t> colour = std::nullopt;
    bool operator==(const ExpectOp&) const = default;
};
struct ExpectImageOp {  // a stored PNG, relative to the journal's folder
    std::filesystem::path image;
    double tolerance = 0;  // root mean square difference of the displayed values, [0, 1]
    std::optional<int> spp;
    std::optional<ImageSize> size;
    bool operator==(const ExpectImageOp&) const = default;
};
struct RenderOp {  // writes `out`, relative to the journal's folder
    std::filesystem::path out;
    std::optional<int> spp;
    std::optional<ImageSize> size;
    bool operator==(const RenderOp&) const = default;
};
// With `map`, the record of a save that took place: replay checks the hash and writes nothing, so that
// replaying a session never overwrites an artist's files. Without, a script's order to write the map,
// relative to the journal. `colour_map`: the colour map is saved there, too, and `colour` is its hash. `mask`: of the
// mask that was saved beside the map; empty: it was not written, because it had not changed or in a script.
struct SaveOp {
    std::filesystem::path path;
    std::optional<std::uint64_t> map;
    std::filesystem::path colour_map = {};
    std::optional<std::uint64_t> colour = std::nullopt;
    std::optional<std::uint64_t> mask = std::nullopt;
    bool operator==(const SaveOp&) const = default;
};
using JournalOp = std::variant<StrokeOp, UndoOp, RedoOp, MaskOp, SetOp, BakeOp, ExpectOp, ExpectImageOp,
                               RenderOp, SaveOp, ColourMapOp>;

struct JournalEntry {
    int line = 0;  // 1-based, for messages
    JournalOp op;
};

struct Journal {
    std::filesystem::path path;
    JournalHeader header;
    std::vector<JournalEntry> entries;
    std::vector<std::string> warnings;  // a torn last line, one sentence

    // Header and operation paths are relative to the journal's folder.
    std::filesystem::path resolve(const std::filesystem::path& written) const;
};

// Throws std::invalid_argument `FILE:LINE: key: what was wrong and what would be right`. A last line that was
// cut off (the program died while writing it) is left out with a warning.
Journal read_journal(const std::filesystem::path& path);

// One line, without the newline. Numbers read back bit for bit. Throws std::invalid_argument on a path or
// word that is not UTF-8.
std::string format_header(const JournalHeader& header);
std::string format_op(const JournalOp& op);

std::span<const std::string_view> mask_commands();  // names, in the order of MaskCommand

std::string hash_text(std::uint64_t hash);  // 16 lower-case hexadecimal digits

}  // namespace relievo
