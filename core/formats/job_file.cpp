// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/job_file.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/base/atomic_file.h"
#include "core/base/tool_number.h"
#include "core/decimation/regions/region_decimator.h"
#include "core/formats/described_json.h"
#include "core/formats/fixture_file.h"
#include "core/formats/job_findings.h"
#include "core/formats/job_json.h"
#include "core/formats/stock_position_json.h"
#include "core/formats/stock_shapes.h"
#include "core/simulation/setup/setup_fields.h"

namespace proveout {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// 2: the position of the stock has separate fields, and a job without a grid has an automatic one.
constexpr int kSchema = 2;
constexpr std::uint64_t kSizeLimit = 16'000'000; ///< bytes; a job has a few hundred
constexpr int kDepthLimit = 32;

constexpr JsonRange kSize{0, 1e6, true}; ///< mm, of a stock

/// The context for finding other files that a job names.
struct Reach {
    fs::path folder; ///< of the job
    const OutsideRule& allowed;
};

/// A file that the job names; empty, with an error reported, if it must not be read.
fs::path reachedFile(JsonFields& fields, const char* key, const std::string& named, const Reach& reach) {
    fs::path file = absolutePath(reach.folder / fs::path(named));
    if (!isOutside(reach.folder, file) || (reach.allowed && reach.allowed(file)))
        return file;
    fields.fail(key, job_finding::kJobOutside, {file.string()});
    return {};
}

void readStockField(JsonFields& fields, const StockField& field, const Reach& reach, StockSpec& spec) {
    if (const auto* length = std::get_if<StockLength>(&field.value)) {
        fields.require({field.name});
        double value = length->get(spec);
        fields.read(field.name, value, kSize);
        length->set(spec, value);
    } else if (const auto* choice = std::get_if<StockChoice>(&field.value)) {
        std::size_t index = choice->get(spec);
        fields.read(field.name, index, choice->choices);
        choice->set(spec, index);
    } else {
        fields.require({field.name});
        std::string file;
        fields.read(field.name, file);
        if (!file.empty()) // a stock that was saved before its file was chosen has none
            spec.shape.file = reachedFile(fields, field.name, file, reach);
    }
}

/// If a job does not give the position, a box has its corner at X0 Y0 and its top at Z0, and a body stays in
/// its own coordinates.
struct DescribedStock {
    StockSpec spec;
    std::optional<Vec3> corner;
};

DescribedStock readStock(JsonFields& job, const Reach& reach) {
    DescribedStock stock;
    job.require({"stock"});
    if (!job.has("stock"))
        return stock;
    JsonFields fields = job.object("stock");
    std::vector<Choice> shapes;
    for (const StockShapeRow& row : stockShapes())
        shapes.push_back({row.key, row.label});
    std::size_t shape = 0;
    fields.read("shape", shape, shapes);
    stock.spec.shape.kind = static_cast<StockKind>(shape);
    for (const StockField& field : stockShapes()[shape].fields)
        readStockField(fields, field, reach, stock.spec);
    stock.corner = readStockPosition(fields);
    fields.warnAboutUnknown();
    return stock;
}

ordered_json writeStock(const Setup& setup, const fs::path& folder) {
    const StockSpec spec{setup.stock, setup.shape};
    const StockShapeRow& row = rowOf(spec.shape.kind);
    ordered_json out = ordered_json::object();
    if (row.kind != StockKind::box) // jobs from before there were shapes have a box without a shape
        out["shape"] = row.key;
    writeStockPosition(out, spec.box);
    for (const StockField& field : row.fields) {
        if (const auto* length = std::get_if<StockLength>(&field.value))
            out[field.name] = length->get(spec);
        else if (const auto* choice = std::get_if<StockChoice>(&field.value))
            out[field.name] = choice->choices[choice->get(spec)].key;
        else
            out[field.name] = spec.shape.file.empty()
                                  ? std::string()
                                  : absolutePath(spec.shape.file).lexically_proximate(folder).string();
    }
    return out;
}

void readTools(JsonFields tools, ToolTable& table) {
    std::set<int> numbers; // "1" and "01" are the same number
    tools.eachString([&](const std::string& key, const std::string& spec) {
        const auto number = parseToolNumber(key);
        if (!number) {
            tools.fail(key, job_finding::kJobFieldToolNumber,
                       {std::to_string(kLeastTool), std::to_string(kLargestTool)});
            return;
        }
        if (!numbers.insert(*number).second)
            tools.fail(key, job_finding::kJobFieldToolTwice, {});
        else if (auto cutter = parseCutter(spec))
            table.set(*number, std::move(*cutter));
        else
            tools.fail(key, job_finding::kJobFieldCutter, {message(cutter.error().front())});
    });
}

// Tools whose sizes are not confirmed, stored beside "tools", which older versions read as well.
constexpr const char* kUnconfirmed = "unconfirmedTools";
constexpr Choice kUnconfirmedSources[] = {{"comment", ""}, {"assumed", ""}};
constexpr JsonRange kLines{0, std::numeric_limits<int>::max()};

/// Keys of a cutter's spec, separated by commas.
void readKeys(JsonFields& fields, const char* name, std::vector<std::string>& keys) {
    std::string text;
    fields.read(name, text);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(',', at), text.size());
        keys.push_back(text.substr(at, end - at));
        at = end + 1;
    }
}

void readOrigin(JsonFields fields, ToolOrigin& origin) {
    std::size_t source = 1;
    fields.require({"source"});
    fields.read("source", source, kUnconfirmedSources);
    origin.source = source == 0 ? ToolSource::comment : ToolSource::assumed;
    int line = 0;
    fields.read("line", line, kLines);
    origin.line = static_cast<std::uint32_t>(line);
    fields.read("comment", origin.comment);
    readKeys(fields, "defaults", origin.defaults);
    readKeys(fields, "entered", origin.entered);
    fields.warnAboutUnknown();
}

void readUnconfirmed(JsonFields& job, ToolTable& table) {
    JsonFields fields = job.object(kUnconfirmed);
    const ToolTable read = table;
    for (const auto& [number, cutter] : read.tools()) {
        const std::string key = std::to_string(number);
        if (!fields.has(key.c_str()))
            continue;
        ToolOrigin origin;
        readOrigin(fields.object(key.c_str()), origin);
        table.set(number, cutter, std::move(origin));
    }
    fields.warnAboutUnknown();
}

ordered_json toJson(const ToolOrigin& origin) {
    ordered_json out{{"source", name(origin.source)}};
    if (origin.source == ToolSource::comment) {
        out["line"] = origin.line;
        out["comment"] = origin.comment;
    }
    if (!origin.defaults.empty())
        out["defaults"] = fmt::format("{}", fmt::join(origin.defaults, ","));
    if (!origin.entered.empty())
        out["entered"] = fmt::format("{}", fmt::join(origin.entered, ","));
    return out;
}

constexpr const char* kFixtures = "fixtures";

/// The file of a mesh, which is read even if the job turns out to have errors.
void reachFixtureFile(JsonFields& fields, const std::string& name, const Reach& reach, Fixture& fixture) {
    auto* mesh = std::get_if<FixtureMesh>(&fixture);
    if (mesh == nullptr)
        return;
    mesh->file = reachedFile(fields, name.c_str(), mesh->file.string(), reach);
    if (!mesh->file.empty())
        readFixtureFile(*mesh);
}

void readFixtures(JsonFields& job, const Reach& reach, Fixtures& fixtures) {
    if (!job.has(kFixtures))
        return;
    JsonFields fields = job.object(kFixtures);
    fields.eachString([&](const std::string& name, const std::string& text) {
        auto fixture = parseFixture(text);
        if (!fixture) {
            fields.fail(name, job_finding::kJobFieldFixture, {message(fixture.error().front())});
            return;
        }
        reachFixtureFile(fields, name, reach, *fixture);
        fixtures[name] = std::move(*fixture);
    });
}

/// The text of a fixture, with its file relative to the folder of the job.
std::string storedText(Fixture fixture, const fs::path& folder) {
    if (auto* mesh = std::get_if<FixtureMesh>(&fixture))
        mesh->file = absolutePath(mesh->file).lexically_proximate(folder);
    return fixtureText(fixture);
}

void readMachine(JsonFields& job, std::optional<Machine>& machine) {
    if (!job.has("machine"))
        return;
    machine.emplace();
    JsonFields fields = job.object("machine");
    describe(*machine, FieldReader{fields});
    fields.warnAboutUnknown();
}

constexpr const char* kPart = "part";

void readPartSpec(JsonFields& job, const Reach& reach, std::optional<PartSpec>& part) {
    if (!job.has(kPart))
        return;
    JsonFields fields = job.object(kPart);
    part.emplace();
    fields.require({"file"});
    std::string file;
    fields.read("file", file);
    if (fields.has("file") && file.empty())
        fields.fail("file", job_finding::kJobFieldEmpty, {});
    else if (!file.empty())
        part->file = reachedFile(fields, "file", file, reach);
    describe(*part, FieldReader{fields});
    fields.warnAboutUnknown();
}

ordered_json toJson(const PartSpec& part, const fs::path& folder) {
    ordered_json out{{"file", absolutePath(part.file).lexically_proximate(folder).string()}};
    describe(part, FieldWriter{out});
    return out;
}

constexpr JsonRange kCoordinates{-1e6, 1e6};
constexpr JsonRange kToolNumbers{0, kLargestTool};

Waiver readWaiver(JsonFields fields) {
    Waiver waiver;
    fields.require({"finding", "reason", "owner"});
    fields.read("finding", waiver.finding);
    fields.read("tool", waiver.tool, kToolNumbers);
    int count = 1;
    fields.read("count", count, {1, std::numeric_limits<int>::max()});
    waiver.count = static_cast<std::size_t>(count);
    fields.read("values", waiver.values);
    fields.read("cutter", waiver.cutter);
    if (fields.has("place"))
        fields.read("place", waiver.place.emplace(0), kCoordinates);
    for (const auto& [key, text] : {std::pair("reason", &waiver.reason), std::pair("owner", &waiver.owner)}) {
        fields.read(key, *text);
        if (fields.has(key) && text->empty()) // nobody would answer for it
            fields.fail(key, job_finding::kJobFieldEmpty, {});
    }
    fields.warnAboutUnknown();
    return waiver;
}

void readReasons(JsonFields fields, IdsWithReasons& ids) {
    fields.eachString([&ids](const std::string& id, const std::string& reason) { ids[id] = reason; });
}

constexpr const char* kCheck = "check";

void readCheck(JsonFields& job, CheckRules& check) {
    if (!job.has(kCheck))
        return;
    JsonFields fields = job.object(kCheck);
    JsonFields limits = fields.object("limits");
    describe(check.limits, FieldReader{limits});
    for (const std::string& name : limits.keys())
        if (const auto of = parseLimitOfTool(name)) {
            const Field field = *limitField(of->key);
            limits.read(name.c_str(), check.limitsOfTools[name], {field.minimum, field.maximum});
        }
    limits.warnAboutUnknown();
    readReasons(fields.object("off"), check.off);
    readReasons(fields.object("accepted"), check.accepted);
    JsonFields waivers = fields.object("waivers");
    for (const std::string& key : waivers.keys())
        check.waivers.push_back(readWaiver(waivers.object(key.c_str())));
    fields.warnAboutUnknown();
}

ordered_json toJson(const Waiver& waiver) {
    ordered_json out{{"finding", waiver.finding}, {"tool", waiver.tool}, {"count", waiver.count}};
    if (!waiver.values.empty())
        out["values"] = waiver.values;
    if (!waiver.cutter.empty())
        out["cutter"] = waiver.cutter;
    if (waiver.place)
        out["place"] = {waiver.place->x, waiver.place->y, waiver.place->z};
    out["reason"] = waiver.reason;
    out["owner"] = waiver.owner;
    return out;
}

ordered_json toJson(const CheckRules& check) {
    ordered_json out = ordered_json::object();
    if (check.limits != RuleLimits())
        describe(check.limits, FieldWriter{out["limits"]});
    for (const auto& [name, value] : check.limitsOfTools)
        out["limits"][name] = value;
    for (const auto& [id, reason] : check.off)
        out["off"][id] = reason;
    for (const auto& [id, reason] : check.accepted)
        out["accepted"][id] = reason;
    for (std::size_t k = 0; k < check.waivers.size(); ++k) // as many digits, so that their order stays
        out["waivers"][fmt::format("{:04}", k + 1)] = toJson(check.waivers[k]);
    return out;
}

void readParameters(JsonFields fields, Job& job) {
    describe(job.parameters, FieldReader{fields});
    job.regionNamed = fields.has("region");
    useDefaults(job.parameters, job.regionNamed, fields.has("period"),
                gridPoints(job.setup.stock, job.setup.spacing));
    fields.warnAboutUnknown();
}

/// The schema is checked first: other fields of a newer file may have a different meaning.
Result<void> checkSchema(const nlohmann::json& json) {
    const auto found = json.is_object() ? json.find("proveout") : json.end();
    if (!json.is_object() || found == json.end())
        return failure(job_finding::kNotAJob);
    if (!found->is_number_integer() || found->get<double>() < 1)
        return failure(job_finding::kJobFieldFormat, {"proveout"});
    if (found->get<double>() > kSchema)
        return failure(job_finding::kJobNewer, {found->dump(), std::to_string(kSchema)});
    return {};
}

/// Warnings in the order of the text; if the job cannot be read they follow the errors, because a missing
/// field may be one whose name is misspelt.
Diagnostics reported(JsonComplaints& complaints) {
    complaints.warnings.sortByPlace();
    complaints.errors.append(std::move(complaints.warnings));
    return complaints.errors.take();
}

Result<Job> parse(std::string_view text, const Reach& reach) {
    const auto document = parseJson(text, kDepthLimit);
    if (!document)
        return tl::unexpected(document.error());
    if (auto schema = checkSchema(document->root); !schema)
        return tl::unexpected(std::move(schema.error()));
    JsonComplaints complaints;
    JsonFields fields(*document, complaints);
    Job job;
    std::string program;
    fields.require({"proveout", "program"});
    fields.read("program", program);
    if (fields.has("program") && program.empty() && complaints.errors.empty())
        fields.fail("program", job_finding::kJobFieldProgram, {});
    else if (!program.empty())
        job.program = reachedFile(fields, "program", program, reach);
    DescribedStock stock = readStock(fields, reach);
    // Its file is read only if its description has no errors.
    const bool needsFile =
        stock.spec.shape.kind != StockKind::box && stock.spec.shape.kind != StockKind::cylinder;
    if (complaints.errors.empty() && !(needsFile && stock.spec.shape.file.empty())) {
        if (auto made = makeStock(stock.spec, stock.corner); !made)
            return tl::unexpected(std::move(made.error()));
    }
    job.setup.stock = stock.spec.box;
    job.setup.shape = std::move(stock.spec.shape);
    if (job.setup.shape.body)
        job.setup.spacing = job.setup.shape.body->spacing().value_or(job.setup.spacing);
    describeGrid(job.setup, FieldReader{fields});
    readTools(fields.object("tools"), job.setup.tools);
    readUnconfirmed(fields, job.setup.tools);
    readFixtures(fields, reach, job.setup.fixtures);
    describeControl(job.setup, FieldReader{fields});
    readMachine(fields, job.machine);
    readCheck(fields, job.check);
    readPartSpec(fields, reach, job.part);
    readParameters(fields.object("decimation"), job);
    fields.warnAboutUnknown();
    const bool usable = complaints.errors.empty();
    Diagnostics all = reported(complaints);
    if (!usable)
        return tl::unexpected(std::move(all));
    job.warnings = std::move(all);
    return job;
}

ordered_json toJson(const Job& job, const fs::path& file) {
    const auto& setup = job.setup;
    ordered_json out;
    out["proveout"] = kSchema;
    out["program"] = absolutePath(job.program).lexically_proximate(folderOfJob(file)).string();
    out["stock"] = writeStock(setup, folderOfJob(file));
    describeGrid(setup, FieldWriter{out});
    out["tools"] = ordered_json::object();
    for (const auto& [number, cutter] : setup.tools.tools())
        out["tools"][std::to_string(number)] = cutter.spec();
    for (const auto& [number, origin] : setup.tools.unconfirmed())
        out[kUnconfirmed][std::to_string(number)] = toJson(origin);
    for (const auto& [name, fixture] : setup.fixtures)
        out[kFixtures][name] = storedText(fixture, folderOfJob(file));
    describeControl(setup, FieldWriter{out});
    if (job.machine)
        describe(*job.machine, FieldWriter{out["machine"]});
    if (job.check != CheckRules())
        out[kCheck] = toJson(job.check);
    if (job.part)
        out[kPart] = toJson(*job.part, folderOfJob(file));
    describe(job.parameters, FieldWriter{out["decimation"]});
    return out;
}

} // namespace

Result<Job> readJob(const fs::path& file, const OutsideRule& allowed) {
    const auto text = readFile(file, kSizeLimit);
    if (!text)
        return tl::unexpected(text.error());
    auto job = parse(*text, {folderOfJob(file), allowed});
    for (auto& diagnostic : job ? job->warnings : job.error())
        if (diagnostic.file.empty()) // otherwise it is about a file that the job names
            diagnostic.file = file.string();
    return job;
}

Result<Job> readJob(const fs::path& file) {
    return readJob(file, {});
}

Result<std::string> jobText(const fs::path& file, const Job& job) {
    try {
        return toJson(job, file).dump(2) + "\n";
    } catch (const nlohmann::json::type_error&) { // the way in which dump() refuses bytes that are not UTF-8
        return failure(job_finding::kJobNotUtf8, {}, file.string());
    }
}

Result<void> writeJob(const fs::path& file, const Job& job) {
    const Result<std::string> text = jobText(file, job);
    return text ? writeFile(file, *text) : tl::unexpected(text.error());
}

} // namespace proveout
