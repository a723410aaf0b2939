// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace proveout {

/// What a program reads but cannot keep: where the machine stands, which tool it holds. Asked before the
/// parameters that were stored.
class SystemValues {
public:
    virtual ~SystemValues() = default;
    /// The value of a system parameter by number; nothing where the number is an ordinary parameter.
    [[nodiscard]] virtual std::optional<double> numbered(int number) const = 0;
    /// Whether a system parameter cannot be read as the machine stands now.
    [[nodiscard]] virtual bool hidden(int number) const = 0;
    /// The value of a predefined parameter by name (lower case); nothing where the name is an ordinary one.
    [[nodiscard]] virtual std::optional<double> named(std::string_view name) const = 0;
};

/// The parameters of a program (#1, #<depth>, #<_global>) as LinuxCNC keeps them: numbers up to 5602, of
/// which 1 to 30 belong to the level of the call; names belong to it too unless they begin with "_". A value:
/// copying it saves the state of a program.
class Parameters {
public:
    static constexpr int kMost = 5602; ///< the first number that is none
    static constexpr int kLocals = 30; ///< #1 to #30
    using Locals = std::array<double, kLocals>;
    static constexpr std::size_t kMostNames = 100'000; ///< of all levels
    static constexpr std::size_t kLongestName = 256;

    Parameters();

    [[nodiscard]] static constexpr bool exists(int number) { return number >= 1 && number < kMost; }
    /// The number must exist. A parameter that was never set is 0.
    [[nodiscard]] double numbered(int number) const;
    void setNumbered(int number, double value);

    /// Names are in lower case and without blanks. Nothing where the name was never set at this level.
    [[nodiscard]] std::optional<double> named(std::string_view name) const;
    /// False where there are too many names.
    [[nodiscard]] bool setNamed(std::string_view name, double value);

    /// A call begins with these local numbers and no local names; leave() gives back those of the caller.
    void enter(const Locals& arguments);
    void leave();

private:
    using Names = std::map<std::string, double, std::less<>>;
    struct Level {
        Locals numbers{};
        Names names;
    };

    [[nodiscard]] const Names& namesOf(std::string_view name) const;

    std::vector<double> m_numbered; ///< by number; those of the level are in m_levels
    Names m_globals;
    std::vector<Level> m_levels;
    std::size_t m_nameCount = 0;
};

} // namespace proveout
