// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timeline/activity_strip.h"

#include <cmath>
#include <numeric>
#include <random>
#include <string>

#include <QTest>

#include "core/nc/run/interpreter.h"
#include "tests/random_seed.h"
#include "ui/look/theme.h"
#include "ui/timeline/activity_follower.h"
#include "ui/timeline/activity_text.h"

namespace proveout {

namespace {

constexpr std::array kKinds{Activity::rapid, Activity::air, Activity::cutting, Activity::rapidInStock};

/// One block per line, alternating between rapids and feeds of random length.
std::shared_ptr<const Program> randomProgram(std::mt19937& random, std::size_t blocks) {
    std::string text = "G21 G90 G1 F500\n";
    for (std::size_t block = 0; block < blocks; ++block) {
        if (random() % 10 == 0)
            text += random() % 3 == 0 ? "G0 " : "G1 ";
        text += 'X';
        text += std::to_string(block % 2 == 0 ? 10 + random() % 50 : 0);
        text += '\n';
    }
    InterpretOptions options;
    options.start = Vec3(5, 0, 0);
    return interpret(NcText(text), options);
}

PersistentArray<BlockStatistics> randomRows(std::mt19937& random, std::size_t count) {
    PersistentArray<BlockStatistics> rows(count);
    const std::size_t rarity = 2 + random() % 200;
    for (std::size_t block = 0; block < count; ++block)
        rows.edit(block).maxDepth = random() % rarity == 0 ? 1.0F : 0.0F;
    return rows;
}

ActivityStrip::Colors plainColors() {
    return {Qt::green, Qt::yellow, Qt::blue, Qt::red};
}

QColor colorOf(const ActivityStrip::Colors& colors, Activity activity) {
    return std::array{colors.rapid, colors.air, colors.cutting,
                      colors.rapidInStock}[static_cast<std::size_t>(activity)];
}

bool columnHas(const QImage& image, int column, const QColor& color) {
    for (int y = 0; y < image.height(); ++y)
        if (image.pixelColor(column, y) == color)
            return true;
    return false;
}

} // namespace

class ActivityStripTest : public QObject {
    Q_OBJECT

private slots:
    void everyBlockHasAColumn() {
        for (const int columns : {1, 2, 7, 100, 1500})
            for (const std::size_t blocks : {1UL, 2UL, 6UL, 7UL, 99UL, 1500UL, 1501UL, 20'000UL}) {
                std::vector<int> shown(blocks, 0);
                for (int column = 0; column < columns; ++column) {
                    const auto stretch = ActivityStrip::blocksOf(column, columns, blocks);
                    QVERIFY(stretch.first < stretch.last && stretch.last <= blocks);
                    for (std::size_t block = stretch.first; block < stretch.last; ++block)
                        ++shown[block];
                }
                for (const int times : shown)
                    QVERIFY(blocks >= static_cast<std::size_t>(columns) ? times == 1 : times >= 1);
            }
    }

    void nothingThatOccursVanishes() {
        const unsigned seed = randomSeed();
        qInfo("PROVEOUT_SEED=%u", seed);
        std::mt19937 random(seed);
        for (int round = 0; round < 2000; ++round) {
            ActivitySums sums;
            const int height = 3 + static_cast<int>(random() % 30);
            for (std::size_t kind = 0; kind < kActivities; ++kind) {
                sums.blocks.at(kind) =
                    random() % 3 == 0 ? static_cast<std::uint32_t>(1 + random() % 1000) : 0;
                if (sums.blocks.at(kind) > 0)
                    sums.seconds.at(kind) = std::pow(10.0, static_cast<double>(random() % 8)) / 1e4;
            }
            const auto rows = ActivityStrip::rowsOf(sums, height);
            const int all = std::accumulate(rows.begin(), rows.end(), 0);
            QCOMPARE(all, sums.empty() ? 0 : height);
            if (sums.has(Activity::rapidInStock)) {
                QCOMPARE(rows.back(), height);
                continue;
            }
            for (const Activity kind : kKinds) {
                const int drawn = rows.at(static_cast<std::size_t>(kind));
                QCOMPARE(drawn > 0, sums.has(kind));
                // Half a row from rounding; the largest part also gets the differences of the others.
                QVERIFY(drawn <= 1 || std::abs(drawn - sums.share(kind) * height) <= 2.5);
            }
        }
    }

    /// Compares an image that grows in steps with one drawn at once, and each column with its blocks.
    void growsAsItWouldBeDrawnAtOnce() {
        const unsigned seed = randomSeed();
        qInfo("PROVEOUT_SEED=%u", seed);
        std::mt19937 random(seed);
        const auto colors = plainColors();
        for (int round = 0; round < 40; ++round) {
            const auto program = randomProgram(random, 1 + random() % 4000);
            const std::size_t blocks = program->blockCount();
            const QSize size(1 + static_cast<int>(random() % 900), 3 + static_cast<int>(random() % 14));
            const auto rows = randomRows(random, blocks);
            ActivityLog log;
            log.setTimes(machineTimes(program, {}));
            ActivityStrip grown;
            grown.fit(size, blocks, colors);
            const std::size_t known = random() % (blocks + 1);
            while (log.size() < known) {
                log.append(*program, rows, std::min(known, log.size() + 1 + random() % 300));
                grown.update(log);
            }
            QCOMPARE(grown.update(log), 0); // nothing is new
            ActivityStrip whole;
            whole.fit(size, blocks, colors);
            whole.update(log);
            QCOMPARE(grown.image(), whole.image());
            for (int column = 0; column < size.width(); ++column)
                compareColumn(whole.image(), column, *program, rows, known);
        }
    }

    void drawsOnlyWhatIsNew() {
        std::mt19937 random(4);
        const auto program = randomProgram(random, 10'000);
        const auto rows = randomRows(random, 10'000);
        ActivityLog log;
        ActivityStrip strip;
        strip.fit({1000, 8}, 10'000, plainColors());
        log.append(*program, rows, 5000);
        QCOMPARE(strip.update(log), 500);
        log.append(*program, rows, 5030);
        QCOMPARE(strip.update(log), 3);
        log.setTimes(machineTimes(program, {})); // changes the shares
        QCOMPARE(strip.update(log), 503);
        log.clear();
        strip.update(log);
        QVERIFY(!columnHas(strip.image(), 10, Qt::green) && !columnHas(strip.image(), 10, Qt::yellow));
        log.append(*program, rows, 10'000);
        QCOMPARE(strip.update(log), 1000);
    }

    void aMillionRowsComeInSeveralTicks() {
        constexpr std::size_t kBlocks = 3 * ActivityFollower::kBlocksPerTick - 10;
        std::mt19937 random(2);
        Frame frame;
        frame.program = randomProgram(random, kBlocks);
        frame.generation = 1;
        frame.block = kBlocks;
        frame.statistics = randomRows(random, kBlocks);
        Session session;
        ActivityFollower follower(session);
        std::size_t known = 0;
        for (int tick = 0; tick < 3; ++tick) {
            QVERIFY(follower.follow(&frame));
            QVERIFY(follower.log().size() - known <= ActivityFollower::kBlocksPerTick);
            known = follower.log().size();
        }
        QCOMPARE(known, kBlocks);
        QVERIFY(!follower.follow(&frame));
        frame.generation = 2; // as after an edit or a load
        frame.statistics.truncate(100);
        QVERIFY(follower.follow(&frame));
        QCOMPARE(follower.log().size(), std::size_t{100});
        QVERIFY(follower.follow(nullptr));
        QCOMPARE(follower.log().size(), std::size_t{0});
    }

    void theLegendNamesWhatIsThere() {
        const auto program = interpret(NcText("G21 G90\nG0 X0 Y0 Z5\nG1 X10 F600\nX20\nX10\nG0 X0\n"), {});
        PersistentArray<BlockStatistics> rows(program->blockCount());
        rows.edit(2).maxDepth = 1;
        ActivityLog log;
        const auto lines = [&](std::size_t first, std::size_t last) {
            return activityLegend(log, {first, last}, plainColors()).join(u'\n');
        };
        QCOMPARE(lines(0, 2), QStringLiteral("Not simulated yet"));
        QVERIFY(activitySummary(log).isEmpty());
        log.append(*program, rows, 5);
        QVERIFY(lines(2, 3).contains(QStringLiteral("Block 3: Cutting")));
        QVERIFY(lines(2, 3).contains(QColor(Qt::green).name()));
        QVERIFY(lines(0, 3).isEmpty()); // the times are not known yet
        log.setTimes(machineTimes(program, {}));
        // Two of three blocks with equal length and feed rate, minus acceleration and deceleration.
        const QString three = lines(1, 4);
        QVERIFY2(three.contains(QStringLiteral("Blocks 2 to 4")), qPrintable(three));
        QVERIFY2(three.contains(QStringLiteral("Cutting: 33.")), qPrintable(three));
        QVERIFY2(three.contains(QStringLiteral("Air cut: 66.")), qPrintable(three));
        QVERIFY(!three.contains(QStringLiteral("Rapid")));
        QVERIFY(lines(3, 50).contains(QStringLiteral("Blocks 4 to 5"))); // limited to the known blocks
        QVERIFY(!activitySummary(log).isEmpty());
    }

    void coloursAreDistinct() {
        for (const QPalette& palette : {lightPalette(), darkPalette()}) {
            const auto colors = ActivityStrip::colors(palette);
            const QColor ground = palette.color(QPalette::Base);
            for (const Activity kind : kKinds)
                QVERIFY(contrast(colorOf(colors, kind), ground) >= 3);
            QVERIFY(contrast(colors.cutting, colors.air) >= 2); // differ without hue
        }
    }

private:
    static void compareColumn(const QImage& image, int column, const Program& program,
                              const PersistentArray<BlockStatistics>& rows, std::size_t known) {
        const auto stretch = ActivityStrip::blocksOf(column, image.width(), program.blockCount());
        std::array<bool, kActivities> occurs{};
        for (std::size_t block = stretch.first; block < std::min(stretch.last, known); ++block)
            occurs.at(static_cast<std::size_t>(activityOf(program, block, rows[block]))) = true;
        if (occurs.back())
            occurs = {false, false, false, true};
        for (const Activity kind : kKinds) {
            QCOMPARE(columnHas(image, column, colorOf(plainColors(), kind)),
                     occurs.at(static_cast<std::size_t>(kind)));
        }
    }
};

} // namespace proveout

QTEST_MAIN(proveout::ActivityStripTest)
#include "activity_strip_test.moc"
