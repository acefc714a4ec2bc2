// measure.cpp -- pelage measure: milliseconds against error, for every way to draw hair.
#include "app/measure/measure.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <thread>

#include "app/cli/cli.h"
#include "app/cli/input.h"
#include "app/cli/measure_report.h"
#include "app/cli/picture.h"
#include "app/render/framing.h"
#include "core/files.h"

namespace pelage {
namespace {

constexpr float kYaw = 35.0f, kPitch = 12.0f;  // degrees, as of pelage render

struct Options {
    InputOptions input;
    std::string folder;
    std::vector<std::string> views, techniques;  // empty = all
    int size = 320;                              // pixels of each side
    uint samples = 256, seed = 1;
    std::size_t repeat = 5;
};

template <class Row>
std::vector<std::string> namesOf(std::span<const Row> rows) {
    std::vector<std::string> names;
    for (const Row& row : rows) names.emplace_back(row.name);
    return names;
}

// The rows of the names, in the order of the table; all of them without a name.
template <class Row>
std::vector<const Row*> chosen(std::span<const Row> rows, const std::vector<std::string>& names) {
    std::vector<const Row*> result;
    for (const Row& row : rows)
        if (names.empty() || std::ranges::count(names, row.name) > 0) result.push_back(&row);
    return result;
}

std::string today() {
    const auto now = std::chrono::system_clock::now();
    const std::chrono::year_month_day day{std::chrono::floor<std::chrono::days>(now)};
    char text[16];
    std::snprintf(text, sizeof text, "%04d-%02u-%02u", static_cast<int>(day.year()),
                  static_cast<unsigned>(day.month()), static_cast<unsigned>(day.day()));
    return text;
}

// As the system names it; empty where it does not.
std::string processorName() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name") && line.find(": ") != std::string::npos)
            return line.substr(line.find(": ") + 2);
    return "an unknown processor";
}

MeasureOptions optionsOf(const Document& document, const Options& options) {
    MeasureOptions wanted;
    wanted.size = ivec2(options.size);
    wanted.spp = options.samples;
    wanted.seed = options.seed;
    wanted.repeat = options.repeat;
    wanted.techniques = chosen(techniques(), options.techniques);
    const Camera whole =
        framedCamera(document, glm::radians(kYaw), glm::radians(kPitch), wanted.size);
    for (const Nearness* near : chosen(nearnesses(), options.views))
        wanted.eyes.push_back({near->name, zoomed(document, whole, near->share)});
    return wanted;
}

// Tells stderr what is being done, a line each, and how long it took.
class Steps {
public:
    Steps() = default;
    ~Steps() { end(); }
    Steps(const Steps&) = delete;
    Steps& operator=(const Steps&) = delete;

    void begin(const std::string& what) {
        end();
        std::fprintf(stderr, "%s", what.c_str());
        start_ = Clock::now();
    }
    void end() {
        if (!start_) return;
        const std::chrono::duration<double> time = Clock::now() - *start_;
        std::fprintf(stderr, ": %.1f s\n", time.count());
        start_.reset();
    }

private:
    using Clock = std::chrono::steady_clock;
    std::optional<Clock::time_point> start_;
};

void write(const std::string& path, const std::string& text) {
    writeFileAtomically(path, std::as_bytes(std::span(text)));
}

void measureFile(const Options& options, bool json) {
    const Document document = openInput(options.input);
    const MeasureOptions wanted = optionsOf(document, options);
    makeFolder(options.folder);
    const HeadlessContext context;
    Steps steps;
    const Measurement measurement =
        measure(document, wanted, [&](const std::string& what) { steps.begin(what); });
    steps.begin("writing the report");

    const ReportHead head{.model = stemOf(sourceName(options.input)),
                          .preset = options.input.preset,
                          .date = today(),
                          .processor = processorName(),
                          .cores = std::thread::hardware_concurrency()};
    OrderedJson report = reportJson(head, measurement);
    const std::string at = options.folder + "/report.";
    write(at + "csv", reportCsv(report));
    write(at + "json", report.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n");
    write(at + "html", reportPage(head, measurement));
    write(options.folder + "/plot.svg", reportPlot(head, measurement));
    steps.end();
    if (json) {
        report["output"] = options.folder;
        printJson(report);
        return;
    }
    print("wrote report.html, report.csv, report.json and plot.svg to " + options.folder + ": " +
          std::to_string(report["rows"].size()) +
          " pictures, views: " + std::to_string(measurement.eyes.size()) + "\n");
}

}  // namespace

void addMeasure(CLI::App& app, bool& json) {
    CLI::App* verb = app.add_subcommand("measure", "Say what each way to draw hair costs and errs");
    const auto options = std::make_shared<Options>();
    addInputOptions(*verb, options->input);
    verb->add_option("-o,--output", options->folder, "The folder to write to, made if need be")
        ->type_name("DIR")
        ->required();
    verb->add_option("--views", options->views, "Of these, all without it")
        ->type_name("close,middle,far")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->take_all()
        ->check(CLI::IsMember(namesOf(nearnesses())));
    verb->add_option("--techniques", options->techniques, "Of the table, all without it")
        ->type_name("A,B")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->take_all()
        ->check(CLI::IsMember(namesOf(techniques())));
    verb->add_option("--size", options->size, "Pixels of each side of a picture")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(16, 2048));
    verb->add_option("--spp", options->samples, "Samples of each pixel of a reference")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(2, 65536));
    verb->add_option("--seed", options->seed, "Of these samples")
        ->type_name("N")
        ->capture_default_str();
    verb->add_option("--repeat", options->repeat, "Frames that are timed for each figure, at least")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(1, 10000));
    addJsonFlag(*verb, json);
    verb->callback([options, &json] { measureFile(*options, json); });
}

}  // namespace pelage
