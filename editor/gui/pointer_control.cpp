// What the pointer does over the picture.
#include "editor/gui/pointer_control.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/gui/camera_control.h"
#include "editor/gui/picture_overlay.h"
#include "renderer/methods/registry.h"

namespace relievo::gui {
namespace {

constexpr double kZoomPerHeight = 12;   // notches for a drag over the picture's height
constexpr double kRadiusPerHeight = 4;  // powers of e
constexpr double kStrengthPerHeight = 1.5;
constexpr double kDegreesPerHeight = 360;
constexpr double kLightDegreesPerHeight = 240;

}  // namespace

void PointerControl::on_event(const InputEvent& event, const Box& picture, bool picture_free) {
    InputEvent local = event;
    local.x -= picture.x;
    local.y -= picture.y;
    picture_width_ = std::max(1, picture.width);
    picture_height_ = std::max(1, picture.height);
    const bool over = picture_free && picture.holds(event.x, event.y);
    switch (event.kind) {
        case InputEvent::Kind::press:
            // What a key has started is kept by a click anywhere.
            if ((over || desk_->view.brush_drag != BrushDrag::none) && !dragging()) on_press(local);
            break;
        case InputEvent::Kind::move:
            on_move(local);
            break;
        case InputEvent::Kind::release:
            on_release(local);
            break;
        case InputEvent::Kind::scroll:
            if (over && !stroke_.active())
                moving_camera() = zoomed(moving_camera(), event.scroll, desk_->session.scene());
            break;
        case InputEvent::Kind::key:
            break;
    }
    last_x_ = local.x;
    last_y_ = local.y;
}

void PointerControl::on_press(const InputEvent& local) {
    if (desk_->view.brush_drag != BrushDrag::none)
        return local.code == GLFW_MOUSE_BUTTON_RIGHT ? cancel() : keep_drag();
    const bool alt = local.mods & GLFW_MOD_ALT;
    drag_button_ = local.code;
    camera_before_ = camera_.value_or(desk_->session.scene().camera);
    if (local.code == GLFW_MOUSE_BUTTON_MIDDLE) {
        const bool shift = local.mods & GLFW_MOD_SHIFT, control = local.mods & GLFW_MOD_CONTROL;
        drag_ = alt || shift ? CameraDrag::pan : control ? CameraDrag::zoom : CameraDrag::orbit;
    } else if (local.code == GLFW_MOUSE_BUTTON_RIGHT && alt) {
        drag_ = CameraDrag::zoom;
    } else if (local.code == GLFW_MOUSE_BUTTON_LEFT && alt) {
        drag_ = CameraDrag::orbit;
    } else if (local.code == GLFW_MOUSE_BUTTON_LEFT && on_divider(*desk_, local.x)) {
        divider_ = true;
    } else if (local.code == GLFW_MOUSE_BUTTON_LEFT && desk_->view.asking) {
        ask(local);
    } else if (local.code == GLFW_MOUSE_BUTTON_LEFT && (local.mods & GLFW_MOD_CONTROL) &&
               desk_->session.brush().tool == Tool::clone) {
        apply_camera();
        desk_->set_clone_source(desk_->live.to_renderer_x(local.x), desk_->live.to_renderer_y(local.y));
    } else if (local.code == GLFW_MOUSE_BUTTON_LEFT) {
        apply_camera();
        const Brush brush = stroke_.brush_for(local);
        if (brush.tool == Tool::mask && brush.blur && !desk_->session.mask())
            return desk_->toasts.info("Nothing is masked yet: there is no border to blur");
        if (brush.tool == Tool::mask) tell_if_mask_is_unseen();
        desk_->attempt([&] {
            desk_->prepare_stroke(brush, [this, brush, local] {
                desk_->keep_colour(brush);
                stroke_.begin(local);
            });
        });
    }
}

void PointerControl::tell_if_mask_is_unseen() {
    const LivePicture& live = desk_->live;
    if (!live.view_shows_mask())
        desk_->toasts.info("This view does not show the mask; Beauty and Prisms do");
    else if (!live.mask_shown())
        desk_->toasts.info("The mask is hidden; M shows it");
}

// The pixel under the pointer, of the renderer that shows it.
void PointerControl::ask(const InputEvent& local) {
    apply_camera();
    LivePicture& live = desk_->live;
    Renderer& renderer = live.renderer_at(local.x);
    const bool second = &renderer != &desk_->session.renderer();
    const MethodChoice& choice = second ? desk_->view.second : desk_->session.scene().method;
    const auto pixel = [](double at, int size, int pixels) {
        return std::clamp(static_cast<int>(at / size * pixels), 0, pixels - 1);
    };
    desk_->ask_why(renderer, std::string(find_method(choice.name).name),
                   {pixel(local.x, picture_width_, renderer.width()), pixel(local.y, picture_height_, renderer.height())});
}

void PointerControl::on_move(const InputEvent& local) {
    const double dx = local.x - last_x_, dy = local.y - last_y_;
    if (divider_) return desk_->live.set_divider(local.x / picture_width_);
    if (stroke_.active()) {
        stroke_.move(local);
    } else if (drag_ != CameraDrag::none) {
        drag_camera(dx, dy);
    } else if (desk_->view.brush_drag != BrushDrag::none) {
        drag_brush(dx, dy);
    }
}

void PointerControl::on_release(const InputEvent& local) {
    if (stroke_.active() && local.code == GLFW_MOUSE_BUTTON_LEFT) stroke_.end(local);
    if (local.code == GLFW_MOUSE_BUTTON_LEFT) divider_ = false;
    if (drag_ != CameraDrag::none && local.code == drag_button_) drag_ = CameraDrag::none;
}

void PointerControl::drag_camera(double dx, double dy) {
    Camera& camera = moving_camera();
    switch (drag_) {
        case CameraDrag::orbit:
            camera = orbited(camera, dx, dy, picture_height_);
            break;
        case CameraDrag::pan:
            camera = panned(camera, dx, dy, picture_height_);
            break;
        case CameraDrag::zoom:
            camera = zoomed(camera, (dx - dy) / picture_height_ * kZoomPerHeight, desk_->session.scene());
            break;
        case CameraDrag::none:
            break;
    }
}

void PointerControl::drag_brush(double dx, double dy) {
    if (desk_->view.brush_drag == BrushDrag::light) {
        const Scene& scene = desk_->session.scene();
        if (!light_before_) light_before_ = Light{scene.lights, scene.environment.up};
        light_across_ += dx;
        light_down_ += dy;
        return;
    }
    Brush& brush = desk_->session.brush();
    if (!brush_before_) brush_before_ = Dragged{brush, desk_->session.stroke_settings()};
    const double share = dx / picture_height_;
    if (desk_->view.brush_drag == BrushDrag::radius) {
        desk_->scale_radius(std::exp(share * kRadiusPerHeight));
    } else if (desk_->view.brush_drag == BrushDrag::rotation) {
        const double degrees = static_cast<double>(brush.rotation) + share * kDegreesPerHeight;
        brush.rotation = static_cast<float>(std::remainder(degrees, 360.0));
    } else {
        const double strength = static_cast<double>(brush.strength) + share * kStrengthPerHeight;
        brush.strength = static_cast<float>(std::clamp(strength, 0.0, 1.0));
    }
}

void PointerControl::keep_drag() {
    desk_->view.brush_drag = BrushDrag::none;
    brush_before_.reset();
    light_before_.reset();
}

void PointerControl::cancel() {
    if (!stroke_.active()) desk_->view.asking = false;
    stroke_.cancel();
    if (drag_ != CameraDrag::none) {
        drag_ = CameraDrag::none;
        camera_ = camera_before_;
        apply_camera();
    }
    if (desk_->view.brush_drag == BrushDrag::none) return;
    if (brush_before_) {
        desk_->session.brush() = brush_before_->brush;
        desk_->session.stroke_settings() = brush_before_->settings;
    }
    brush_before_.reset();
    light_across_ = light_down_ = 0;
    if (light_before_) desk_->place_lights(light_before_->lights, light_before_->sky_up);
    light_before_.reset();
    desk_->view.brush_drag = BrushDrag::none;
}

Camera& PointerControl::moving_camera() {
    if (!camera_) camera_ = desk_->session.scene().camera;
    return *camera_;
}

void PointerControl::apply_camera() {
    if (camera_) desk_->set_camera(*std::exchange(camera_, std::nullopt));
}

void PointerControl::apply_moves() {
    apply_camera();
    const double degrees = kLightDegreesPerHeight / picture_height_;
    const double across = std::exchange(light_across_, 0), down = std::exchange(light_down_, 0);
    if (across != 0 || down != 0) desk_->turn_light(across * degrees, down * degrees);
}

}  // namespace relievo::gui
