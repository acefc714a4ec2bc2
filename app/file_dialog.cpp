// file_dialog.cpp -- folders, filter, typed paths, recent files.
#include "app/file_dialog.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "core/files.h"

namespace pelage {
namespace {

namespace fs = std::filesystem;

std::string lowered(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

bool wanted(const FileDialog& dialog, const std::string& name) {
    return std::ranges::any_of(dialog.extensions, [&](const std::string& extension) {
        return hasExtension(name, extension);
    });
}

std::string homeFolder() {
    const char* home = std::getenv("HOME");
    return home && *home ? home : "/";
}

// What was typed, as a path: relative to the folder shown, with ~ for home.
std::string typedPath(const FileDialog& dialog) {
    fs::path path(dialog.name);
    if (dialog.name.starts_with("~/")) path = fs::path(homeFolder()) / dialog.name.substr(2);
    if (path.is_relative()) path = fs::path(dialog.folder) / path;
    return path.lexically_normal().string();
}

std::string sizeText(std::uintmax_t bytes) {
    char text[32];
    const double kb = static_cast<double>(bytes) / 1000.0;
    if (kb < 1000.0)
        std::snprintf(text, sizeof text, "%.0f kB", std::max(kb, 1.0));
    else
        std::snprintf(text, sizeof text, "%.1f MB", kb / 1000.0);
    return text;
}

// What the typed or chosen name means: a folder to enter, a file to take, or a problem to show.
FileChoice accept(FileDialog& dialog) {
    dialog.problem.clear();
    if (dialog.name.empty()) return FileChoice::open;
    std::string path = typedPath(dialog);
    std::error_code failed;
    if (fs::is_directory(path, failed)) {
        browse(dialog, path, "");
        return FileChoice::open;
    }
    if (dialog.saving && !hasExtension(path, dialog.extensions.front()))
        path += dialog.extensions.front();
    const bool exists = fs::exists(path, failed);
    if (!dialog.saving && !exists) {
        dialog.problem = "There is no file " + path;
        return FileChoice::open;
    }
    if (dialog.saving && !fs::is_directory(fs::path(path).parent_path(), failed)) {
        dialog.problem = "There is no folder " + fs::path(path).parent_path().string();
        return FileChoice::open;
    }
    if (dialog.saving && exists && !dialog.replaceAsked) {
        dialog.replaceAsked = true;
        dialog.problem = "The file exists. Press again to replace it.";
        return FileChoice::open;
    }
    dialog.name = path;
    return FileChoice::accepted;
}

// Where to go with one click.
void drawPlaces(Ui ui, FileDialog& dialog, std::span<const std::string> recent,
                FileChoice& choice) {
    const auto place = [&](const char* glyph, const std::string& label, const std::string& folder) {
        const std::string shown = std::string(ui.theme.glyph(glyph)) + "  " + label;
        if (ImGui::Selectable((shown + "##" + folder).c_str(), dialog.folder == folder))
            browse(dialog, folder, dialog.saving ? dialog.name : "");
    };
    caption(ui, "PLACES");
    place(icon::kHome, "Home", homeFolder());
    std::error_code failed;
    place(icon::kFolder, "Working folder", fs::current_path(failed).string());
    place(icon::kDisk, "Computer", "/");
    if (recent.empty()) return;
    ImGui::Dummy({0, ui.theme.px(4)});
    caption(ui, "RECENT");
    for (const std::string& path : recent) {
        const std::string label = std::string(ui.theme.glyph(icon::kRecent)) + "  " +
                                  fs::path(path).filename().string() + "##" + path;
        if (!ImGui::Selectable(label.c_str())) continue;
        if (dialog.saving) {
            browse(dialog, fs::path(path).parent_path().string(), dialog.name);
        } else {
            dialog.name = path;
            choice = accept(dialog);
        }
    }
}

void drawEntries(Ui ui, FileDialog& dialog, FileChoice& choice) {
    constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg;
    if (!ImGui::BeginTable("entries", 2, kFlags)) return;
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("size", ImGuiTableColumnFlags_WidthFixed, ui.theme.px(76));
    std::string enter;
    for (const FileDialog::Entry& entry : dialog.entries) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        const char* glyph = ui.theme.glyph(entry.folder ? icon::kFolder : icon::kBox);
        const std::string label = std::string(glyph) + "  " + entry.name;
        constexpr ImGuiSelectableFlags kRow = ImGuiSelectableFlags_SpanAllColumns |
                                              ImGuiSelectableFlags_AllowDoubleClick |
                                              ImGuiSelectableFlags_DontClosePopups;
        if (ImGui::Selectable(label.c_str(), dialog.name == entry.name, kRow)) {
            dialog.replaceAsked = false;
            if (!entry.folder) dialog.name = entry.name;
            if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) enter = entry.name;
        }
        ImGui::TableNextColumn();
        if (!entry.folder) ImGui::TextDisabled("%s", sizeText(entry.bytes).c_str());
    }
    ImGui::EndTable();
    if (enter.empty()) return;
    const std::string typed = dialog.name;
    dialog.name = enter;
    choice = accept(dialog);
    if (choice == FileChoice::open && dialog.saving) dialog.name = typed;
}

}  // namespace

void browse(FileDialog& dialog, const std::string& folder, const std::string& name) {
    dialog.entries.clear();
    dialog.problem.clear();
    dialog.replaceAsked = false;
    dialog.folder = fs::path(folder).lexically_normal().string();
    if (dialog.folder.size() > 1 && dialog.folder.ends_with('/')) dialog.folder.pop_back();
    dialog.name = name;
    std::error_code failed;
    for (fs::directory_iterator at(dialog.folder, failed), end; !failed && at != end;
         at.increment(failed)) {
        FileDialog::Entry entry{at->path().filename().string()};
        if (entry.name.starts_with('.')) continue;
        std::error_code unknown;
        entry.folder = at->is_directory(unknown);
        if (!entry.folder && (!at->is_regular_file(unknown) || !wanted(dialog, entry.name)))
            continue;
        if (!entry.folder) entry.bytes = at->file_size(unknown);
        dialog.entries.push_back(std::move(entry));
    }
    if (failed) dialog.problem = dialog.folder + ": " + failed.message();
    std::ranges::sort(dialog.entries, [](const auto& a, const auto& b) {
        if (a.folder != b.folder) return a.folder;
        return lowered(a.name) < lowered(b.name);
    });
}

FileChoice drawFileDialog(Ui ui, FileDialog& dialog, std::span<const std::string> recent,
                          bool enter, const std::function<void()>& extras) {
    FileChoice choice = FileChoice::open;
    const Theme& theme = ui.theme;
    ImGui::PushFont(theme.title);
    ImGui::TextUnformatted(dialog.title.c_str());
    ImGui::PopFont();
    if (iconButton(ui, icon::kUp, "Up", false, dialog.folder != "/"))
        browse(dialog, fs::path(dialog.folder).parent_path().string(),
               dialog.saving ? dialog.name : "");
    ImGui::SameLine();
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + theme.px(5));
    ImGui::TextDisabled("%s", dialog.folder.c_str());

    const float listHeight = theme.px(extras ? 200.0f : 300.0f);
    ImGui::BeginChild("places", {theme.px(180), listHeight}, true);
    drawPlaces(ui, dialog, recent, choice);
    ImGui::EndChild();
    ImGui::SameLine();
    ImGui::BeginChild("files", {0, listHeight}, true);
    if (choice == FileChoice::open) drawEntries(ui, dialog, choice);
    ImGui::EndChild();

    ImGui::SetNextItemWidth(-1);
    if (dialog.fresh) ImGui::SetKeyboardFocusHere();
    dialog.fresh = false;
    ImGui::InputTextWithHint(
        "##name", dialog.saving ? "File name or path" : "Type a path, or choose a file above",
        &dialog.name, ImGuiInputTextFlags_AutoSelectAll);
    if (ImGui::IsItemEdited()) dialog.replaceAsked = false;
    if (extras) extras();
    ImGui::PushStyleColor(ImGuiCol_Text, dialog.replaceAsked ? color::kAccent : color::kBad);
    ImGui::TextUnformatted(dialog.problem.empty() ? " " : dialog.problem.c_str());
    ImGui::PopStyleColor();
    const float width = theme.px(110);
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - 2 * width -
                         ImGui::GetStyle().ItemSpacing.x);
    if (plainButton(ui, "Cancel", width)) choice = FileChoice::cancelled;
    ImGui::SameLine();
    const char* label = dialog.replaceAsked ? "Replace" : dialog.accept.c_str();
    if (primaryButton(ui, label, width) || enter) choice = accept(dialog);
    return choice;
}

}  // namespace pelage
