// SPDX-License-Identifier: GPL-3.0-or-later
// The architecture rules, checked in the sources: which folder may include which, and what no file may
// contain.
#include <algorithm>
#include <cstddef>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "tests/architecture/source_tree.h"

namespace proveout {
namespace {

const std::set<std::string> kTopFolders{"app", "core", "resources", "tests", "ui"};

/// The other rooms that a room of the core may include. A path that ends in ".h" permits only that header.
const std::map<std::string, std::set<std::string>> kCoreRooms{
    {"core/base", {}},
    {"core/nc", {"core/base"}},
    {"core/cutter", {"core/base"}},
    {"core/zmap", {"core/base"}},
    {"core/cutting", {"core/base", "core/nc/program/motion.h", "core/cutter", "core/zmap"}},
    {"core/decimation", {"core/base", "core/zmap"}},
    {"core/part", {"core/base", "core/zmap"}},
    {"core/simulation",
     {"core/base", "core/nc", "core/cutter", "core/zmap", "core/cutting", "core/decimation"}},
    {"core/study",
     {"core/base", "core/nc", "core/cutter", "core/zmap", "core/cutting", "core/decimation",
      "core/simulation"}},
    {"core/formats",
     {"core/base", "core/nc", "core/cutter", "core/zmap", "core/cutting", "core/decimation", "core/part",
      "core/simulation"}},
    {"core/verification",
     {"core/base", "core/nc", "core/cutter", "core/zmap", "core/cutting", "core/decimation", "core/part",
      "core/simulation", "core/study", "core/formats"}},
    {"core/report",
     {"core/base", "core/zmap", "core/decimation", "core/part", "core/formats", "core/verification"}},
};

/// The rooms within a room, lowest first: each may include those before it.
const std::map<std::string, std::vector<std::string>> kRoomsWithin{
    {"core/nc",
     {"text", "codes", "program", "geometry", "state", "motions", "cycles", "handlers", "flow", "run"}},
    {"core/cutting", {"profiles", "rows", "kernels", "cut", "fixtures"}},
    {"core/decimation", {"regions", "lattice", "lee", "certified", "surface", "solid"}},
    {"core/simulation", {"setup", "time", "run", "records", "thread"}},
    {"core/verification", {"findings", "rules", "part", "verdict", "check"}},
};

/// The rooms that panels share, lowest first: each may include those before it.
const std::vector<std::string> kSharedRooms{"ui/look",    "ui/work",    "ui/document", "ui/program",
                                            "ui/session", "ui/readout", "ui/files"};
/// The room of the window, which contains the panels and may include all of them.
const std::string kWindow = "ui/window";

bool isQt(const Include& include) {
    static const std::regex kQt("(Qt?[A-Z]\\w*(/.*)?|Qsci/.*|qcustomplot\\.h|q[a-z]+\\.h)");
    return include.angled && std::regex_match(include.target, kQt);
}

bool isOpenGl(const Include& include) {
    static const std::regex kOpenGl("(QtOpenGL.*|QOpenGL.*|GL/.*|GLES.*|EGL/.*)");
    return include.angled && std::regex_match(include.target, kOpenGl);
}

bool isOf(const Include& include, const std::string& library) {
    return include.target.starts_with(library + "/");
}

std::string place(const SourceFile& file, const Include& include) {
    return file.path + ":" + std::to_string(include.line) + ": includes " + include.target;
}

/// The folder of `path` two levels deep, like SourceFile::room().
std::string roomOf(const std::string& path) {
    return SourceFile{path, {}, {}}.room();
}

/// Fails for each include outside the tests for which `wrong` returns a reason.
template<class Wrong>
void forbid(const Wrong& wrong) {
    for (const SourceFile& file : sourceTree())
        for (const Include& include : file.includes)
            EXPECT_FALSE(!file.in("tests") && wrong(file, include)) << place(file, include);
}

TEST(Architecture, SeesTheTree) {
    // A check that reads no file would always pass.
    std::size_t includes = 0;
    for (const SourceFile& file : sourceTree())
        includes += file.includes.size();
    EXPECT_GT(sourceTree().size(), 50U);
    EXPECT_GT(includes, 200U);
    EXPECT_TRUE(isQt({1, true, "QString"}) && isQt({1, true, "QtCore/QString"}) &&
                isQt({1, true, "Qsci/qsciscintilla.h"}));
    EXPECT_FALSE(isQt({1, true, "queue"}) || isQt({1, true, "vector"}));
    EXPECT_TRUE(isOpenGl({1, true, "QOpenGLWidget"}) && isOpenGl({1, true, "GL/gl.h"}));
}

TEST(Architecture, CoreHasNoQtAndNoOpenGl) {
    forbid([](const SourceFile& file, const Include& include) {
        return file.in("core") && (isQt(include) || isOpenGl(include));
    });
}

TEST(Architecture, OpenMeshStaysInDecimation) {
    forbid([](const SourceFile& file, const Include& include) {
        return isOf(include, "OpenMesh") && !file.in("core/decimation");
    });
}

TEST(Architecture, OpenGlStaysInGlAndTheViewport) {
    forbid([](const SourceFile& file, const Include& include) {
        return isOpenGl(include) && !file.in("ui/gl") && !file.in("ui/viewport");
    });
}

/// ThreadSanitizer would not understand loops elsewhere: core/base/parallel.h.
TEST(Architecture, ParallelLoopsStayInBase) {
    forbid([](const SourceFile& file, const Include& include) {
        return include.target.find("tbb/parallel_") != std::string::npos &&
               file.path != "core/base/parallel.cpp";
    });
}

TEST(Architecture, CgalStaysInTheTests) {
    forbid([](const SourceFile&, const Include& include) { return isOf(include, "CGAL"); });
}

TEST(Architecture, IncludesAreWrittenFromTheRoot) {
    for (const SourceFile& file : sourceTree()) {
        for (const Include& include : file.includes) {
            const std::string top = include.target.substr(0, include.target.find('/'));
            const bool generated = include.target.ends_with(".moc");
            EXPECT_TRUE(include.angled || generated || kTopFolders.count(top) == 1) << place(file, include);
            EXPECT_FALSE(include.angled && kTopFolders.count(top) == 1) << place(file, include);
        }
    }
}

TEST(Architecture, LayersLookUpwardsOnly) {
    forbid([](const SourceFile& file, const Include& include) {
        return isOf(include, "tests") || (isOf(include, "app") && !file.in("app")) ||
               (isOf(include, "ui") && !file.in("ui") && !file.in("app")) ||
               (isOf(include, "resources") && !file.in("resources"));
    });
}

TEST(Architecture, RoomsOfTheCoreIncludeOnlyRoomsAboveThem) {
    for (const SourceFile& file : sourceTree()) {
        if (!file.in("core") || !file.isCpp())
            continue;
        const auto room = kCoreRooms.find(file.room());
        ASSERT_NE(room, kCoreRooms.end()) << file.path << " is in no room of the core";
        for (const Include& include : file.includes) {
            const std::string other = roomOf(include.target);
            if (include.angled || other == room->first)
                continue;
            EXPECT_TRUE(room->second.count(other) == 1 || room->second.count(include.target) == 1)
                << place(file, include);
        }
    }
}

/// The level of a path's room among those within `room`; their number if it is none of them.
std::size_t levelOf(const std::string& path, const std::string& room, const std::vector<std::string>& order) {
    const SourceFile file{path, {}, {}};
    return static_cast<std::size_t>(
        std::find_if(order.begin(), order.end(),
                     [&](const std::string& each) { return file.in(room + "/" + each); }) -
        order.begin());
}

TEST(Architecture, RoomsWithinARoomLookDownOnly) {
    for (const auto& [room, order] : kRoomsWithin) {
        for (const SourceFile& file : sourceTree()) {
            if (!file.in(room) || !file.isCpp())
                continue;
            const std::size_t level = levelOf(file.path, room, order);
            ASSERT_LT(level, order.size()) << file.path << " is in no room of " << room;
            for (const Include& include : file.includes) {
                if (!include.angled && isOf(include, room)) {
                    EXPECT_LE(levelOf(include.target, room, order), level) << place(file, include);
                }
            }
        }
    }
}

/// The level of a room among those that panels share; their number if it is a panel or the window.
std::size_t sharedLevel(const std::string& room) {
    return static_cast<std::size_t>(std::ranges::find(kSharedRooms, room) - kSharedRooms.begin());
}

TEST(Architecture, EveryFileOfTheUiIsInARoom) {
    for (const SourceFile& file : sourceTree()) {
        if (file.in("ui") && file.isCpp()) {
            EXPECT_FALSE(file.room().empty()) << file.path;
        }
    }
}

TEST(Architecture, SharedRoomsLookDownOnly) {
    for (const std::string& room : kSharedRooms)
        EXPECT_TRUE(std::ranges::any_of(sourceTree(), [&](const SourceFile& file) { return file.in(room); }))
            << room;
    forbid([](const SourceFile& file, const Include& include) {
        const std::size_t level = sharedLevel(file.room());
        return level < kSharedRooms.size() && isOf(include, "ui") &&
               sharedLevel(roomOf(include.target)) > level;
    });
}

TEST(Architecture, PanelsDoNotKnowEachOther) {
    forbid([](const SourceFile& file, const Include& include) {
        const std::string panel = file.room();
        const std::string other = roomOf(include.target);
        const bool viewportDraws = panel == "ui/viewport" && other == "ui/gl";
        return file.in("ui") && panel != kWindow && isOf(include, "ui") && other != panel &&
               sharedLevel(other) == kSharedRooms.size() && !viewportDraws;
    });
}

TEST(Architecture, NothingOfTheUiKnowsTheWindow) {
    forbid([](const SourceFile& file, const Include& include) {
        return file.in("ui") && !file.in(kWindow) && isOf(include, kWindow);
    });
}

TEST(Architecture, NoFileIsADumpingGround) {
    static const std::regex kDump("(^|.*[/_.-])(util|utils|helper|helpers|common|misc|manager)([/_.-].*|$)");
    for (const SourceFile& file : sourceTree())
        EXPECT_FALSE(std::regex_match(file.path, kDump)) << file.path;
}

TEST(Architecture, TheMainWindowStaysSmall) {
    for (const SourceFile& file : sourceTree()) {
        if (file.path.starts_with(kWindow + "/main_window.")) {
            EXPECT_LT(std::count(file.text.begin(), file.text.end(), '\n'), 400) << file.path;
        }
    }
}

TEST(Architecture, EverySourceNamesItsLicence) {
    static const std::regex kSource(
        ".*(\\.(h|cpp|cmake|sh|vert|geom|frag|glsl|svg|qrc|desktop|supp)|CMakeLists\\.txt)");
    for (const SourceFile& file : sourceTree()) {
        if (std::regex_match(file.path, kSource)) {
            const std::string head = file.text.substr(0, 600);
            EXPECT_NE(head.find("SPDX-License-Identifier: GPL-3.0-or-later"), std::string::npos) << file.path;
        }
    }
}

TEST(Architecture, NothingNamesTheMachineItWasWrittenOn) {
    static const std::regex kMachine("(^|[^\\w.:/$}])/(home|root|work|Users)/\\w");
    for (const SourceFile& file : sourceTree())
        EXPECT_FALSE(std::regex_search(file.text, kMachine)) << file.path;
}

TEST(Architecture, EverySourceIsBuilt) {
    std::map<std::string, std::string> lists;
    for (const SourceFile& file : sourceTree())
        if (file.path.ends_with("CMakeLists.txt"))
            lists[file.path.substr(0, file.path.rfind('/'))] = file.text;
    for (const SourceFile& file : sourceTree()) {
        if (!file.path.ends_with(".cpp"))
            continue;
        // Listed in its own folder, or with its folder in one above; some lists add ".cpp" themselves.
        bool listed = false;
        std::string folder = file.path.substr(0, file.path.size() - std::string_view(".cpp").size());
        std::string name;
        while (!listed && folder.find('/') != std::string::npos) {
            const std::size_t slash = folder.rfind('/');
            name = folder.substr(slash + 1) + (name.empty() ? "" : "/" + name);
            folder.resize(slash);
            const auto list = lists.find(folder);
            listed = list != lists.end() && list->second.find(name) != std::string::npos;
        }
        EXPECT_TRUE(listed) << file.path << " is in no CMakeLists.txt";
    }
}

} // namespace
} // namespace proveout
