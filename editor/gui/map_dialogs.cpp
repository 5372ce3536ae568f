// Dialogs about map files.
#include "editor/gui/map_dialogs.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <array>
#include <cmath>
#include <stdexcept>

#include "editor/gui/theme.h"
#include "editor/gui/widgets.h"
#include "editor/session/memory_estimate.h"
#include "editor/session/text.h"

namespace relievo::gui {
namespace fs = std::filesystem;

namespace {

constexpr const char* kNewTitle = "New map";
constexpr const char* kExportTitle = "Export the map";
constexpr float kWidth = 480;

struct FormatRow {
    MapFormat format;
    const char* name;
    const char* extension;
    const char* tooltip;
};
constexpr std::array kFormats{
    FormatRow{MapFormat::png16, "PNG, 16 bit", ".png", "All 65,536 values, compressed."},
    FormatRow{MapFormat::tiff16, "TIFF, 16 bit", ".tif", "All 65,536 values; quick to save."},
    FormatRow{MapFormat::exr_float, "EXR, float", ".exr", "All values, as numbers of a range."},
    FormatRow{MapFormat::exr_half, "EXR, half float", ".exr",
              "Half as large, but it tells only some 15,000 values apart."},
};
constexpr std::array kSides{256, 512, 1024, 2048, 4096, 8192, 16384};

const FormatRow& row_of(MapFormat format) {
    for (const FormatRow& row : kFormats)
        if (row.format == format) return row;
    return kFormats.front();
}

bool is_float(MapFormat format) {
    return format == MapFormat::exr_float || format == MapFormat::exr_half;
}

void side_row(const char* label, int& side) {
    row_label(label);
    if (!ImGui::BeginCombo((std::string("##") + label).c_str(), std::to_string(side).c_str())) return;
    for (const int wanted : kSides)
        if (ImGui::Selectable(std::to_string(wanted).c_str(), wanted == side)) side = wanted;
    ImGui::EndCombo();
}

MapRange world_range(const Displacement& d) {
    return {d.amplitude * (0 - d.midlevel), d.amplitude * (1 - d.midlevel)};
}

}  // namespace

void MapDialogs::choose_name(const Desk& desk, const char* suffix) {
    const fs::path fresh = desk.beside_scene(suffix);
    const auto map = desk.session.map_path();
    name_ = (map ? map->parent_path() / fresh.filename() : fresh).string();
    ask_anew();
}

void MapDialogs::open_new(const Desk& desk) {
    fresh_.width = desk.session.map().width();
    fresh_.height = desk.session.map().height();
    choose_name(desk, (std::string("-new") + row_of(fresh_.format).extension).c_str());
    opening_new_ = true;
}

void MapDialogs::open_export(const Desk& desk) {
    choose_name(desk, (std::string("-export") + row_of(format_).extension).c_str());
    opening_export_ = true;
}

// The name's extension follows the format.
void MapDialogs::name_row(MapFormat& format) {
    row_label("Format");
    if (ImGui::BeginCombo("##format", row_of(format).name)) {
        for (const FormatRow& row : kFormats) {
            if (ImGui::Selectable(row.name, row.format == format)) {
                format = row.format;
                name_ = fs::path(name_).replace_extension(row.extension).string();
                ask_anew();
            }
            tooltip(row.tooltip, row.name);
        }
        ImGui::EndCombo();
    }
    row_label("File");
    if (path_input("##file", name_)) ask_anew();
    tooltip(name_, "File");
}

// Another file: consent to replace the last one is none to replace this one.
void MapDialogs::ask_anew() {
    confirmed_ = false;
    trouble_.clear();
}

bool MapDialogs::may_write() {
    std::error_code ignored;
    if (!fs::exists(name_, ignored) || confirmed_) return true;
    confirmed_ = true;
    trouble_ = "the file exists; press again to replace it";
    return false;
}

void MapDialogs::draw_new(Desk& desk) {
    if (!begin_modal(kNewTitle, kWidth)) return;
    side_row("Width", fresh_.width);
    side_row("Height", fresh_.height);
    name_row(fresh_.format);
    const MapMemory need = estimate_memory({fresh_.width, fresh_.height, 4, fresh_.format}, true, MapBounds::planes);
    text_row("Memory", bytes_text(need.editing + need.device) + " while it is edited, of " +
                           bytes_text(available_memory()) + " available");
    note(trouble_);
    if (dialog_button(confirmed_ ? "Replace" : "Create", true) && may_write()) {
        fresh_.path = name_;
        try {
            const fs::path scene = scene_with_new_map(desk.session.scene().path, fresh_,
                                                      desk.session.map_path().value_or(fs::path()));
            ImGui::CloseCurrentPopup();
            desk.leave({Departure::Kind::open, scene, {}});
        } catch (const std::exception& error) {
            trouble_ = error.what();
        }
    }
    beside_dialog_button();
    if (dialog_button("Cancel") || escape_pressed()) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

void MapDialogs::range_rows(const Desk& desk) {
    if (!is_float(format_)) {
        text_row("Values", "the map's own, 0 to 65535");
        return;
    }
    constexpr std::array kNames{"0 to 1", "world units: the displacement itself", "a range of your own"};
    row_label("Values");
    if (ImGui::BeginCombo("##values", kNames[static_cast<std::size_t>(values_)])) {
        for (std::size_t i = 0; i < kNames.size(); ++i)
            if (ImGui::Selectable(kNames[i], i == static_cast<std::size_t>(values_)))
                values_ = static_cast<Values>(i);
        ImGui::EndCombo();
    }
    if (values_ != Values::custom)
        range_ = values_ == Values::world ? world_range(desk.session.scene().objects.front().displacement)
                                          : MapRange{};
    ImGui::BeginDisabled(values_ != Values::custom);
    row_label("0 is written as");
    ImGui::InputDouble("##low", &range_.low, 0, 0, "%.6g");
    row_label("65535 as");
    ImGui::InputDouble("##high", &range_.high, 0, 0, "%.6g");
    ImGui::EndDisabled();
}

void MapDialogs::draw_export(Desk& desk) {
    if (!begin_modal(kExportTitle, kWidth)) return;
    name_row(format_);
    range_rows(desk);
    note(trouble_);
    const bool sound = !is_float(format_) ||
                       (std::isfinite(range_.low) && std::isfinite(range_.high) && range_.low != range_.high);
    if (dialog_button(confirmed_ ? "Replace" : "Export", true)) {
        if (!sound) {
            trouble_ = "the range must have two different, finite ends";
        } else if (may_write()) {
            ImGui::CloseCurrentPopup();
            desk.work = LongWork{
                "Exporting " + std::filesystem::path(name_).filename().string(),
                [this, &desk](const Advance& advance) { desk.session.export_map(name_, format_, range_, advance); },
                [this, &desk] { desk.toasts.info("Exported " + name_); },
                [this](const std::string& trouble) {
                    trouble_ = trouble;
                    opening_export_ = true;
                }};
        }
    }
    beside_dialog_button();
    if (dialog_button("Cancel") || escape_pressed()) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

void MapDialogs::draw(Desk& desk) {
    if (std::exchange(opening_new_, false)) ImGui::OpenPopup(kNewTitle);
    if (std::exchange(opening_export_, false)) ImGui::OpenPopup(kExportTitle);
    draw_new(desk);
    draw_export(desk);
}

}  // namespace relievo::gui
