// SPDX-License-Identifier: GPL-3.0-or-later
// study: the paper's curves on a program, and the choice of region size and period.
#include "app/cli/study_command.h"

#include <algorithm>
#include <cstdio>
#include <fmt/core.h>
#include <optional>
#include <utility>
#include <vector>

#include "app/cli/load_program.h"
#include "app/cli/report.h"
#include "app/cli/setup_options.h"
#include "app/cli/study_files.h"
#include "app/cli/study_optimise.h"
#include "app/cli/thread_limit.h"
#include "core/simulation/run/finding_log.h"
#include "core/simulation/setup/tool_choice.h"
#include "core/study/figures.h"

namespace proveout::cli {

namespace {

struct StudyOptions {
    SetupOptions setup;
    ThreadLimit threads;
    std::string sweep;
    std::string out = ".";
    bool optimise = false;
    bool exhaustive = false;
    std::optional<int> repeats;
    std::size_t drawEvery = 1;
    std::optional<double> trianglesPerSecond;
    std::string picture = "1280x800";
    bool json = false;
    StudyEquipment equipment;
};

constexpr int kCheckingRuns = 3; ///< for the choice, and for the given parameters
constexpr int kSmallestPicture = 16;
constexpr int kLargestPicture = 8192;

struct PictureSize {
    int width = 0;
    int height = 0;
};

/// Zeros if the text is not a size.
PictureSize pictureSize(const std::string& text) {
    PictureSize size;
    char rest = '\0';
    if (std::sscanf(text.c_str(), "%5dx%5d%c", &size.width, &size.height, &rest) != 2 ||
        std::min(size.width, size.height) < kSmallestPicture ||
        std::max(size.width, size.height) > kLargestPicture)
        return {};
    return size;
}

std::string checkPicture(const std::string& text) {
    if (pictureSize(text).width > 0)
        return {};
    return fmt::format("{} is not a size WxH from {} to {} pixels", text, kSmallestPicture, kLargestPicture);
}

std::string timeLabel(const StudyOptions& options) {
    if (options.trianglesPerSecond)
        return fmt::format("Rendering time at {:g} million triangles/s", *options.trianglesPerSecond / 1e6);
    return options.equipment.renderer ? "Rendering time" : "Cutting and decimation time";
}

/// One run of the command.
class Study {
public:
    explicit Study(const StudyOptions& options)
        : m_options(options), m_report(options.setup.subject()), m_files(options.out, options.equipment) {}

    ExitCode run() {
        if (auto done = work(); !done)
            m_report.addFatal(std::move(done.error()));
        if (m_options.json) {
            m_json["files"] = m_files.names();
            m_json["findings"] = m_report.findings();
            m_json["unverified"] = m_report.unverified();
            printJson(m_json);
        }
        return m_report.exitCode();
    }

private:
    Result<void> work() {
        if (auto ready = prepare(); !ready)
            return ready;
        if (m_job.program->blockCount() == 0)
            return {}; // the error was reported already
        if (m_options.optimise)
            return optimise();
        if (auto made = m_files.prepare(); !made)
            return made;
        for (const StudyVariant& variant : variants())
            if (auto swept = sweep(variant); !swept)
                return swept;
        return {};
    }

    Result<void> prepare() {
        auto job = m_options.setup.job();
        if (!job)
            return tl::unexpected(std::move(job.error()));
        m_report.add(job->warnings);
        const bool given = !job->setup.automaticGrid;
        if (auto fits = given ? m_options.setup.checkGrid(*job, {}) : Result<void>(); !fits)
            return fits;
        auto program = loadProgram(*job, m_report);
        if (!program)
            return tl::unexpected(std::move(program.error()));
        SetupOptions::settleGrid(*job, **program, {});
        if (auto fits = given ? Result<void>() : m_options.setup.checkGrid(*job, {}); !fits)
            return fits;
        // Without its tools the program cuts nothing, and the curves would not describe it.
        m_report.add(FindingLog().diagnostics(**program, ToolChoice(**program, job->setup)));
        m_base = job->parameters;
        m_job = {std::move(*program), std::make_shared<const Setup>(job->setup)};
        return makeDrawing();
    }

    Result<void> makeDrawing() {
        if (m_options.trianglesPerSecond) {
            m_drawing = std::make_unique<RatedDrawing>(*m_options.trianglesPerSecond);
        } else if (m_options.optimise && !m_options.equipment.renderer) {
            m_drawing = std::make_unique<RatedDrawing>(); // without a drawing cost, decimation never pays off
        } else if (m_options.equipment.renderer) {
            const auto [width, height] = pictureSize(m_options.picture);
            auto drawing = m_options.equipment.renderer(width, height);
            if (!drawing)
                return tl::unexpected(std::move(drawing.error()));
            m_drawing = std::move(*drawing);
        }
        return {};
    }

    Result<void> optimise() {
        const SweepOptions measuring{
            m_drawing.get(), m_options.drawEvery, m_options.repeats.value_or(kCheckingRuns), {}};
        const auto optimised = Optimised::of(m_job, m_base, measuring, m_options.exhaustive);
        if (!optimised)
            return tl::unexpected(optimised.error());
        if (m_options.json)
            m_json = optimised->json();
        else
            optimised->print();
        return {};
    }

    /// The requested method, or all of them; the other given options apply to each.
    [[nodiscard]] std::vector<StudyVariant> variants() const {
        const DecimationOptions& given = m_options.setup.decimation();
        if (given.given("method"))
            return {{kMethodChoices[static_cast<std::size_t>(m_base.method)].key, m_base}};
        std::vector<StudyVariant> all = studyVariants(m_base);
        for (StudyVariant& variant : all)
            given.apply(variant.base, {.region = true, .period = true}, 0);
        return all;
    }

    [[nodiscard]] std::vector<SweepKind> kinds() const {
        std::vector<SweepKind> kinds;
        for (const SweepRow& row : sweepTable())
            if (m_options.sweep == "all" || m_options.sweep == row.key)
                kinds.push_back(row.kind);
        return kinds;
    }

    Result<void> sweep(const StudyVariant& variant) {
        const std::vector<SweepKind> wanted = kinds();
        const StudySubject subject{m_job, variant.base, timeLabel(m_options)};
        const std::vector<StudyPoint> points = pointsOf(wanted, subject);
        std::size_t finished = 0;
        SweepOptions options{m_drawing.get(), m_options.drawEvery, m_options.repeats.value_or(1), {}};
        options.finished = [&](const StudyRun&) {
            fmt::print(stderr, "{}: {} of {} runs\n", variant.key, ++finished, points.size());
        };
        const auto swept = runSweep(m_job, points, options);
        if (!swept)
            return tl::unexpected(swept.error());
        std::vector<StudyRun> runs;
        for (const SweptPoint& point : *swept)
            runs.push_back(point.run);
        for (const FigureRow& figure : figureTable()) {
            if (std::ranges::find(wanted, figure.sweep) == wanted.end())
                continue;
            Chart chart = figure.chart(subject, runs);
            chart.id = fmt::format("{}-{}", figure.id, variant.key);
            chart.title = figure.title;
            if (std::ranges::all_of(chart.curves, [](const Curve& curve) { return curve.points.empty(); }))
                continue; // this method has no removal order
            if (auto written = m_files.write(chart); !written)
                return written;
        }
        return m_files.write("runs-" + variant.key, *swept);
    }

    const StudyOptions& m_options;
    Report m_report;
    StudyFiles m_files;
    DecimationParameters m_base;
    StudyJob m_job;
    std::unique_ptr<DrawCost> m_drawing;
    nlohmann::ordered_json m_json = nlohmann::ordered_json::object();
};

std::vector<std::string> sweepKeys() {
    std::vector<std::string> keys;
    for (const SweepRow& row : sweepTable())
        keys.emplace_back(row.key);
    keys.emplace_back("all");
    return keys;
}

} // namespace

void addStudyCommand(CLI::App& app, ExitCode& exitCode, StudyEquipment equipment) {
    auto* command = app.add_subcommand(
        "study", "Reproduce the curves of the paper for a program, as tables and pictures");
    auto options = std::make_shared<StudyOptions>();
    options->equipment = std::move(equipment);
    options->setup.addTo(*command);
    options->threads.addTo(*command);
    auto* sweep = command->add_option("--sweep", options->sweep, "What the sweep varies")
                      ->check(CLI::IsMember(sweepKeys()));
    command->add_option("--out", options->out, "Folder for the tables and pictures (.)")->type_name("DIR");
    auto* optimise = command->add_flag("--optimise", options->optimise, "Choose region size and period");
    sweep->excludes(optimise);
    command
        ->add_flag("--exhaustive", options->exhaustive,
                   "Compare the choice with direct runs of all region sizes and periods")
        ->needs(optimise);
    command
        ->add_option("--repeats", options->repeats,
                     "Runs per point; the median is used (1; with --optimise 3)")
        ->check(CLI::Range(1, 99));
    command
        ->add_option("--draw-every", options->drawEvery, "Draw one block in N and count its time for all (1)")
        ->check(CLI::Range(1, 1000000));
    command
        ->add_option("--triangles-per-second", options->trianglesPerSecond,
                     "Calculate drawing time at this rate instead of measuring it")
        ->check(CLI::Range(1.0, 1e15));
    if (options->equipment.renderer)
        command->add_option("--picture", options->picture, "Size of the drawn picture (1280x800)")
            ->check(checkPicture)
            ->type_name("WxH");
    command->add_flag("--json", options->json, "Print one JSON object");
    command->callback([options, &exitCode] {
        if (options->sweep.empty() && !options->optimise)
            throw CLI::RequiredError("--sweep or --optimise");
        options->threads.apply();
        exitCode = Study(*options).run();
    });
}

} // namespace proveout::cli
