// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/nc/text/dialect.h"
#include "core/nc/text/messages.h"

namespace proveout {

/// Values that a program can read but that are not stored as parameters: the position of the machine, the
/// tool in its spindle. They have priority over stored parameters.
class SystemValues {
public:
    virtual ~SystemValues() = default;
    /// The value of a system parameter by number; nothing if the number is an ordinary parameter.
    [[nodiscard]] virtual std::optional<double> numbered(int number) const = 0;
    /// Why a system parameter cannot be read in the present state of the machine; null if it can.
    [[nodiscard]] virtual const FindingRow* refusal(int number) const = 0;
    /// Whether a program may name the number although it can only be written.
    [[nodiscard]] virtual bool writable(int /*number*/) const { return false; }
    /// The least increment of lengths, if numbers without a decimal point are in it; 1 otherwise.
    [[nodiscard]] virtual double leastUnit() const { return 1; }
    /// The value of a predefined parameter by name (lower case); nothing if the name is an ordinary one.
    [[nodiscard]] virtual std::optional<double> named(std::string_view name) const = 0;

    /// Whether the result of a probing motion was read since the last call of this function.
    [[nodiscard]] bool consumeProbeRead() const { return std::exchange(m_probeRead, false); }
    /// The number of a value that was read since the last call of this function and is assumed to be 0; 0:
    /// none.
    [[nodiscard]] int consumeAssumedRead() const { return std::exchange(m_assumedRead, 0); }

    /// Call it when an expression depends on the state of the machine.
    void noteUse() const { m_used = true; }
    /// Whether one did since the last call of this function.
    [[nodiscard]] bool consumeUse() const { return std::exchange(m_used, false); }

protected:
    /// Call it when a number is read: the results of a probing motion are between `first` and `last`.
    void noteProbeRead(int number, int first, int last) const {
        m_probeRead = m_probeRead || (number >= first && number <= last);
    }

    void noteAssumedRead(int number) const { m_assumedRead = number; }

private:
    mutable bool m_probeRead = false;
    mutable bool m_used = false;
    mutable int m_assumedRead = 0;
};

/// The parameters of a program as its control stores them. LinuxCNC: numbers up to 5601 that begin as 0, of
/// which 1 to 30 belong to the level of the call; names (#<depth>, #<_global>) belong to it too unless they
/// begin with "_". Custom macro B: #1 to #33 of the level, #100 to #199, #500 to #999, which begin as null,
/// and offsets. A value: copying it saves the state of a program.
class Parameters {
public:
    static constexpr int kLargest = 20'000; ///< no control has larger numbers
    static constexpr std::size_t kMostLocals = 33;
    using Locals = std::array<double, kMostLocals>;
    static constexpr std::size_t kMostNames = 100'000; ///< of all levels
    static constexpr std::size_t kLongestName = 256;

    explicit Parameters(MacroLanguage language = MacroLanguage::oWords);

    /// Whether a program may use the number; #0 of custom macro B may only be read.
    [[nodiscard]] bool exists(int number) const;
    /// Numbers from 0 on. Codes use the numbers of LinuxCNC: if a control does not store such a number, it is
    /// 0 and stays so.
    [[nodiscard]] double numbered(int number) const;
    void setNumbered(int number, double value);
    /// The locals of a call without arguments.
    [[nodiscard]] Locals noArguments() const;

    /// Names are in lower case and without blanks. Nothing if the name was never set at this level.
    [[nodiscard]] std::optional<double> named(std::string_view name) const;
    /// False if there are too many names.
    [[nodiscard]] bool setNamed(std::string_view name, double value);

    /// The parameters that have been set and are visible here: numbers as "#100", then names as "#<depth>".
    [[nodiscard]] std::vector<std::pair<std::string, double>> listed() const;

    /// A call begins with these local numbers and no local names; leave() restores those of the caller.
    void enter(const Locals& arguments);
    void leave();
    /// The same for a subprogram that reads and writes the local numbers of its caller; names are its own.
    void enterSharing();
    void leaveSharing();

    /// Rises with every change to a different value, among the parameters visible at this level.
    [[nodiscard]] std::uint64_t changes() const { return m_changes + m_levels.back().changes; }

private:
    using Names = std::map<std::string, double, std::less<>>;
    struct Level {
        Locals numbers;
        Names names;
        std::uint64_t changes = 0;
    };

    [[nodiscard]] const Names& namesOf(std::string_view name) const;

    [[nodiscard]] std::size_t placeOf(int number) const;

    MacroLanguage m_language;
    std::vector<double> m_numbered; ///< the ranges one after the other; those of the level are in m_levels
    Names m_globals;
    std::vector<Level> m_levels;
    std::size_t m_nameCount = 0;
    std::uint64_t m_changes = 0; ///< of the parameters that all levels share
};

} // namespace proveout
