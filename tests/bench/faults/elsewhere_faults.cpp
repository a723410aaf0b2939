// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/faults/fault_cases.h"

namespace proveout {

const std::vector<FaultElsewhere>& faultsElsewhere() {
    static const std::vector<FaultElsewhere> elsewhere{
        {35, "cancel while reading", "Reliability.Fault35ManyLines, session_test readingALongProgram…"},
        {36, "no case of the command line", "Reliability.Fault36FilesThatChangeWhileOpen"},
        {37, "a network path that is gone", "files_test fault37ADriveThatDoesNotAnswerHoldsNothingUp"},
        {37, "no permission, as root", "Reliability.Fault37WithoutPermission"},
        {52, "new fails at any point (one place: session_test anInterpreterThatThrows…)", ""},
        {54, "rapid along a face; ball tip touching", "Findings.RapidAlongAStockFaceOrACutWallIsNone"},
        {55, "cancel, edit, close during simulation",
         "SimulationThread.AnswersACancelOfLongWorkSoon, EndsInTheMiddleOfWork; breathing_test "
         "…ThroughACancel"},
        {56, "run twice; run and export",
         "session_test oneExportAtATime, exportsWhatTheFrameShows; tsan_core"},
        {57, "decimation of flat and one-cell maps", "decimation tests; here by their jobs"},
        {58, "export to a full disk, read-only, its own source",
         "AtomicFile.FullDisk…, MeshFile.AFullDisk…, CliOutputs.*, CliExport.AFileThatOutgrowsTheDisk…"},
        {59, "kill -9 during a save", "AtomicFile.KilledWhileSavingLeavesTheOldOrTheNewFile"},
        {60, "a crash while editing", "recovery_test whatWasTypedComesBackAfterAKill"},
        {61, "one bit flipped, 1,000 times", "JobFile.SurvivesDamage, StockFile.DamageIsNoticedOrHarmless"},
        {62, "archives", "StockFile.MemoryIsAskedForFirst; here zip-…"},
        {63, "entity expansion", "no XML is read"},
        {64, "two instances on one project", "edit_claim_test"},
        {65, "OpenGL context lost", ""},
        {65, "no OpenGL 3.3", "viewport_message_test saysWhyThereIsNoPicture"},
        {65, "a window on a removed screen", ""},
        {66, "decimal comma", "StlAscii.HasADecimalPointInEveryLocale"},
        {66, "dark theme", "viewport_test followsThePalette, window_test textsHaveContrast"},
        {66, "clock jump, scaling switch", ""},
    };
    return elsewhere;
}

} // namespace proveout
