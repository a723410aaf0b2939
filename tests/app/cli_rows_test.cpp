// SPDX-License-Identifier: GPL-3.0-or-later
// Every row of setup, decimation and machine is an option whose help contains the text and the unit of the
// row.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "core/decimation/regions/parameters.h"
#include "core/simulation/setup/machine.h"
#include "core/simulation/setup/setup_fields.h"
#include "tests/app/command_line.h"

namespace proveout {
namespace {

class CliRows : public CommandLine {
protected:
    /// The entry of an option in the help of a command: its line and its text, which may be on the next line.
    std::string entry(const std::string& help, const std::string& option) {
        const std::size_t at = help.find("  " + option + ' ');
        const std::size_t next = help.find("\n  --", at);
        return at == std::string::npos ? std::string() : help.substr(at, next - at);
    }
    /// Expects the option of a row with its text, its unit and its range.
    template<class Value>
    void expectDescribed(const std::string& help, const Value& value, const Field& field) {
        bool on = false;
        if constexpr (std::is_same_v<Value, bool>)
            on = value && field.choices.empty();
        const std::string reported = entry(help, std::string(on ? "--no-" : "--") + optionOf(field));
        EXPECT_THAT(reported, testing::HasSubstr(field.help)) << field.key;
        EXPECT_THAT(reported, testing::HasSubstr(field.unit)) << field.key;
        for (const Choice& choice : field.choices)
            EXPECT_THAT(reported, testing::HasSubstr(choice.key)) << field.key;
        if constexpr (std::is_arithmetic_v<Value>) {
            const std::string unit = *field.unit == '\0' ? "" : std::string(" ") + field.unit;
            if (hasRange(field)) {
                EXPECT_THAT(reported, testing::HasSubstr(
                                          fmt::format("{} to {}{}", field.minimum, field.maximum, unit)));
            }
        }
    }
};

TEST_F(CliRows, AreInTheHelpWithTheirUnits) {
    const std::string simulate = run("simulate --help").out;
    const std::string study = run("study --help").out;
    const std::string interpret = run("interpret --help").out;
    const auto described = [this](const std::string& help) {
        return [this, &help](const auto& value, const Field& field) {
            expectDescribed<std::remove_cvref_t<decltype(value)>>(help, value, field);
        };
    };
    const proveout::Setup setup;
    const DecimationParameters parameters;
    for (const std::string& help : {simulate, study}) {
        describe(setup, described(help));
        describe(parameters, described(help));
    }
    describeControl(setup, described(interpret));
    describe(parameters, described(run("decimate --help").out));
}

TEST_F(CliRows, OfTheMachineAreInTheHelpOfItsOption) {
    const std::string reported = entry(run("simulate --help").out, "--machine");
    const Machine machine;
    describe(machine, [&reported](double, const Field& field) {
        EXPECT_THAT(reported, testing::HasSubstr(fmt::format("{} ({})", field.key, field.unit)));
    });
}

TEST_F(CliRows, NumbersOutOfTheirRangeAreUsageErrorsThatNameIt) {
    const DecimationParameters parameters;
    describe(parameters, [this](const auto& value, const Field& field) {
        if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(value)>>) {
            if (!hasRange(field))
                return;
            const auto done = run(fmt::format("simulate a.nc --{}={}", optionOf(field), field.maximum + 1));
            EXPECT_EQ(done.exitCode, 3);
            EXPECT_THAT(done.err,
                        testing::HasSubstr(fmt::format("from {} to {}", field.minimum, field.maximum)));
        }
    });
}

} // namespace
} // namespace proveout
