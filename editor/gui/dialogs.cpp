// The dialogs over the picture.
#include "editor/gui/dialogs.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "editor/gui/keys.h"
#include "editor/gui/theme.h"
#include "editor/gui/widgets.h"
#include "editor/session/derived_scene.h"
#include "editor/session/preferences.h"

namespace relievo::gui {
namespace {

constexpr const char* kKeysTitle = "Keys and mouse";
constexpr const char* kUnsavedTitle = "Unsaved work";
constexpr const char* kRecoveryTitle = "Recover unsaved work";

void draw_keys() {
    if (!begin_modal(kKeysTitle, 660)) return;
    // A small window scrolls them.
    const float rows = static_cast<float>(bindings().size()) * (ImGui::GetTextLineHeight() + points(4));
    const float room = ImGui::GetMainViewport()->Size.y - points(130);
    if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_ScrollY,
                          ImVec2(0, std::clamp(rows, points(80), std::max(points(80), room))))) {
        ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed);
        ImGui::TableSetupColumn("meaning", ImGuiTableColumnFlags_WidthStretch);
        for (const Binding& key : bindings()) {
            if (key.keys.empty()) continue;
            ImGui::TableNextRow();
            ImGui::TableNextColumn();
            const bool heading = key.meaning.empty();
            if (heading) ImGui::PushFont(strong_font());
            ImGui::TextUnformatted(key.keys.data(), key.keys.data() + key.keys.size());
            if (heading) ImGui::PopFont();
            ImGui::TableNextColumn();
            ImGui::PushStyleColor(ImGuiCol_Text, kTextDim);
            ImGui::PushTextWrapPos(0);
            ImGui::TextUnformatted(key.meaning.data(), key.meaning.data() + key.meaning.size());
            ImGui::PopTextWrapPos();
            ImGui::PopStyleColor();
        }
        ImGui::EndTable();
    }
    if (dialog_button("Close", true) || escape_pressed()) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

void depart(Desk& desk) {
    desk.departure = std::exchange(desk.pending, std::nullopt);
    ImGui::CloseCurrentPopup();
}

std::string age(std::filesystem::file_time_type when) {
    const auto minutes =
        std::chrono::duration_cast<std::chrono::minutes>(std::filesystem::file_time_type::clock::now() - when)
            .count();
    if (minutes < 1) return "just now";
    if (minutes < 120) return std::to_string(minutes) + " minutes ago";
    if (minutes < 48 * 60) return std::to_string(minutes / 60) + " hours ago";
    return std::to_string(minutes / (24 * 60)) + " days ago";
}

void draw_recovery(Desk& desk) {
    if (!begin_modal(kRecoveryTitle, 560)) return;
    ImGui::TextWrapped(
        "Relievo ended without saving. Its journals hold the strokes; restoring replays them.");
    ImGui::Spacing();
    std::optional<std::size_t> gone;
    for (std::size_t i = 0; i < desk.abandoned.size(); ++i) {
        const AbandonedJournal& journal = desk.abandoned[i];
        ImGui::PushID(static_cast<int>(i));
        ImGui::PushFont(strong_font());
        ImGui::TextUnformatted(scene_name(journal.scene).c_str());
        ImGui::PopFont();
        ImGui::SameLine();
        ImGui::TextDisabled("%zu unsaved edit%s, %s", journal.edits, journal.edits == 1 ? "" : "s",
                            age(journal.when).c_str());
        if (dialog_button("Restore", i == 0)) {
            desk.leave({Departure::Kind::restore, {}, journal});
            ImGui::CloseCurrentPopup();
        }
        beside_dialog_button();
        // Asked twice, and nothing is lost by a double click.
        bool& sure = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("sure"));
        if (!sure) {
            sure = dialog_button("Throw away...");
        } else {
            if (dialog_button("Keep")) sure = false;
            beside_dialog_button();
            if (dialog_button("Yes, throw away")) {
                gone = i;
                sure = false;  // the next journal takes this one's place, and its state
            }
        }
        ImGui::PopID();
        ImGui::Spacing();
    }
    if (gone) {
        remove_recovery(desk.abandoned[*gone].journal);
        desk.abandoned.erase(desk.abandoned.begin() + static_cast<std::ptrdiff_t>(*gone));
    }
    if (dialog_button("Later") || escape_pressed() || desk.abandoned.empty()) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace

FileDialog::Purpose open_purpose() {
    return {"Open a scene, a mesh or a map",
            "Open",
            {".json", ".obj", ".ply", ".off", ".png", ".tif", ".tiff", ".exr"},
            false,
            load_preferences().recent};
}

void Dialogs::open(Desk& desk, Dialog dialog) {
    const bool saves = dialog == Dialog::save_as, exports = dialog == Dialog::export_map;
    if ((saves || exports) && !desk.attempt([&] { desk.session.require_map(saves ? "save" : "export"); })) return;
    switch (dialog) {
        case Dialog::none:
            return;
        case Dialog::keys:
            return ImGui::OpenPopup(kKeysTitle);
        case Dialog::unsaved:
            return ImGui::OpenPopup(kUnsavedTitle);
        case Dialog::recovery:
            return ImGui::OpenPopup(kRecoveryTitle);
        case Dialog::open:
            files_.open(open_purpose(), desk.session.scene().path);
            break;
        case Dialog::new_map:
            return maps_.open_new(desk);
        case Dialog::export_map:
            return maps_.open_export(desk);
        case Dialog::save_picture: {
            const std::filesystem::path fresh = desk.beside_scene("-picture.png"), &last = desk.view.picture_folder;
            files_.open({"Save the picture as far as it is refined", "Save", {".png", ".exr"}, true, {}},
                        last.empty() ? fresh : last / fresh.filename());
            break;
        }
        case Dialog::exemplar: {
            const auto& source = desk.session.scene().objects.front().displacement.procedural;
            if (!source) return;
            files_.open({"Choose an exemplar", "Choose", {".png", ".tif", ".tiff", ".exr"}, false, {}}, source->exemplar);
            break;
        }
        case Dialog::alpha: {
            const auto& alpha = desk.session.alpha();
            files_.open(
                {"Choose an image for the stamp",
                 "Choose",
                 {".png", ".tif", ".tiff", ".exr", ".jpg", ".jpeg", ".tga", ".bmp", ".hdr", ".psd", ".webp"},
                 false,
                 {}},
                alpha ? alpha->path() : desk.session.scene().path);
            break;
        }
        case Dialog::export_colours: {
            if (!desk.session.colours()) return desk.toasts.info("There is no colour map yet: paint one");
            files_.open({"Export the colours", "Save", {".png", ".tif", ".tiff"}, true, {}},
                        desk.beside_scene("-colours.png"));
            break;
        }
        case Dialog::save_as: {
            after_saving_ = std::exchange(desk.pending, std::nullopt);
            files_.open({"Save the map", "Save", {".png", ".tif", ".tiff", ".exr"}, true, {}},
                        desk.session.map_path().value_or(desk.beside_scene(".tif")));
            break;
        }
    }
    file_purpose_ = dialog;
}

void Dialogs::draw_unsaved(Desk& desk) {
    if (!begin_modal(kUnsavedTitle, 560)) return;
    const auto path = desk.session.map_path();
    ImGui::TextWrapped("%s has changes that are not saved.",
                       path ? path->filename().string().c_str() : "The new map");
    note(unsaved_trouble_);
    const bool save = dialog_button("Save", true);
    beside_dialog_button();
    const bool save_as = dialog_button("Save as...") || (save && !path);
    if (save_as) {
        desk.view.wanted = Dialog::save_as;  // goes on from there
        ImGui::CloseCurrentPopup();
    } else if (save) {
        unsaved_trouble_.clear();
        ImGui::CloseCurrentPopup();
        desk.save_to(
            *path,
            [&desk] { desk.departure = std::exchange(desk.pending, std::nullopt); },
            [this, &desk](const std::string& trouble) {
                desk.view.wanted = Dialog::unsaved;
                unsaved_trouble_ = trouble;
            });
    }
    beside_dialog_button();
    if (dialog_button("Don't save")) depart(desk);
    beside_dialog_button();
    if (dialog_button("Cancel") || escape_pressed()) {
        desk.pending.reset();
        unsaved_trouble_.clear();
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

void Dialogs::draw_files(Desk& desk) {
    const bool was_open = files_.is_open();
    const auto path = files_.draw();
    if (path && file_purpose_ == Dialog::open) desk.open_file(*path);
    if (path && file_purpose_ == Dialog::save_picture) desk.save_picture(*path);
    if (path && file_purpose_ == Dialog::export_colours) desk.export_colours(*path);
    if (path && file_purpose_ == Dialog::exemplar) desk.set_exemplar(*path);
    if (path && file_purpose_ == Dialog::alpha) desk.set_alpha(*path);
    if (file_purpose_ != Dialog::save_as || !was_open || files_.is_open()) return;
    const auto waiting = std::exchange(after_saving_, std::nullopt);
    if (path) desk.save_to(*path, [&desk, waiting] { desk.departure = waiting; });
}

void Dialogs::draw(Desk& desk) {
    if (!desk.session.in_stroke()) open(desk, std::exchange(desk.view.wanted, Dialog::none));
    draw_files(desk);
    maps_.draw(desk);
    draw_keys();
    draw_unsaved(desk);
    draw_recovery(desk);
}

}  // namespace relievo::gui
