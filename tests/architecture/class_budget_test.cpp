// SPDX-License-Identifier: GPL-3.0-or-later
// The maximum size of a class, counted over all its files: splitting a class into files without splitting the
// class does not make it easier to read.
#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/architecture/source_tree.h"

namespace proveout {
namespace {

struct ClassSize {
    std::size_t lines = 0; ///< of its body in the header, and of the definitions of its members elsewhere
    std::size_t fields = 0;
    std::size_t signals = 0;
};

/// By name; a nested class has both names: "CallStack::Level".
using ClassSizes = std::map<std::string, ClassSize>;

constexpr ClassSize kBudget{400, 30, 10};
/// For a hub of the session: a class that every panel may use must not collect everything.
constexpr ClassSize kHubBudget{300, 15, 10};

/// The classes that exceed the budget today. A number here may only be reduced; a class within the budget has
/// no row.
const ClassSizes kLarger{
    {"NcEditor", {.lines = 435}},
    {"PlotView", {.lines = 449}},
    {"Program", {.lines = 458}},
};

/// The text with comments, string contents and directives replaced by blanks; line breaks stay.
std::string codeOf(std::string_view text) {
    std::string code(text);
    const auto blank = [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < std::min(end, code.size()); ++i)
            code[i] = code[i] == '\n' ? '\n' : ' ';
    };
    const auto endOf = [&](std::string_view what, std::size_t from) {
        const std::size_t at = text.find(what, from);
        return at == std::string_view::npos ? text.size() : at + what.size();
    };
    for (std::size_t at = 0; at < code.size();) {
        std::size_t end = at + 1;
        const bool digitBefore = at > 0 && std::isalnum(static_cast<unsigned char>(text[at - 1])) != 0;
        if (text.substr(at, 2) == "//" || (text[at] == '#' && (at == 0 || text[at - 1] == '\n'))) {
            end = endOf("\n", at);
            blank(at, end);
        } else if (text.substr(at, 2) == "/*") {
            end = endOf("*/", at);
            blank(at, end);
        } else if (text.substr(at, 2) == "R\"" && !digitBefore) {
            const std::size_t open = text.find('(', at);
            end = endOf(")" + std::string(text.substr(at + 2, open - at - 2)) + "\"", open);
            blank(at, end);
        } else if (text[at] == '"' || (text[at] == '\'' && !digitBefore)) { // 1'000 is a number
            while (end < text.size() && text[end] != text[at])
                end += text[end] == '\\' ? 2 : 1;
            blank(at, ++end);
        }
        at = end;
    }
    return code;
}

/// The position after the bracket that closes the one at `open`.
std::size_t behindClosing(const std::string& code, std::size_t open) {
    const char opens = code[open];
    const char closes = opens == '{' ? '}' : ')';
    int depth = 0;
    for (std::size_t at = open; at < code.size(); ++at) {
        depth += code[at] == opens ? 1 : code[at] == closes ? -1 : 0;
        if (depth == 0)
            return at + 1;
    }
    return code.size();
}

std::size_t lineCount(std::string_view code) {
    return static_cast<std::size_t>(std::ranges::count(code, '\n')) + 1;
}

/// The body of a class without the content of its brackets: bodies of functions, arguments, initial values.
std::string outline(std::string body) {
    for (std::size_t at = 0; at < body.size(); ++at) {
        if (body[at] != '{' && body[at] != '(')
            continue;
        const std::size_t end = behindClosing(body, at) - 1;
        std::fill(body.begin() + static_cast<std::ptrdiff_t>(at) + 1,
                  body.begin() + static_cast<std::ptrdiff_t>(end), ' ');
        at = end;
    }
    return body;
}

std::size_t fieldCount(const std::string& outlined) {
    // After a comma or a colon it is the initializer of a constructor.
    static const std::regex kField(R"([^,:\s]\s*[\s&*](m_\w+)\s*[;={\[])");
    std::set<std::string> names;
    for (std::sregex_iterator at(outlined.begin(), outlined.end(), kField), end; at != end; ++at)
        names.insert((*at)[1]);
    return names.size();
}

std::size_t signalCount(const std::string& outlined) {
    static const std::regex kSection(
        R"((?:signals|Q_SIGNALS):([^:]*?)(?=\b(?:public|private|protected)\b|$))");
    std::size_t count = 0;
    for (std::sregex_iterator at(outlined.begin(), outlined.end(), kSection), end; at != end; ++at)
        count += static_cast<std::size_t>(std::ranges::count((*at)[1].str(), ';'));
    return count;
}

/// Adds the classes that a piece of a header declares, including nested ones.
void addClasses(const std::string& code, const std::string& outer, ClassSizes& sizes) {
    static const std::regex kClass(
        R"(\b(enum\s+)?(?:class|struct)\s+(\w+)(?:\s+final)?\s*(?::[^;{}()]*)?\{)");
    auto at = code.cbegin();
    for (std::smatch found; std::regex_search(at, code.cend(), found, kClass);) {
        const auto open = static_cast<std::size_t>(found[0].second - code.cbegin()) - 1;
        const std::size_t end = behindClosing(code, open);
        at = code.cbegin() + static_cast<std::ptrdiff_t>(end);
        if (found[1].matched)
            continue;
        const std::string body = code.substr(open + 1, end - open - 2);
        const std::string outlined = outline(body);
        const std::string name = outer + found[2].str();
        ClassSize& size = sizes[name];
        size.lines += lineCount(body);
        size.fields += fieldCount(outlined);
        size.signals += signalCount(outlined);
        addClasses(body, name + "::", sizes);
    }
}

/// The class whose member the head of a definition names; empty if it is not a member.
std::string classOf(const std::string& head) {
    static const std::regex kMember(R"(((?:\w+::)*\w+)::(?:~?\w+|operator[^\w\s(]+)\s*$)");
    std::smatch found;
    const std::string name = head.substr(0, head.find('('));
    return std::regex_search(name, found, kMember) ? found[1].str() : std::string();
}

/// Adds the member definitions in a source file to their classes, if a header declares these.
void addMembers(const std::string& code, ClassSizes& sizes) {
    static const std::regex kNamespace(R"(^\s*(?:inline\s+)?namespace\b)");
    std::size_t begin = 0; // start of a declaration
    for (std::size_t at = 0; at < code.size(); ++at) {
        if (code[at] == ';' || code[at] == '}')
            begin = at + 1;
        if (code[at] == '(')
            at = behindClosing(code, at) - 1;
        if (code[at] != '{')
            continue;
        const std::string head = code.substr(begin, at - begin);
        if (std::regex_search(head, kNamespace)) {
            begin = at + 1;
            continue;
        }
        at = behindClosing(code, at) - 1;
        const std::size_t next = code.find_first_not_of(" \n", at + 1);
        if (next != std::string::npos && (code[next] == ',' || code[next] == '{'))
            continue; // a member initializer before the body
        const std::size_t first = std::min(code.find_first_not_of(" \n", begin), at);
        if (const auto size = sizes.find(classOf(head)); size != sizes.end())
            size->second.lines += lineCount(std::string_view(code).substr(first, at - first));
        begin = at + 1;
    }
}

ClassSizes sizesOfTree() {
    ClassSizes sizes;
    const auto counts = [](const SourceFile& file) { return file.in("core") || file.in("ui"); };
    for (const SourceFile& file : sourceTree()) {
        if (counts(file) && file.path.ends_with(".h"))
            addClasses(codeOf(file.text), "", sizes);
    }
    for (const SourceFile& file : sourceTree()) {
        if (counts(file) && file.isCpp())
            addMembers(codeOf(file.text), sizes);
    }
    return sizes;
}

struct Measure {
    const char* name;
    std::size_t ClassSize::*count;
};
constexpr std::array kMeasures{Measure{"lines", &ClassSize::lines}, Measure{"fields", &ClassSize::fields},
                               Measure{"signals", &ClassSize::signals}};

TEST(ClassBudget, CountsAClassOverItsFiles) {
    ClassSizes sizes;
    addClasses(codeOf(R"(
namespace proveout {
enum class Kind { none };
class Forward;
/// { a bracket in a comment
class Panel final : public QWidget {
    Q_OBJECT
public:
    explicit Panel(int width) : m_width{width}, m_names{"}"} {}
    struct Row {
        int m_height = 0;
    };
    int width() const { return m_width; }

signals:
    void moved(int x, int y);
    void closed();

private:
    int m_width = 1'000;
    std::vector<int> m_names{1, 2};
    Kind& m_kind;
};
}
)"),
               "", sizes);
    ASSERT_EQ(sizes.size(), 2U);
    EXPECT_EQ(sizes["Panel"].lines, 18U);
    EXPECT_EQ(sizes["Panel"].fields, 3U);
    EXPECT_EQ(sizes["Panel"].signals, 2U);
    EXPECT_EQ(sizes["Panel::Row"].lines, 3U);
    EXPECT_EQ(sizes["Panel::Row"].fields, 1U);

    addMembers(codeOf(R"(
namespace proveout {
namespace {
void helper(Panel& panel) {
    panel.show();
}
} // namespace

Panel::Panel()
    : m_width{1}, m_names{3} {
    if (m_width > 0)
        { helper(*this); }
}

std::vector<Panel::Row> Panel::rows(int first) const {
    return {};
}
}
)"),
               sizes);
    EXPECT_EQ(sizes["Panel"].lines, 18U + 5U + 3U);
    EXPECT_EQ(sizes["Panel::Row"].lines, 3U);
}

TEST(ClassBudget, NoClassIsLargerThanTheBudget) {
    const ClassSizes sizes = sizesOfTree();
    EXPECT_GT(sizes.size(), 300U); // ensures that the tree was read
    for (const auto& [name, size] : sizes) {
        const auto larger = kLarger.find(name);
        const ClassSize& usual = name.ends_with("Hub") ? kHubBudget : kBudget;
        const ClassSize& most = larger == kLarger.end() ? usual : larger->second;
        for (const Measure& measure : kMeasures)
            EXPECT_LE(size.*measure.count, std::max(most.*measure.count, usual.*measure.count))
                << name << " has too many " << measure.name << ": cut it by what its fields share";
    }
}

TEST(ClassBudget, ExceptionsAreNeeded) {
    const ClassSizes sizes = sizesOfTree();
    for (const auto& [name, most] : kLarger) {
        const auto found = sizes.find(name);
        ASSERT_NE(found, sizes.end()) << name << " is no longer a class: delete its row";
        const bool needed = std::ranges::any_of(kMeasures, [&](const Measure& measure) {
            return found->second.*measure.count > kBudget.*measure.count;
        });
        EXPECT_TRUE(needed) << name << " keeps the budget: delete its row";
    }
}

} // namespace
} // namespace proveout
