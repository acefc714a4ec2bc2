// cli.cpp -- the parser, the exit status, and one line for whatever went wrong.
#include "app/cli/cli.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <new>

#include "app/window.h"

namespace pelage {
namespace {

constexpr int kFailed = 1, kBadUsage = 2;

// Messages may quote names from files; on the terminal they stay one line without control codes.
std::string oneLine(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    for (char& c : text) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
    }
    return text;
}

int complain(const std::string& what, int status) {
    std::fprintf(stderr, "pelage: %s\n", oneLine(what).c_str());
    return status;
}

bool haveDisplay() {
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY"}) {
        const char* value = std::getenv(name);
        if (value && *value) return true;
    }
    return false;
}

// "render ", or nothing when no verb was named.
std::string verbOf(const CLI::App& app) {
    const auto verbs = app.get_subcommands();
    return verbs.empty() ? "" : verbs.front()->get_name() + " ";
}

}  // namespace

void addJsonFlag(CLI::App& verb, bool& json) {
    verb.add_flag("--json", json, "Print one JSON object");
}

int runCommandLine(int argc, char** argv) {
    std::signal(SIGPIPE, SIG_IGN);  // a closed stdout is an error of ours, not a sudden end
    CLI::App app("Pelage, an interactive fur editor. Without a verb it opens the editor.",
                 "pelage");
    app.footer("Exit status: 0; 1 bad input or failed work; 2 bad usage. -- ends the options.");
    app.set_version_flag("--version", "pelage " PELAGE_VERSION, "Print the version");
    app.require_subcommand(0, 1);
    std::string file;
    bool json = false;
    int status = 0;  // of the editor
    CLI::Option* fileOption = app.add_option("FILE", file, "The mesh to open in the editor");
    addJsonFlag(app, json);
    addInfo(app, json);
    addRender(app, json);
    addExport(app, json);
    addCompare(app, json);
    addMeasure(app, json);
    addAnimal(app, json);
    addPreset(app, json);
    addPresets(app, json);
    addShapeError(app, json);
    addShells(app, json);
    app.final_callback([&] {
        if (!app.get_subcommands().empty()) return;
        if (haveDisplay()) {
            status = runEditor({.file = file});
        } else {
            runShowcase(file, json);
        }
    });
    app.parse_complete_callback([&] {
        const auto verbs = app.get_subcommands();
        if (!verbs.empty() && fileOption->count() > 0) {
            throw UsageError("\"" + file + "\" stands before the verb " +
                             verbs.front()->get_name());
        }
    });
    try {
        app.parse(argc, argv);
        return status;
    } catch (const CLI::Success& help) {
        app.exit(help);
        return 0;
    } catch (const CLI::ParseError& error) {
        return complain(verbOf(app) + error.what() + "; see pelage " + verbOf(app) + "--help",
                        kBadUsage);
    } catch (const UsageError& error) {
        return complain(error.what(), kBadUsage);
    } catch (const std::bad_alloc&) {
        return complain("out of memory", kFailed);
    } catch (const std::exception& error) {
        return complain(error.what(), kFailed);
    }
}

}  // namespace pelage
