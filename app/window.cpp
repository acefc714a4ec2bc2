// window.cpp -- GLFW, Dear ImGui and the loop; the only owner of the App and the Renderer.
#include "app/window.h"

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "app/actions.h"
#include "app/app.h"
#include "app/frame.h"
#include "app/pen.h"
#include "core/files.h"

namespace pelage {
namespace {

constexpr double kRest = 0.15;  // s without change until the picture converges
constexpr int kLightTouchKey = GLFW_KEY_Z;

struct Window {
    GLFWwindow* handle = nullptr;
    App app;
    std::unique_ptr<Renderer> renderer;
    Pen pen;
    FrameKeys keys;
    int redraws = 0;     // frames still needed for widgets to settle
    bool events = true;  // something came since the last frame
    bool closing = false;
    double happened = 0.0;  // s, when something came last
    bool rested = false;    // nothing goes on since then (traced once)
    std::string title;
    // Window units, as the events tell it: when a slow frame is over glfwGetCursorPos is ahead.
    vec2 cursor{-1.0f};
};

Window& windowOf(GLFWwindow* handle) {
    return *static_cast<Window*>(glfwGetWindowUserPointer(handle));
}

void happened(GLFWwindow* handle) {
    windowOf(handle).events = true;
    windowOf(handle).redraws = 2;
    windowOf(handle).happened = glfwGetTime();
    windowOf(handle).rested = false;
}

// The letter or digit that the key has on the user's layout, else GLFW's name for its place.
int keyOnLayout(int key, int scancode) {
    const bool printable = key >= GLFW_KEY_SPACE && key <= GLFW_KEY_GRAVE_ACCENT;
    const char* name = printable ? glfwGetKeyName(key, scancode) : nullptr;
    if (!name || !name[0] || name[1] != '\0') return key;
    const auto letter = static_cast<unsigned char>(name[0]);
    return std::isgraph(letter) ? std::toupper(letter) : key;
}

void onKey(GLFWwindow* handle, int key, int scancode, int action, int mods) {
    happened(handle);
    Window& window = windowOf(handle);
    Viewport& viewport = window.app.viewport;
    const bool down = action != GLFW_RELEASE;
    if (key == GLFW_KEY_LEFT_SHIFT || key == GLFW_KEY_RIGHT_SHIFT) viewport.shift = down;
    if (key == GLFW_KEY_LEFT_CONTROL || key == GLFW_KEY_RIGHT_CONTROL) viewport.control = down;
    const int onLayout = keyOnLayout(key, scancode);
    if (onLayout == kLightTouchKey) viewport.light = down;
    if (!down) return;
    constexpr int kMods = GLFW_MOD_SHIFT | GLFW_MOD_CONTROL | GLFW_MOD_ALT;
    window.keys.pressed.push_back({{onLayout, mods & kMods}, action == GLFW_REPEAT});
}

PointerEvent pointerEvent(GLFWwindow* handle, PointerKind kind) {
    const auto held = [&](int left, int right) {
        return glfwGetKey(handle, left) == GLFW_PRESS || glfwGetKey(handle, right) == GLFW_PRESS;
    };
    Window& window = windowOf(handle);
    PointerEvent event{.kind = kind, .at = window.cursor};
    event.pressure = window.pen.pressure();
    event.light = window.app.viewport.light;
    event.seconds = glfwGetTime();
    event.shift = held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
    event.control = held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
    event.alt = held(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
    return event;
}

void onCursor(GLFWwindow* handle, double x, double y) {
    happened(handle);
    windowOf(handle).cursor = {static_cast<float>(x), static_cast<float>(y)};
    windowOf(handle).app.viewport.events.push_back(pointerEvent(handle, PointerKind::move));
}

void onButton(GLFWwindow* handle, int button, int action, int mods) {
    happened(handle);
    PointerEvent event =
        pointerEvent(handle, action == GLFW_PRESS ? PointerKind::press : PointerKind::release);
    event.button = button;
    event.shift = (mods & GLFW_MOD_SHIFT) != 0;
    event.control = (mods & GLFW_MOD_CONTROL) != 0;
    event.alt = (mods & GLFW_MOD_ALT) != 0;
    windowOf(handle).app.viewport.events.push_back(event);
}

void onScroll(GLFWwindow* handle, double, double y) {
    happened(handle);
    PointerEvent event = pointerEvent(handle, PointerKind::wheel);
    event.wheel = static_cast<float>(y);
    windowOf(handle).app.viewport.events.push_back(event);
}

void onDrop(GLFWwindow* handle, int count, const char** paths) {
    happened(handle);
    App& app = windowOf(handle).app;
    if (count < 1 || app.dialogs.current != Dialog::none) return;
    if (hasExtension(paths[0], kPresetExtension))
        dropPreset(app, paths[0]);
    else if (std::ranges::any_of(std::array{".png", ".jpg", ".jpeg"},
                                 [&](const char* end) { return hasExtension(paths[0], end); }))
        openShellPicture(app, paths[0], ShellRecipe::From::photo);
    else
        openFile(app, paths[0]);
}

void onClose(GLFWwindow* handle) {
    happened(handle);
    glfwSetWindowShouldClose(handle, GLFW_FALSE);
    windowOf(handle).closing = true;
}

// Callbacks of our own come first; those of Dear ImGui are chained behind them.
void listen(GLFWwindow* handle) {
    glfwSetKeyCallback(handle, onKey);
    glfwSetCursorPosCallback(handle, onCursor);
    glfwSetMouseButtonCallback(handle, onButton);
    glfwSetScrollCallback(handle, onScroll);
    glfwSetDropCallback(handle, onDrop);
    glfwSetWindowCloseCallback(handle, onClose);
    glfwSetCharCallback(handle, [](GLFWwindow* of, unsigned) { happened(of); });
    glfwSetFramebufferSizeCallback(handle, [](GLFWwindow* of, int, int) { happened(of); });
    glfwSetWindowRefreshCallback(handle, happened);
    glfwSetWindowFocusCallback(handle, [](GLFWwindow* of, int) { happened(of); });
    glfwSetCursorEnterCallback(handle, [](GLFWwindow* of, int entered) {
        happened(of);
        windowOf(of).pen.listen(entered == GLFW_TRUE);
    });
    glfwSetWindowContentScaleCallback(handle, [](GLFWwindow* of, float, float) { happened(of); });
}

// GLFW and its window for as long as this lives.
class Glfw {
public:
    explicit Glfw(const EditorOptions& options) {
        glfwSetErrorCallback([](int, const char* what) {
            std::fprintf(stderr, "pelage: window system: %s\n", what);
        });
        if (!glfwInit()) throw std::runtime_error("no display to open a window on");
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
        handle = glfwCreateWindow(options.width, options.height, "Pelage", nullptr, nullptr);
        if (!handle) {
            glfwTerminate();
            throw std::runtime_error("no window with OpenGL 4.5 core could be opened");
        }
        glfwMakeContextCurrent(handle);
        glfwSwapInterval(1);
    }
    ~Glfw() {
        glfwDestroyWindow(handle);
        glfwTerminate();
    }
    Glfw(const Glfw&) = delete;
    Glfw& operator=(const Glfw&) = delete;
    GLFWwindow* handle = nullptr;
};

// Dear ImGui and its back ends for as long as this lives.
class Widgets {
public:
    explicit Widgets(GLFWwindow* handle) {
        IMGUI_CHECKVERSION();
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;
        ImGui::GetIO().ConfigWindowsMoveFromTitleBarOnly = true;
        ImGui_ImplGlfw_InitForOpenGL(handle, true);
        ImGui_ImplOpenGL3_Init("#version 450 core");
    }
    ~Widgets() {
        ImGui_ImplOpenGL3_Shutdown();
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
    }
    Widgets(const Widgets&) = delete;
    Widgets& operator=(const Widgets&) = delete;
};

// The scale that the user asks for, in the environment or by the menu; 0 = that of the display.
float wishedScale(const App& app) {
    const char* wish = std::getenv("PELAGE_SCALE");
    const float scale = wish ? static_cast<float>(std::atof(wish)) : 0.0f;
    return scale > 0.0f ? scale : app.settings.scale;
}

// Makes fonts and style anew when the display, the settings or PELAGE_SCALE ask for another size.
void followScale(Window& window) {
    int width = 0, pixels = 0, height = 0;
    glfwGetWindowSize(window.handle, &width, &height);
    glfwGetFramebufferSize(window.handle, &pixels, &height);
    if (width <= 0 || pixels <= 0) return;
    const float ratio = static_cast<float>(pixels) / static_cast<float>(width);
    float content = 1.0f, unused = 1.0f;
    glfwGetWindowContentScale(window.handle, &content, &unused);
    App& app = window.app;
    float scale = content / ratio;
    if (const float wished = wishedScale(app); wished > 0.0f) scale = wished;
    scale = std::clamp(scale, 0.5f, 4.0f);
    const bool same = app.theme.regular && scale == app.theme.scale && ratio == app.viewport.pixels;
    if (same) return;
    app.viewport.pixels = ratio;
    app.theme = applyTheme(scale, ratio);
    glfwSetWindowSizeLimits(window.handle, static_cast<int>(940 * scale),
                            static_cast<int>(540 * scale), GLFW_DONT_CARE, GLFW_DONT_CARE);
    ImGui_ImplOpenGL3_DestroyDeviceObjects();  // the next frame makes them, with the new fonts
}

// Tells once that all that came is shown and nothing goes on by itself. Returns the seconds after
// which to ask again.
double traceRest(Window& window, double now) {
    if (window.rested) return 1e9;
    const double left = window.happened + kRest - now;
    if (left > 0.0) return left;
    window.rested = true;
    trace(window.app, "rest");
    return 1e9;
}

// Sleeps until something happens, or until something that goes on by itself needs a frame.
void awaitEvents(Window& window) {
    App& app = window.app;
    const double now = glfwGetTime();
    double wait = 1e9;
    if (window.redraws > 0 || window.closing || app.moves() || shelfBusy(app.shelf)) wait = 0.0;
    if (app.isOpen() && !app.stats.finished && !ImGui::GetIO().WantTextInput) wait = 0.0;
    if (window.keys.moving)
        wait = std::min(wait, std::max(window.keys.changed + kRest - now, 0.001));
    if (app.work.running()) wait = std::min(wait, 0.1);
    wait = std::min(wait, window.keys.accuracyWaits);
    if (app.tips.wakeAt > 0.0) wait = std::min(wait, std::max(app.tips.wakeAt - now, 0.01));
    if (ImGui::GetIO().WantTextInput) wait = std::min(wait, 0.4);  // the cursor blinks
    if (glfwGetWindowAttrib(window.handle, GLFW_ICONIFIED)) wait = std::max(wait, 0.2);
    if (wait <= 0.0 || window.keys.moving || app.work.running() || app.accuracy.tracing())
        window.rested = false;
    else if (app.trace)
        wait = std::min(wait, traceRest(window, now));
    if (wait <= 0.0)
        glfwPollEvents();
    else if (wait < 1e6)
        glfwWaitEventsTimeout(wait);
    else
        glfwWaitEvents();
}

void showTitle(Window& window) {
    const App& app = window.app;
    std::string title = app.isOpen() ? app.name + (app.saved() ? "" : "*") + " - Pelage" : "Pelage";
    if (title == window.title) return;
    glfwSetWindowTitle(window.handle, title.c_str());
    window.title = std::move(title);
}

void loop(Window& window) {
    App& app = window.app;
    while (!app.quit) {
        window.events = false;
        awaitEvents(window);
        if (window.redraws > 0 && !window.events) --window.redraws;
        try {
            app.work.collect();
        } catch (const std::exception& error) {
            complain(app, error.what());
        }
        if (window.closing && app.dialogs.current == Dialog::none && app.dialogs.problem.empty())
            requestQuit(app);
        window.closing = false;
        followScale(window);
        int width = 0, height = 0;
        glfwGetFramebufferSize(window.handle, &width, &height);
        if (width <= 0 || height <= 0) continue;

        ImGui_ImplOpenGL3_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        ImGui::NewFrame();
        drawFrame(app, *window.renderer, window.keys, glfwGetTime(), window.events);
        ImGui::Render();
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glViewport(0, 0, width, height);
        glClearColor(color::kBack.x, color::kBack.y, color::kBack.z, 1.0f);
        glClear(GL_COLOR_BUFFER_BIT);
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
        glfwSwapBuffers(window.handle);
        showTitle(window);
    }
}

// Settings, journal, and work that an earlier editor could not save.
void begin(App& app) {
    const LoadedSettings loaded = loadSettings(settingsPath());
    app.settings = loaded.settings;
    if (!loaded.warning.empty()) std::fprintf(stderr, "pelage: %s\n", loaded.warning.c_str());
    try {
        const std::string folder = journalFolder();
        app.dialogs.lost = lostWork(folder);
        app.journal = std::make_unique<Journal>(folder);
    } catch (const std::exception& error) {
        complain(app, std::string("work cannot be kept safe: ") + error.what());
    }
    for (const LostWork& lost : app.dialogs.lost)
        trace(app, "lost " + std::to_string(lost.edits) + " " + lost.document);
    if (!app.dialogs.lost.empty()) app.dialogs.current = Dialog::lostWork;
}

}  // namespace

int runEditor(const EditorOptions& options) {
    assert(firstClash().empty());
    const Glfw glfw(options);
    Window window;
    window.handle = glfw.handle;
    App& app = window.app;
    app.wake = [] { glfwPostEmptyEvent(); };
    const char* tracing = std::getenv("PELAGE_TRACE");
    app.trace = tracing && *tracing && *tracing != '0';
    glfwSetWindowUserPointer(glfw.handle, &window);
    listen(glfw.handle);
    const Widgets widgets(glfw.handle);
    window.renderer = std::make_unique<Renderer>();
    app.device = window.renderer->device();
    begin(app);
    // A wished scale is for the window as well; the display's own is GLFW's care.
    if (const float wished = wishedScale(app); wished > 0.0f)
        glfwSetWindowSize(glfw.handle, static_cast<int>(static_cast<float>(options.width) * wished),
                          static_cast<int>(static_cast<float>(options.height) * wished));
    if (options.file.empty())
        openAnimal(app);
    else
        openFile(app, options.file);
    loop(window);
    app.work.cancel();
    app.journal.reset();  // before the snapshot that it names
    dropSnapshot(app);
    return app.isOpen() ? 0 : 1;
}

}  // namespace pelage
