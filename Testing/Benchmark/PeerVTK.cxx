// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PeerVTK.h"

#include <vtkDijkstraGraphGeodesicPath.h>
#include <vtkDoubleArray.h>
#include <vtkPolyData.h>

PeerVTK::PeerVTK(vtkPolyData* mesh)
{
  this->Filter->SetInputData(mesh);
  this->Filter->StopWhenEndReachedOff();
  this->Run(0);
}

PeerVTK::~PeerVTK() = default;

void PeerVTK::Run(vtkIdType source)
{
  this->Filter->SetStartVertex(source);
  // The path itself is not wanted: the shortest one is traced.
  this->Filter->SetEndVertex(source);
  this->Filter->Modified();
  this->Filter->Update();
}

std::vector<double> PeerVTK::GetDistances()
{
  vtkNew<vtkDoubleArray> weights;
  this->Filter->GetCumulativeWeights(weights);
  const double* begin = weights->GetPointer(0);
  return std::vector<double>(begin, begin + weights->GetNumberOfTuples());
}
