// SPDX-License-Identifier: GPL-3.0-or-later
// Every row of the table of stock shapes.
#include "core/formats/stock_shapes.h"

#include <gtest/gtest.h>
#include <numbers>
#include <set>

#include "core/base/atomic_file.h"
#include "core/formats/stock_file.h"
#include "tests/core/temporary_folder.h"

namespace proveout {
namespace {

std::string idOf(const std::string& text) {
    const auto stock = parseStock(text);
    return stock ? std::string() : stock.error().front().id;
}

TEST(StockShapes, RowsAreInTheOrderOfTheirKinds) {
    std::set<std::string> keys;
    for (std::size_t k = 0; k < stockShapes().size(); ++k) {
        const StockShapeRow& row = stockShapes()[k];
        EXPECT_EQ(row.kind, static_cast<StockKind>(k));
        EXPECT_TRUE(keys.insert(row.key).second);
        EXPECT_EQ(row.make == nullptr, row.kind == StockKind::box);
    }
}

TEST(StockShapes, ExamplesAreReadAndWritten) {
    for (const StockShapeRow& row : stockShapes()) {
        const auto stock = parseStock(row.example);
        ASSERT_TRUE(stock) << row.example;
        EXPECT_EQ(stock->shape.kind, row.kind);
        const auto again = parseStock(stockText(*stock));
        ASSERT_TRUE(again) << stockText(*stock);
        EXPECT_EQ(*again, *stock);
    }
}

TEST(StockShapes, OfTheCommandLine) {
    EXPECT_EQ(parseStock("140x100x30")->box, (StockBox{{0, 0, 0}, 140, 100, 30}));
    EXPECT_EQ(parseStock("box:w=1,d=2,h=3")->box, (StockBox{{0, 0, 0}, 1, 2, 3}));
    EXPECT_EQ(parseStock("cylinder:h=20,d=50")->box, (StockBox{{0, 0, 0}, 50, 50, 20}));
    const auto saved = parseStock("file:file=a, b=c.pvstock,turn=270,flip=y");
    ASSERT_TRUE(saved);
    EXPECT_EQ(saved->shape.file, "a, b=c.pvstock"); // a comma belongs to the file name if no key follows it
    EXPECT_EQ(saved->shape.turn, StockTurn::threeQuarters);
    EXPECT_EQ(saved->shape.flip, StockFlip::aboutY);
}

TEST(StockShapes, WhatCannotBeIsReported) {
    EXPECT_EQ(idOf("140x100"), "stock-size-form");
    EXPECT_EQ(idOf("cone:d=5"), "stock-shape-unknown");
    EXPECT_EQ(idOf("cylinder:d=50"), "stock-key-missing");
    EXPECT_EQ(idOf("cylinder:d=50,h=20,d=3"), "stock-key-twice");
    EXPECT_EQ(idOf("cylinder:d=50,h=20,r=3"), "stock-key-unknown");
    EXPECT_EQ(idOf("cylinder:d=50,h=20,"), "");
    for (const char* value : {"0", "-1", "nan", "inf", "1e300", "5x", ""})
        EXPECT_EQ(idOf(std::string("cylinder:h=20,d=") + value), "stock-value-bad") << value;
    EXPECT_EQ(idOf("stl:file="), "stock-file-missing");
    EXPECT_EQ(idOf("file:file=a,turn=45"), "stock-choice-unknown");
    EXPECT_EQ(idOf("stl:"), "stock-key-missing");
}

TEST(StockShapes, BodiesLieWhereTheyLieOrWhereTheyAreWanted) {
    TemporaryFolder folder;
    const auto file = folder.path() / "plate.csv";
    ASSERT_TRUE(writeFile(file, "# a plate\n10;20\n60;20\n60;50;1\n10;50\n\n30 30\n40 30\n40 40\n30 40\n"));
    StockSpec spec = parseStock("outline:h=8,file=" + file.string()).value();
    ASSERT_TRUE(makeStock(spec, {}));
    EXPECT_EQ(spec.box.corner, Vec3(10, 20, 0));
    EXPECT_NEAR(spec.box.depth, 30 + 25, 1e-9); // the upper side is a half circle of 50 mm
    ASSERT_NE(spec.shape.body, nullptr);
    const double area = 50 * 30 + std::numbers::pi * 25 * 25 / 2 - 100;
    const auto uncut = uncutStock(spec.box, spec.shape, makeGrid(spec.box, 0.1).value());
    EXPECT_NEAR(uncut.zmap.snapshot().volume(), area * 8, area * 8 * 0.003);
    ASSERT_TRUE(makeStock(spec, Vec3(-1, -2, 3)));
    EXPECT_EQ(spec.box.corner, Vec3(-1, -2, 3));
}

TEST(StockShapes, WrongOutlinesAreReportedWithTheirLine) {
    TemporaryFolder folder;
    const auto file = folder.path() / "plate.csv";
    const std::pair<const char*, int> cases[] = {
        {"0 0\n5 0\nx 5\n", 3}, {"0 0\n5\n", 2},     {"0 0 1 2\n", 1},     {"0 0\n\n1 1\n2 2\n", 2},
        {"1 1\n", 1},           {"nan 0\n1 1\n", 1}, {"1e999 0\n1 1\n", 1}};
    for (const auto& [text, line] : cases) {
        ASSERT_TRUE(writeFile(file, text));
        StockSpec spec = parseStock("outline:h=8,file=" + file.string()).value();
        const auto made = makeStock(spec, {});
        ASSERT_FALSE(made) << text;
        EXPECT_EQ(made.error().front().where.line, line) << text;
        EXPECT_EQ(made.error().front().file, file.string());
    }
    ASSERT_TRUE(writeFile(file, "# nothing\n"));
    StockSpec spec = parseStock("outline:h=8,file=" + file.string()).value();
    EXPECT_EQ(makeStock(spec, {}).error().front().id, std::string("outline-empty"));
}

TEST(StockShapes, MissingFilesAreNamed) {
    for (const StockShapeRow& row : stockShapes()) {
        StockSpec spec = parseStock(row.example).value();
        if (spec.shape.file.empty())
            continue;
        spec.shape.file = "/nowhere/at/all";
        const auto made = makeStock(spec, {});
        ASSERT_FALSE(made) << row.key;
        EXPECT_EQ(made.error().front().file, "/nowhere/at/all");
    }
}

} // namespace
} // namespace proveout
