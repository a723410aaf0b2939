// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/report_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <memory>
#include <png.h>
#include <string>
#include <vector>

#include "core/formats/glb.h"
#include "core/report/map_picture.h"

namespace proveout {
namespace {

TEST(Png, ReadsBackAsTheSamePicture) {
    Picture picture{7, 3, {}};
    for (int k = 0; k < 21; ++k)
        picture.pixels.push_back({static_cast<std::uint8_t>(k * 11), static_cast<std::uint8_t>(255 - k),
                                  static_cast<std::uint8_t>(k)});
    const std::string bytes = pngOf(picture);
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    ASSERT_NE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()), 0);
    image.format = PNG_FORMAT_RGB;
    std::vector<Rgb> pixels(21);
    ASSERT_EQ(image.width, 7U);
    ASSERT_EQ(image.height, 3U);
    ASSERT_NE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr), 0);
    EXPECT_EQ(pixels, picture.pixels);
    EXPECT_EQ(pngOf(picture), bytes);
}

/// How a colour looks to somebody without red or green cones, in linear light. Source: F. Viénot, H. Brettel
/// and J. D. Mollon, Digital video colourmaps for checking the legibility of displays by dichromats, 1999.
std::array<double, 3> seen(const Rgb& colour, bool withoutRed) {
    std::array<double, 3> linear{};
    for (std::size_t k = 0; k < 3; ++k)
        linear[k] = std::pow(colour[k] / 255.0, 2.2);
    const double share = withoutRed ? 0.11238 : 0.29275;
    const double both = share * linear[0] + (1 - share) * linear[1];
    return {both, both, linear[2]};
}

TEST(DeviationColours, DifferForEveryEye) {
    const PartTolerance tolerance{0.1, 0.1, 0};
    const std::array colours{deviationColour(-0.3, tolerance), deviationColour(0, tolerance),
                             deviationColour(0.3, tolerance)};
    for (std::size_t one = 0; one < colours.size(); ++one)
        for (std::size_t other = 0; other < one; ++other)
            for (const bool withoutRed : {true, false}) {
                const auto a = seen(colours[one], withoutRed);
                const auto b = seen(colours[other], withoutRed);
                EXPECT_GT(std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), 0.25) << one << ' ' << other;
            }
}

TEST(DeviationColours, AreStrongBeyondTheTolerance) {
    const PartTolerance tolerance{0.05, 0.2, 0};
    const auto distance = [](const Rgb& a, const Rgb& b) {
        return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
    };
    EXPECT_GT(distance(deviationColour(-0.051, tolerance), deviationColour(-0.05, tolerance)), 60);
    EXPECT_GT(distance(deviationColour(0.201, tolerance), deviationColour(0.2, tolerance)), 60);
    EXPECT_LT(distance(deviationColour(0.199, tolerance), deviationColour(0.2, tolerance)), 4);
    EXPECT_EQ(deviationColour(1, tolerance), deviationColour(5, tolerance));
}

ZMapSnapshot withHole(int side) {
    const StockBox stock{{0, 0, 0}, 20, 20, 5};
    const Grid grid = *makeGrid(stock, 20.0 / (side - 1));
    ZMap zmap(stock, grid);
    for (std::size_t index = 0; index < zmap.tileCount(); ++index) {
        const IndexRect rect = zmap.tileRect(index);
        Tile& tile = zmap.tileForWriting(index);
        for (int j = rect.j0; j < rect.j1; ++j)
            for (int i = rect.i0; i < rect.i1; ++i)
                if (grid.x(i) > 15 && grid.y(j) > 15)
                    tile.at(i - rect.i0, j - rect.j0) = -1;
        tile.refreshMaximum();
    }
    return zmap.snapshot();
}

std::shared_ptr<const DesignPart> block() {
    TriangleMesh box;
    for (int k = 0; k < 8; ++k)
        box.vertices.emplace_back((k & 1) != 0 ? 20 : 0, (k & 2) != 0 ? 20 : 0, (k & 4) != 0 ? 0 : -5);
    box.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                     {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return std::make_shared<const DesignPart>(std::move(box));
}

/// The gouge is at the upper right of the picture; a pixel for several points shows the worst of them.
TEST(DeviationPicture, HasTheGougeWhereItIs) {
    const PartTolerance tolerance{0.1, 0.1, 0};
    for (const int side : {41, 2501}) {
        const ZMapSnapshot stock = withHole(side);
        const auto deviation = Deviation::of(stock, block(), tolerance);
        Picture picture = deviationPicture(*deviation, tolerance, Shading::none);
        EXPECT_LE(picture.width, kPictureSide);
        EXPECT_GE(picture.width, side <= kPictureSide ? side : kPictureSide / 2);
        EXPECT_EQ(picture.at(picture.width - 2, 1), deviationColour(-1, tolerance));
        EXPECT_EQ(picture.at(1, picture.height - 2), deviationColour(0, tolerance));
        EXPECT_EQ(picture.at(1, 1), deviationColour(0, tolerance));
    }
}

TEST(ReportPictures, HaveThePartInThreeDimensionsWithinItsError) {
    const PartTolerance tolerance{0.1, 0.1, 0};
    PartComparison comparison;
    comparison.tolerance = tolerance;
    comparison.deviation = *Deviation::of(withHole(41), block(), tolerance);
    const ReportPictures pictures = reportPictures(comparison.deviation.stock(), &comparison);
    ASSERT_GT(pictures.glb.size(), 100U);
    EXPECT_EQ(pictures.glb.substr(0, 4), "glTF");
    std::uint32_t bytes = 0;
    std::memcpy(&bytes, pictures.glb.data() + 8, 4);
    EXPECT_EQ(bytes, pictures.glb.size());
    std::uint32_t length = 0;
    std::memcpy(&length, pictures.glb.data() + 12, 4);
    const auto json = nlohmann::json::parse(pictures.glb.substr(20, length));
    EXPECT_EQ(json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"], 2);
    const auto& views = json["bufferViews"];
    ASSERT_EQ(views.size(), 4U);
    const std::size_t picture = 20 + length + 8 + views[3]["byteOffset"].get<std::size_t>();
    EXPECT_EQ(pictures.glb.substr(picture + 1, 3), "PNG");
    EXPECT_LE(picture + views[3]["byteLength"].get<std::size_t>(), pictures.glb.size());
    EXPECT_LE(pictures.glbErrorMm, 0.1);
    EXPECT_TRUE(reportPictures(comparison.deviation.stock(), nullptr).glb.empty());
}

} // namespace
} // namespace proveout
