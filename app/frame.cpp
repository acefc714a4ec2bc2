// frame.cpp -- what happens in one frame, in its order.
#include "app/frame.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/panels/panels.h"

namespace pelage {
namespace {

constexpr double kRest = 0.15;             // s without change until the picture converges
constexpr double kPatience = 0.25;         // s of a frame, for the error of a picture at rest
constexpr float kAccuracyHeight = 222.0f;  // of the panel, units of the design
constexpr uint kMovingLayers = 12;         // of shells cut from pictures, while the hand moves

bool asking(const App& app) {
    return app.dialogs.current != Dialog::none || !app.dialogs.problem.empty() ||
           app.work.running();
}

void useKeys(App& app, FrameKeys& keys) {
    const bool typing = ImGui::GetIO().WantTextInput;
    if (!std::exchange(keys.typing, typing) && typing) trace(app, "typing");
    app.dialogs.escape = app.dialogs.enter = false;
    for (const PressedKey& pressed : std::exchange(keys.pressed, {})) {
        const int key = pressed.key.key;
        if (key == GLFW_KEY_ESCAPE) {
            if (asking(app))
                app.dialogs.escape = true;
            else if (!cancelDrag(app)) {
                app.dialogs.help = app.dialogs.report = false;
                app.accuracy.shown = AccuracyPicture::none;
            }
            continue;
        }
        if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER) app.dialogs.enter = true;
        if (typing) continue;
        const Action* action = actionOfKey(pressed.key);
        if (action && (!pressed.repeated || action->repeats)) perform(app, *action);
    }
}

Layout layOut(App& app, float menu) {
    const Theme& theme = app.theme;
    Layout layout;
    layout.window = ImGui::GetIO().DisplaySize;
    layout.menu = menu;
    layout.status = theme.px(24);
    if (!app.panelsHidden) {
        layout.toolbar = theme.px(36);
        layout.left = theme.px(214);
        layout.right = theme.px(318);
        if (app.rig() && !app.rig()->clips.empty()) layout.timeline = theme.px(36);
        if (app.accuracy.open && app.isOpen()) layout.accuracy = theme.px(kAccuracyHeight);
    }
    Viewport& viewport = app.viewport;
    viewport.corner = {layout.left, layout.menu + layout.toolbar};
    viewport.size = {
        std::max(layout.window.x - layout.left - layout.right, 16.0f),
        std::max(layout.window.y - viewport.corner.y - layout.bottom() - layout.timeline, 16.0f)};
    return layout;
}

void drawPicture(App& app, Renderer& renderer, FrameKeys& keys, double now, bool events) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool held = ImGui::IsAnyItemActive() && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0);
    if (std::exchange(app.touched, false) || held || app.moves() ||
        app.session.camera != keys.camera)
        keys.changed = now;
    if (app.windBlows()) app.session.view.windSeconds += io.DeltaTime;
    keys.camera = app.session.camera;
    // However long this frame takes: another one comes after it.
    const bool moving = keys.moving = now - keys.changed < kRest;

    const Viewport& viewport = app.viewport;
    View view = viewAtRest(app);
    view.patience = kPatience;
    view.waits = false;
    if (moving) {
        view.detail.milliseconds = app.session.view.detail.milliseconds;
        view.samples = 1;
        for (ShellSource& source : view.maps)
            source.layers = std::min(source.layers, kMovingLayers);
    }
    view.lines = viewport.lines;
    // While the hand is on a panel, widgets answer first and the picture goes on afterwards. The
    // keys of a text field would be lost in slow frames.
    const bool busyElsewhere = !moving && ((events && io.WantCaptureMouse) || io.WantTextInput);
    if (!busyElsewhere) app.stats = renderer.draw(app.document(), view);
    if (!busyElsewhere && moving) app.movingStats = app.stats;

    const ImVec2 corner{viewport.corner.x, viewport.corner.y};
    const ImVec2 end{corner.x + viewport.size.x, corner.y + viewport.size.y};
    const auto draw = [&](unsigned texture, ImVec2 upperLeft, ImVec2 lowerRight) {
        ImGui::GetBackgroundDrawList()->AddImage((ImTextureID) static_cast<std::intptr_t>(texture),
                                                 corner, end, upperLeft, lowerRight);
    };
    if (app.accuracy.shown == AccuracyPicture::none)
        draw(renderer.texture(), {0, 1}, {1, 0});
    else
        draw(accuracyTexture(app, app.accuracy.shown), {0, 0}, {1, 1});
    if (app.stats.finished && !moving && !std::exchange(keys.ready, true)) {
        char place[96];
        std::snprintf(place, sizeof place, "ready, viewport %.0f %.0f %.0f %.0f",
                      static_cast<double>(viewport.corner.x),
                      static_cast<double>(viewport.corner.y), static_cast<double>(viewport.size.x),
                      static_cast<double>(viewport.size.y));
        trace(app, place);
    }
}

// What the hand is doing, over the picture.
void drawHint(App& app) {
    const Drag drag = app.viewport.drag;
    if (drag != Drag::radius && drag != Drag::strength) return;
    const Brush& brush = app.session.brush();
    const Hand& hand = app.session.hand;
    char text[64];
    if (drag == Drag::strength)
        std::snprintf(text, sizeof text, "Strength %.2f", static_cast<double>(brush.strength));
    else if (hand.screenRadius)
        std::snprintf(text, sizeof text, "Radius %.0f px", static_cast<double>(hand.radius));
    else
        std::snprintf(text, sizeof text, "Radius %s", lengthText(brush.radius).c_str());
    const ImVec2 size = ImGui::CalcTextSize(text);
    const float pad = app.theme.px(8);
    const ImVec2 at{app.viewport.dragStart.x + 2 * pad, app.viewport.dragStart.y + 2 * pad};
    ImDrawList& draw = *ImGui::GetForegroundDrawList();
    draw.AddRectFilled({at.x - pad, at.y - 0.6f * pad},
                       {at.x + size.x + pad, at.y + size.y + 0.6f * pad},
                       ImGui::GetColorU32(ImGuiCol_PopupBg), app.theme.px(5));
    draw.AddText(at, ImGui::GetColorU32(ImGuiCol_Text), text);
}

// In an empty window: what to do first.
void drawWelcome(App& app) {
    const Viewport& viewport = app.viewport;
    const float width = app.theme.px(340);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0, 0, 0, 0));
    beginPanel("welcome",
               {viewport.corner.x + 0.5f * (viewport.size.x - width),
                viewport.corner.y + 0.4f * viewport.size.y},
               {width, app.theme.px(150)}, ImGuiWindowFlags_NoScrollbar);
    ImGui::PopStyleColor();
    const auto centered = [&](const char* text) {
        ImGui::SetCursorPosX(0.5f * (width - ImGui::CalcTextSize(text).x));
        ImGui::TextUnformatted(text);
    };
    ImGui::PushFont(app.theme.title);
    centered("Drop a mesh here");
    ImGui::PopFont();
    ImGui::PushStyleColor(ImGuiCol_Text, color::kDim);
    centered(".glb   .gltf   .obj   .ply   .off   .stl");
    ImGui::PopStyleColor();
    ImGui::Dummy({0, app.theme.px(6)});
    const float half = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    const Ui ui{app.theme, app.tips};
    if (primaryButton(ui, "Open...", half)) perform(app, actionNamed("file.open"));
    ImGui::SameLine();
    if (plainButton(ui, "Built-in animal", half)) perform(app, actionNamed("file.animal"));
    ImGui::End();
}

}  // namespace

void beginPanel(const char* name, ImVec2 corner, ImVec2 size, ImGuiWindowFlags extra) {
    ImGui::SetNextWindowPos(corner);
    ImGui::SetNextWindowSize(size);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | extra);
    ImGui::PopStyleVar(2);
}

void drawFrame(App& app, Renderer& renderer, FrameKeys& keys, double now, bool events) {
    beginTips(app.tips);
    const Layout layout = layOut(app, drawMenu(app));
    if (!app.panelsHidden) {
        drawToolbar(app, layout);
        drawBrushPanel(app, layout);
        drawSidePanel(app, layout);
    }
    drawTimeline(app, layout);
    drawAccuracy(app, layout);
    playOn(app, ImGui::GetIO().DeltaTime);
    const bool mine = !asking(app) && !ImGui::GetIO().WantCaptureMouse;
    meetPointer(app, mine);
    usePointer(app, mine);
    useKeys(app, keys);
    if (app.isOpen() && !ImGui::IsAnyItemActive() && app.viewport.drag != Drag::axis)
        commitPending(app);
    updateLines(app);
    if (app.isOpen() && now - keys.changed >= kRest) stepPresets(app);
    if (app.isOpen()) {
        drawPicture(app, renderer, keys, now, events);
        keys.accuracyWaits = stepAccuracy(app, now - keys.changed, events);
        drawHand(app);
    } else if (!asking(app)) {
        drawWelcome(app);
    }
    drawStatus(app, layout);
    drawHint(app);
    drawHelp(app);
    drawReport(app);
    drawDialogs(app);
}

}  // namespace pelage
