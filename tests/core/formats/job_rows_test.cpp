// SPDX-License-Identifier: GPL-3.0-or-later
// Every row of setup, decimation and machine is in the job file.
#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/formats/job_file.h"
#include "tests/core/another_value.h"
#include "tests/core/temporary_folder.h"

namespace proveout {
namespace {

using nlohmann::json;

class JobRows : public testing::Test {
protected:
    Job job() {
        Job job;
        job.program = m_folder / "a.nc";
        job.setup.stock = {Vec3(0), 40, 30, 10};
        return job;
    }
    /// Writes the job and reads it again.
    Job reread(const Job& job) {
        EXPECT_TRUE(writeJob(file(), job));
        const auto read = readJob(file());
        EXPECT_TRUE(read) << message(read.error().front());
        EXPECT_TRUE(read && read->warnings.empty());
        return read.value_or(Job());
    }
    json written() { return json::parse(*readFile(file(), 100'000)); }
    /// The messages for a job whose JSON was changed.
    std::string reported(const json& changed) {
        m_folder.put("a.proveout", changed.dump());
        const auto read = readJob(file());
        return read ? std::string() : message(read.error().front());
    }
    std::filesystem::path file() { return m_folder / "a.proveout"; }

private:
    TemporaryFolder m_folder;
};

/// Numbers outside the range of their row are refused, and the message contains the range.
template<class Test, class Params>
void expectRefusedOutOfRange(Test reported, const Params& params, const json& whole,
                             const std::string& object) {
    describe(params, [&](const auto& value, const Field& field) {
        if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(value)>>) {
            if (!hasRange(field))
                return;
            for (const double wrong : {field.minimum - 1, field.maximum + 1}) {
                json changed = whole;
                changed[object][field.key] = wrong;
                EXPECT_EQ(reported(changed),
                          fmt::format("The field \"{}.{}\" must be a number from {} to {}.", object,
                                      field.key, field.minimum, field.maximum));
            }
        }
    });
}

TEST_F(JobRows, OfTheSetupAreReadAsTheyAreWritten) {
    eachRowChanged(job().setup, [this](const proveout::Setup& setup, const Field& field) {
        Job changed = job();
        changed.setup = setup;
        EXPECT_TRUE(reread(changed).setup == setup) << field.key;
        EXPECT_TRUE(written().contains(field.key)) << field.key;
    });
}

TEST_F(JobRows, OfTheDecimationAreReadAsTheyAreWritten) {
    eachRowChanged(job().parameters, [this](const DecimationParameters& parameters, const Field& field) {
        Job changed = job();
        changed.parameters = parameters;
        EXPECT_TRUE(reread(changed).parameters == parameters) << field.key;
        EXPECT_TRUE(written()["decimation"].contains(field.key)) << field.key;
    });
    expectRefusedOutOfRange([this](const json& changed) { return reported(changed); }, DecimationParameters(),
                            written(), "decimation");
}

TEST_F(JobRows, OfTheMachineAreReadAsTheyAreWritten) {
    eachRowChanged(Machine(), [this](const Machine& machine, const Field& field) {
        Job changed = job();
        changed.machine = machine;
        EXPECT_TRUE(reread(changed).machine == machine) << field.key;
        EXPECT_TRUE(written()["machine"].contains(field.key)) << field.key;
    });
    expectRefusedOutOfRange([this](const json& changed) { return reported(changed); }, Machine(), written(),
                            "machine");
}

} // namespace
} // namespace proveout
