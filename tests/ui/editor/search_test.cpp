// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cctype>
#include <ctime>
#include <random>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

#include "core/base/utf8.h"
#include "ui/editor/editor_search.h"
#include "ui/editor/find_bar.h"
#include "ui/editor/nc_editor.h"
#include "ui/editor/text_search.h"

namespace proveout {
namespace {

Document documentOf(std::string text) {
    Document document;
    document.utf8 = isUtf8(text);
    document.text = NcText(std::move(text));
    return document;
}

std::vector<std::size_t> allOf(const std::string& text, const TextPattern& pattern) {
    std::vector<std::size_t> found;
    for (auto at = findForward(text, pattern, 0); at; at = findForward(text, pattern, *at + 1))
        found.push_back(*at);
    return found;
}

/// The same with the regular expressions of the library, using look-ahead for the word boundaries.
std::vector<std::size_t> byExpression(const std::string& text, const TextPattern& pattern) {
    std::string escaped;
    for (const char c : pattern.bytes)
        escaped +=
            std::isalnum(static_cast<unsigned char>(c)) != 0 ? std::string(1, c) : std::string("\\") + c;
    const auto ofNumber = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.'; };
    const auto behind = [&](char c) {
        return ofNumber(c)                                        ? "(?![0-9.])"
               : std::isalpha(static_cast<unsigned char>(c)) != 0 ? "(?![a-z])"
                                                                  : "";
    };
    const std::regex expression(escaped + (pattern.wholeWords ? behind(pattern.bytes.back()) : ""),
                                std::regex::icase);
    std::vector<std::size_t> found;
    for (std::size_t at = 0; at + pattern.bytes.size() <= text.size(); ++at) {
        const auto begin = text.begin() + static_cast<std::ptrdiff_t>(at);
        std::smatch match;
        if (!std::regex_search(begin, text.end(), match, expression, std::regex_constants::match_continuous))
            continue;
        const char first = pattern.bytes.front();
        const bool letterBefore = at > 0 && std::isalpha(static_cast<unsigned char>(text[at - 1])) != 0;
        const bool numberBefore = at > 0 && ofNumber(text[at - 1]);
        if (pattern.wholeWords && ((ofNumber(first) && numberBefore) ||
                                   (std::isalpha(static_cast<unsigned char>(first)) != 0 && letterBefore)))
            continue;
        found.push_back(at);
    }
    return found;
}

} // namespace

class SearchTest : public QObject {
    Q_OBJECT

private slots:
    void wholeWordsAreWordsOfNc_data() {
        QTest::addColumn<QByteArray>("pattern");
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<bool>("found");
        const auto row = [](const char* pattern, const char* text, bool found) {
            QTest::addRow("%s in %s", pattern, text) << QByteArray(pattern) << QByteArray(text) << found;
        };
        row("G2", "G2 X1", true);
        row("G2", "g2x10", true);
        row("G2", "N5G2", true);
        row("G2", "N5 G2", true);
        row("G2", "G21", false);
        row("G2", "G2.1", false);
        row("G2", "G02", false);
        row("X1", "X10", false);
        row("X1", "X1.", false);
        row("X1.", "X1.Y2", true);
        row("X1.", "X1.5", false);
        row("X1", "(BOX1)", false);
        row("10", "X10 Y2", true);
        row("10", "X-10", true);
        row("10", "X110", false);
        row("pocket", "(POCKET)", true);
        row("pocket", "(POCKETS)", false);
        row("X", "X10", true);
        row("X", "(BOX)", false);
    }
    void wholeWordsAreWordsOfNc() {
        QFETCH(QByteArray, pattern);
        QFETCH(QByteArray, text);
        QFETCH(bool, found);
        const TextPattern wanted{pattern.toStdString(), true};
        QCOMPARE(findForward(text.toStdString(), wanted, 0).has_value(), found);
        QCOMPARE(findBackward(text.toStdString(), wanted, static_cast<std::size_t>(text.size())).has_value(),
                 found);
    }

    void findsWhatRegularExpressionsFind() {
        std::mt19937 random(17); // the seed
        const std::string letters = "GXgx012.-( ";
        const auto piece = [&](std::size_t length) {
            std::string text(length, ' ');
            for (char& c : text)
                c = letters[random() % letters.size()];
            return text;
        };
        for (int round = 0; round < 3000; ++round) {
            const std::string text = piece(random() % 40);
            const TextPattern pattern{piece(1 + random() % 3), random() % 2 == 0};
            const auto expected = byExpression(text, pattern);
            QCOMPARE(allOf(text, pattern), expected);
            const std::size_t before = random() % 41;
            const auto last = findBackward(text, pattern, before);
            const auto behind = std::ranges::lower_bound(expected, before);
            QCOMPARE(last.has_value(), behind != expected.begin());
            if (last)
                QCOMPARE(*last, *(behind - 1));
        }
    }

    void findsAndReplaces() {
        NcEditor editor;
        editor.load(documentOf("X1\nx1\nX2 X12\n"));
        EditorSearch search(editor, nullptr);
        search.setPattern(QStringLiteral("X1"), true);
        QVERIFY(search.find(true));
        QCOMPARE(editor.caretLine(), 1);
        QVERIFY(search.find(true));
        QCOMPARE(editor.caretLine(), 2);
        QVERIFY(search.find(true)); // wraps around at the end
        QCOMPARE(editor.caretLine(), 1);
        QVERIFY(search.find(false));
        QCOMPARE(editor.caretLine(), 2);
        search.replaceSelected(QStringLiteral("Z"));
        QCOMPARE(editor.text(), QStringLiteral("X1\nZ\nX2 X12\n"));
        editor.undo();
        search.setPattern(QStringLiteral("X3"), false);
        QVERIFY(!search.find(true));
        search.setPattern(QStringLiteral("X1"), false);
        QCOMPARE(search.replaceAll(QStringLiteral("X11")), 3);
        QCOMPARE(editor.text(), QStringLiteral("X11\nX11\nX2 X112\n"));
        editor.undo(); // a single step
        QCOMPARE(editor.text(), QStringLiteral("X1\nx1\nX2 X12\n"));
        search.setPattern(QStringLiteral("X1"), true);
        QCOMPARE(search.replaceAll(QString()), 2);
        QCOMPARE(editor.text(), QStringLiteral("\n\nX2 X12\n"));
    }

    void replacingThatIsStoppedUndoesNothingElse() {
        const std::string text = std::string(900'000, '\n') + "X1\n";
        NcEditor editor;
        editor.load(documentOf(text));
        QTRY_VERIFY(!editor.isFilling());
        editor.replaceBytes(0, 0, "(mine)");
        EditorSearch search(editor, nullptr);
        search.setPattern(QStringLiteral("X1"), false);
        QCOMPARE(search.replaceAll(QStringLiteral("X2"), [](double) { return false; }), 0);
        QVERIFY(editor.textBytes() == "(mine)" + text);
    }

    void anotherTextEndsReplacing() {
        NcEditor editor;
        editor.load(documentOf(std::string(900'000, '\n') + "X1\n"));
        QTRY_VERIFY(!editor.isFilling());
        EditorSearch search(editor, nullptr);
        search.setPattern(QStringLiteral("X1"), false);
        const auto loadAnother = [&](double) {
            editor.load(documentOf("X1\n"));
            return true;
        };
        QCOMPARE(search.replaceAll(QStringLiteral("X2"), loadAnother), 0);
        QCOMPARE(editor.text(), QStringLiteral("X1\n"));
        editor.replaceBytes(0, 0, "G0 ");
        editor.undo();
        QCOMPARE(editor.text(), QStringLiteral("X1\n"));
    }

    void aLongTextIsReplacedInParts() {
        std::mt19937 random(3); // the seed
        std::string text;
        while (text.size() < 1'500'000)
            for (std::size_t word = random() % 12, end = word + 1; word < end; ++word)
                text += std::array{"X1", "X1 ", "x1",   "X11",    "1X1", " ",
                                   "Y",  "\n",  "X1\n", "(X1X1)", "\n",  "Z"}[word];
        for (const bool wholeWords : {false, true})
            for (const QString& replacement : {QStringLiteral("X1X"), QString()}) {
                const TextPattern pattern{"X1", wholeWords};
                const std::string instead = replacement.toStdString();
                std::string expected;
                std::size_t done = 0;
                int matches = 0;
                for (auto at = findForward(text, pattern, 0); at; at = findForward(text, pattern, done)) {
                    expected.append(text, done, *at - done).append(instead);
                    done = *at + 2;
                    ++matches;
                }
                expected.append(text, done);

                NcEditor editor;
                editor.load(documentOf(text));
                QTRY_VERIFY(!editor.isFilling());
                EditorSearch search(editor, nullptr);
                search.setPattern(QStringLiteral("X1"), wholeWords);
                double last = 0;
                int parts = 1;
                const auto proceed = [&](double share) {
                    ++parts;
                    return share > std::exchange(last, share) && share < 1;
                };
                QCOMPARE(search.replaceAll(replacement, proceed), matches);
                QVERIFY(parts > 4);
                QVERIFY(editor.textBytes() == expected);
                editor.undo(); // a single step
                QVERIFY(editor.textBytes() == text);
                // Stopped in the middle, nothing is replaced.
                parts = 0;
                QCOMPARE(search.replaceAll(replacement, [&](double) { return ++parts < 3; }), 0);
                QVERIFY(editor.textBytes() == text);
            }
    }

    void searchesLatin1AsBytes() {
        NcEditor editor;
        editor.load(documentOf("(M\xFChle)\n(M\xFChle)\n"));
        EditorSearch search(editor, nullptr);
        search.setPattern(QStringLiteral("m\u00fchle"), true);
        QVERIFY(search.find(true) && search.find(true));
        QCOMPARE(editor.caretLine(), 2);
    }

    void theBarShowsWhichOfHowMany() {
        NcEditor editor;
        editor.load(documentOf("G2\nG21\nG2 X1\n"));
        FindBar bar(editor, nullptr);
        bar.open(false);
        auto* text = bar.findChild<QLineEdit*>(QStringLiteral("find-text"));
        auto* words = bar.findChild<QCheckBox*>(QStringLiteral("whole-words"));
        auto* tally = bar.findChild<QLabel*>(QStringLiteral("tally"));
        text->setText(QStringLiteral("g2"));
        QTRY_COMPARE(tally->text(), QStringLiteral("3 found"));
        bar.find(true);
        QTRY_COMPARE(tally->text(), QStringLiteral("1 of 3"));
        bar.find(false);
        QTRY_COMPARE(tally->text(), QStringLiteral("3 of 3"));
        words->setChecked(true);
        QTRY_COMPARE(tally->text(), QStringLiteral("2 of 2"));
        editor.insertAt(QStringLiteral("G2\n"), 0, 0); // counted live; it clears the selection
        QTRY_COMPARE(tally->text(), QStringLiteral("3 found"));
        bar.find(true);
        QTRY_COMPARE(tally->text(), QStringLiteral("1 of 3"));
        text->setText(QStringLiteral("G2."));
        QTRY_COMPARE(tally->text(), QStringLiteral("Not found."));
        text->clear();
        QTRY_COMPARE(tally->text(), QString());
    }

    void countingHoldsNothingUp() {
        NcEditor editor;
        std::string text;
        while (text.size() < 30'000'000)
            text += "N10 G1 X12.5 Y-3.25\n";
        const auto lines = text.size() / 20;
        editor.load(documentOf(std::move(text)));
        QTRY_VERIFY_WITH_TIMEOUT(!editor.isFilling(), 30'000);
        EditorSearch search(editor, nullptr);
        QSignalSpy tallied(&search, &EditorSearch::tallied);
        const auto cpuMs = [] {
            timespec now{};
            clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
            return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
        };
        double longest = 0;
        const auto measured = [&](const auto& work) {
            const double before = cpuMs();
            work();
            longest = std::max(longest, cpuMs() - before);
        };
        search.setCounting(true);
        measured([&] { search.setPattern(QStringLiteral("Y-3.25"), true); });
        int turns = 0;
        while (search.tally().counting && ++turns < 10'000)
            measured([] { QCoreApplication::processEvents(QEventLoop::AllEvents, 1); });
        QVERIFY2(longest < 50, qPrintable(QString::number(longest)));
        QVERIFY(search.tally().more);
        QCOMPARE(search.tally().total, MatchCounter::kMost);
        QVERIFY(lines > MatchCounter::kMost);
        search.setPattern(QStringLiteral("Z"), true);
        QTRY_VERIFY(!search.tally().counting);
        QCOMPARE(search.tally().total, std::size_t{0});
    }
};

} // namespace proveout

QTEST_MAIN(proveout::SearchTest)
#include "search_test.moc"
