// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <random>
#include <string>

#include <QApplication>
#include <QHelpEvent>
#include <QRandomGenerator>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QToolTip>

#include "core/base/utf8.h"
#include "tests/ui/opened.h"
#include "ui/document/document.h"
#include "ui/editor/editor_panel.h"
#include "ui/editor/nc_editor.h"
#include "ui/editor/nc_highlighter.h"
#include "ui/look/icons.h"
#include "ui/session/session.h"

namespace proveout {
namespace {

/// One letter per byte: . plain, c comment, G code, ? unknown code, x coordinate, f machine, n label.
std::string styles(std::string_view line) {
    std::string letters = styleLine(line, DialectId::linuxcnc);
    for (char& style : letters)
        style = ".cG?xfn"[static_cast<std::size_t>(style)];
    return letters;
}

Document documentOf(std::string text) {
    Document document;
    document.utf8 = isUtf8(text);
    document.lineEnd = mostFrequentLineEnd(text);
    document.text = NcText(std::move(text));
    return document;
}

} // namespace

class EditorTest : public QObject {
    Q_OBJECT

private slots:
    void editsAreToldAsTheyAreMade() {
        const std::uint32_t seed = QRandomGenerator::global()->generate();
        std::mt19937 random(seed);
        const auto anyText = [&random](std::size_t most) {
            std::string text;
            for (std::size_t k = random() % most; k > 0; --k)
                text += "X1\r\n\r\n"[random() % 6];
            return text;
        };
        for (int round = 0; round < 100; ++round) {
            std::string text = anyText(40);
            NcEditor editor;
            editor.load(documentOf(text));
            std::ptrdiff_t lines = editor.lines();
            connect(&editor, &NcEditor::edited, this,
                    [&](std::size_t offset, std::size_t removed, std::string_view inserted) {
                        text.replace(offset, removed, inserted);
                    });
            connect(&editor, &NcEditor::linesMoved, this,
                    [&](std::uint32_t, bool, std::ptrdiff_t added) { lines += added; });
            QSignalSpy changed(&editor, &QsciScintilla::textChanged);
            for (int step = 0; step < 30; ++step) {
                const std::size_t begin = random() % (text.size() + 1);
                const std::size_t end = begin + random() % (text.size() + 1 - begin);
                const std::size_t what = random() % 8;
                if (what == 0)
                    editor.undo();
                else if (what == 1)
                    editor.redo();
                else
                    editor.replaceBytes(begin, what < 5 ? begin : end, anyText(6));
                if (what < 2)
                    QCoreApplication::processEvents();
                QVERIFY2(editor.textBytes() == text, qPrintable(QStringLiteral("seed %1").arg(seed)));
                QVERIFY2(editor.lines() == lines, qPrintable(QStringLiteral("seed %1").arg(seed)));
            }
            QVERIFY(changed.count() > 0);
        }
    }

    void anEditThatWasNotToldIsNotOneOfTheNextText() {
        NcEditor editor;
        editor.load(documentOf("G0\n"));
        QSignalSpy edited(&editor, &NcEditor::edited);
        editor.insert(QStringLiteral("X1 ")); // told when events are handled
        editor.load(documentOf("G1\n"));
        QCoreApplication::processEvents();
        QCOMPARE(edited.count(), 0);
        editor.insertAt(QStringLiteral("X1"), 0, 2);
        editor.undo(); // tells of both
        QCOMPARE(edited.count(), 2);
    }

    void aLongTextIsFilledInTheBackground() {
        std::string bytes;
        for (int line = 0; bytes.size() < 3'000'000; ++line)
            bytes += "G1 X" + std::to_string(line) + "\r\n";
        bytes += "(\xFC)"; // Latin-1
        NcEditor editor;
        QSignalSpy loaded(&editor, &NcEditor::loaded);
        QSignalSpy edited(&editor, &NcEditor::edited);
        QSignalSpy savedState(&editor, &NcEditor::savedStateChanged);
        Document document;
        document.text = NcText(bytes);
        document.utf8 = false;
        document.lineEnd = LineEnd::crLf;
        editor.load(document);
        QVERIFY(editor.isFilling());
        QVERIFY(editor.isReadOnly());
        QVERIFY(editor.textBytes().empty());
        editor.goTo(1000, 3);
        QTRY_VERIFY_WITH_TIMEOUT(!editor.isFilling(), kOpeningPatience);
        QCOMPARE(loaded.count(), 2); // including the empty text before
        QVERIFY(editor.textBytes() == bytes);
        QCOMPARE(editor.caretLine(), 1000);
        QVERIFY(!editor.isReadOnly());
        QVERIFY(!editor.isUtf8());
        QVERIFY(!editor.isUndoAvailable());
        QCOMPARE(editor.eolMode(), QsciScintilla::EolWindows);
        QCOMPARE(editor.tabWidth(), 4);
        QCOMPARE(edited.count(), 0);
        QCOMPARE(savedState.count(), 0);
        editor.insertAt(QStringLiteral("Y2"), 0, 2);
        QTRY_COMPARE(edited.count(), 1);
        QVERIFY(editor.isUndoAvailable());
        editor.undo();
        QVERIFY(editor.textBytes() == bytes);
    }

    void theNewestTextIsTheOneThatIsShown() {
        Document longOne;
        longOne.text = NcText(std::string(30'000'000, '\n'));
        Document shortOne;
        shortOne.text = NcText(std::string("G0 X1\n"));
        NcEditor editor;
        QSignalSpy loaded(&editor, &NcEditor::loaded);
        editor.load(longOne);
        editor.load(longOne);
        editor.load(shortOne);
        QVERIFY(!editor.isFilling());
        QTest::qWait(300);
        QCOMPARE(loaded.count(), 3);
        QCOMPARE(QByteArray(editor.textBytes().data()), QByteArray("G0 X1\n"));
        QVERIFY(!editor.isReadOnly());
        editor.load(longOne); // destroyed while it is being filled
    }

    void marksOfProblemsGoWhereTheTextGoes() {
        Document document;
        document.text = NcText(std::string("G0\nG1\nG2\nG3\n"));
        NcEditor editor;
        editor.load(document);
        Diagnostic problem;
        problem.severity = Severity::error;
        problem.id = "any";
        problem.text = "Any.";
        problem.where.line = 2;
        Diagnostic next = problem;
        next.where.line = 3;
        editor.showProblems({problem, next});
        editor.showCurrentLine(2, false);
        const auto marked = [&] {
            QString lines;
            for (int line = 0; line < editor.lines(); ++line)
                lines += editor.markersAtLine(line) != 0 ? u'x' : u'-';
            return lines;
        };
        QCOMPARE(marked(), QStringLiteral("-xx--"));
        editor.insertAt(QStringLiteral("(new)\n"), 0, 0);
        QCOMPARE(marked(), QStringLiteral("--xx--"));
        editor.showProblems({problem});
        editor.showCurrentLine(0, false);
        QCOMPARE(marked(), QStringLiteral("-x----"));
        editor.showProblems({});
        QCOMPARE(marked(), QStringLiteral("------"));
    }

    void coloursByTheCodesTable_data() {
        QTest::addColumn<QByteArray>("line");
        QTest::addColumn<QByteArray>("expected");
        QTest::newRow("words") << QByteArray("N10 G1 X-1.5 F100") << QByteArray("nnn.GG.xxxxx.ffff");
        QTest::newRow("no blanks") << QByteArray("g01x10y2") << QByteArray("GGGxxxxx");
        QTest::newRow("unknown code") << QByteArray("G999 X1") << QByteArray("????.xx");
        QTest::newRow("comment") << QByteArray("G0 (G1) X1") << QByteArray("GG.cccc.xx");
        QTest::newRow("rest of line") << QByteArray("M5 ; G1") << QByteArray("GG.cccc");
        QTest::newRow("unclosed") << QByteArray("(abc") << QByteArray("cccc");
        QTest::newRow("labels") << QByteArray("/ % O5") << QByteArray("n.n.nn");
    }
    void coloursByTheCodesTable() {
        QFETCH(QByteArray, line);
        QFETCH(QByteArray, expected);
        QCOMPARE(QByteArray::fromStdString(styles(line.toStdString())), expected);
    }

    void anyBytesGetAStyleEach() {
        std::mt19937 random(1);
        for (int round = 0; round < 2000; ++round) {
            std::string line(random() % 60, ' ');
            for (char& c : line)
                c = static_cast<char>(random());
            QCOMPARE(styleLine(line, DialectId::linuxcnc).size(), line.size());
        }
    }

    void editsReachTheSessionAsBytes() {
        Session session;
        session.document().newFile();
        EditorPanel panel(session);
        NcEditor& editor = panel.editor();
        // The text in the editor and in the session must stay equal through typing, pasting, undo and redo.
        std::mt19937 random(7);
        const QStringList pieces{"G1 X10\n", "é", "(комментарий)", " ", "\n", "M30", "🙂"};
        for (int step = 0; step < 400; ++step) {
            const int length = editor.length();
            switch (random() % 5) {
            case 0:
            case 1: {
                int line = 0;
                int index = 0;
                editor.lineIndexFromPosition(
                    length == 0 ? 0 : static_cast<int>(random() % static_cast<unsigned>(length)), &line,
                    &index);
                editor.setCursorPosition(line, index);
                editor.insert(pieces[static_cast<int>(random() % static_cast<unsigned>(pieces.size()))]);
                break;
            }
            case 2:
                editor.undo();
                break;
            case 3:
                editor.redo();
                break;
            default:
                editor.setSelection(0, 0, 1, 1);
                editor.removeSelectedText();
            }
            QCoreApplication::processEvents();
            QCOMPARE(QByteArray::fromStdString(session.document().text().text.toString()),
                     editor.text().toUtf8());
        }
    }

    void keepsBytesThatAreNotUtf8() {
        NcEditor editor;
        std::string edits;
        connect(&editor, &NcEditor::edited, &editor,
                [&](std::size_t offset, std::size_t removed, std::string_view inserted) {
                    edits +=
                        std::to_string(offset) + '-' + std::to_string(removed) + '+' + std::string(inserted);
                });
        const std::string text = "(M\xFChle)\r\nG0 X1\r\n";
        editor.load(documentOf(text));
        QVERIFY(edits.empty()); // loading is not an edit
        QCOMPARE(editor.lines(), 3);
        editor.setCursorPosition(1, 0);
        editor.insert(QStringLiteral("\u00e9"));
        QTRY_COMPARE(edits, std::string("9-0+\xE9")); // one byte, as in the rest of the file
    }

    void knowsWhenTheTextIsSaved() {
        NcEditor editor;
        editor.load(documentOf("G0\n"));
        QList<bool> states;
        connect(&editor, &NcEditor::savedStateChanged, &editor, [&](bool modified) { states << modified; });
        editor.insert(QStringLiteral("G1"));
        editor.undo();
        QCOMPARE(states, (QList<bool>{true, false}));
    }

    void playbackNeverMovesTheCaret() {
        NcEditor editor;
        editor.resize(300, 200);
        std::string text;
        for (int i = 0; i < 1000; ++i)
            text += "G1 X" + std::to_string(i) + "\n";
        editor.load(documentOf(text));
        editor.goTo(5, 1);
        for (int line = 1; line < 1000; line += 7) {
            editor.showCurrentLine(line, true);
            const long first = editor.SendScintilla(QsciScintilla::SCI_GETFIRSTVISIBLELINE);
            const long shown = editor.SendScintilla(QsciScintilla::SCI_LINESONSCREEN);
            QVERIFY(first <= line - 1 && line - 1 < first + shown);
            QCOMPARE(editor.caretLine(), 5);
            QCOMPARE(editor.markerFindNext(0, 1 << 1), line - 1); // only this line is marked
        }
    }

    void choosingALineEmitsTypingDoesNot() {
        NcEditor editor;
        editor.load(documentOf("G0\nG1\nG2\n"));
        QList<int> chosen;
        connect(&editor, &NcEditor::lineChosen, &editor, [&](int line) { chosen << line; });
        QTest::keyClick(&editor, Qt::Key_Down);
        QTest::keyClick(&editor, Qt::Key_Down);
        QCOMPARE(chosen, (QList<int>{2, 3}));
        QTest::keyClick(&editor, Qt::Key_Return);
        QTest::keyClicks(&editor, QStringLiteral("X1"));
        QCOMPARE(chosen.size(), 2);
        QCOMPARE(editor.caretLine(), 4);
    }

    /// The click sets a breakpoint, and the simulation does not move.
    void aClickInTheMarginChoosesNoLine() {
        NcEditor editor;
        editor.resize(400, 200);
        editor.show();
        editor.load(documentOf("G0\nG1\nG2\n"));
        QList<int> chosen;
        QList<int> margins;
        connect(&editor, &NcEditor::lineChosen, &editor, [&](int line) { chosen << line; });
        connect(&editor, &NcEditor::marginChosen, &editor, [&](int line) { margins << line; });
        const auto middleOf = [&](unsigned long line) {
            const long position = editor.SendScintilla(QsciScintilla::SCI_POSITIONFROMLINE, line);
            return static_cast<int>(
                editor.SendScintilla(QsciScintilla::SCI_POINTYFROMPOSITION, 0UL, position) + 5);
        };
        QTest::mouseClick(editor.viewport(), Qt::LeftButton, {}, {5, middleOf(2)});
        QCOMPARE(margins, QList<int>{3});
        QCOMPARE(chosen, QList<int>{});
        QTest::mouseClick(editor.viewport(), Qt::LeftButton, {}, {200, middleOf(1)});
        QCOMPARE(margins, QList<int>{3});
        QCOMPARE(chosen, QList<int>{2});
    }

    void problemLinesAreMarkedBySeverity() {
        NcEditor editor;
        editor.resize(400, 200);
        editor.show();
        editor.load(documentOf("G0\nG1\nG2\nG3\n"));
        const auto problem = [](Severity severity, const char* text, int line) {
            Diagnostic made;
            made.severity = severity;
            made.text = text;
            made.where = {line, 1, 2};
            return made;
        };
        editor.showProblems(
            {problem(Severity::warning, "Only a warning.", 1), problem(Severity::error, "An error.", 2),
             problem(Severity::warning, "And a warning.", 2), problem(Severity::note, "A note.", 3)});
        const auto marks = [&](int line) { return editor.markersAtLine(line - 1); };
        QVERIFY(marks(1) != 0 && marks(2) != 0 && marks(3) != 0);
        QCOMPARE(marks(4), 0U);
        QVERIFY(marks(1) != marks(2) && marks(1) != marks(3) && marks(2) != marks(3));
        QCOMPARE(std::popcount(marks(2)), 1); // the most severe one
        // The shapes differ too, not only the colours.
        const auto shape = [](const char* name) {
            return icon(QLatin1String(name)).pixmap(13, 13).toImage().convertToFormat(QImage::Format_Alpha8);
        };
        QVERIFY(shape("warning") != shape("error") && shape("warning") != shape("note") &&
                shape("error") != shape("note"));
        // The tooltip in the margin is about the whole line, that in the text about the position; elsewhere
        // there is none.
        const auto tipAt = [&](int line, int x) {
            const long top = editor.SendScintilla(QsciScintilla::SCI_POINTYFROMPOSITION, 0UL,
                                                  editor.SendScintilla(QsciScintilla::SCI_POSITIONFROMLINE,
                                                                       static_cast<unsigned long>(line - 1)));
            const QPoint place = editor.viewport()->mapTo(&editor, QPoint(x, static_cast<int>(top) + 5));
            QHelpEvent event(QEvent::ToolTip, place, editor.mapToGlobal(place));
            return QApplication::sendEvent(&editor, &event) ? QToolTip::text() : QString();
        };
        QVERIFY2(tipAt(2, 5).contains(QLatin1String("An error.")), qPrintable(tipAt(2, 5)));
        QVERIFY(tipAt(2, 5).contains(QLatin1String("And a warning.")));
        QVERIFY(tipAt(1, 5).contains(QLatin1String("Only a warning.")));
        QVERIFY(tipAt(4, 5).isEmpty());
        editor.showProblems({});
        QCOMPARE(marks(1) | marks(2) | marks(3), 0U);
    }

    void wordsExplainThemselvesInTheirDialect() {
        NcEditor editor;
        editor.resize(400, 200);
        editor.show();
        Document document;
        document.text = NcText("G54 X1 (G2)\nG76 Q1\n");
        editor.load(document);
        const auto tipAt = [&](long position) {
            const auto at = [&](unsigned message) {
                return static_cast<int>(editor.SendScintilla(message, 0UL, position));
            };
            const QPoint inside(at(QsciScintilla::SCI_POINTXFROMPOSITION) + 2,
                                at(QsciScintilla::SCI_POINTYFROMPOSITION) + 5);
            const QPoint place = editor.viewport()->mapTo(&editor, inside);
            QHelpEvent event(QEvent::ToolTip, place, editor.mapToGlobal(place));
            return QApplication::sendEvent(&editor, &event) ? QToolTip::text() : QString();
        };
        QCOMPARE(tipAt(1), QStringLiteral("G54: work offset 1 (LinuxCNC)<br>Modal group: work offset"));
        QCOMPARE(tipAt(4), QStringLiteral("X: X coordinate (LinuxCNC)"));
        QVERIFY(tipAt(9).isEmpty());
        QVERIFY(tipAt(12).contains(QLatin1String("Not supported")));
        editor.showDialect(DialectId::fanuc);
        QVERIFY2(tipAt(12).startsWith(QLatin1String("G76: fine boring cycle (Fanuc)")),
                 qPrintable(tipAt(12)));
    }

    void wordsShowTheirValuesAtThatPoint() {
        QTemporaryDir folder;
        const QString path = folder.filePath("values.ngc");
        const QByteArray text =
            "#1=10.5\nG1 X[#1+2] F300\no1 repeat [3]\n#1=[#1+1]\no1 endrepeat\nG55 G20\nX1\n"
            "M2\nX9\n";
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(text);
        file.close();
        Session session;
        EditorPanel panel(session);
        panel.resize(400, 300);
        panel.show();
        QVERIFY(QTest::qWaitForWindowActive(&panel));
        QVERIFY(opened(session, path));
        QTRY_VERIFY(session.program().current() != nullptr);
        NcEditor& editor = panel.editor();
        const auto point = [&](const char* word) {
            const long position = text.indexOf(word);
            const auto at = [&](unsigned message) {
                return static_cast<int>(editor.SendScintilla(message, 0UL, position));
            };
            const QPoint inside(at(QsciScintilla::SCI_POINTXFROMPOSITION) + 2,
                                at(QsciScintilla::SCI_POINTYFROMPOSITION) + 5);
            const QPoint place = editor.viewport()->mapTo(&editor, inside);
            // Moves the pointer there, because a tooltip disappears with the next motion that the system
            // reports.
            QCursor::setPos(editor.mapToGlobal(place));
            QTest::qWait(50);
            QHelpEvent event(QEvent::ToolTip, place, editor.mapToGlobal(place));
            QApplication::sendEvent(&editor, &event);
        };
        const auto reports = [](const char* what) { return QToolTip::text().contains(QLatin1String(what)); };
        point("X[");
        QVERIFY(reports("X: X coordinate (LinuxCNC)")); // shown immediately; the value follows
        QTRY_VERIFY2(reports("<br>Value: 12.5 mm"), qPrintable(QToolTip::text()));
        point("#1+2");
        QTRY_VERIFY2(reports("#1: parameter (LinuxCNC)<br>Value: 10.5"), qPrintable(QToolTip::text()));
        point("G1 ");
        QTRY_VERIFY2(reports("After this line: G1 (straight feed)"), qPrintable(QToolTip::text()));
        QVERIFY2(reports("Active before: G80"), qPrintable(QToolTip::text()));
        point("#1=[");
        QTRY_VERIFY2(reports("Value: 10.5<br>After this line: 11.5"), qPrintable(QToolTip::text()));
        QTRY_VERIFY2(reports("First of 3 executions"), qPrintable(QToolTip::text()));
        point("X1\n");
        QTRY_VERIFY2(reports("Value: 1 in (25.4 mm)"), qPrintable(QToolTip::text()));
        point("X9");
        QTRY_VERIFY2(reports("This line is not executed"), qPrintable(QToolTip::text()));
    }

    void aTipThatWasLeftStaysAway() {
        NcEditor editor;
        editor.resize(400, 200);
        editor.show();
        Document document;
        document.text = NcText("G54 X1\n");
        editor.load(document);
        int wanted = 0;
        int unwanted = 0;
        connect(&editor, &NcEditor::valuesWanted, this, [&] { ++wanted; });
        connect(&editor, &NcEditor::valuesUnwanted, this, [&] { ++unwanted; });
        const QPoint inside(editor.viewport()->mapTo(
            &editor,
            QPoint(static_cast<int>(editor.SendScintilla(QsciScintilla::SCI_POINTXFROMPOSITION, 0UL, 1L)),
                   5)));
        QHelpEvent help(QEvent::ToolTip, inside, editor.mapToGlobal(inside));
        QApplication::sendEvent(&editor, &help);
        QCOMPARE(wanted, 1);
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(editor.viewport(), &leave);
        QCOMPARE(unwanted, 1);
        QToolTip::hideText();
        QTRY_VERIFY(!QToolTip::isVisible());
        LineValues values;
        values.line = 1;
        values.executions = 1;
        editor.showValues(std::make_shared<const LineValues>(values));
        QVERIFY(!QToolTip::isVisible());
    }

    /// Laying out such a line takes more than a second for each repaint.
    void longLinesAreCutOff() {
        QTemporaryDir folder;
        const QString path = folder.filePath("digits.nc");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        const QByteArray umlauts = QByteArray("\xc3\xa4").repeated(30'000); // 2 bytes each
        file.write("G21 G90\r\nG1 X" + QByteArray(1'000'000, '1') + "\r\n(" + umlauts + ")\r\nG0 Z5\r\n");
        file.close();
        Session session;
        EditorPanel panel(session);
        QVERIFY(opened(session, path));
        NcEditor& editor = panel.editor();
        QVERIFY(editor.isReadOnly());
        QTRY_COMPARE_WITH_TIMEOUT(editor.lines(), 5, kOpeningPatience);
        QVERIFY(editor.text(1).startsWith(QLatin1String("G1 X1111")));
        QVERIFY(editor.text(1).size() < 2100);
        QVERIFY(editor.text(2).startsWith(QString::fromUtf8("(\xc3\xa4\xc3\xa4")));
        QVERIFY(editor.text(2).endsWith(QString::fromUtf8("\xc3\xa4 ...\n")));
        QCOMPARE(editor.text(3), QStringLiteral("G0 Z5\n"));
        bool reported = false;
        for (const QLabel* label : panel.findChildren<QLabel*>())
            reported =
                reported || label->text().contains(QLatin1String("line 2 has more than 20,000 characters"));
        QVERIFY(reported);
        // The text itself is complete.
        QVERIFY(session.document().text().text.size() > 1'060'000);
    }

    void largeTextsAreEditedOnceTheyAreWhole() {
        QTemporaryDir folder;
        const QString path = folder.filePath("large.nc");
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray("G1 X10 Y20 Z30 F1000\n").repeated(600'000));
        file.close();
        Session session;
        EditorPanel panel(session);
        QVERIFY(opened(session, path));
        QVERIFY(!session.document().text().readOnly);
        QVERIFY(panel.editor().isReadOnly()); // a part of it must not be edited
        QTRY_COMPARE_WITH_TIMEOUT(panel.editor().lines(), 600'001, kOpeningPatience);
        QVERIFY(!panel.editor().isReadOnly());
        panel.editor().goTo(300'000, 5);
        QTest::keyClicks(&panel.editor(), QStringLiteral("7"));
        QCOMPARE(session.document().text().text.line(299'999), std::string_view("G1 X710 Y20 Z30 F1000"));
        QCOMPARE(session.document().text().text.size(), std::size_t{600'000} * 21 + 1);
    }
};

} // namespace proveout

QTEST_MAIN(proveout::EditorTest)
#include "editor_test.moc"
