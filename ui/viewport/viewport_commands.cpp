// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/viewport_commands.h"

#include <array>

namespace proveout {
namespace {

template<StandardView View>
void look(Viewport& viewport) {
    viewport.setStandardView(View);
}

template<auto Member>
void toggle(Viewport& viewport) {
    SceneOptions options = viewport.options();
    options.*Member = !(options.*Member);
    viewport.setOptions(options);
}

template<auto Member, auto Value, auto Other>
void alternate(Viewport& viewport) {
    SceneOptions options = viewport.options();
    options.*Member = options.*Member == Value ? Other : Value;
    viewport.setOptions(options);
}

template<auto Member, auto Value>
void choose(Viewport& viewport) {
    SceneOptions options = viewport.options();
    options.*Member = Value;
    viewport.setOptions(options);
}

constexpr auto kFocus = Reach::focus;

const std::array<Command<Viewport>, 29> kCommands{{
    {"view-fit", QT_TRANSLATE_NOOP("ViewportCommands", "&Fit"),
     QT_TRANSLATE_NOOP("ViewportCommands", "Show the whole stock and its fixtures"), "fit", "F", kFocus,
     [](Viewport& viewport) { viewport.fit(); }},
    {"view-iso", QT_TRANSLATE_NOOP("ViewportCommands", "&Isometric"),
     QT_TRANSLATE_NOOP("ViewportCommands", "View from the right, front and top"), "iso", "0", kFocus,
     look<StandardView::iso>},
    {"view-top", QT_TRANSLATE_NOOP("ViewportCommands", "&Top"),
     QT_TRANSLATE_NOOP("ViewportCommands", "View along -Z"), "top", "1", kFocus, look<StandardView::top>},
    {"view-bottom", QT_TRANSLATE_NOOP("ViewportCommands", "&Bottom"),
     QT_TRANSLATE_NOOP("ViewportCommands", "View along +Z"), "bottom", "2", kFocus,
     look<StandardView::bottom>},
    {"view-front", QT_TRANSLATE_NOOP("ViewportCommands", "F&ront"),
     QT_TRANSLATE_NOOP("ViewportCommands", "View along +Y"), "front", "3", kFocus, look<StandardView::front>},
    {"view-back", QT_TRANSLATE_NOOP("ViewportCommands", "Bac&k"),
     QT_TRANSLATE_NOOP("ViewportCommands", "View along -Y"), "back", "4", kFocus, look<StandardView::back>},
    {"view-left", QT_TRANSLATE_NOOP("ViewportCommands", "&Left"),
     QT_TRANSLATE_NOOP("ViewportCommands", "View along +X"), "left", "5", kFocus, look<StandardView::left>},
    {"view-right", QT_TRANSLATE_NOOP("ViewportCommands", "Ri&ght"),
     QT_TRANSLATE_NOOP("ViewportCommands", "View along -X"), "right", "6", kFocus, look<StandardView::right>},
    separator<Viewport>(),
    {"view-perspective", QT_TRANSLATE_NOOP("ViewportCommands", "&Perspective"),
     QT_TRANSLATE_NOOP("ViewportCommands", "Perspective or parallel projection"), "perspective", "P", kFocus,
     [](Viewport& viewport) { viewport.setPerspective(!viewport.camera().perspective()); }},
    {"view-wireframe", QT_TRANSLATE_NOOP("ViewportCommands", "&Wireframe"),
     QT_TRANSLATE_NOOP("ViewportCommands", "Show the triangles and the borders of the regions"), "wireframe",
     "W", kFocus, toggle<&SceneOptions::wireframe>},
    {"view-tint", QT_TRANSLATE_NOOP("ViewportCommands", "Tint R&egions"),
     QT_TRANSLATE_NOOP("ViewportCommands", "Colour decimated and undecimated regions differently"), "tint",
     "T", kFocus, toggle<&SceneOptions::tint>},
    {"view-fixtures", QT_TRANSLATE_NOOP("ViewportCommands", "Fi&xtures"),
     QT_TRANSLATE_NOOP("ViewportCommands", "Draw what holds the stock"), "", "", kFocus,
     toggle<&SceneOptions::fixtures>},
    {"view-deviation", QT_TRANSLATE_NOOP("ViewportCommands", "Colour b&y Deviation"),
     QT_TRANSLATE_NOOP("ViewportCommands", "Colour the stock by its deviation from the design part"), "", "D",
     kFocus, toggle<&SceneOptions::deviation>},
    {"view-part", QT_TRANSLATE_NOOP("ViewportCommands", "De&sign Part"),
     QT_TRANSLATE_NOOP("ViewportCommands", "Draw the design part, see-through"), "", "", kFocus,
     toggle<&SceneOptions::part>},
    {"view-legend", QT_TRANSLATE_NOOP("ViewportCommands", "Lege&nd"),
     QT_TRANSLATE_NOOP("ViewportCommands", "Show what the colours and lines mean"), "legend", "L", kFocus,
     [](Viewport& viewport) { viewport.setLegendShown(!viewport.legendShown()); }},
    {"view-place", QT_TRANSLATE_NOOP("ViewportCommands", "P&osition at Pointer"),
     QT_TRANSLATE_NOOP("ViewportCommands",
                       "Show the coordinates under the pointer, and the line that cut this point"),
     "", "", kFocus, [](Viewport& viewport) { viewport.setPlaceLabelShown(!viewport.placeLabelShown()); }},
    separator<Viewport>(),
    {"look-closer", QT_TRANSLATE_NOOP("ViewportCommands", "&Magnifier"),
     QT_TRANSLATE_NOOP("ViewportCommands", "Cut a box of the stock again on a much finer grid"), "", "B",
     kFocus, [](Viewport& viewport) { viewport.toggleCloserLook(); }},
    {"go-to-block", QT_TRANSLATE_NOOP("ViewportCommands", "Go to &Cutting Block"),
     QT_TRANSLATE_NOOP("ViewportCommands", "Click a point on the stock to go to the block that cut it"), "",
     "G", kFocus, [](Viewport& viewport) { viewport.toggleBlockSearch(); }},
    separator<Viewport>(),
    {"path-none", QT_TRANSLATE_NOOP("ViewportCommands", "Hide Toolpat&h"),
     QT_TRANSLATE_NOOP("ViewportCommands", "Draw no toolpath"), "", "", kFocus,
     choose<&SceneOptions::path, PathShown::none>},
    {"path-near", QT_TRANSLATE_NOOP("ViewportCommands", "Toolp&ath Near the Cutter"),
     QT_TRANSLATE_NOOP("ViewportCommands",
                       "Draw the toolpath of the blocks just before and after the current one"),
     "path", "", kFocus, choose<&SceneOptions::path, PathShown::nearCutter>},
    {"path-whole", QT_TRANSLATE_NOOP("ViewportCommands", "Wh&ole Toolpath"),
     QT_TRANSLATE_NOOP("ViewportCommands", "Draw the toolpath of the whole program"), "", "", kFocus,
     choose<&SceneOptions::path, PathShown::whole>},
    {"path-through", QT_TRANSLATE_NOOP("ViewportCommands", "Toolpath Through Stoc&k"),
     QT_TRANSLATE_NOOP("ViewportCommands", "Show the toolpath inside and behind the stock, dimmed"), "", "",
     kFocus, toggle<&SceneOptions::pathThroughStock>},
    separator<Viewport>(),
    {"cutter-see-through", QT_TRANSLATE_NOOP("ViewportCommands", "See-Through C&utter"),
     QT_TRANSLATE_NOOP("ViewportCommands", "Make the cutter transparent"), "cutter", "", kFocus,
     alternate<&SceneOptions::cutter, CutterShown::seeThrough, CutterShown::solid>},
    {"cutter-hidden", QT_TRANSLATE_NOOP("ViewportCommands", "Hi&de Cutter"),
     QT_TRANSLATE_NOOP("ViewportCommands", "Draw no cutter"), "", "", kFocus,
     alternate<&SceneOptions::cutter, CutterShown::hidden, CutterShown::solid>},
    {"hide-contact", QT_TRANSLATE_NOOP("ViewportCommands", "Hide C&ontact"),
     QT_TRANSLATE_NOOP("ViewportCommands", "Show the cutter at the end of the block again"), "", "Esc",
     Reach::window, [](Viewport& viewport) { viewport.hideContact(); }},
}};

/// The commands that can be turned on and off.
struct Switch {
    const char* id;
    bool (*on)(const Viewport&);
};

template<auto Member, auto Value>
bool has(const Viewport& viewport) {
    return viewport.options().*Member == Value;
}

const std::array<Switch, 15> kSwitches{{
    {"view-perspective", [](const Viewport& viewport) { return viewport.camera().perspective(); }},
    {"view-wireframe", has<&SceneOptions::wireframe, true>},
    {"view-tint", has<&SceneOptions::tint, true>},
    {"view-fixtures", has<&SceneOptions::fixtures, true>},
    {"view-deviation", has<&SceneOptions::deviation, true>},
    {"view-part", has<&SceneOptions::part, true>},
    {"view-legend", [](const Viewport& viewport) { return viewport.legendShown(); }},
    {"view-place", [](const Viewport& viewport) { return viewport.placeLabelShown(); }},
    {"look-closer", [](const Viewport& viewport) { return viewport.looksCloser(); }},
    {"path-none", has<&SceneOptions::path, PathShown::none>},
    {"path-near", has<&SceneOptions::path, PathShown::nearCutter>},
    {"path-whole", has<&SceneOptions::path, PathShown::whole>},
    {"path-through", has<&SceneOptions::pathThroughStock, true>},
    {"cutter-see-through", has<&SceneOptions::cutter, CutterShown::seeThrough>},
    {"cutter-hidden", has<&SceneOptions::cutter, CutterShown::hidden>},
}};

} // namespace

std::span<const Command<Viewport>> viewportCommands() {
    return kCommands;
}

std::unique_ptr<CommandActions<Viewport>> addCommands(Viewport& viewport) {
    auto commands =
        std::make_unique<CommandActions<Viewport>>(viewport, "ViewportCommands", kCommands, &viewport);
    for (QAction* action : commands->all()) {
        action->setCheckable(isOn(viewport, action->objectName().toStdString()).has_value());
        viewport.addAction(action);
        // A click toggles the check mark by itself; it must show the actual state.
        QObject::connect(action, &QAction::triggered, &viewport,
                         [&viewport, &all = *commands] { showSwitches(viewport, all); });
    }
    showSwitches(viewport, *commands);
    return commands;
}

void showSwitches(const Viewport& viewport, const CommandActions<Viewport>& commands) {
    for (QAction* action : commands.all())
        if (const auto on = isOn(viewport, action->objectName().toStdString()))
            action->setChecked(*on);
}

std::optional<bool> isOn(const Viewport& viewport, std::string_view id) {
    for (const Switch& row : kSwitches)
        if (id == row.id)
            return row.on(viewport);
    return std::nullopt;
}

} // namespace proveout
