// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/stock_shapes.h"

#include <array>
#include <utility>

#include "core/base/text.h"
#include "core/formats/outline_file.h"
#include "core/formats/stl.h"
#include "core/formats/stock_file.h"
#include "core/zmap/extruded_stock.h"
#include "core/zmap/mesh_stock.h"
#include "core/zmap/saved_stock.h"

namespace proveout {

namespace {

using Body = Result<std::shared_ptr<const StockBody>>;

constexpr StockField kHeight{"h", "height", PROVEOUT_TEXT("Core", "Height Z"),
                             PROVEOUT_TEXT("Core", "Size of the stock along Z, from its top downwards."),
                             StockLength{[](const StockSpec& spec) { return spec.box.height; },
                                         [](StockSpec& spec, double length) { spec.box.height = length; }}};

constexpr std::array kBoxFields{
    StockField{"w", "width", PROVEOUT_TEXT("Core", "Width X"),
               PROVEOUT_TEXT("Core", "Size of the stock along X."),
               StockLength{[](const StockSpec& spec) { return spec.box.width; },
                           [](StockSpec& spec, double length) { spec.box.width = length; }}},
    StockField{"d", "depth", PROVEOUT_TEXT("Core", "Length Y"),
               PROVEOUT_TEXT("Core", "Size of the stock along Y."),
               StockLength{[](const StockSpec& spec) { return spec.box.depth; },
                           [](StockSpec& spec, double length) { spec.box.depth = length; }}},
    kHeight};

constexpr std::array kCylinderFields{
    StockField{"d", "diameter", PROVEOUT_TEXT("Core", "Diameter"),
               PROVEOUT_TEXT("Core", "Diameter of the upright cylinder."),
               StockLength{[](const StockSpec& spec) { return spec.box.width; },
                           [](StockSpec& spec, double length) {
                               spec.box.width = length;
                               spec.box.depth = length;
                           }}},
    kHeight};

constexpr std::array kOutlineFields{
    StockField{
        "file", "file", PROVEOUT_TEXT("Core", "Outline"),
        PROVEOUT_TEXT("Core",
                      "A text file with one point X Y per line, and a third number for an arc to the next "
                      "point: the tangent of a quarter of its angle. An empty line begins another loop."),
        StockFile{"*.csv *.txt"}},
    kHeight};

constexpr std::array kMeshFields{StockField{
    "file", "file", PROVEOUT_TEXT("Core", "Mesh"),
    PROVEOUT_TEXT("Core", "A closed mesh, in mm; the stock is everything below its upper surface."),
    StockFile{"*.stl"}}};

constexpr std::array<Choice, 4> kTurns{{{"0", PROVEOUT_TEXT("Core", "Not turned")},
                                        {"90", PROVEOUT_TEXT("Core", "90° to the left")},
                                        {"180", PROVEOUT_TEXT("Core", "180°")},
                                        {"270", PROVEOUT_TEXT("Core", "90° to the right")}}};
constexpr std::array<Choice, 3> kFlips{{{"none", PROVEOUT_TEXT("Core", "Not flipped")},
                                        {"x", PROVEOUT_TEXT("Core", "About X")},
                                        {"y", PROVEOUT_TEXT("Core", "About Y")}}};

constexpr std::array kSavedFields{
    StockField{"file", "file", PROVEOUT_TEXT("Core", "Saved stock"),
               PROVEOUT_TEXT("Core", "The stock left by an earlier setup, as saved by File, Save Stock."),
               StockFile{"*.pvstock"}},
    StockField{"flip", "flip", PROVEOUT_TEXT("Core", "Flipped"),
               PROVEOUT_TEXT("Core", "By half a turn, so that the underside is on top; before it is turned."),
               StockChoice{kFlips,
                           [](const StockSpec& spec) { return static_cast<std::size_t>(spec.shape.flip); },
                           [](StockSpec& spec, std::size_t index) {
                               spec.shape.flip = static_cast<StockFlip>(index);
                           }}},
    StockField{"turn", "turn", PROVEOUT_TEXT("Core", "Turned"),
               PROVEOUT_TEXT("Core", "About the upright axis, seen from above."),
               StockChoice{kTurns,
                           [](const StockSpec& spec) { return static_cast<std::size_t>(spec.shape.turn); },
                           [](StockSpec& spec, std::size_t index) {
                               spec.shape.turn = static_cast<StockTurn>(index);
                           }}}};

Body makeCylinder(const StockSpec& spec) {
    return extrudedStock({circleOutline(spec.box.width)}, spec.box.height);
}

Body makeOutline(const StockSpec& spec) {
    const auto loops = readOutline(spec.shape.file);
    if (!loops)
        return tl::unexpected(loops.error());
    return extrudedStock(*loops, spec.box.height);
}

Body makeMesh(const StockSpec& spec) {
    auto stl = readStlContents(spec.shape.file);
    if (!stl)
        return tl::unexpected(std::move(stl.error()));
    return meshStock({std::move(stl->mesh.vertices), std::move(stl->mesh.triangles)},
                     std::move(stl->warnings));
}

Body makeSaved(const StockSpec& spec) {
    const auto saved = readStock(spec.shape.file);
    if (!saved)
        return tl::unexpected(saved.error());
    return savedStock(saved->zmap, saved->spacing, spec.shape.turn, spec.shape.flip);
}

constexpr std::array kShapes{
    StockShapeRow{StockKind::box, "box", PROVEOUT_TEXT("Core", "Box"),
                  PROVEOUT_TEXT("Core", "A block with its sides along the axes."), "box:w=140,d=100,h=30",
                  kBoxFields, nullptr},
    StockShapeRow{StockKind::cylinder, "cylinder", PROVEOUT_TEXT("Core", "Cylinder"),
                  PROVEOUT_TEXT("Core", "A round bar that stands upright."), "cylinder:d=50,h=20",
                  kCylinderFields, makeCylinder},
    StockShapeRow{StockKind::outline, "outline", PROVEOUT_TEXT("Core", "Extruded outline"),
                  PROVEOUT_TEXT("Core", "A plate within a closed outline of lines and arcs, with holes."),
                  "outline:file=plate.csv,h=12", kOutlineFields, makeOutline},
    StockShapeRow{StockKind::mesh, "stl", PROVEOUT_TEXT("Core", "Mesh (STL)"),
                  PROVEOUT_TEXT("Core", "A casting or a forging, as a closed mesh."), "stl:file=casting.stl",
                  kMeshFields, makeMesh},
    StockShapeRow{StockKind::saved, "file", PROVEOUT_TEXT("Core", "Saved stock"),
                  PROVEOUT_TEXT("Core", "The stock left by an earlier setup, also flipped or turned."),
                  "file:file=side1.pvstock,flip=x,turn=90", kSavedFields, makeSaved},
};

void addFile(Diagnostics& errors, const std::filesystem::path& file) {
    for (Diagnostic& error : errors)
        if (error.file.empty())
            error.file = file.string();
}

} // namespace

std::span<const StockShapeRow> stockShapes() {
    return kShapes;
}

const StockShapeRow& rowOf(StockKind kind) {
    return kShapes.at(static_cast<std::size_t>(kind));
}

Result<void> makeStock(StockSpec& spec, const std::optional<Vec3>& corner) {
    const StockShapeRow& row = rowOf(spec.shape.kind);
    spec.shape.body.reset();
    spec.shape.fileState = stateOf(spec.shape.file);
    if (row.make != nullptr) {
        auto body = row.make(spec);
        if (!body) {
            addFile(body.error(), spec.shape.file);
            return tl::unexpected(std::move(body.error()));
        }
        spec.shape.body = std::move(*body);
        spec.box = spec.shape.body->box();
    }
    if (corner)
        spec.box.corner = *corner;
    return {};
}

} // namespace proveout
