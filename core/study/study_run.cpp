// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/study_run.h"

#include <algorithm>
#include <utility>

#include "core/base/stop_watch.h"
#include "core/decimation/surface/decimation_findings.h"
#include "core/simulation/run/simulation.h"
#include "core/study/study_findings.h"

namespace proveout {

namespace {

/// Follows the surface of a run from frame to frame.
class FaceCounter {
public:
    /// Triangles of the meshes that are new since the previous surface.
    std::uint64_t facesMade(const SurfaceSnapshot& surface) {
        const std::size_t regions = surface.meshes.size();
        m_meshes.resize(regions);
        std::uint64_t made = 0;
        for (std::size_t region = 0; region < regions; ++region) {
            const RegionMeshPtr& mesh = surface.meshes[region];
            if (mesh && mesh != m_meshes[region])
                made += mesh->triangles.size();
            if (mesh) // a dirty region keeps its old mesh here, so that its next mesh counts as a different
                      // object
                m_meshes[region] = mesh;
        }
        return made;
    }

private:
    std::vector<RegionMeshPtr> m_meshes;
};

class Run {
public:
    Run(std::unique_ptr<Simulation> simulation, double createSeconds, DrawCost* drawing, std::size_t every)
        : m_simulation(std::move(simulation)), m_drawing(drawing), m_every(std::max<std::size_t>(1, every)),
          m_wall(createSeconds - m_simulation->effort().allocateSeconds) {}

    /// An error if the memory did not suffice for the surface: its figures would be those of another method.
    Result<StudyRun> go(const StudyPoint& point, const WorkContext& context) {
        const std::size_t blocks = std::min(point.blocks, m_simulation->blockCount());
        m_run.point = point;
        m_run.rows.reserve(blocks);
        start();
        while (m_simulation->position() < blocks && !context.stopped()) {
            if (!step({context.stop, {}}))
                break;
            context.report(static_cast<double>(m_simulation->position()) / static_cast<double>(blocks));
        }
        finish();
        const Frame last = m_simulation->frame();
        for (const Diagnostic& finding : last.findings)
            if (hasIdOf(finding, decimation_finding::kSurfaceTooLarge))
                return tl::unexpected(Diagnostics{finding});
        return std::move(m_run);
    }

private:
    void start() {
        const SurfaceSnapshot surface = m_simulation->frame().surface;
        const std::size_t decimated = surface.meshes.size() - surface.dirtyRegions;
        m_run.count.moments = decimated > 0 ? 1 : 0;
        m_run.count.startRegions = decimated;
        m_run.count.regionsDecimated = decimated;
        m_run.count.facesMade = m_counter.facesMade(surface);
        if (m_drawing == nullptr)
            return;
        m_drawing->begin();
        // The first picture is shown before the first block; its upload is counted as part of the start.
        const auto first = m_drawing->draw(std::make_shared<const Frame>(m_simulation->frame()));
        m_run.seconds.upload += first.upload;
        m_run.seconds.draw += first.draw;
    }

    /// False where it was stopped.
    bool step(const WorkContext& context) {
        const std::size_t block = m_simulation->position();
        const StopWatch watch;
        m_simulation->step(context);
        if (context.stopped())
            return false;
        FramePtr frame;
        const bool drawn = m_drawing != nullptr && isDrawn(block);
        if (drawn)
            frame = std::make_shared<const Frame>(m_simulation->frame());
        const double wall = watch.seconds();
        m_wall += wall;
        double shown = 0;
        if (m_drawing != nullptr) {
            if (drawn)
                m_last = m_drawing->draw(frame);
            // Data not uploaded for a frame is uploaded with the next; drawing that is skipped is not made up
            // for.
            m_run.seconds.upload += drawn ? m_last.upload : 0;
            m_run.seconds.draw += m_last.draw;
            shown = m_last.draw + m_last.upload / static_cast<double>(m_every);
        }
        count(block, frame);
        m_run.rows.push_back({m_lastRow.facesShown, static_cast<float>(wall + shown)});
        return true;
    }

    /// One block of each m_every, never at the same position: a regular pattern would interfere with the
    /// period.
    [[nodiscard]] bool isDrawn(std::size_t block) const {
        const std::size_t stretch = block / m_every;
        return block == 0 || block % m_every == (stretch * 2654435761U >> 7U) % m_every;
    }

    void count(std::size_t block, const FramePtr& frame) {
        const Frame now = frame ? *frame : m_simulation->frame();
        m_lastRow = now.statistics[block];
        WorkCount& count = m_run.count;
        ++count.frames;
        count.faces += m_lastRow.facesShown;
        count.regionsShown += now.surface.meshes.size();
        count.regionsDecimated += m_lastRow.regionsDecimated;
        if (m_lastRow.regionsDecimated > 0) {
            ++count.moments;
            count.facesMade += m_counter.facesMade(now.surface);
        }
    }

    void finish() {
        const Simulation::Effort effort = m_simulation->effort();
        m_run.seconds.cut = effort.cutSeconds;
        m_run.seconds.decimate = effort.decimationSeconds;
        m_run.seconds.other = std::max(0.0, m_wall - effort.cutSeconds - effort.decimationSeconds);
    }

    std::unique_ptr<Simulation> m_simulation;
    DrawCost* m_drawing;
    std::size_t m_every;
    double m_wall;
    FaceCounter m_counter;
    DrawCost::Seconds m_last;
    BlockStatistics m_lastRow;
    StudyRun m_run;
};

} // namespace

Result<StudyRun> runStudy(const StudyJob& job, const StudyPoint& point, DrawCost* drawing,
                          std::size_t drawEvery, const WorkContext& context) {
    const StopWatch watch;
    auto simulation = Simulation::create(job.program, job.setup, point.parameters, {context.stop, {}});
    if (!simulation)
        return tl::unexpected(std::move(simulation.error()));
    Result<StudyRun> run =
        Run(std::move(*simulation), watch.seconds(), drawing, drawEvery).go(point, context);
    if (context.stopped())
        return failure(study_finding::kStudyStopped);
    return run;
}

} // namespace proveout
