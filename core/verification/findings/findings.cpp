// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verification/findings/findings.h"

#include <algorithm>
#include <array>

#include "core/base/base_findings.h"
#include "core/cutter/cutter_findings.h"
#include "core/cutting/fixtures/fixture_findings.h"
#include "core/decimation/surface/decimation_findings.h"
#include "core/formats/array_findings.h"
#include "core/formats/export_findings.h"
#include "core/formats/job_findings.h"
#include "core/formats/mesh_findings.h"
#include "core/formats/stock_file_findings.h"
#include "core/nc/text/messages.h"
#include "core/part/part_findings.h"
#include "core/simulation/records/detail_findings.h"
#include "core/simulation/run/cutting_findings.h"
#include "core/simulation/run/tool_findings.h"
#include "core/simulation/setup/setup_findings.h"
#include "core/simulation/thread/condition_findings.h"
#include "core/simulation/thread/run_findings.h"
#include "core/study/study_findings.h"
#include "core/verification/findings/check_findings.h"
#include "core/verification/findings/command_line_findings.h"
#include "core/verification/findings/rule_findings.h"
#include "core/verification/findings/window_findings.h"
#include "core/zmap/stock_body_findings.h"
#include "core/zmap/zmap_findings.h"

namespace proveout {

namespace {

/// The source of the rows, the rows, and whether an error among them refuses the input.
constexpr std::array kTables{
    FindingTable{FindingSource::files, base_finding::kBaseRows, true},
    FindingTable{FindingSource::reader, nc_message::kLoadRows, true},
    FindingTable{FindingSource::reader, nc_message::kProgramRows, false},
    FindingTable{FindingSource::reader, nc_message::kLineRows, false},
    FindingTable{FindingSource::reader, nc_message::kExpressionRows, false},
    FindingTable{FindingSource::interpreter, nc_message::kFlowRows, false},
    FindingTable{FindingSource::interpreter, nc_message::kCodeRows, false},
    FindingTable{FindingSource::interpreter, nc_message::kOffsetRows, false},
    FindingTable{FindingSource::interpreter, nc_message::kMotionRows, false},
    FindingTable{FindingSource::interpreter, nc_message::kFeedRows, false},
    FindingTable{FindingSource::interpreter, nc_message::kCycleRows, false},
    FindingTable{FindingSource::interpreter, nc_message::kCornerRows, false},
    FindingTable{FindingSource::interpreter, nc_message::kCompensationRows, false},
    FindingTable{FindingSource::interpreter, nc_message::kProbeRows, false},
    FindingTable{FindingSource::interpreter, nc_message::kSplineRows, false},
    FindingTable{FindingSource::interpreter, nc_message::kForeignRows, false},
    FindingTable{FindingSource::lint, nc_message::kLintRows, false},
    FindingTable{FindingSource::tools, cutter_finding::kCutterRows, true},
    FindingTable{FindingSource::stock, zmap_finding::kZmapRows, true},
    FindingTable{FindingSource::stock, stock_body_finding::kStockBodyRows, false},
    FindingTable{FindingSource::decimation, decimation_finding::kDecimationRows, true},
    FindingTable{FindingSource::files, mesh_finding::kMeshRows, true},
    FindingTable{FindingSource::exporting, export_finding::kExportRows, true},
    FindingTable{FindingSource::files, array_finding::kArrayRows, true},
    FindingTable{FindingSource::jobFile, job_finding::kJobRows, true},
    FindingTable{FindingSource::stock, stock_finding::kStockFileRows, true},
    FindingTable{FindingSource::setup, setup_finding::kSetupRows, true},
    FindingTable{FindingSource::setup, fixture_finding::kFixtureRows, true},
    FindingTable{FindingSource::setup, fixture_finding::kFixtureFileRows, false},
    FindingTable{FindingSource::simulation, cutting_finding::kCuttingRows, false},
    FindingTable{FindingSource::simulation, tool_finding::kToolRows, false},
    FindingTable{FindingSource::rules, rule_finding::kRuleRows, false},
    FindingTable{FindingSource::setup, part_finding::kPartRows, true},
    FindingTable{FindingSource::rules, part_finding::kComparisonRows, false},
    FindingTable{FindingSource::rules, check_finding::kCheckRows, true},
    FindingTable{FindingSource::simulation, detail_finding::kDetailRows, true},
    FindingTable{FindingSource::simulation, run_finding::kRunRows, true},
    FindingTable{FindingSource::breakpoints, condition_finding::kConditionRows, true},
    FindingTable{FindingSource::study, study_finding::kStudyRows, true},
    FindingTable{FindingSource::window, window_finding::kWindowRows, true},
    FindingTable{FindingSource::commandLine, command_line_finding::kCommandLineRows, true},
};

} // namespace

std::span<const FindingTable> findingTables() {
    return kTables;
}

const FindingRow* findFinding(std::string_view id) {
    for (const FindingTable& table : kTables) {
        const auto row = std::ranges::find(table.rows, id, &FindingRow::id);
        if (row != table.rows.end())
            return *row;
    }
    return nullptr;
}

const char* findingTitle(std::string_view id) {
    const FindingRow* row = findFinding(id);
    return row == nullptr ? "" : row->title;
}

} // namespace proveout
