// SPDX-License-Identifier: GPL-3.0-or-later
// Converts the listing of LinuxCNC's stand-alone interpreter to records that can be compared.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/base/geometry.h"
#include "core/nc/geometry/work_frame.h"
#include "core/nc/program/motion.h"

namespace proveout::test {

/// The stand-alone interpreter assumes that every probe triggers this far before its programmed end, mm.
constexpr double kProbeBackup = 0.254;

/// Reads the listing line by line. The listing has program coordinates in the program's unit; the records
/// have machine coordinates of the tip without tool length, in mm. Value type.
class Rs274Listing {
public:
    void readLine(std::string_view line);
    /// Motions and the events that can be compared, in sequence.
    [[nodiscard]] std::vector<nlohmann::json> releaseRecords() { return std::move(m_records); }
    /// Whether cutter compensation was used anywhere.
    [[nodiscard]] bool compensated() const { return m_compensated; }
    /// Why the stand-alone machine is at another position than a real LinuxCNC machine, after which nothing
    /// is read; empty: it is not.
    [[nodiscard]] const std::string& lost() const { return m_lost; }
    /// The number of records before the first M61.
    [[nodiscard]] std::optional<std::size_t> beforeRename() const { return m_beforeRename; }

private:
    struct Call {
        int line = 0; ///< the block number; 0: none
        std::string_view name;
        std::string_view words;
        std::vector<double> numbers;
    };

    static bool parse(std::string_view text, Call& call);
    void read(const Call& call);
    bool readMotion(const Call& call);
    bool readFrame(const Call& call);
    bool readSpindle(const Call& call);
    void readEvent(const Call& call);
    void addMotion(const char* kind, const Call& call, const Vec3& end);
    void addArc(const Call& call);
    void addProbe(const Call& call);
    void addCutting(nlohmann::json& record) const;
    [[nodiscard]] static Vec3 endOfProbe(const Vec3& start, const Vec3& end);
    void setFrame(const WorkFrame& frame);
    void setUnit(double unit);
    [[nodiscard]] Vec3 pointOf(const Call& call, std::size_t first) const;

    std::vector<nlohmann::json> m_records;
    double m_unit = 1; ///< mm
    Plane m_plane = Plane::xy;
    WorkFrame m_frame;
    Vec3 m_length{0};
    Vec3 m_program{0};
    Vec3 m_machine{0};
    double m_feed = 0;
    bool m_perRevolution = false;
    double m_pitch = 0; ///< mm, for a spindle-synchronised motion; 0: not synchronised
    double m_speed = 0;
    double m_most = 0; ///< with G96 the speed depends on S and X and is limited by D: the limit is used
    int m_direction = 0;
    int m_selected = 0;
    int m_tool = 0;
    bool m_compensated = false;
    bool m_lengthUnused = false; ///< no motion since it was changed
    bool m_toolChanged = false;  ///< by M6, at least once
    std::string m_lost;
    std::optional<std::size_t> m_beforeRename;
};

} // namespace proveout::test
