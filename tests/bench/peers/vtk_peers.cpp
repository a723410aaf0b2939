// SPDX-License-Identifier: GPL-3.0-or-later
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkGreedyTerrainDecimation.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include "tests/bench/peers/peer.h"

namespace proveout::bench {

namespace {

PeerResult inserted(const PeerMap& map, double allowance, std::size_t /*faces*/) {
    vtkNew<vtkImageData> image;
    image->SetDimensions(map.nx, map.ny, 1);
    image->SetSpacing(map.spacing, map.spacing, 1);
    vtkNew<vtkFloatArray> heights;
    for (const float height : map.heights)
        heights->InsertNextValue(height);
    image->GetPointData()->SetScalars(heights);
    vtkNew<vtkGreedyTerrainDecimation> decimation;
    decimation->SetInputData(image);
    decimation->SetErrorMeasureToAbsoluteError();
    decimation->SetAbsoluteError(allowance);
    decimation->BoundaryVertexDeletionOn();
    const double begin = cpuSeconds();
    decimation->Update();
    PeerResult result{{}, {}, cpuSeconds() - begin};
    vtkPolyData* mesh = decimation->GetOutput();
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell) {
        mesh->GetCellPoints(cell, ids);
        LatticeTriangle triangle{};
        for (vtkIdType corner = 0; corner < 3; ++corner) {
            const double* p = mesh->GetPoint(ids->GetId(corner));
            triangle[static_cast<std::size_t>(corner)] = indexOf(map, p[0], p[1]);
        }
        result.triangles.push_back(triangle);
    }
    return result;
}

} // namespace

Peers vtkPeers() {
    return {{"VTK, vtkGreedyTerrainDecimation", "ε", inserted}};
}

} // namespace proveout::bench
