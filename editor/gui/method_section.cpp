// The side panel's section about methods: the one in use, a second one beside it, and what a ray of theirs
// does.
#include <imgui.h>

#include <algorithm>
#include <functional>
#include <string>

#include "editor/gui/panels.h"
#include "editor/gui/widgets.h"
#include "renderer/methods/registry.h"

namespace relievo::gui {
namespace {

using SetParameter = std::function<void(const std::string& name, double value)>;

std::string readable(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

void named_row(const MethodParameter& parameter, const std::string& label, std::size_t now,
               const std::function<void(double value)>& set) {
    row_label(label);
    if (ImGui::BeginCombo(("##" + label).c_str(), std::string(parameter.names[now]).c_str())) {
        for (std::size_t i = 0; i < parameter.names.size(); ++i) {
            if (ImGui::Selectable(std::string(parameter.names[i]).c_str(), i == now))
                set(static_cast<double>(i));
        }
        ImGui::EndCombo();
    }
    tooltip(parameter.tooltip, label);
}

void parameter_rows(const Method& method, const MethodChoice& choice, const SetParameter& set) {
    const auto values = resolve_parameters(method, choice.parameters);
    for (const MethodParameter& parameter : method.parameters) {
        const std::string name(parameter.name), label = readable(name);
        if (parameter.is_switch) {
            bool on = values.at(name) != 0;
            if (switch_row(label, on, parameter.tooltip)) set(name, on ? 1.0 : 0.0);
            continue;
        }
        if (!parameter.names.empty()) {
            named_row(parameter, label, static_cast<std::size_t>(values.at(name)),
                      [&](double value) { set(name, value); });
            continue;
        }
        auto value = static_cast<float>(values.at(name));
        const bool decades = parameter.low > 0 && parameter.high / parameter.low > 50;
        const Range range{static_cast<float>(parameter.low), static_cast<float>(parameter.high), decades,
                          "%.5g"};
        if (slider_row(label, value, range, parameter.tooltip, parameter.unit))
            set(name, std::clamp(static_cast<double>(value), parameter.low, parameter.high));
    }
}

void limits_row(const Method& method) {
    text_row("Limits", method.limits.substr(0, method.limits.find(": ")));
    tooltip(std::string(method.limits) + "\n\n" + std::string(method.paper), method.title);
}

void count_row(LivePicture& live) {
    row_label("Count");
    const auto now = static_cast<std::size_t>(live.count());
    const auto counts = ray_counts();
    if (ImGui::BeginCombo("##count", std::string(counts[now].name).c_str())) {
        for (std::size_t i = 0; i < counts.size(); ++i) {
            if (ImGui::Selectable(std::string(counts[i].name).c_str(), i == now))
                live.set_count(static_cast<RayCount>(i));
            tooltip(counts[i].tooltip, counts[i].name);
        }
        ImGui::EndCombo();
    }
    tooltip(counts[now].tooltip, "What the view Steps counts");
}

void second_method_rows(Desk& desk) {
    bool split = desk.live.is_split();
    if (switch_row(
            "Side by side", split,
            "Two methods over the same surface, each with its time. Drag the line between them; both go on "
            "refining while you sculpt.  (C)"))
        desk.split(split);
    if (!desk.live.is_split()) return;
    const MethodChoice choice = desk.view.second;
    const Method& method = find_method(choice.name);
    ImGui::PushID("second");
    row_label("Right");
    if (ImGui::BeginCombo("##name", std::string(method.name).c_str())) {
        for (const Method* other : methods()) {
            if (ImGui::Selectable(std::string(other->name).c_str(), other == &method))
                desk.set_second({std::string(other->name), {}});
            tooltip(other->limits, other->title);
        }
        ImGui::EndCombo();
    }
    tooltip(method.title, "Method of the right part");
    parameter_rows(method, choice, [&](const std::string& name, double value) {
        MethodChoice changed{std::string(method.name), choice.parameters};
        changed.parameters[name] = value;
        desk.set_second(changed);
    });
    limits_row(method);
    ImGui::PopID();
}

}  // namespace

void draw_method_section(Desk& desk) {
    if (!section("Method")) return;
    const MethodChoice choice = desk.session.scene().method;
    const Method& method = find_method(choice.name);
    row_label(desk.live.is_split() ? "Left" : "Name");
    method_combo(desk);
    parameter_rows(method, choice,
                   [&](const std::string& name, double value) { desk.set("method." + name, value); });
    limits_row(method);
    if (desk.live.view() == View::steps) count_row(desk.live);
    second_method_rows(desk);
    switch_row(
        "Why this pixel", desk.view.asking,
        "A click lists what happened to that pixel's ray: triangles, stretches or steps, cells, roots, and "
        "what the reference says.  (F2)");
}

}  // namespace relievo::gui
