// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/nc/rs274_listing.h"

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>

namespace proveout::test {

namespace {

using nlohmann::json;

constexpr double kInch = 25.4;
constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kNoLimit = 1e29;   ///< for the spindle under G96 without D
constexpr double kSamePoint = 5e-9; ///< in the unit of the program; below the rounding of the listing

json listed(const Vec3& point) {
    return {point.x, point.y, point.z};
}

std::string_view withoutBlanks(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(' ');
    return begin == std::string_view::npos ? std::string_view() : text.substr(begin);
}

/// All numbers of a text, wherever they are.
std::vector<double> numbersOf(std::string_view words) {
    const std::string text(words);
    std::vector<double> numbers;
    for (const char* at = text.c_str(); *at != '\0';) {
        const bool begins =
            std::isdigit(static_cast<unsigned char>(*at)) != 0 ||
            ((*at == '-' || *at == '.') && std::isdigit(static_cast<unsigned char>(at[1])) != 0);
        const bool inName = at != text.c_str() && (std::isalpha(static_cast<unsigned char>(at[-1])) != 0);
        if (!begins || inName) {
            ++at;
            continue;
        }
        char* end = nullptr;
        numbers.push_back(std::strtod(at, &end));
        at = end;
    }
    return numbers;
}

double sweepOf(const Vec2& from, const Vec2& to, int turns, bool full) {
    double sweep = std::atan2(to.y, to.x) - std::atan2(from.y, from.x);
    if (turns >= 0) {
        while (sweep <= 0)
            sweep += kTurn;
        return (full ? kTurn : sweep) + kTurn * std::max(0, turns - 1);
    }
    while (sweep >= 0)
        sweep -= kTurn;
    return (full ? -kTurn : sweep) + kTurn * std::min(0, turns + 1);
}

} // namespace

/// "  12 N5     NAME(1.0, 2.0)": a sequence number, the block number or dots, the call.
bool Rs274Listing::parse(std::string_view text, Call& call) {
    text = withoutBlanks(text);
    const std::size_t number = text.find(" N");
    const std::size_t open = text.find('(');
    if (number == std::string_view::npos || open == std::string_view::npos || number > open ||
        text.back() != ')')
        return false;
    std::size_t at = number + 2;
    while (at < open && (std::isdigit(static_cast<unsigned char>(text[at])) != 0 || text[at] == '.'))
        ++at;
    call.line = std::atoi(std::string(text.substr(number + 2, at - number - 2)).c_str());
    const std::string_view rest = withoutBlanks(text.substr(at));
    call.name = rest.substr(0, rest.find('('));
    call.words = text.substr(open + 1, text.size() - open - 2);
    call.numbers =
        call.name == "COMMENT" || call.name == "MESSAGE" ? std::vector<double>() : numbersOf(call.words);
    return true;
}

void Rs274Listing::readLine(std::string_view line) {
    Call call;
    if (m_lost.empty() && parse(line, call))
        read(call);
}

void Rs274Listing::read(const Call& call) {
    if (!readMotion(call) && !readFrame(call) && !readSpindle(call))
        readEvent(call);
}

Vec3 Rs274Listing::pointOf(const Call& call, std::size_t first) const {
    return Vec3(call.numbers.at(first), call.numbers.at(first + 1), call.numbers.at(first + 2)) * m_unit;
}

void Rs274Listing::addCutting(json& record) const {
    record["f"] = m_pitch > 0 ? m_pitch : m_feed;
    record["fm"] = m_pitch > 0 || m_perRevolution ? "rev" : "min";
    record["s"] = m_most == 0 ? m_speed : m_most < kNoLimit ? m_most : 0;
    record["d"] = m_direction;
    record["t"] = m_tool;
}

void Rs274Listing::addMotion(const char* kind, const Call& call, const Vec3& end) {
    m_program = end;
    m_machine = m_frame.toMachine(end);
    m_lengthUnused = false;
    json record{{"k", kind}, {"l", call.line}, {"e", listed(m_machine)}};
    if (record["k"] != "rapid")
        addCutting(record);
    m_records.push_back(std::move(record));
}

void Rs274Listing::addArc(const Call& call) {
    const PlaneAxes plane = axes(m_plane);
    const Vec2 end(call.numbers.at(0) * m_unit, call.numbers.at(1) * m_unit);
    const Vec2 centre(call.numbers.at(2) * m_unit, call.numbers.at(3) * m_unit);
    const Vec2 start(m_program[plane.first], m_program[plane.second]);
    Vec3 target(0);
    target[plane.first] = end.x;
    target[plane.second] = end.y;
    target[plane.normal] = call.numbers.at(5) * m_unit;
    Vec3 about = m_program;
    about[plane.first] = centre.x;
    about[plane.second] = centre.y;
    Vec3 normal(0);
    normal[plane.normal] = 1;
    const bool full = glm::distance(start, end) < kSamePoint * m_unit;
    const double sweep = sweepOf(start - centre, end - centre, static_cast<int>(call.numbers.at(4)), full);
    addMotion("arc", call, target);
    json& record = m_records.back();
    record["c"] = listed(m_frame.toMachine(about));
    record["n"] = listed(m_frame.turned(normal));
    record["w"] = sweep;
    record["r"] = glm::distance(start, centre);
}

void Rs274Listing::addProbe(const Call& call) {
    if (m_lengthUnused)
        m_lost =
            "the stand-alone machine probes from where it was before a length that no motion has used yet";
    else
        addMotion("probe", call, endOfProbe(m_program, pointOf(call, 0)));
}

bool Rs274Listing::readMotion(const Call& call) {
    if (call.name == "STRAIGHT_TRAVERSE") {
        addMotion("rapid", call, pointOf(call, 0));
    } else if (call.name == "STRAIGHT_FEED") {
        addMotion("feed", call, pointOf(call, 0));
    } else if (call.name == "STRAIGHT_PROBE") {
        addProbe(call);
    } else if (call.name == "ARC_FEED") {
        addArc(call);
    } else if (call.name == "RIGID_TAP") {
        const Vec3 start = m_program;
        addMotion("tap", call, pointOf(call, 0));
        m_program = start; // a rigid tap returns to its start
        m_machine = m_frame.toMachine(start);
    } else if (call.name == "NURBS_FEED") {
        m_records.push_back({{"k", "nurbs"}, {"l", call.line}});
    } else {
        return false;
    }
    return true;
}

Vec3 Rs274Listing::endOfProbe(const Vec3& start, const Vec3& end) {
    const double distance = glm::distance(start, end);
    return distance == 0 ? end : end + (start - end) * (kProbeBackup / distance);
}

void Rs274Listing::setFrame(const WorkFrame& frame) {
    m_frame = frame;
    m_program = frame.toProgram(m_machine);
}

void Rs274Listing::setUnit(double unit) {
    if (unit != m_unit && m_length != Vec3(0))
        m_lost = "the stand-alone machine does not convert the tool length when the unit changes";
    m_unit = unit;
}

bool Rs274Listing::readFrame(const Call& call) {
    WorkFrame frame = m_frame;
    if (call.name == "USE_LENGTH_UNITS") {
        setUnit(call.words.find("INCHES") != std::string_view::npos ? kInch : 1);
    } else if (call.name == "SELECT_PLANE") {
        m_plane = call.words.ends_with("XY") ? Plane::xy : call.words.ends_with("YZ") ? Plane::yz : Plane::zx;
    } else if (call.name == "SET_G5X_OFFSET") {
        frame.offset = pointOf(call, 1);
    } else if (call.name == "SET_G92_OFFSET") {
        frame.shift = pointOf(call, 0);
    } else if (call.name == "SET_XY_ROTATION") {
        frame.rotation = call.numbers.at(0);
    } else if (call.name == "USE_TOOL_LENGTH_OFFSET") {
        const Vec3 length = pointOf(call, 0); // the tip moves, the spindle does not
        m_lengthUnused = m_lengthUnused || length != m_length;
        m_machine += m_length - length;
        m_length = length;
    } else {
        return false;
    }
    setFrame(frame);
    return true;
}

bool Rs274Listing::readSpindle(const Call& call) {
    if (call.name == "SET_FEED_RATE")
        m_feed = call.numbers.at(0) * m_unit;
    else if (call.name == "SET_FEED_MODE")
        m_perRevolution = call.numbers.back() != 0;
    else if (call.name == "START_SPEED_FEED_SYNC")
        m_pitch = call.numbers.at(0) * m_unit;
    else if (call.name == "STOP_SPEED_FEED_SYNCH")
        m_pitch = 0;
    else if (call.name == "SET_SPINDLE_MODE")
        m_most = call.numbers.at(1);
    else if (call.name == "SET_SPINDLE_SPEED")
        m_speed = call.numbers.at(1);
    else if (call.name == "START_SPINDLE_CLOCKWISE")
        m_direction = 1;
    else if (call.name == "START_SPINDLE_COUNTERCLOCKWISE")
        m_direction = -1;
    else if (call.name == "STOP_SPINDLE_TURNING" || call.name == "ORIENT_SPINDLE")
        m_direction = 0;
    else
        return false;
    return true;
}

void Rs274Listing::readEvent(const Call& call) {
    if (call.name == "SELECT_TOOL") {
        m_selected = static_cast<int>(call.numbers.at(0));
    } else if (call.name == "CHANGE_TOOL") {
        m_tool = m_selected;
        m_toolChanged = true;
        if (m_lengthUnused) // the position is read back
            m_lost =
                "the stand-alone machine changes tools and forgets the length that no motion has used yet";
        m_records.push_back({{"k", "tool"}, {"l", call.line}, {"t", m_tool}});
    } else if (call.name == "CHANGE_TOOL_NUMBER") {
        m_beforeRename = m_beforeRename.value_or(m_records.size());
        m_tool = static_cast<int>(call.numbers.at(0));
        m_records.push_back({{"k", "tool"}, {"l", call.line}, {"t", m_tool}});
    } else if (call.name == "SET_TOOL_TABLE_ENTRY") {
        if (!m_toolChanged && call.numbers.at(0) == 0)
            m_lost = "the stand-alone machine begins with the first tool in its spindle";
    } else if (call.name == "DWELL") {
        m_records.push_back({{"k", "dwell"}, {"l", call.line}, {"sec", call.numbers.at(0)}});
    } else if (call.name == "PROGRAM_END") {
        m_records.push_back({{"k", "end"}, {"l", call.line}});
    } else if (call.name == "COMMENT" &&
               call.words.find("cutter radius compensation") != std::string_view::npos) {
        m_compensated = m_compensated || call.words.find("off") == std::string_view::npos;
    }
}

} // namespace proveout::test
