// view_actions.cpp -- framing, overlays, text size.
#include "app/view_actions.h"

#include <algorithm>

#include "app/app.h"

namespace pelage {

void frameAnimal(App& app) {
    frameAll(app.session, app.skin(), app.viewport.size.x / std::max(app.viewport.size.y, 1.0f));
}

void nextOverlay(App& app) {
    constexpr int kOverlays = static_cast<int>(Overlay::segment) + 1;
    Overlay& overlay = app.session.view.overlay;
    overlay = static_cast<Overlay>((static_cast<int>(overlay) + 1) % kOverlays);
}

void paintSegments(App& app) {
    takeTool(app, Tool::segment);
    app.session.view.overlay = Overlay::segment;
}

void flipAccuracy(App& app) {
    const bool reference = app.accuracy.shown == AccuracyPicture::reference;
    showAccuracy(app, reference ? AccuracyPicture::live : AccuracyPicture::reference);
}

void scaleText(App& app, float factor) {
    app.settings.scale = factor == 0.0f ? 0.0f : std::clamp(app.theme.scale * factor, 0.5f, 4.0f);
    try {
        saveSettings(app.settings, settingsPath());
    } catch (const std::exception& error) {
        tell(app, error.what());
    }
}

}  // namespace pelage
