// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/job_paths.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>

#include "core/formats/job_file.h"
#include "tests/core/temporary_folder.h"

namespace proveout {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
namespace fs = std::filesystem;

class JobPaths : public testing::Test {
protected:
    JobPaths() {
        fs::create_directories(m_root / "job/nc");
        fs::create_directories(m_root / "job-other");
        for (const char* name : {"part.nc", "job/part.nc", "job/nc/part.nc", "job-other/part.nc"})
            m_folder.put(name, "G0 X1\n");
        m_folder.put("casting.stl", "solid nothing\n");
    }
    Result<Job> read(const std::string& program, const std::string& stock = "\"width\":1,\"depth\":1",
                     const OutsideRule& allowed = {}) {
        m_folder.put("job/a.proveout", "{\"proveout\":2,\n\"program\":\"" + program +
                                           "\",\n\"stock\":{\"height\":1," + stock + "}}");
        return readJob(m_root / "job/a.proveout", allowed);
    }
    /// "LINE: FILE" for each refused file.
    std::string refused(const Result<Job>& job) {
        std::string out;
        if (!job)
            for (const Diagnostic& error : job.error()) {
                if (error.severity == Severity::warning)
                    continue;
                EXPECT_STREQ(error.id, "job-outside");
                EXPECT_EQ(error.file, (m_root / "job/a.proveout").string());
                out += std::to_string(error.where.line) + ": " + error.arguments.at(1).text() + "\n";
            }
        return out;
    }

    TemporaryFolder m_folder;
    const fs::path m_root = fs::canonical(m_folder.path());
};

TEST_F(JobPaths, FilesBesideAndBelowTheJobNeedNoPermission) {
    for (const std::string& program : {std::string("part.nc"), std::string("nc/part.nc"),
                                       std::string("./nc/../part.nc"), std::string("nc/../../job/part.nc"),
                                       (m_root / "job/nc/part.nc").string(), std::string("not-there.nc")})
        EXPECT_TRUE(read(program)) << program;
}

TEST_F(JobPaths, FilesOutsideAreRefusedWithTheirNames) {
    EXPECT_EQ(refused(read("../part.nc")), "2: " + (m_root / "part.nc").string() + "\n");
    EXPECT_EQ(refused(read("/etc/hostname")), "2: /etc/hostname\n");
    EXPECT_EQ(refused(read("../not-there.nc")), "2: " + (m_root / "not-there.nc").string() + "\n");
    // Not below the folder, although its name starts with the same letters.
    EXPECT_EQ(refused(read("../job-other/part.nc")), "2: " + (m_root / "job-other/part.nc").string() + "\n");
}

TEST_F(JobPaths, SymbolicLinksCountWhereTheyLead) {
    fs::create_symlink("../part.nc", m_root / "job/link.nc");
    fs::create_symlink("..", m_root / "job/up");
    fs::create_symlink("nc", m_root / "job/down");
    EXPECT_EQ(refused(read("link.nc")), "2: " + (m_root / "part.nc").string() + "\n");
    EXPECT_EQ(refused(read("up/part.nc")), "2: " + (m_root / "part.nc").string() + "\n");
    EXPECT_TRUE(read("down/part.nc"));
    // A job behind a link counts as being at its real location.
    ASSERT_TRUE(read("part.nc"));
    fs::create_symlink(m_root / "job/a.proveout", m_root / "job-other/b.proveout");
    const auto linked = readJob(m_root / "job-other/b.proveout");
    ASSERT_TRUE(linked);
    EXPECT_EQ(linked->program, m_root / "job/part.nc");
}

/// The file is not a valid mesh, so reading it would cause another error.
TEST_F(JobPaths, AStockOutsideIsNotRead) {
    const std::string stock = "\"shape\":\"stl\",\"file\":\"../casting.stl\"";
    EXPECT_EQ(refused(read("../part.nc", stock)),
              "2: " + (m_root / "part.nc").string() + "\n3: " + (m_root / "casting.stl").string() + "\n");
    const auto other = read("part.nc", stock, anyOutside);
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().front().file, (m_root / "casting.stl").string());
}

TEST_F(JobPaths, TheRuleAllowsSingleFiles) {
    const OutsideRule rule = [&](const fs::path& file) { return file == m_root / "part.nc"; };
    ASSERT_TRUE(read("../part.nc", "\"width\":1,\"depth\":1", rule));
    EXPECT_EQ(read("../part.nc", "\"width\":1,\"depth\":1", rule)->program, m_root / "part.nc");
    EXPECT_FALSE(read("../job-other/part.nc", "\"width\":1,\"depth\":1", rule));
}

TEST_F(JobPaths, WhatAJobWouldNameOutsideIsKnownBeforeItIsWritten) {
    Job job;
    EXPECT_TRUE(outsideFiles(m_root / "job/a.proveout", job).empty());
    job.program = m_root / "job/nc/part.nc";
    EXPECT_TRUE(outsideFiles(m_root / "job/a.proveout", job).empty());
    job.program = m_root / "part.nc";
    job.setup.shape.file = m_root / "casting.stl";
    EXPECT_THAT(outsideFiles(m_root / "job/a.proveout", job),
                ElementsAre(m_root / "part.nc", m_root / "casting.stl"));
    job.setup.fixtures = {{"vice", FixtureMesh{.file = m_root / "vice.stl"}}, {"jaw", FixtureBox{}}};
    EXPECT_THAT(outsideFiles(m_root / "job/a.proveout", job),
                ElementsAre(m_root / "part.nc", m_root / "casting.stl", m_root / "vice.stl"));
    job.setup.fixtures.clear();
    job.setup.shape.file = m_root / "job/../part.nc";
    EXPECT_THAT(outsideFiles(m_root / "job/a.proveout", job), ElementsAre(m_root / "part.nc"));
    EXPECT_TRUE(outsideFiles(m_root / "a.proveout", job).empty());
}

} // namespace
} // namespace proveout
