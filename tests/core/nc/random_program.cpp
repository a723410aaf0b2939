// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/nc/random_program.h"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "tests/core/nc/random_rare_blocks.h"
#include "tests/core/nc/random_words.h"

namespace proveout::test {

namespace {

using Words = std::vector<std::string>;

constexpr const char* kAxisLetters = "XYZ";
constexpr const char* kCentreLetters = "IJK";
constexpr int kDeepest = 3; ///< levels of nested O-words

/// The modal state of the program that its generator keeps track of.
struct Mind {
    int plane = 17;
    int spindle = 0;
    bool compensated = false;
    bool inverseTime = false;
    bool straight = false; ///< G0 or G1 is active
    int saved = 0;         ///< number of states saved by M70
    int depth = 0;         ///< nesting level of O-words
    int label = 100;
};

std::string word(char letter, const std::string& number) {
    return fmt::format("{}{}", letter, number);
}

class Writer {
public:
    explicit Writer(std::mt19937& random) : m_words(random), m_random(random) {}

    std::vector<std::string> write() {
        writeHead();
        for (int blocks = m_words.between(3, 22); blocks > 0; --blocks)
            writeBlock();
        writeEnd();
        return std::move(m_lines);
    }

private:
    int between(int least, int most) { return m_words.between(least, most); }
    bool once(int n) { return m_words.once(n); }
    std::string oneOf(std::initializer_list<const char*> all) { return m_words.oneOf(all); }

    void add(const std::string& line) {
        constexpr std::size_t kLongest = 200; // LinuxCNC reads 252 characters
        if (line.size() > kLongest)
            return;
        const bool flow = line.starts_with('o') || line.starts_with('O');
        std::string text = line;
        if (!flow && once(40))
            text.insert(text.begin(), '/');
        if (once(30))
            text += oneOf({" ; remark", " (remark)", "\t"});
        m_lines.push_back(text);
    }
    void addBlock(const Words& words) { add(m_words.block(words)); }

    void writeHead() {
        if (!once(20))
            addBlock({once(6) ? "G20" : "G21", "G90", "G17", fmt::format("F{}", between(50, 900))});
        if (!once(3))
            add(fmt::format("T{} M6", between(1, 3)));
        if (!once(8))
            startSpindle();
        if (!once(20))
            add("#<own>=1 #<_shared>=-2.5");
        if (!once(6))
            add(fmt::format("G0 X{} Y{} Z{}", between(-9, 9), between(-9, 9), between(0, 12))),
                m_mind.straight = true;
        if (once(3))
            add(m_words.block(
                {fmt::format("#1={}", m_words.number(-9, 9)), fmt::format("#2={}", m_words.number(1, 9))}));
    }

    void writeEnd() {
        if (m_mind.compensated && !once(4))
            add("G40 G1 X60 Y60 Z9");
        if (!once(25))
            add(oneOf({"M2", "M30", "%"}));
        for (std::size_t i = 0; i < m_numbered.size(); ++i)
            writeNumberedProgram(m_numbered[i]);
    }

    void writeRare() {
        if (m_mind.inverseTime)
            writeFeedPerMinute();
        for (const std::string& line : randomRareBlocks(m_words))
            add(line);
        m_mind.straight = false;
        m_mind.plane = 17;
    }

    /// Calls a program after the end of this one, in the syntax of other controls.
    void writeNumberedCall() {
        if (m_mind.depth >= kDeepest)
            return writeStraight();
        m_numbered.push_back(++m_mind.label);
        add(m_words.block({"M98", fmt::format("P{}", m_mind.label), fmt::format("L{}", between(0, 3))}));
    }

    void writeNumberedProgram(int label) {
        m_mind.depth = kDeepest; // prevents further subprograms in it
        m_lines.push_back(fmt::format("O{}", label));
        for (int blocks = between(1, 3); blocks > 0; --blocks)
            writeBlock();
        m_lines.push_back("M99");
    }

    void startSpindle() {
        m_mind.spindle = once(3) ? 4 : 3;
        addBlock({fmt::format("M{}", m_mind.spindle), fmt::format("S{}", between(100, 4000))});
    }

    /// Blocks of all kinds, with motions more often than others.
    void writeBlock() {
        using Kind = void (Writer::*)();
        static const std::vector<std::pair<int, Kind>> kKinds{
            {30, &Writer::writeStraight}, {16, &Writer::writeArc},         {14, &Writer::writeCycle},
            {10, &Writer::writeMode},     {8, &Writer::writeOffset},       {5, &Writer::writeReference},
            {5, &Writer::writeLength},    {8, &Writer::writeMachine},      {6, &Writer::writeAssignment},
            {5, &Writer::writeFlow},      {5, &Writer::writeCompensation}, {4, &Writer::writeSynchronised},
            {3, &Writer::writeSpline},    {3, &Writer::writeSaved},        {3, &Writer::writeAnything},
            {2, &Writer::writePolar},     {3, &Writer::writeFeedMode},     {2, &Writer::writeSubprogram},
            {3, &Writer::writeRare},      {1, &Writer::writeNumberedCall}};
        if (m_mind.compensated && !once(10))
            return once(4) ? writeCompensation() : writeBeside();
        int all = 0;
        for (const auto& [weight, kind] : kKinds)
            all += weight;
        int drawn = between(1, all);
        for (const auto& [weight, kind] : kKinds) {
            drawn -= weight;
            if (drawn <= 0)
                return (this->*kind)();
        }
    }

    std::string axisWords(Words& words, int mostMissing = 2) {
        const int missing = between(0, mostMissing);
        std::string named = kAxisLetters;
        for (int i = 0; i < missing; ++i)
            named.erase(static_cast<std::size_t>(between(0, static_cast<int>(named.size()) - 1)), 1);
        for (const char letter : named)
            words.push_back(word(letter, m_words.length()));
        return named;
    }

    void addFeed(Words& words) {
        if (m_mind.inverseTime ? !once(20) : once(10))
            words.push_back(fmt::format("F{}", between(1, 900)));
    }

    void writeStraight() {
        Words words;
        if (!once(3) || (!m_mind.straight && !once(20)))
            words.push_back(oneOf({"G0", "G1", "G1", "G00", "G01"})), m_mind.straight = true;
        axisWords(words);
        addFeed(words);
        if (once(15))
            words.push_back("G53");
        if (once(15))
            words.push_back(oneOf({"G90", "G91", "M8", "M9", "G64", "G61"}));
        addBlock(words);
    }

    struct PlaneOfArc {
        int first;
        int second;
        int normal;
    };
    [[nodiscard]] PlaneOfArc planeOfArc() const {
        switch (m_mind.plane) {
        case 18:
            return {2, 0, 1};
        case 19:
            return {1, 2, 0};
        default:
            return {0, 1, 2};
        }
    }

    /// An arc with consistent words, computed from the current position.
    void writeArc() {
        const PlaneOfArc plane = planeOfArc();
        const double radius = between(1, 12);
        const double from = between(0, 360) * std::numbers::pi / 180;
        const double sweep = once(6) ? 0 : between(5, 355) * std::numbers::pi / 180;
        const double i = -radius * std::cos(from);
        const double j = -radius * std::sin(from);
        const double x = i + radius * std::cos(from + sweep);
        const double y = j + radius * std::sin(from + sweep);
        Words words{oneOf({"G2", "G3", "G02", "G03"})};
        m_mind.straight = false;
        const bool absolute = once(2) && !m_mind.compensated;
        const auto end = [&](int axis, double way) {
            const std::string letter(1, kAxisLetters[axis]);
            return absolute ? fmt::format("{}[#{} + {:.5f}]", letter, 5420 + axis, way)
                            : fmt::format("{}{:.5f}", letter, way);
        };
        if (sweep != 0 || once(2)) {
            words.push_back(end(plane.first, x));
            words.push_back(end(plane.second, y));
        }
        if (once(3))
            words.push_back(end(plane.normal, between(-3, 3)));
        if (sweep != 0 && once(3)) {
            words.push_back(fmt::format("R{}{:.4f}", once(3) ? "-" : "", radius + 1e-4));
        } else {
            words.push_back(fmt::format("{}{:.5f}", kCentreLetters[plane.first], i));
            words.push_back(fmt::format("{}{:.5f}", kCentreLetters[plane.second], j));
        }
        if (once(8))
            words.push_back(fmt::format("P{}", between(1, 4)));
        if (!once(30))
            words.push_back(absolute ? "G90" : "G91");
        addFeed(words);
        addBlock(words);
        if (!once(3))
            add("G90");
    }

    void writeCycle() {
        const PlaneOfArc plane = planeOfArc();
        if (m_mind.spindle == 0 && !once(4))
            startSpindle();
        const int code = m_words.oneOf(std::vector<int>{73, 74, 81, 81, 82, 83, 84, 85, 86, 87, 88, 89});
        if ((code == 74 || code == 84) && !once(6))
            m_mind.spindle = code == 74 ? 4 : 3, add(fmt::format("M{} S100", m_mind.spindle));
        if (m_mind.inverseTime && !once(5))
            writeFeedPerMinute();
        Words words{fmt::format("G{}", code)};
        m_mind.straight = false;
        words.push_back(fmt::format("{}{}", kAxisLetters[plane.normal], m_words.number(-12, 1)));
        words.push_back(word('R', m_words.number(1, 5)));
        words.push_back(word(kAxisLetters[plane.first], m_words.length()));
        if (once(2))
            words.push_back(word(kAxisLetters[plane.second], m_words.length()));
        addCycleWords(words, code);
        addBlock(words);
        for (int more = between(0, 4); more > 0; --more)
            writeNextHole(plane, code);
        if (!once(3))
            add(oneOf({"G80", "G80", "G0 X0", "G1 Z9"}));
        if (m_lines.back().starts_with("G0") || m_lines.back().starts_with("G1"))
            m_mind.straight = true;
    }

    static bool dwells(int code) { return code == 82 || code == 86 || code == 88 || code == 89; }

    void addCycleWords(Words& words, int code) {
        if ((code == 73 || code == 83) && !once(15))
            words.push_back(word('Q', m_words.number(0.4, 4)));
        if (dwells(code) && !once(15))
            words.push_back(fmt::format("P{}", oneOf({"0", "0.5", "1", "2.25"})));
        if (code == 87 && !once(8))
            words.insert(words.end(), {"I1", "J.5", "K-1"});
        if (once(4))
            words.push_back(oneOf({"G98", "G99"}));
        if (once(8))
            words.push_back(oneOf({"G90", "G91"}));
        if (once(8))
            words.push_back(fmt::format("L{}", between(1, 3)));
    }

    void writeNextHole(const PlaneOfArc& plane, int code) {
        Words words;
        if (!once(8))
            words.push_back(word(kAxisLetters[once(3) ? plane.second : plane.first], m_words.length()));
        if (once(3))
            words.push_back(oneOf({"G98", "G99"}));
        if (once(8))
            words.push_back(fmt::format("{}{}", kAxisLetters[plane.normal], m_words.number(-12, 3)));
        if (once(8))
            words.push_back(word('R', m_words.number(-1, 14)));
        if (once(dwells(code) ? 6 : 60))
            words.push_back(fmt::format("P{}", between(0, 2)));
        if (once(code == 73 || code == 83 ? 6 : 60))
            words.push_back(fmt::format("Q{}", between(1, 3)));
        if (once(12))
            words.push_back(fmt::format("L{}", once(9) ? 0 : between(1, 3)));
        if (once(10))
            words.push_back(fmt::format("G{}", code));
        if (once(20))
            words.push_back(oneOf({"G91", "G90", "G55", "G54", "G20", "G21", "G18", "G17", "G92 X1", "G49"}));
        if (words.empty())
            words.push_back("M8");
        addBlock(words);
    }

    void writeMode() {
        Words words;
        for (int count = between(1, 2); count > 0; --count) {
            const std::string code =
                oneOf({"G17", "G17", "G18",      "G19",      "G90", "G91",       "G90.1", "G91.1",
                       "G98", "G99", "G61",      "G61.1",    "G64", "G64 P0.01", "G8",    "G20",
                       "G21", "G21", "G94 F300", "G97 S500", "G80", "G54",       "G40",   "G49"});
            if (code == "G17" || code == "G18" || code == "G19")
                m_mind.plane = std::stoi(code.substr(1));
            if (code == "G80")
                m_mind.straight = false;
            if (code == "G94 F300")
                m_mind.inverseTime = false;
            words.push_back(code);
        }
        addBlock(words);
    }

    void writeOffset() {
        switch (between(0, 9)) {
        case 0:
        case 1:
            return add(oneOf({"G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"}));
        case 2:
        case 3: {
            Words words{"G10", oneOf({"L2", "L20"}), fmt::format("P{}", between(0, 9))};
            axisWords(words);
            if (once(4))
                words.push_back(fmt::format("R{}", m_words.number(-180, 180)));
            return addBlock(words);
        }
        case 4: {
            Words words{"G10", oneOf({"L1", "L10", "L11"}), fmt::format("P{}", between(1, 3))};
            axisWords(words);
            if (once(4))
                words.push_back(word('R', m_words.number(0, 4)));
            return addBlock(words);
        }
        case 5:
            return add(oneOf({"G92.1", "G92.2", "G92.3"}));
        case 6: {
            Words words{"G52"};
            axisWords(words);
            return addBlock(words);
        }
        case 7:
            return add(fmt::format("#5220={}", between(0, 9)));
        default: {
            Words words{"G92"};
            axisWords(words);
            return addBlock(words);
        }
        }
    }

    void writeReference() {
        if (once(3))
            return add(oneOf({"G28.1", "G30.1"}));
        Words words{oneOf({"G28", "G30"})};
        axisWords(words, 3);
        if (once(3))
            words.push_back(oneOf({"G91", "G90"}));
        addBlock(words);
    }

    void writeLength() {
        Words words{oneOf({"G43", "G43", "G43", "G43.1", "G43.2", "G49"})};
        if (words[0] == "G43" && !once(3))
            words.push_back(fmt::format("H{}", between(0, 3)));
        else if (words[0] == "G43.2" && once(2))
            words.push_back(fmt::format("H{}", between(1, 3)));
        else if (words[0] == "G43.1" || words[0] == "G43.2")
            axisWords(words);
        addBlock(words);
    }

    void writeMachine() {
        static const std::vector<Words> kGroups{
            {"M3", "M4", "M3", "M5"},
            {"M7", "M8", "M9"},
            {"T1", "T2", "T3", "T1 M6", "T2 M6", "T3 M6", "M61 Q2"},
            {"M48", "M49", "M50", "M51", "M52", "M53 P1"},
            {"M0", "M1", "M60"},
            {"M62 P1", "M63 P0", "M64 P1", "M65 P1", "M67 E0 Q1", "M68 E0 Q2"},
            {"S500", "S1200"},
            {"F200", "F350"},
            {"G4 P0.5", "G4 P1"},
            {"M19 R10"}};
        Words words;
        for (const Words& group : kGroups) {
            if (once(8))
                words.push_back(m_words.oneOf(group));
        }
        for (const std::string& chosen : words) {
            if (chosen == "M3" || chosen == "M4" || chosen == "M5")
                m_mind.spindle = chosen == "M5" ? 0 : chosen[1] - '0';
            else if (chosen.ends_with("M6"))
                m_mind.spindle = 0;
        }
        if (words.empty())
            words.push_back("M9");
        addBlock(words);
    }

    void writeAssignment() {
        Words words{
            fmt::format("{}={}", m_words.target(), once(2) ? m_words.expression() : m_words.number(-9, 9))};
        if (once(3))
            words.push_back(fmt::format("{} = {}", m_words.target(), m_words.parameter()));
        if (once(4))
            words.push_back(fmt::format("X#{}", between(1, 6)));
        addBlock(words);
    }

    void writeFlow() {
        if (m_mind.depth >= kDeepest)
            return writeStraight();
        ++m_mind.depth;
        const int label = ++m_mind.label;
        switch (between(0, 3)) {
        case 0:
            writeBranch(label);
            break;
        case 1:
            writeWhile(label);
            break;
        case 2:
            add(fmt::format("o{} repeat [{}]", label, between(0, 3)));
            writeBody(label);
            add(fmt::format("o{} endrepeat", label));
            break;
        default:
            add(fmt::format("#{}=0", 10 + m_mind.depth));
            add(fmt::format("o{} do", label));
            writeBody(label);
            add(fmt::format("#{0}=[#{0}+1]", 10 + m_mind.depth));
            add(fmt::format("o{} while [#{} LT {}]", label, 10 + m_mind.depth, between(0, 3)));
        }
        --m_mind.depth;
    }

    void writeBody(int label) {
        for (int blocks = between(1, 3); blocks > 0; --blocks)
            writeBlock();
        if (once(8)) {
            add(fmt::format("o{} if {}", label + 500, m_words.expression()));
            add(fmt::format("o{} {}", label, oneOf({"break", "continue"})));
            add(fmt::format("o{} endif", label + 500));
        }
    }

    void writeBranch(int label) {
        add(fmt::format("o{} if {}", label, m_words.expression()));
        writeBlock();
        if (once(3)) {
            add(fmt::format("o{} elseif {}", label, m_words.expression(1)));
            writeBlock();
        }
        if (once(2)) {
            add(fmt::format("o{} else", label));
            writeBlock();
        }
        add(fmt::format("o{} endif", label));
    }

    void writeWhile(int label) {
        const int counter = 14 + m_mind.depth;
        add(fmt::format("#{}={}", counter, between(0, 3)));
        const std::string more = once(4) ? fmt::format(" AND {}", m_words.expression(1)) : "";
        add(fmt::format("o{} while [[#{} GT 0]{}]", label, counter, more));
        add(fmt::format("#{0}=[#{0}-1]", counter));
        writeBody(label);
        add(fmt::format("o{} endwhile", label));
    }

    void writeSubprogram() {
        if (m_mind.depth > 0)
            return writeStraight();
        ++m_mind.depth;
        const int label = ++m_mind.label;
        add(fmt::format("o{} sub", label));
        for (int blocks = between(1, 3); blocks > 0; --blocks)
            writeBlock();
        if (once(4))
            add(fmt::format("o{} return {}", label, once(2) ? m_words.expression(1) : ""));
        add(fmt::format("o{} endsub {}", label, once(4) ? m_words.expression(0) : ""));
        for (int calls = between(1, 2); calls > 0; --calls)
            add(fmt::format("o{} call [{}] [{}]", label, m_words.number(-9, 9), m_words.number(-9, 9)));
        --m_mind.depth;
    }

    void writeCompensation() {
        if (m_mind.compensated) {
            m_mind.compensated = false;
            return add(oneOf({"G40", "G40 G0 Z20", "G40 G1 X50 Y50"}));
        }
        if (!once(6)) {
            add("G17 G90 G40");
            m_mind.plane = 17;
        }
        m_mind.compensated = true;
        const std::string side = oneOf({"G41", "G42"});
        Words words{
            fmt::format("{}{}", side, oneOf({".1 D1.1", ".1 D2.3", ".1 D4.1", "", " D1", " D1", " D2"}))};
        if (once(2))
            words.insert(words.end(),
                         {"G1", fmt::format("X{}", between(-90, 90)), fmt::format("Y{}", between(-90, 90))});
        addBlock(words);
        for (int blocks = between(1, 6); blocks > 0; --blocks)
            writeBeside();
    }

    /// Long motions, into whose corners a tool fits.
    void writeBeside() {
        if (once(4))
            return writeArc();
        Words words{once(8) ? "G0" : "G1"};
        words.push_back(fmt::format("X{}", m_words.number(-90, 90)));
        if (!once(4))
            words.push_back(fmt::format("Y{}", m_words.number(-90, 90)));
        if (once(6))
            words.push_back(fmt::format("Z{}", m_words.number(-5, 5)));
        addFeed(words);
        addBlock(words);
    }

    void writeSynchronised() {
        if (m_mind.spindle == 0 && !once(5))
            startSpindle();
        m_mind.straight = false;
        Words words{oneOf({"G33", "G33.1"})};
        words.push_back(word('K', m_words.number(0.6, 3)));
        axisWords(words);
        addBlock(words);
    }

    /// The listing does not contain the end of a spline, so a straight motion must follow.
    void writeSpline() {
        writeSplineItself();
        m_lines.push_back("G1 Z1");
        m_mind.straight = true;
    }

    void writeSplineItself() {
        if (m_mind.plane != 17)
            add("G17"), m_mind.plane = 17;
        if (m_mind.inverseTime)
            writeFeedPerMinute();
        if (once(2)) {
            add(fmt::format("G5 X{} Y{} I{} J{} P{} Q{}", m_words.number(-20, 20), m_words.number(-20, 20),
                            m_words.number(-5, 5), m_words.number(-5, 5), m_words.number(-5, 5),
                            m_words.number(-5, 5)));
            return;
        }
        add(fmt::format("G5.1 X{} Y{} I{} J{}", m_words.number(-20, 20), m_words.number(-20, 20),
                        m_words.number(-5, 5), m_words.number(-5, 5)));
    }

    void writeSaved() {
        if (m_mind.saved == 0 && !once(10)) {
            m_mind.saved = 1;
            return add(oneOf({"M70", "M70", "M73"}));
        }
        add(oneOf({"M72", "M72", "M70", "M71"}));
        m_mind.saved = m_lines.back() == "M71" ? 0 : 1;
    }

    void writePolar() {
        m_mind.straight = true;
        Words words{oneOf({"G0", "G1"})};
        if (!once(4))
            words.push_back(word('@', m_words.number(1, 20)));
        words.push_back(word('^', m_words.number(-180, 180)));
        if (once(3))
            words.push_back(word('Z', m_words.number(-5, 5)));
        addBlock(words);
    }

    void writeFeedMode() {
        if (m_mind.inverseTime || once(3))
            return writeFeedPerMinute();
        if (once(2))
            return addBlock({"G95", word('F', m_words.number(0.1, 2))});
        if (once(3))
            return addBlock(
                {"G96", fmt::format("S{}", between(50, 400)), fmt::format("D{}", between(500, 3000))});
        m_mind.inverseTime = true;
        addBlock({"G93", "F10"});
    }

    void writeFeedPerMinute() {
        m_mind.inverseTime = false;
        addBlock({"G94", fmt::format("F{}", between(50, 900))});
    }

    /// Random words, which need not be consistent.
    void writeAnything() {
        Words words;
        for (int count = between(1, 4); count > 0; --count) {
            if (once(2)) {
                words.push_back(
                    oneOf({"G0",    "G1",  "G2",  "G3",  "G4",  "G10", "G17", "G18", "G19", "G20", "G21",
                           "G28",   "G30", "G33", "G40", "G41", "G43", "G49", "G52", "G53", "G54", "G55",
                           "G61",   "G64", "G73", "G80", "G81", "G82", "G83", "G85", "G90", "G91", "G92",
                           "G92.1", "G93", "G94", "G95", "G96", "G97", "G98", "G99", "M0",  "M3",  "M5",
                           "T1 M6", "M8",  "M48", "M61", "M62", "M67", "M70", "M72"}));
            } else {
                const std::string letter = oneOf({"X", "Y", "Z", "I", "J", "K", "R", "P", "Q", "L",
                                                  "D", "H", "S", "F", "T", "E", "@", "^", "N", "$"});
                words.push_back(letter + (once(4) ? "-" : "") + (once(6) ? "-" : "") +
                                std::to_string(between(0, 9)));
            }
        }
        addBlock(words);
    }

    RandomWords m_words;
    std::mt19937& m_random;
    Mind m_mind;
    std::vector<std::string> m_lines;
    std::vector<int> m_numbered; ///< programs called by M98
};

} // namespace

std::map<int, ToolOffset> toolsOfRandomPrograms() {
    return {{1, {Vec3(0, 0, 10), 6.1}}, {2, {Vec3(1, -2, 25.5), 3.2}}, {3, {Vec3(0), 0}}};
}

std::vector<std::string> randomProgram(std::mt19937& random) {
    return Writer(random).write();
}

} // namespace proveout::test
