// A file browser inside the window.
#include "editor/gui/file_dialog.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "editor/gui/theme.h"
#include "editor/gui/widgets.h"

namespace relievo::gui {
namespace fs = std::filesystem;

namespace {

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

}  // namespace

void FileDialog::open(const Purpose& purpose, const fs::path& start) {
    purpose_ = purpose;
    name_ = start.filename().string();
    open_ = just_opened_ = true;
    confirm_ = false;
    std::error_code ignored;
    const fs::path folder = start.has_parent_path() ? start.parent_path() : fs::current_path(ignored);
    go_to(fs::is_directory(folder, ignored) ? folder : fs::current_path(ignored));
}

void FileDialog::go_to(const fs::path& folder) {
    std::error_code error;
    const fs::path real = fs::weakly_canonical(folder, error);
    std::vector<Entry> found;
    for (fs::directory_iterator file(real, error), end; !error && file != end; file.increment(error)) {
        std::error_code ignored;
        const Entry entry{file->path().filename().string(), file->is_directory(ignored)};
        if (entry.name.starts_with('.')) continue;
        const auto& wanted = purpose_.extensions;
        const std::string extension = lower(file->path().extension().string());
        if (entry.folder || std::find(wanted.begin(), wanted.end(), extension) != wanted.end())
            found.push_back(entry);
    }
    if (error) {
        trouble_ = folder.string() + ": " + error.message();
        return;
    }
    std::sort(found.begin(), found.end(), [](const Entry& a, const Entry& b) {
        return a.folder != b.folder ? a.folder : lower(a.name) < lower(b.name);
    });
    folder_ = real;
    entries_ = std::move(found);
    trouble_.clear();
}

fs::path FileDialog::named() const {
    const fs::path typed(name_);
    return typed.is_absolute() ? typed : folder_ / typed;
}

// The path to hand out, or a reason why not.
std::optional<fs::path> FileDialog::accept() {
    const fs::path path = named();
    std::error_code ignored;
    if (name_.empty()) {
        trouble_ = "give a name";
    } else if (fs::is_directory(path, ignored)) {
        go_to(path);
        name_.clear();
    } else if (const std::string extension = lower(path.extension().string());
               std::find(purpose_.extensions.begin(), purpose_.extensions.end(), extension) ==
               purpose_.extensions.end()) {
        trouble_ = "the name must end in " + joined(purpose_.extensions);
    } else if (!purpose_.saving && !fs::exists(path, ignored)) {
        trouble_ = "no such file";
    } else if (purpose_.saving && fs::exists(path, ignored) && !confirm_) {
        confirm_ = true;
        trouble_ = "the file exists; press again to replace it";
    } else {
        return path;
    }
    return std::nullopt;
}

void FileDialog::draw_places() {
    if (ImGui::Button("Up")) go_to(fs::path(folder_).parent_path());
    if (const char* home = std::getenv("HOME"); home && *home) {
        ImGui::SameLine();
        if (ImGui::Button("Home")) go_to(home);
    }
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    path_text(folder_.string());
}

std::optional<fs::path> FileDialog::draw_recent() {
    std::optional<fs::path> chosen;
    if (purpose_.recent.empty()) return chosen;
    ImGui::SetNextItemWidth(-1);
    if (!ImGui::BeginCombo("##recent", "Recent files")) return chosen;
    for (const fs::path& path : purpose_.recent) {
        std::error_code ignored;
        const bool there = fs::exists(path, ignored);
        const std::string whole = path.string();
        ImGui::PushID(whole.c_str());
        const std::string shown = fitting_end(whole, ImGui::GetContentRegionAvail().x, text_width);
        if (ImGui::Selectable(shown.c_str(), false, there ? 0 : ImGuiSelectableFlags_Disabled)) chosen = path;
        if (shown != whole) tooltip(whole);
        ImGui::PopID();
    }
    ImGui::EndCombo();
    return chosen;
}

void FileDialog::draw_entries(bool& accepted) {
    ImGui::PushStyleColor(ImGuiCol_ChildBg, ImGui::GetStyleColorVec4(ImGuiCol_FrameBg));
    const float room = ImGui::GetMainViewport()->Size.y - points(230);  // what stands above and below takes the rest
    ImGui::BeginChild("files", ImVec2(0, std::clamp(room, points(60), points(300))), true);
    std::optional<fs::path> enter;
    for (const Entry& entry : entries_) {
        const std::string shown = entry.folder ? entry.name + "/" : entry.name;
        if (entry.folder) ImGui::PushStyleColor(ImGuiCol_Text, kAccent);
        const bool chosen =
            ImGui::Selectable(shown.c_str(), entry.name == name_,
                              ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_DontClosePopups);
        if (entry.folder) ImGui::PopStyleColor();
        if (!chosen) continue;
        confirm_ = false;
        if (entry.folder) {
            if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) enter = folder_ / entry.name;
        } else {
            name_ = entry.name;
            accepted |= ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && !purpose_.saving;
        }
    }
    if (entries_.empty()) ImGui::TextDisabled("nothing with %s here", joined(purpose_.extensions).c_str());
    ImGui::EndChild();
    ImGui::PopStyleColor();
    if (enter) go_to(*enter);
}

std::optional<fs::path> FileDialog::draw() {
    if (!open_) return std::nullopt;
    if (just_opened_) ImGui::OpenPopup(purpose_.title);
    bool keep = true;
    if (!begin_modal(purpose_.title, 560, &keep)) {
        open_ = false;
        return std::nullopt;
    }
    bool accepted = false;
    const std::optional<fs::path> recent = draw_recent();
    draw_places();
    draw_entries(accepted);
    if (just_opened_) ImGui::SetKeyboardFocusHere();
    just_opened_ = false;
    ImGui::SetNextItemWidth(-1);
    accepted |= ImGui::InputText("##name", &name_,
                                 ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    if (ImGui::IsItemEdited()) confirm_ = false;
    note(trouble_);
    accepted |= ImGui::Button(confirm_ ? "Replace" : purpose_.accept, ImVec2(points(110), 0));
    ImGui::SameLine();
    if (ImGui::Button("Cancel", ImVec2(points(110), 0)) || escape_pressed()) keep = false;
    const std::optional<fs::path> result = recent ? recent : accepted && keep ? accept() : std::nullopt;
    if (result || !keep) {
        ImGui::CloseCurrentPopup();
        open_ = false;
    }
    ImGui::EndPopup();
    return result;
}

}  // namespace relievo::gui
