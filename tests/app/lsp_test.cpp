// SPDX-License-Identifier: GPL-3.0-or-later
// The language server, over pipes.
#include <algorithm>
#include <cstdlib>
#include <random>
#include <set>
#include <tuple>

#include "tests/app/command_line.h"
#include "tests/app/lsp_client.h"
#include "tests/random_seed.h"

namespace proveout {
namespace {

using Json = nlohmann::json;

constexpr int kParseError = -32700;
const std::string kUri = "untitled:part.nc";

class Lsp : public CommandLine {
protected:
    [[nodiscard]] std::string uriOf(const std::string& name) const {
        return "file://" + (folder / name).string();
    }
};

Json at(const std::string& uri, int line, int character) {
    return {{"textDocument", {{"uri", uri}}}, {"position", {{"line", line}, {"character", character}}}};
}

Json edit(int line, int from, int to, const std::string& text) {
    return {
        {"range",
         {{"start", {{"line", line}, {"character", from}}}, {"end", {{"line", line}, {"character", to}}}}},
        {"text", text}};
}

TEST_F(Lsp, TheExitCodeIsZeroOnlyAfterAShutdown) {
    LspClient polite;
    polite.initialize();
    EXPECT_TRUE(polite.ask("shutdown", nullptr)["result"].is_null());
    EXPECT_EQ(polite.ask("textDocument/hover", at(kUri, 0, 0))["error"]["code"], -32600);
    polite.notify("exit", nullptr);
    EXPECT_EQ(polite.finish(), 0);
    LspClient hasty;
    hasty.initialize();
    hasty.notify("exit", nullptr);
    EXPECT_EQ(hasty.finish(), 1);
    LspClient gone;
    EXPECT_EQ(gone.finish(), 1);
}

TEST_F(Lsp, UnknownAndUntimelyMessagesAreRefused) {
    LspClient client;
    EXPECT_EQ(client.ask("textDocument/hover", at(kUri, 0, 0))["error"]["code"], -32002);
    client.initialize();
    EXPECT_EQ(client.ask("foo/bar", Json::object())["error"]["code"], -32601);
    EXPECT_EQ(client.ask("textDocument/hover", at("untitled:other", 0, 0))["error"]["code"], -32602);
    client.notify("$/cancelRequest", {{"id", 12345}});
    client.notify("$/setTrace", {{"value", "off"}});
    client.open(kUri, "G0 X1\n");
    EXPECT_EQ(client.ask("textDocument/hover", at(kUri, 9, 9))["result"], Json());
    EXPECT_EQ(client.ask("textDocument/hover", at(kUri, -1, 0))["error"]["code"], -32602);
}

TEST_F(Lsp, HostileInputStopsNothing) {
    LspClient client;
    client.initialize();
    const auto expectRefused = [&](const std::string& bytes) {
        client.sendBytes(bytes);
        const Json refused = client.until([](const Json& one) { return one.contains("error"); });
        ASSERT_TRUE(refused.is_object()) << bytes.substr(0, 80);
        EXPECT_EQ(refused["error"]["code"], kParseError);
        EXPECT_EQ(client.ask("foo", nullptr)["error"]["code"], -32601) << bytes.substr(0, 80);
    };
    const std::string blank = "\r\n\r\n";
    for (const char* length : {"-5", "99999999999999999999999", "999999999999", "abc", "", "5 5", "0x10"})
        expectRefused("Content-Length: " + std::string(length) + blank + "{}");
    expectRefused("no header at all\r\n\r\n");
    expectRefused("Content-Type: x" + blank);
    expectRefused(std::string(100'000, 'x') + "\r\n");
    expectRefused("Content-Length: 5" + blank + "{bad}");
    expectRefused("Content-Length: 0" + blank);
    const std::string deep(100'000, '[');
    expectRefused("Content-Length: " + std::to_string(deep.size()) + blank + deep);
    // The rest of a message that is longer than its header says.
    expectRefused("Content-Length: 3" + blank + R"({"jsonrpc": "2.0", "method": "initialized"})");
    client.sendText(R"({"jsonrpc":"2.0","id":{},"method":"x"})");
    client.sendText("[]");
    client.sendText(R"({"jsonrpc":"2.0","method":"textDocument/didChange","params":7})");
    client.sendText(R"({"jsonrpc":"2.0","method":"textDocument/didOpen","params":{"textDocument":)"
                    R"({"uri":"untitled:s","version":1,"text":"G0 X1 (\ud800 \udc00\ud83d)\nG999\n"}}})");
    const Json found = client.diagnostics(1);
    EXPECT_TRUE(std::ranges::any_of(found, [](const Json& one) { return one["code"] == "code-unknown"; }));
    std::mt19937 random(randomSeed());
    std::string noise(50'000, '\0');
    std::ranges::generate(noise, [&] { return static_cast<char>(random()); });
    client.sendBytes(noise);
    EXPECT_EQ(client.ask("foo", nullptr)["error"]["code"], -32601);
}

/// A finding of the command and of the server: id, line and column.
using Place = std::tuple<std::string, int, int>;

std::multiset<Place> placesOf(const Json& diagnostics) {
    std::multiset<Place> places;
    for (const Json& one : diagnostics) {
        const Json& start = one["range"]["start"];
        places.emplace(one["code"].get<std::string>(), start["line"].get<int>(),
                       start["character"].get<int>());
    }
    return places;
}

std::multiset<Place> checkedPlaces(const Json& checked) {
    std::multiset<Place> places;
    for (const Json& one : checked["findings"])
        places.emplace(one["id"].get<std::string>(), std::max(one.value("line", 1), 1) - 1,
                       std::max(one.value("column", 1), 1) - 1);
    return places;
}

TEST_F(Lsp, DiagnosticsAreTheFindingsOfTheCommandCheck) {
    const std::vector<std::string> texts{"",
                                         kSound,
                                         "G21\nT1 M6\nG0 X1 Y1 Z1\nG999\nG1 X5\nG2 X9 I1 J1\nM30\n",
                                         "O1000\nT1 M6\nIF[#1GT3]GOTO 77\nG65 P12 A1\nG1 X5.\nM30\n",
                                         "o<a> call\n#<b>=[1/0]\nG1 X[#<c>]\nM2\n",
                                         "%\nG0 X1 (open\nG1 X2 F\n\tX3 X4\nM30\n%\n"};
    LspClient client;
    client.initialize();
    int version = 0;
    for (const std::string& text : texts) {
        const std::string name = "p" + std::to_string(++version) + ".nc";
        write(name, text);
        client.open(uriOf(name), text, version);
        const auto expected = checkedPlaces(run("check --json " + name).json());
        EXPECT_EQ(placesOf(client.diagnostics(version)), expected) << text;
        EXPECT_EQ(expected.empty(), text == kSound) << text;
    }
}

TEST_F(Lsp, TheJobBesideAProgramIsRun) {
    write("part.nc", "G21 G90 G17 G54\nT1 M6\nS1000 M3\nG0 X5 Y5 Z5\nG1 Z-2 F100\nX10\nG0 X20\nG0 Z5\nM30\n");
    write("other.proveout", R"({"schema": 1, "program": "other.nc"})");
    const std::string sample = "resources/samples/mouse-case.proveout";
    Json job = Json::parse(std::ifstream(std::string(PROVEOUT_SOURCE_DIR) + "/" + sample));
    job["program"] = "part.nc";
    write("a.proveout", job.dump());
    const auto expected = checkedPlaces(run("check --json a.proveout").json());
    const auto isOfRun = [](const Place& one) { return std::get<0>(one) == "rapid-cuts"; };
    ASSERT_TRUE(std::ranges::any_of(expected, isOfRun));
    LspClient client;
    client.initialize();
    client.open(uriOf("part.nc"), read("part.nc"));
    auto found = placesOf(client.diagnostics(1));
    EXPECT_FALSE(std::ranges::any_of(found, isOfRun)) << "what is in the text comes first";
    EXPECT_EQ(placesOf(client.diagnostics(1)), expected);
    // A newer text replaces the work on the one before.
    for (int version = 2; version <= 20; ++version)
        client.change(uriOf("part.nc"), version,
                      Json::array({edit(6, 0, 2, version % 2 == 0 ? "G1" : "G0")}));
    client.change(uriOf("part.nc"), 21, Json::array({edit(6, 0, 2, "G1")}));
    const Json first = client.until(
        [](const Json& one) { return one.value("method", "") == "textDocument/publishDiagnostics"; });
    EXPECT_EQ(first["params"]["version"], 21) << "the texts before it are not judged";
    found = placesOf(client.diagnostics(21));
    EXPECT_FALSE(std::ranges::any_of(found, isOfRun));
}

/// A text as UTF-16 for the reference; lines end with LF.
std::u16string lineEdit(std::u16string text, int line, int from, int to, const std::u16string& with) {
    std::size_t begin = 0;
    for (int k = 0; k < line; ++k)
        begin = text.find(u'\n', begin) + 1;
    const auto index = begin + static_cast<std::size_t>(from);
    return text.replace(index, static_cast<std::size_t>(to - from), with);
}

std::string utf8Of(const std::u16string& text) {
    Json json;
    std::string escaped = "\"";
    for (const char16_t unit : text) {
        char digits[8];
        std::snprintf(digits, sizeof digits, "\\u%04x", static_cast<unsigned>(unit));
        escaped += digits;
    }
    return Json::parse(escaped + "\"").get<std::string>();
}

TEST_F(Lsp, EditsAreAtUtf16Positions) {
    const std::uint32_t seed = randomSeed();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto upTo = [&](std::size_t most) { return static_cast<int>(random() % (most + 1)); };
    const std::vector<std::u16string> pieces{u"G1 ", u"X1.",  u"(\u00e4)", u"(\U0001F600\uac00)",
                                             u"\n",  u"G999", u""};
    LspClient edited;
    LspClient whole;
    edited.initialize();
    whole.initialize();
    std::u16string text = u"G21 (\U0001F600) G999\nG0 X1\n(\u00e4) G998\n";
    edited.open(kUri, utf8Of(text), 1);
    for (int version = 2; version < 2 + roundsOf(10); ++version) {
        Json changes = Json::array();
        for (int k = 0; k < 20; ++k) {
            const int line = upTo(static_cast<std::size_t>(std::ranges::count(text, u'\n')));
            std::size_t begin = 0;
            for (int skipped = 0; skipped < line; ++skipped)
                begin = text.find(u'\n', begin) + 1;
            const std::u16string content = text.substr(begin, text.find(u'\n', begin) - begin);
            int from = upTo(content.size());
            int to = std::min(from + upTo(4), static_cast<int>(content.size()));
            const auto isInPair = [&](int place) {
                return place < static_cast<int>(content.size()) &&
                       (content[static_cast<std::size_t>(place)] & 0xfc00) == 0xdc00;
            };
            from -= isInPair(from) ? 1 : 0;
            to += isInPair(to) ? 1 : 0;
            const std::u16string with = pieces[static_cast<std::size_t>(upTo(pieces.size() - 1))];
            changes.push_back(edit(line, from, to, utf8Of(with)));
            text = lineEdit(text, line, from, to, with);
        }
        edited.change(kUri, version, changes);
        whole.open(kUri, utf8Of(text), version);
        EXPECT_EQ(edited.diagnostics(version), whole.diagnostics(version)) << utf8Of(text);
    }
}

TEST_F(Lsp, PositionsAreInTheUnitsOfTheEditor) {
    const std::string text = "(\xf0\x9f\x98\x80\xc3\xa4) G999\n";
    const auto startIn = [&](const Json& encodings, const char* announced) {
        LspClient client;
        const Json server = client.initialize({{"general", {{"positionEncodings", encodings}}}});
        EXPECT_EQ(server["positionEncoding"], announced);
        client.open(kUri, text);
        for (const Json& one : client.diagnostics(1))
            if (one["code"] == "code-unknown")
                return one["range"]["start"]["character"].get<int>();
        return -1;
    };
    EXPECT_EQ(startIn({"utf-16"}, "utf-16"), 6);
    EXPECT_EQ(startIn({"utf-8", "utf-16"}, "utf-8"), 9);
}

TEST_F(Lsp, HoverDefinitionAndOutlineAnswer) {
    write("probe.ngc", "(probe)\no<probe> sub\no<probe> endsub\n");
    const std::string uri = uriOf("main.ngc");
    LspClient client;
    client.initialize({{"textDocument",
                        {{"hover", {{"contentFormat", {"markdown"}}}},
                         {"documentSymbol", {{"hierarchicalDocumentSymbolSupport", true}}}}}});
    client.open(uri,
                "G21\n#<depth>=3\nT2 M6 (D8 END MILL)\n(pocket)\nG1 Z[-#<depth>] F100\no<probe> call\nM2\n");
    EXPECT_EQ(client.ask("textDocument/hover", at(uri, 4, 1))["result"]["contents"]["value"],
              "`G1`: straight feed (LinuxCNC)  \nModal group: motion");
    EXPECT_EQ(client.ask("textDocument/definition", at(uri, 4, 9))["result"]["range"]["start"]["line"], 1);
    const Json called = client.ask("textDocument/definition", at(uri, 5, 4))["result"];
    EXPECT_EQ(called["uri"], uriOf("probe.ngc"));
    EXPECT_EQ(called["range"]["start"]["line"], 1);
    const Json symbols =
        client.ask("textDocument/documentSymbol", {{"textDocument", {{"uri", uri}}}})["result"];
    ASSERT_EQ(symbols.size(), 1U) << symbols;
    EXPECT_EQ(symbols[0]["name"], "T2");
    EXPECT_EQ(symbols[0]["detail"], "D8 END MILL");
    EXPECT_EQ(symbols[0]["children"][0]["name"], "pocket");
}

TEST_F(Lsp, NeovimShowsFindingsAndAnswers) {
    if (std::system("command -v nvim >/dev/null") != 0)
        GTEST_SKIP() << "Neovim is not installed";
    write("part.ngc", "T2 M6\n#<depth>=3\n(pocket)\nG999 Z[-#<depth>] F100\nM2\n");
    const std::string script = PROVEOUT_SOURCE_DIR "/tests/app/lsp_neovim.lua";
    const std::string command = "cd '" + folder.path().string() +
                                "' && XDG_CACHE_HOME=. XDG_STATE_HOME=. HOME=. " +
                                "PROVEOUT_CLI=" PROVEOUT_CLI " nvim --headless --clean -u NONE -c 'luafile " +
                                script + "' >out.txt 2>&1 </dev/null";
    EXPECT_EQ(std::system(command.c_str()), 0);
    EXPECT_NE(read("out.txt").find("passed"), std::string::npos) << read("out.txt");
}

} // namespace
} // namespace proveout
